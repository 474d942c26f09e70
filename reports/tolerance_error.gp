# Error of the scenes against tolerance, as SVG. Called by reports/run:
#   gnuplot -e "data='scenes-error.tolerance_error.dat'; svg='scenes-error.svg'" tolerance_error.gp
# Tab-separated, written by selvage_scenes. First line: two empty cells, then the name of each series
# and an empty cell. Others: a tolerance, its place, then log10 of the largest and of the mean error
# of each series; -7 stands for none.
# What is drawn black here takes the text colour of a light or dark page (plot.css).
set terminal svg size 660,400 dynamic enhanced font 'sans-serif,13' linewidth 1.2
set output svg
set datafile separator "\t"
none = -7
stats data every ::1 using 2 nooutput
series = (STATS_columns - 2) / 2
last = STATS_max
array names[16]
do for [s = 1:series] { stats data every ::0::0 using (names[s] = strcol(2 * s + 1), 0) nooutput }
array colours[4] = ['#2f86d6', '#7fb8ec', '#d9661f', '#b8901a']
array shapes[4] = [7, 6, 5, 4]
# "1/16" as its logarithm; above what is drawn where there is none.
tolerance(name) = strstrt(name, '/') > 0 ? -log10(real(name[strstrt(name, '/') + 1:])) : \
                  real(name) > 0 ? log10(real(name)) : NaN
set border 3
set tics nomirror out
set xrange [-0.4:last + 0.4]
set yrange [none - 0.4:1.2]
set xlabel 'tolerance, texels'
set ylabel 'error, texels'
set ytics ('none' none, '10^{-6}' -6, '10^{-5}' -5, '10^{-4}' -4, '10^{-3}' -3, '0.01' -2, '0.1' -1, \
           '1' 0, '10' 1)
set key outside right top vertical Left reverse samplen 1.5
plot data every ::1 using 2:(tolerance(strcol(1))):xtic(1) with points pointtype 0 notitle, \
     data every ::1 using ($2 - 0.35):(tolerance(strcol(1))):(0.7):(0) with vectors nohead \
       linewidth 2.5 linecolor rgb '#7f7f7f' title 'tolerance', \
     for [s = 1:series] data every ::1 using 2:(column(2 * s + 1)) with linespoints \
       pointtype shapes[1 + (s - 1) % 4] pointsize 0.7 linecolor rgb colours[1 + (s - 1) % 4] \
       title names[s] . ': largest', \
     for [s = 1:series] data every ::1 using 2:(column(2 * s + 2)) with linespoints dashtype 3 \
       pointtype shapes[1 + (s - 1) % 4] pointsize 0.5 linecolor rgb colours[1 + (s - 1) % 4] \
       title names[s] . ': mean'
