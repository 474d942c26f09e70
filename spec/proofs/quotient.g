#@ -Eprecision=200 -Eno-auto-dichotomy
# Divisor::floor_fx32: an estimate in double, then at most one correction by the exact remainder.
# n and d are integers, |n / d| <= 2^TEXEL_BITS texels; unit 2^-LANE_FRACTION texel.
# Claim: the estimate is off by at most ERROR, and n / d - quotient, the remainder over d, lies
# strictly between -1 and 2, so that one correction by one unit makes the floor.
# Used: src/mapper/lanes.cpp. That the remainder lies in [-2d, 2d) and so fits int128, follows.
# By hand: trunc(x) - (x < 0 ? 1 : 0) lies in [x - 1, x] for every x.

@double = float<ieee_64, ne>;
estimate = double(double(n) * double(1b@LANE_FRACTION@ / double(d)));
exact = n * (1b@LANE_FRACTION@ / d);
remainder = exact - quotient;  # over d

{ @FIX(n, 0) /\ @FIX(d, 0) /\ d in [1, 1b@DENOMINATOR_BITS@]
  /\ |exact| <= 1b@QUOTIENT_BITS@
  /\ quotient - estimate in [-1, 0]
  -> |estimate - exact| <= @ERROR@ /\ remainder >= -0.999 /\ remainder <= 1.999 }

remainder -> (estimate - quotient) - (estimate - exact) { d <> 0 };
