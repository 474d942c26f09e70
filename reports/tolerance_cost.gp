# Cost of the scenes against tolerance, as SVG. Called by reports/run:
#   gnuplot -e "data='scenes-cost.tolerance_cost.dat'; svg='scenes-cost.svg'" tolerance_cost.gp
# Tab-separated, written by selvage_scenes. First line: two empty cells, then the name of each series
# and two empty cells. Others: a tolerance, its place, then median, lower and upper quartile of each.
# What is drawn black here takes the text colour of a light or dark page (plot.css).
set terminal svg size 660,400 dynamic enhanced font 'sans-serif,13' linewidth 1.2
set output svg
set datafile separator "\t"
stats data every ::1 using 2 nooutput
series = (STATS_columns - 2) / 3
last = STATS_max
array names[16]
do for [s = 1:series] { stats data every ::0::0 using (names[s] = strcol(3 * s), 0) nooutput }
array colours[4] = ['#2f86d6', '#7fb8ec', '#d9661f', '#b8901a']
array shapes[4] = [7, 6, 5, 4]
set border 3
set tics nomirror out
set xrange [-0.3:last + 0.3]
set logscale y
set xlabel 'tolerance, texels'
set ylabel 'ns per pixel'
set ytics (0.5, 0.7, 1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 10, 15, 20, 30, 50, 70, 100, 150, 200, 300, 500, 1000)
set format y '%g'
set key outside right top vertical Left reverse samplen 1.5 width 2
# The area filter costs many times what nearest costs: an axis of its own for each.
is_shown(s, with_area) = (strstrt(names[s], 'nearest') == 0) == with_area
set lmargin 9
set rmargin 20
set multiplot layout 2,1
do for [panel in '1 0'] {
  area = int(panel)
  lowest = 1e9
  highest = 0
  set yrange [*:*]  # stats leaves out what is out of range
  do for [s = 1:series] {
    if (is_shown(s, area)) {
      stats data every ::1 using 3 * s + 1 nooutput
      lowest = STATS_min < lowest ? STATS_min : lowest
      stats data every ::1 using 3 * s + 2 nooutput
      highest = STATS_max > highest ? STATS_max : highest
    }
  }
  set yrange [lowest / 1.15:highest * 1.15]
  if (area) { unset xlabel } else { set xlabel 'tolerance, texels' }
  plot for [s = 1:series] data every ::1 \
         using 2:(is_shown(s, area) ? column(3 * s) : NaN):(column(3 * s + 1)): \
               (column(3 * s + 2)):xtic(1) with yerrorlines pointtype shapes[1 + (s - 1) % 4] \
         pointsize 0.7 linecolor rgb colours[1 + (s - 1) % 4] \
         title (is_shown(s, area) ? names[s] : '')
}
unset multiplot
