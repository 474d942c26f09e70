#@ -Eprecision=200 -Eno-auto-dichotomy
# Footprint::side_fx8: the estimate of T / D^2, T = |A - B| + |E - F|, from four products of two
# integers each; M = |A| + |B| + |E| + |F|.
# X D stands for A and E, N Y for B and F; p and g for the magnitudes of the two differences in
# double, P and G for the exact ones, x1 to x4 for the magnitudes of the products, X1 to X4 for the
# exact ones.
# Claim: a product is off by at most 6.01 units of 2^-53, a difference by 14.01; and given that, the
# estimate with ROUNDINGS 2^-53 of the magnitudes taken off is not above T / D^2, with as much
# put on not below it.
# Used: src/mapper/footprint.cpp.
# By hand: scaled by powers of two, which do not round, so that M and D are in [1, 2]; with M = 0
# all is 0. The integers have fewer than 400 bits below their scaled ones. ||x| - |y|| <= |x - y|.

@double = float<ieee_64, ne>;
a = double(double(X) * double(D));
b = double(double(N) * double(Y));
difference = double(a - b);

T = P + G;
M = X1 + X2 + X3 + X4;
sum = double(p + g);
magnitude = double(double(double(x1 + x2) + x3) + x4);
slack = double(magnitude * (@ROUNDINGS@ * 1b-53));
d = double(D);
square = double(d * d);
q = double(sum - slack);
r = double(sum + slack);
low = double(q / square);
high = double(r / square);

{ @FIX(X, -400) /\ @FIX(D, -400) /\ @FIX(N, -400) /\ @FIX(Y, -400)
  /\ D in [1, 2] /\ |X * D| <= 2 /\ |N * Y| <= 2 /\ |X * D - N * Y| <= 2
  /\ @FIX(p, -1000) /\ @FIX(g, -1000) /\ P in [0, 2] /\ G in [0, 2] /\ T in [0, 2]
  /\ |(p - P) * 1b53| <= 14.01 /\ |(g - G) * 1b53| <= 14.01
  /\ @FIX(x1, -1000) /\ @FIX(x2, -1000) /\ @FIX(x3, -1000) /\ @FIX(x4, -1000)
  /\ X1 in [0, 2] /\ X2 in [0, 2] /\ X3 in [0, 2] /\ X4 in [0, 2] /\ M in [1, 2]
  /\ X1 + X2 in [0, 2] /\ X1 + X2 + X3 in [0, 2]
  /\ |(x1 - X1) * 1b53| <= 6.01 /\ |(x2 - X2) * 1b53| <= 6.01
  /\ |(x3 - X3) * 1b53| <= 6.01 /\ |(x4 - X4) * 1b53| <= 6.01
  -> |(a - X * D) * 1b53| <= 6.01 /\ |(b - N * Y) * 1b53| <= 6.01
  /\ |(difference - (X * D - N * Y)) * 1b53| <= 14.01
  /\ (T / (D * D) - low) * (D * D) >= 0 /\ (high - T / (D * D)) * (D * D) >= 0 }

difference - (X * D - N * Y) -> (difference - (a - b)) + (a - X * D) - (b - N * Y);
a - b -> (X * D - N * Y) + (a - X * D) - (b - N * Y);
p + g -> T + (p - P) + (g - G);
sum -> T + (sum - (p + g)) + (p - P) + (g - G);
magnitude -> M + (magnitude - (double(double(x1 + x2) + x3) + x4))
               + (double(double(x1 + x2) + x3) - (double(x1 + x2) + x3))
               + (double(x1 + x2) - (x1 + x2)) + (x1 - X1) + (x2 - X2) + (x3 - X3) + (x4 - X4);
(T / (D * D) - low) * (D * D) -> (sum - slack - q) - (sum - T) + slack
    + q * ((square - D * D) / square) + (q / square - low) * (D * D) { D <> 0, square <> 0 };
(high - T / (D * D)) * (D * D) -> (r - (sum + slack)) + (sum - T) + slack
    - r * ((square - D * D) / square) + (high - r / square) * (D * D) { D <> 0, square <> 0 };
sum - T -> (sum - (p + g)) + (p - P) + (g - G);
