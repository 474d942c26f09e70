# Cost against one quantity, as SVG. Called by reports/run:
#   gnuplot -e "data='scale.curve.dat'; svg='scale.svg'" curve.gp
# Tab-separated, written by selvage_page. First line: the axis, then the name of each series and two
# empty cells. Others: a tic's label, its place, then median, lower and upper quartile of each series.
# What is drawn black here takes the text colour of a light or dark page (plot.css).
set terminal svg size 660,400 dynamic enhanced font 'sans-serif,13' linewidth 1.2
set output svg
set datafile separator "\t"
stats data every ::1 using 2 nooutput
series = (STATS_columns - 2) / 3
if (STATS_records > 8) set xtics font ',10'
lowest_x = STATS_min
highest_x = STATS_max
axis = ''
stats data every ::0::0 using (axis = strcol(1), 0) nooutput
names = ''
do for [s = 1:series] {
  stats data every ::0::0 using (names = names . strcol(3 * s) . ' ', 0) nooutput
}
array colours[8] = ['#2f86d6', '#7fb8ec', '#d9661f', '#b8901a', '#7f7f7f', '#b455c8', '#2e9e62', \
                    '#d64550']
array shapes[8] = [7, 6, 5, 9, 13, 11, 15, 4]
set border 3
set tics nomirror out
margin = highest_x > lowest_x ? 0.04 * (highest_x - lowest_x) : 1
lowest = 1e9
highest = 0
do for [s = 1:series] {
  stats data every ::1 using 3 * s + 1 nooutput
  lowest = exists('STATS_min') && STATS_min < lowest ? STATS_min : lowest
  stats data every ::1 using 3 * s + 2 nooutput
  highest = exists('STATS_max') && STATS_max > highest ? STATS_max : highest
}
set logscale y
set xrange [lowest_x - margin:highest_x + margin]
set yrange [lowest / 1.3:highest * 1.2]
set xlabel axis
set ylabel 'ns per covered pixel'
set ytics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
set format y '%g'
set key outside right top vertical Left reverse samplen 1.5
plot for [s = 1:series] data every ::1 using 2:(column(3 * s)):(column(3 * s + 1)): \
       (column(3 * s + 2)):xtic(1) with yerrorlines pointtype shapes[1 + (s - 1) % 8] \
       pointsize 0.7 linecolor rgb colours[1 + (s - 1) % 8] title word(names, s)
