#@ -Eprecision=200 -Eno-auto-dichotomy
# Law ORACLE, warpAffine: how far the texel that OpenCV rounds to is from the exact U = u - 1/2.
#   texel = (rn(1024 a) + rn(1024 b)) / 1024    a = M0 x    b = M1 y + M2    in double
# Claim: off by at most ROUNDING + ROUNDINGS 2^-53 sum, where sum is |M0 x| + |M1 y| + |M2| as the
# law computes it, in double too. So where u is further than that from an integer, the texel is
# floor u.
# Used: spec/oracle_opencv.cpp, is_decided_affine; spec/README.md, law ORACLE.
# By hand: rounding to double is a factor 1 + r, |r| <= 2^-53, and so is no rounding (a fused
# product, a 0); truncating an entry of the exact matrix is a factor 1 + c, -2^-52 <= c <= 0: all
# numbers are 0 or far from the ends of the exponents. Signs are split off: M0 x = s0 t0, t0 >= 0,
# and so on. A distance in double above the margin rounded to double is no less than the margin.
# The law's sum is below half of LARGEST_TERM, so no exact term is above it, and 32-bit integers
# hold the sums of 1/1024 texel, which are little above 2^10 times the law's.

A0 = (1 + c0) * (1 + r0);
A1 = (1 + c1) * (1 + r1);
A2 = 1 + c2;
a = s0 * (t0 * A0);
b = (s1 * (t1 * A1) + s2 * (t2 * A2)) * (1 + r2);
sum = ((t0 * A0 + t1 * A1) * (1 + r3) + t2 * A2) * (1 + r4);

U = s0 * t0 + s1 * t1 + s2 * t2;
off = (int<ne>(a * 1024) + int<ne>(b * 1024)) / 1024 - U;
margin = @ROUNDING@ + @ROUNDINGS@ * 1b-53 * sum;
W0 = @ROUNDINGS@ * 1b-53 * A0 * (1 + r3) * (1 + r4);
W1 = @ROUNDINGS@ * 1b-53 * A1 * (1 + r3) * (1 + r4);
W2 = @ROUNDINGS@ * 1b-53 * A2 * (1 + r4);
cut_a = (int<ne>(a * 1024) - a * 1024) / 1024;
cut_b = (int<ne>(b * 1024) - b * 1024) / 1024;

{ t0 in [0, @LARGEST_TERM@] /\ t1 in [0, @LARGEST_TERM@] /\ t2 in [0, @LARGEST_TERM@]
  /\ |s0| <= 1 /\ |s1| <= 1 /\ |s2| <= 1
  /\ c0 in [-1b-52, 0] /\ c1 in [-1b-52, 0] /\ c2 in [-1b-52, 0]
  /\ |r0| <= 1b-53 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53 /\ |r4| <= 1b-53
  -> margin - off >= 0 /\ margin + off >= 0 }

margin - off -> (@ROUNDING@ - cut_a - cut_b) + t0 * (W0 - s0 * (A0 - 1))
              + t1 * (W1 - s1 * (A1 * (1 + r2) - 1)) + t2 * (W2 - s2 * (A2 * (1 + r2) - 1));
margin + off -> (@ROUNDING@ + cut_a + cut_b) + t0 * (W0 + s0 * (A0 - 1))
              + t1 * (W1 + s1 * (A1 * (1 + r2) - 1)) + t2 * (W2 + s2 * (A2 * (1 + r2) - 1));
