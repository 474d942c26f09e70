# selvage_snap rounds to the nearest integer, halves upward, with
#   fraction = value - floor(value);  fraction >= 1/2 ? floor(value) + 1 : floor(value)
# in double. The fraction is not always exact: that of -2^-60 is no double.
# Claim: yet the comparison comes out as that of the exact fraction, and floor(value) + 1 is exact,
# for every |value| <= 2^FRACTION_BITS. Doubles beyond are integers, and stay as they are.
# Used: src/snap.cpp, round_half_up.
# By hand: floor of a double is one; where floor(value) is 0 the fraction is the value itself.

@double = float<ieee_64, ne>;
value = double(any);
below = int<dn>(value);
fraction = value - below;

{ (value in [1, 1b@FRACTION_BITS@] -> double(fraction) - fraction in [0, 0])
  /\ (value in [-1b@FRACTION_BITS@, -1] -> double(fraction) - fraction in [0, 0])
  /\ (value in [0, 0x1.fffffffffffffp-1] -> below in [0, 0])
  /\ (value in [-1, -0.5] -> double(fraction) - fraction in [0, 0])
  /\ (value in [-0.5, -1b-1074] -> fraction >= 0.5 /\ double(fraction) >= 0.5)
  /\ (value in [-1b@FRACTION_BITS@, 1b@FRACTION_BITS@]
      -> double(below + 1) - (below + 1) in [0, 0]) }
