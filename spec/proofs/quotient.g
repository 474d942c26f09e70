#@ -Eprecision=200 -Eno-auto-dichotomy
# LaneDivisor::floor_fx32: an estimate in double, then at most one correction by the exact remainder.
# n and d are integers, |n / d| <= 2^TEXEL_BITS texels; unit 2^-LANE_FRACTION texel.
# Claim: the estimate is off by at most ERROR, and n / d - quotient, the remainder over d, lies
# strictly between -1 and 2, so that one correction by one unit makes the floor.
# Used: src/mapper/lane_divisor.h. That the remainder lies in [-2d, 2d) and so fits int128, follows.
# By hand: trunc(x) - (x < 0 ? 1 : 0) lies in [x - 1, x] for every x. A rounding is a factor 1 + r,
# for nothing is less than 2^-80 but 0; a conversion is one of at most CONVERSION, and so it is to
# what is divided by it, for it is off by less than 2.01 2^-53.

off = (1 + n_r) * (1 + d_r) * (1 + r1) * (1 + r2) - 1;
estimate = exact + exact * off;
remainder = exact - quotient;  # over d

{ |n_r| <= @CONVERSION@ /\ |d_r| <= @CONVERSION@ /\ |r1| <= 1b-53 /\ |r2| <= 1b-53
  /\ |exact| <= 1b@QUOTIENT_BITS@
  /\ quotient - estimate in [-1, 0]
  -> |estimate - exact| <= @ERROR@ /\ remainder >= -0.999 /\ remainder <= 1.999 }

estimate - exact -> exact * off;
remainder -> (estimate - quotient) - (estimate - exact);
