#@ -Eprecision=200 -Eno-auto-dichotomy
# Small triangles in perspective: u = n / d at a pixel, both affine over 16 x 16 pixels, by single
# precision; d is over the least q of the vertices, so that d >= 1. Unit 2^-24 texel.
#   S, T     the most that the terms' magnitudes of n, or of v's, and of d add up to there
#   w        u / S, for 0 <= u = n / d <= n <= S; inverse: 1 / T, for T >= d >= 1
# Claims: the quotient is off by at most PRODUCT 2^-24 S T, so that with `low`, ROUNDINGS of those
# and SLACK, what is lowered and rounded is no more than u, and its floor more than u less twice
# `low` and TRUNCATIONS - 1.
# Used: src/mapper/vector/small_projective-inl.h.
# By hand: a rounding is a factor 1 + r, for nothing is less than 2^-80 but 0; each term takes no more
# factors than `factor`, its conversion and three sums, or a product and a sum. Fused products
# are not rounded before. n, u and S are of the forms as they are in double, S but for a factor
# 1 +- 2^-40, and the true u is off by FORMS from theirs at a pixel (small_forms.g); so w may be
# below 0 by a little, where all that is said of it holds for -w. Where S is 0 so are n and u.
# Truncating what is below 0 does not reach above 0, and the true u is not below. The code adds
# TRUNCATIONS to twice `low` and then truncates. The instructions that estimate reciprocals are off
# by less than 3/2 2^-12: RCPPS as Intel and AMD specify it, VRCP14PS by 2^-14.

# Of n, a share of S; of d, a share of T.
factor = (1 + conversion) * (1 + r1) * (1 + r2) * (1 + r3) * (1 + double_r);

# The estimate is (1 + estimate_r) / d, what is left of 1 is -estimate_r (1 + rest_r), and
# (1 + estimate_r) (1 - estimate_r (1 + rest_r)) is this, but for the last rounding.
reciprocal = (1 - estimate_r * estimate_r - estimate_r * rest_r * (1 + estimate_r)) * (1 + sum_r);
# How far the quotient is from u, over S T; in units of 2^-24.
off = (((n_off * inverse - w * d_off) * (1 / (d + d_off * T))) * reciprocal
       + w * inverse * (reciprocal - 1)) * 1b24;

low = error + low_off;
at = u + st * off_st * 1b-24 + forms - low;
lowered = at + at * at_r;

{ |conversion| <= 1b-24 /\ |r1| <= 1b-24 /\ |r2| <= 1b-24 /\ |r3| <= 1b-24 /\ |double_r| <= 1b-48
  /\ |n_off| <= @SUM@ /\ |d_off| <= @SUM@
  /\ |estimate_r| <= 0x1.8p-12 /\ |rest_r| <= 1b-24 /\ |sum_r| <= 1b-24
  /\ w in [0, 1] /\ inverse in [0, 1] /\ d in [1, @MOST_RATIO@] /\ T in [1, @MOST_DEPTH@]
  /\ |off_st| <= @PRODUCT@ /\ |forms| <= @FORMS@
  /\ u / st in [0, 1] /\ st in [1b-80, 1b50]
  /\ error - (@ROUNDINGS@ * 1b-24 * st + @SLACK@) in [-1b-10, 1b-10]
  /\ error in [0, @MOST_ERROR@] /\ |low_off| <= 1b-4
  /\ |at_r| <= 1b-24
  -> |factor - 1| <= @SUM@
  /\ |off| <= @PRODUCT@
  /\ u - lowered >= 0
  /\ int<dn>(lowered) + 2 * error + (@TRUNCATIONS@ - 1) - u >= 0 }

u - lowered -> (error - (@ROUNDINGS@ * 1b-24 * st + @SLACK@))
    + st * 1b-24 * ((@ROUNDINGS@ - off_st * (1 + at_r)) - (at_r * 1b24) * (u / st))
    + (@SLACK@ + low_off - forms * (1 + at_r) + at_r * (error + low_off)) { st <> 0 };
int<dn>(lowered) + 2 * error + (@TRUNCATIONS@ - 1) - u
  -> (error - (@ROUNDINGS@ * 1b-24 * st + @SLACK@))
    + st * 1b-24 * ((@ROUNDINGS@ + off_st * (1 + at_r)) + (at_r * 1b24) * (u / st))
    + (@SLACK@ - low_off + forms * (1 + at_r) - at_r * (error + low_off))
    + ((@TRUNCATIONS@ - 1) + (int<dn>(lowered) - lowered)) { st <> 0 };
