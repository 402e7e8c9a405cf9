#!/usr/bin/env bash
# slurm_of_one_node.sh start FOLDER | stop FOLDER: a real Slurm on this machine alone, as root and without systemd. Then
# SLURM_CONF=FOLDER/slurm.conf. Says why and ends with code 1 where it cannot start.
set -euo pipefail
action=$1
mkdir -p "$2"
folder=$(cd "$2" && pwd)
if [ "$action" = stop ]; then
  export SLURM_CONF=$folder/slurm.conf
  scancel --quiet --state=PENDING,RUNNING --user=root 2>/dev/null || true
  for daemon in slurmd slurmctld; do
    [ -s "$folder/$daemon.pid" ] || continue
    pid=$(cat "$folder/$daemon.pid")
    kill "$pid" 2>/dev/null || continue
    for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
  done
  exit 0
fi
for program in slurmctld slurmd sbatch munged; do
  command -v "$program" >/dev/null || { echo "$program is not installed (slurm-wlm, munge)"; exit 1; }
done
[ "$(id -u)" = 0 ] || { echo "Slurm starts as root only"; exit 1; }
mkdir -p "$folder/state" "$folder/spool" "$folder/log"
if ! munge -n </dev/null >/dev/null 2>&1; then
  install -d -o munge -g munge /run/munge /var/log/munge /var/lib/munge
  su -s /bin/sh munge -c /usr/sbin/munged || { echo "munge does not start"; exit 1; }
fi
host=$(hostname -s)
read -r port < <(python3 -c 'import socket
a, b = socket.socket(), socket.socket()
for base in range(20000, 60000, 2):
    try:
        a.bind(("127.0.0.1", base)); b.bind(("127.0.0.1", base + 1)); print(base); break
    except OSError:
        a, b = socket.socket(), socket.socket()')
cat >"$folder/slurm.conf" <<C
ClusterName=rift
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc=$folder/log/jobcomp.txt
ReturnToService=2
SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1
MinJobAge=3600
MailProg=/bin/true
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1000 State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
C
echo 'CgroupPlugin=cgroup/v1' >"$folder/cgroup.conf"  # "disabled" is not known to Slurm 22.05
export SLURM_CONF=$folder/slurm.conf
slurmctld -f "$SLURM_CONF"
slurmd -f "$SLURM_CONF" || { echo "slurmd does not start: $(tail -n 3 "$folder/log/slurmd.log")"; exit 1; }
for _ in $(seq 50); do
  [ "$(sinfo -h -o %T 2>/dev/null)" != idle ] || exit 0
  sleep 0.2
done
echo "the node does not become idle: $(tail -n 3 "$folder/log/slurmctld.log")"
exit 1
