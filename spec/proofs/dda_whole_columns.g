#@ -Eno-auto-dichotomy
# How far from a pixel a span walked in whole columns samples the line between its edges, in pixels.
# The edges cross the row at xL and xR, which are rounded to the columns L and R. Pixel L + k shows
# the point xL + t (xR - xL), which is off the pixel's place by e = that - (L + k).
#   abrash56  L, R = ceil                 t = k / W           W = R - L
#   abrash57  L, R = ceil                 t = (k + 1/2) / W
#   dkit      L, R = nearest, halves up   t = k / W
# Claim: e lies in [-BELOW, ABOVE] of each profile. And: dkit rounds the coordinates on both edges
# to whole texels, which changes those along the span by at most DKIT_ROUNDING texels.
# Used: spec/dda_bounds.h, by spec/reach.cpp.
# By hand: t is in [0, 1], for k < W in the first two and k <= W in dkit, where a span of one pixel,
# W = 0, shows its left end, t = 0. A place L + k beyond the line is moved to the line's end: nearer
# to the point shown, which is on it, so that e stays of its sign and gets no greater.

ceil_L = int<up>(xL);
ceil_R = int<up>(xR);
round_L = int<nu>(xL);
round_R = int<nu>(xR);
W = ceil_R - ceil_L;
W_dkit = round_R - round_L;
t_56 = k / W;
t_57 = (k + 0.5) / W;
t_dkit = k / W_dkit;
e_56 = xL + t_56 * (xR - xL) - (ceil_L + k);
e_57 = xL + t_57 * (xR - xL) - (ceil_L + k);
e_dkit = xL + t_dkit * (xR - xL) - (round_L + k);
value = (int<nu>(uL) + t_dkit * (int<nu>(uR) - int<nu>(uL))) - (uL + t_dkit * (uR - uL));

{ W in [1, 0x1p16] /\ W_dkit in [1, 0x1p16] /\ t_56 in [0, 1] /\ t_57 in [0, 1] /\ t_dkit in [0, 1]
  -> e_56 + @BELOW_56@ >= 0 /\ @ABOVE_56@ - e_56 >= 0
  /\ e_57 + @BELOW_57@ >= 0 /\ @ABOVE_57@ - e_57 >= 0
  /\ e_dkit + @BELOW_DKIT@ >= 0 /\ @ABOVE_DKIT@ - e_dkit >= 0
  /\ @DKIT_ROUNDING@ - value >= 0 /\ @DKIT_ROUNDING@ + value >= 0 }

# Each is a mean of the two ends' roundings; in abrash57 half a pixel is added.
e_56 + @BELOW_56@ -> ((xL - ceil_L) + @BELOW_56@) * (1 - t_56)
                   + ((xR - ceil_R) + @BELOW_56@) * t_56 { W <> 0 };
@ABOVE_56@ - e_56 -> (@ABOVE_56@ - (xL - ceil_L)) * (1 - t_56)
                  + (@ABOVE_56@ - (xR - ceil_R)) * t_56 { W <> 0 };
e_57 + @BELOW_57@ -> ((xL - ceil_L) + 0.5 + @BELOW_57@) * (1 - t_57)
                   + ((xR - ceil_R) + 0.5 + @BELOW_57@) * t_57 { W <> 0 };
@ABOVE_57@ - e_57 -> (@ABOVE_57@ - 0.5 - (xL - ceil_L)) * (1 - t_57)
                  + (@ABOVE_57@ - 0.5 - (xR - ceil_R)) * t_57 { W <> 0 };
e_dkit + @BELOW_DKIT@ -> ((xL - round_L) + @BELOW_DKIT@) * (1 - t_dkit)
                       + ((xR - round_R) + @BELOW_DKIT@) * t_dkit { W_dkit <> 0 };
@ABOVE_DKIT@ - e_dkit -> (@ABOVE_DKIT@ - (xL - round_L)) * (1 - t_dkit)
                      + (@ABOVE_DKIT@ - (xR - round_R)) * t_dkit { W_dkit <> 0 };
@DKIT_ROUNDING@ - value -> (@DKIT_ROUNDING@ - (int<nu>(uL) - uL)) * (1 - t_dkit)
                         + (@DKIT_ROUNDING@ - (int<nu>(uR) - uR)) * t_dkit { W_dkit <> 0 };
@DKIT_ROUNDING@ + value -> (@DKIT_ROUNDING@ + (int<nu>(uL) - uL)) * (1 - t_dkit)
                         + (@DKIT_ROUNDING@ + (int<nu>(uR) - uR)) * t_dkit { W_dkit <> 0 };
