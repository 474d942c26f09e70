#@ -Eprecision=200 -Eno-auto-dichotomy
# Law ORACLE, warpPerspective: how far the U that OpenCV rounds is from the exact U = X / W.
#   U' = X' (1 / W')    X' = M0 x0 + M1 y + M2 + M0 x1    W' likewise    x = x0 + x1, in double
# Claim: off by at most FACTOR 2^-53 (TERMS a + V (TERMS b + QUOTIENT)), where a = S_X / |W|,
# b = S_W / |W|, S is the sum of absolute terms, and V = |u| + 1 >= |U|; wherever that is at most
# 1/2, as it is where the law calls a pixel decided: no number is further from an integer.
# Used: spec/oracle_opencv.cpp, is_decided_projective; spec/README.md, law ORACLE.
# By hand: each rounding is a factor 1 + r, |r| <= 2^-53; truncating an entry of the exact matrix is
# one of 1 + c, -2^-52 <= c <= 0. A term goes through `term` at most, so X' = X + x S_X where |x| is
# at most its distance from 1, and W' = W (1 + w b), the same of w. The law computes its bound in
# double, in less than 32 roundings: the factor `law_rounding`. As V >= 1, `part` is no more than
# the bound.

term = (1 + c) * (1 + r0) * (1 + r1) * (1 + r2) * (1 + r3);  # entry, product, three sums
divided = (1 + r4) * (1 + r5);                               # reciprocal and its product
near = 1 + w * b;                                            # W' / W
U = s * V;                                                   # |s| <= 1
off = (U + x * a) * divided / near - U;                      # X' / W is U + x a

unit = @FACTOR@ * 1b-53 * law_rounding;
bound = unit * (@TERMS@ * a + V * (@TERMS@ * b + @QUOTIENT@));
part = unit * @TERMS@ * b;

{ c in [-1b-52, 0] /\ |r0| <= 1b-53 /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53
  /\ |r4| <= 1b-53 /\ |r5| <= 1b-53 /\ |x| <= 0x1.81p-51 /\ |w| <= 0x1.81p-51
  /\ a in [0, 1b60] /\ V in [1, 1b20] /\ |s| <= 1 /\ part in [0, 0.5]
  /\ law_rounding in [0x0.fffffffffp0, 0x1.000000001p0]
  -> |term - 1| <= 0x1.81p-51 /\ near >= 0.5 /\ bound - off >= 0 /\ bound + off >= 0 }

w * b -> (w / unit) * part / @TERMS@ { unit <> 0 };
bound - off -> (a * (unit * @TERMS@ * near - x * divided)
    + V * (b * (unit * @TERMS@ * near + s * w)
           + (unit * @QUOTIENT@ * near - s * (divided - 1)))) / near { near <> 0 };
bound + off -> (a * (unit * @TERMS@ * near + x * divided)
    + V * (b * (unit * @TERMS@ * near - s * w)
           + (unit * @QUOTIENT@ * near + s * (divided - 1)))) / near { near <> 0 };
