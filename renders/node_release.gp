# G_ID/G_I0 against tip position at 0.5 c_r, both ways of release. Made by
#   ./rift run plate_pnrt --out runs/pnrt && ./rift run plate_snrt --out runs/snrt
#   gnuplot -e "pnrt='runs/pnrt/series.csv'; snrt='runs/snrt/series.csv'" renders/node_release.gp > renders/node_release.svg
set terminal svg size 860,440 font "DejaVu Sans,13" background "white"
set datafile separator ","
set xlabel "tip position [mm]"
set ylabel "G_{ID} / G_{I0}" enhanced
set xrange [0:80]
set yrange [0:1.35]
set key top right
set grid ytics lc rgb "#dddddd"
set object rectangle from 40,0 to 80,1.35 fc rgb "#f3f3f3" fs solid noborder behind
set label "window of the plateau" at 60,0.06 center tc rgb "#777777"
plot 1 with lines dt 2 lw 1.5 lc rgb "#555555" title "steady strip (Nilsson)", \
     0.52025538 with lines dt 4 lw 1.5 lc rgb "#555555" title "expanding crack (Broberg)", \
     pnrt using (column("tip_m")*1000):"ratio_with_damping" with lines lw 2.5 lc rgb "#0072b2" title "progressive release, r_l = 1", \
     snrt using (column("tip_m")*1000):"ratio_with_damping" with lines lw 2.5 lc rgb "#d55e00" title "simple release"
