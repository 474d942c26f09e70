#@ -Eno-auto-dichotomy
# How far a texture coordinate stepped along a span is from the exact one; unit 1/65536 texel.
#   abrash56  uL + k step                 at t = k / W
#   abrash57  uL + (step >> 1) + k step   at t = (k + 1/2) / W
# against UL + t (UR - UL), where step = trunc((uR - uL) / W), and uL and uR are off from the exact
# UL and UR by at most the edge's bound after n rows (dda_edge.g): by edge * a and edge * b.
# Claim: off by at most ROW n + PIXEL k in the first, ROW n + PIXEL k + 2 PRESTEP in the second,
# n being the greater of the two edges' rows.
# Used: spec/dda_bounds.h, by spec/reach.cpp.
# By hand: 0 <= k < W puts t into [0, 1].

edge_56 = @ROW@ * n;
edge_57 = @ROW@ * n + @PRESTEP@;
step_56 = int<zr>(((UR + edge_56 * b) - (UL + edge_56 * a)) / W);
step_57 = int<zr>(((UR + edge_57 * b) - (UL + edge_57 * a)) / W);
half = int<dn>(step_57 * 0.5);  # step >> 1
t_56 = k / W;
t_57 = (k + 0.5) / W;
error_56 = (UL + edge_56 * a) + k * step_56 - (UL + t_56 * (UR - UL));
error_57 = (UL + edge_57 * a) + half + k * step_57 - (UL + t_57 * (UR - UL));

most_56 = @ROW@ * n + @PIXEL@ * k;
most_57 = @ROW@ * n + @PIXEL@ * k + 2 * @PRESTEP@;
cut_56 = step_56 - ((UR + edge_56 * b) - (UL + edge_56 * a)) / W;
cut_57 = step_57 - ((UR + edge_57 * b) - (UL + edge_57 * a)) / W;
start = (half - step_57 * 0.5) + cut_57 * 0.5;

{ n in [0, 0x1p16] /\ k in [0, 0x1p16] /\ W in [1, 0x1p16] /\ |a| <= 1 /\ |b| <= 1
  /\ t_56 in [0, 1] /\ t_57 in [0, 1]
  -> most_56 - error_56 >= 0 /\ most_56 + error_56 >= 0
  /\ most_57 - error_57 >= 0 /\ most_57 + error_57 >= 0 }

# The errors of the edges come in as a mean of the two, those of the step k times.
most_56 - error_56 -> edge_56 * ((1 - a) * (1 - t_56) + (1 - b) * t_56) + k * (@PIXEL@ - cut_56)
                    { W <> 0 };
most_56 + error_56 -> edge_56 * ((1 + a) * (1 - t_56) + (1 + b) * t_56) + k * (@PIXEL@ + cut_56)
                    { W <> 0 };
most_57 - error_57 -> edge_57 * ((1 - a) * (1 - t_57) + (1 - b) * t_57) + k * (@PIXEL@ - cut_57)
                      + (@PRESTEP@ - start) { W <> 0 };
most_57 + error_57 -> edge_57 * ((1 + a) * (1 - t_57) + (1 + b) * t_57) + k * (@PIXEL@ + cut_57)
                      + (@PRESTEP@ + start) { W <> 0 };
