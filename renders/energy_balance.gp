# Fig. 5: the energy balance of the whole test at 0.2 c_r. Made by
#   ./rift run fig05_energy_balance --out runs/fig05
#   gnuplot -e "run='runs/fig05/series.csv'" renders/energy_balance.gp > renders/energy_balance.svg
set terminal svg size 860,440 font "DejaVu Sans,13" background "white"
set datafile separator ","
set xlabel "time [ms]"
set ylabel "energy [J]"
set xrange [0:1.165]
set yrange [0:250]
set key top left
set grid ytics lc rgb "#dddddd"
set arrow from 0.47,0 to 0.47,250 nohead dt 3 lc rgb "#888888"
set arrow from 0.705,0 to 0.705,250 nohead dt 3 lc rgb "#888888"
set label "tension" at 0.37,235 tc rgb "#777777"
set label "stabilisation" at 0.59,235 center tc rgb "#777777"
set label "fracture" at 0.93,235 center tc rgb "#777777"
t(x) = x * 1000
plot run using (t(column("time_s"))):"work_external_j" with lines lw 2 dt 2 lc rgb "#555555" title "work of the grip", \
     run using (t(column("time_s"))):"energy_elastic_j" with lines lw 2.5 lc rgb "#0072b2" title "elastic", \
     run using (t(column("time_s"))):"energy_fracture_j" with lines lw 2.5 lc rgb "#d55e00" title "fracture", \
     run using (t(column("time_s"))):(column("energy_kinetic_translation_j")+column("energy_kinetic_rotation_j")) with lines lw 2.5 lc rgb "#009e73" title "kinetic"
