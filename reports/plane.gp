# Speed against error of one work item, as SVG. Called by reports/run:
#   gnuplot -e "data='W1.plane.dat'; svg='W1.svg'" plane.gp
# Tab-separated, in three blocks two empty lines apart, which selvage_page writes:
#   0  the mappers: name, place on the axis of errors, median ns per pixel, lower and upper quartile,
#      group (1 to 4, its colour), number within the group (its shape)
#   1  the Pareto front, from above and no errors on to the right end: place, ns
#   2  the limits: name, ns
# The place is log10 of errors per million pixels; those without any stand side by side about -0.95.
# What is drawn black here takes the text colour of a light or dark page (plot.css).
set terminal svg size 660,420 dynamic enhanced font 'sans-serif,13' linewidth 1.2
set output svg
set datafile separator "\t"
mappers = 0
names = ''
array group[64]
array shape[64]
stats data index 0 using (mappers = mappers + 1, names = names . strcol(1) . ' ', \
                          group[mappers] = int($6), shape[mappers] = int($7), 0) nooutput
stats data index 0 using 5 nooutput
highest = STATS_max
limits = 0
array limit[4]
array limit_name[4]
lowest = highest
stats data index 2 using (limits = limits + 1, limit[limits] = $2, limit_name[limits] = strcol(1), \
                          lowest = $2 < lowest ? $2 : lowest, 0) nooutput
stats data index 1 using 2 nooutput
front = STATS_min
stats data index 0 using 4 nooutput
lowest = STATS_min < lowest ? STATS_min : lowest
array colours[4] = ['#2f86d6', '#2e9e62', '#d9661f', '#b455c8']
array shapes[12] = [7, 5, 9, 13, 11, 15, 6, 4, 8, 12, 10, 14]
set border 3
set tics nomirror out
set xrange [-1.7:6.1]
set yrange [lowest / 2:highest * 1.5]
set logscale y
set xtics ('none' -0.95, '1' 0, '10' 1, '100' 2, '1000' 3, '10^4' 4, '10^5' 5, '10^6' 6)
set xlabel 'errors per million pixels'
set ylabel 'ns per covered pixel'
set ytics (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
set format y '%g'
set pointintervalbox 0
set key outside right top vertical Left reverse samplen 0.5 spacing 0.85 font ',11' maxcols 1
# One at either end, the upper one above its line and the lower one below: the two may be close. The
# third in the middle. Each below its line where the front is close above. No line is drawn where it
# would strike out a name.
is_under_front(i) = front >= limit[i] && front < 1.6 * limit[i]
off(i, other) = (limits > 1 && limit[i] < limit[other]) || is_under_front(i) ? -0.6 : 0.5
if (limits > 0) set label 1 sprintf('%s %.2f', limit_name[1], limit[1]) \
  at graph 0.99, first limit[1] right offset 0, off(1, 2)
if (limits > 1) set label 2 sprintf('%s %.2f', limit_name[2], limit[2]) \
  at graph 0.01, first limit[2] left offset 0, off(2, 1)
middle_off = limits > 2 && is_under_front(3) ? -0.6 : 0.5
if (limits > 2) set label 3 sprintf('%s %.2f', limit_name[3], limit[3]) \
  at graph 0.5, first limit[3] center offset 0, middle_off
is_just_above(i) = limit[3] > limit[i] && limit[3] < 1.6 * limit[i]
is_just_below(i) = limit[3] < limit[i] && limit[i] < 1.35 * limit[3]
strikes(i, other) = limits > 2 && (off(i, other) > 0 ? is_just_above(i) : is_just_below(i))
left_end = strikes(2, 1) ? 0 : -2
right_end = strikes(1, 2) ? 4.4 : 7
apart(i) = middle_off > 0 ? limit[i] / limit[3] : limit[3] / limit[i]
in_middle(i, x) = limits > 2 && x > 0.3 && x < 4.1 && apart(i) >= 1 && apart(i) < 1.6
line(i, x) = (i == 3 ? x < left_end || x > right_end : in_middle(i, x)) ? NaN : limit[i]
plot for [i = 1:limits] line(i, x) with lines dashtype 2 linewidth 1 linecolor rgb '#7f7f7f' notitle, \
     data index 1 using 1:2 with steps linewidth 1.2 linecolor rgb '#d64550' \
       title 'Pareto front', \
     for [i = 1:mappers] data index 0 using 2:3:4:5 every ::(i - 1)::(i - 1) with yerrorbars \
       pointtype shapes[1 + (shape[i] - 1) % 12] pointsize 0.8 linecolor rgb colours[group[i]] \
       title word(names, i)
