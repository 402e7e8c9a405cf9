# Sourced by the scripts beside: a study that is computed in seconds, and what of its table lasts.

# preset KEYS_OF_THE_SOLVER GRID
preset() {
  cat <<T
[specimen]
length = "36 mm"
height = "12 mm"
layers = 2
elements = 500
coordination = 5.6
[loading]
displacement = "0.6 mm"
[crack]
end = "16 mm"
[output]
samples = 30
window = [0.2, 0.4]
[solver]
$1
[study]
$2
T
}

# lasting TABLE: without the columns of when and beside what a scenario was computed
lasting() {
  python3 - "$1" <<'P'
import csv, sys
passing = ("wall_", "cost_s", "lanes", "threads", "element_steps", "beam_steps", "memory", "packing_from", "prestress_from", "error_converged")
for row in csv.DictReader(open(sys.argv[1])):
    print([value for name, value in row.items() if not name.startswith(passing)])
P
}
