# G_ID/G_I0 against tip position at 0.5 c_R, both ways of release, in the style of all charts (studio/charts). Made by
#   ./rift run plate_pnrt --out runs/pnrt && ./rift run plate_snrt --out runs/snrt
#   gnuplot -e "pnrt='runs/pnrt/series.csv'; snrt='runs/snrt/series.csv'" renders/node_release.gp > renders/node_release.svg
set encoding utf8
set terminal svg size 860,520 enhanced font "sans-serif,14" background "white"
set datafile separator ","
set border 3 lc rgb "#444444"
set tics nomirror out tc rgb "#222222"
set grid lt 1 lw 0.7 lc rgb "#e2e2e2"
set title "Release rate against tip position at 0.5 c_R" font ",16" offset 0, 1.1
set xlabel "tip position [mm]"
set ylabel "G_{ID}⁠ / G_{I0}⁠ [-]"
set xrange [0:80]
set yrange [0:*]
set rmargin at screen 0.70
set key at screen 0.72, graph 1 left top Left reverse samplen 3 spacing 1.3 tc rgb "#222222"
set object rectangle from 40, graph 0 to 80, graph 1 fc rgb "#efefef" fs solid noborder behind
set label "measuring window" at 60, graph 1 center offset 0, 0.6 tc rgb "#555555" font ",12"
plot pnrt using (column("tip_m")*1000):"ratio" with lines lw 2 dt 1 lc rgb "#0072b2" title "progressive, r_l⁠ = 1", \
     snrt using (column("tip_m")*1000):"ratio" with lines lw 2 dt 2 lc rgb "#d55e00" title "simple", \
     0.52025538 with lines dt 4 lw 1.5 lc rgb "#000000" title "Broberg", \
     1 with lines dt 3 lw 1.5 lc rgb "#666666" title "strip limit (Nilsson)"
