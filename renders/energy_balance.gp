# Energies of the whole test at 0.2 c_R (the paper's Fig. 5), in the style of all charts (studio/charts). Made by
#   ./rift run fig05_energy_balance --out runs/fig05
#   gnuplot -e "run='runs/fig05/series.csv'" renders/energy_balance.gp > renders/energy_balance.svg
set encoding utf8
set terminal svg size 860,520 enhanced font "sans-serif,14" background "white"
set datafile separator ","
set border 3 lc rgb "#444444"
set tics nomirror out tc rgb "#222222"
set grid lt 1 lw 0.7 lc rgb "#e2e2e2"
set title "Energies of the whole test: tension, rest, fracture" font ",16" offset 0, 1.1
set xlabel "time [ms]"
set ylabel "energy [J]"
set xrange [0:1.165]
set yrange [0:*]
set rmargin at screen 0.76
set key at screen 0.78, graph 1 left top Left reverse samplen 3 spacing 1.3 tc rgb "#222222"
set arrow from 0.47, graph 0 to 0.47, graph 1 nohead dt 3 lw 1.5 lc rgb "#777777" back
set arrow from 0.705, graph 0 to 0.705, graph 1 nohead dt 3 lw 1.5 lc rgb "#777777" back
set label "tension" at 0.235, graph 1 center offset 0, 0.6 tc rgb "#555555" font ",12"
set label "rest" at 0.5875, graph 1 center offset 0, 0.6 tc rgb "#555555" font ",12"
set label "fracture" at 0.935, graph 1 center offset 0, 0.6 tc rgb "#555555" font ",12"
t(x) = x * 1000
plot run using (t(column("time_s"))):"energy_elastic_j" with lines lw 2 dt 1 lc rgb "#0072b2" title "elastic", \
     run using (t(column("time_s"))):(column("energy_kinetic_translation_j")+column("energy_kinetic_rotation_j")) with lines lw 2 dt 2 lc rgb "#d55e00" title "kinetic", \
     run using (t(column("time_s"))):"energy_fracture_j" with lines lw 2 dt 4 lc rgb "#009e73" title "fracture", \
     run using (t(column("time_s"))):"work_external_j" with lines lw 2 dt 5 lc rgb "#cc79a7" title "work of the grips"
