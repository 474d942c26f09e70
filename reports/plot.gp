# Speed against error of one work item, as SVG. Called by reports/run:
#   gnuplot -e "data='W1.dat'; svg='W1.svg'" plot.gp
# Columns of data, tab-separated: name (one word), errors per million pixels, median ns per pixel,
# lower and upper quartile, place in the list of subjects, which chooses colour and shape. The first
# row is the solid fill, which draws no texels.
# The axis of errors is logarithmic in 1 + errors per million, so that zero has a place on it.
# What is drawn black here takes the text colour of a light or dark page (plot.css).
set terminal svg size 460,330 dynamic enhanced font 'sans-serif,13' linewidth 1.2
set output svg
set datafile separator "\t"
stats data using 3 every ::0::0 nooutput
fill = STATS_min
stats data using 5 nooutput
highest = STATS_max
subjects = STATS_records - 1
names = ''
stats data using (names = names . strcol(1) . ' ', 0) nooutput
array places[subjects]
do for [i = 1:subjects] {
  stats data using 6 every ::i::i nooutput
  places[i] = int(STATS_min)
}
place(errors) = log10(1 + errors)
array colours[8] = ['#2f86d6', '#d9661f', '#2e9e62', '#b455c8', '#b8901a', '#d64550', '#1fa5a5', \
                    '#8a6d5a']
array shapes[8] = [7, 5, 9, 13, 11, 15, 4, 6]
set border 3
set tics nomirror out
set xrange [-0.35:5.3]
set yrange [fill / 1.6:highest * 2]
set logscale y
set xtics ('0' 0, '1' place(1), '10' place(10), '100' place(100), '1000' place(1000), \
           '10 000' place(10000), '100 000' place(100000))
set xlabel 'errors per million pixels'
set ylabel 'ns per covered pixel'
set ytics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200)
set format y '%g'
set pointintervalbox 0
set key outside top center horizontal
set label 1 sprintf('solid fill %.2f ns', fill) at graph 0.99, first fill right offset 0, 0.6
plot fill with lines dashtype 2 linewidth 1 linecolor rgb '#7f7f7f' notitle, \
     for [i = 1:subjects] data using (place($2)):3:4:5 every ::i::i with yerrorbars \
       pointtype shapes[places[i]] pointsize 0.9 linecolor rgb colours[places[i]] title word(names, i + 1)
