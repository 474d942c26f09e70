#@ -Eprecision=200 -Eno-auto-dichotomy
# The numerator of u at a pixel of a span fits 127 bits and a sign, and so does what it is compared
# with, D (s + 1): denominator times texel column. Heights and width are at most LONGEST, 1/256 px.
#   N = U_L w_L + U_R w_R    where |U| <= 2^UQ_BITS h and h_L w_L + h_R w_R = h_L h_R width
#   D = q h_L h_R width 2^TEXEL_FRACTION    where q, a mean of the vertices', is at most 2^Q_BITS
# Claim: |N| < 2^NUMERATOR_BITS and |D (s + 1)| < 2^NUMERATOR_BITS.
# Used: src/mapper/number.h, span.h; spec/README.md, section 8.2.
# By hand: that the two weighted heights add up so. (The right one is area - left here.)

U_most = 1b@UQ_BITS@;
area = h_L * h_R * width;
N = a * left + b * (area - left);  # a, b: U over h
D = q * area * 1b@TEXEL_FRACTION@;

{ |a| <= 1b@UQ_BITS@ /\ |b| <= 1b@UQ_BITS@ /\ left in [0, 0x1p100] /\ area - left >= 0
  /\ h_L in [1, @LONGEST@] /\ h_R in [1, @LONGEST@] /\ width in [0, @LONGEST@]
  /\ q in [1, 1b@Q_BITS@] /\ |s + 1| <= 1b@COLUMN_BITS@
  -> 1b@NUMERATOR_BITS@ - N >= 1 /\ 1b@NUMERATOR_BITS@ + N >= 1
  /\ 1b@NUMERATOR_BITS@ - D * (s + 1) >= 1 /\ 1b@NUMERATOR_BITS@ + D * (s + 1) >= 1 }

1b@NUMERATOR_BITS@ - N -> 1b@NUMERATOR_BITS@ - U_most * area
                        + ((U_most - a) * left + (U_most - b) * (area - left));
1b@NUMERATOR_BITS@ + N -> 1b@NUMERATOR_BITS@ - U_most * area
                        + ((U_most + a) * left + (U_most + b) * (area - left));
