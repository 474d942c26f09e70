#@ -Eprecision=200 -Eno-auto-dichotomy
# The mean of a box that is looked up in sums: a product with a rounded reciprocal, rounded. S is the
# sum and 1/4, D the area, at most 2^AREA_BITS (1/256 texel)^2; sum / D is at most 255.
# Claim: S is a double, and the product is off by an eighth of the reciprocal of the greatest area at
# most.
# Used: src/mapper/vector/box_sums-inl.h.
# By hand: sum / D is a half, or at least 1 / (2 D) from each; with 1 / (4 D) more it is at least that
# from each, so that what is off by less is on the same side.

@double = float<ieee_64, ne>;
reciprocal = double(1 / D);
mean = double(S * reciprocal);

{ @FIX(S, -2) /\ S in [0x1p-2, 256b@AREA_BITS@] /\ @FIX(D, 0) /\ D in [1, 1b@AREA_BITS@]
  /\ |S * (1 / D)| <= 256
  -> double(S) - S in [0, 0] /\ |8 * (mean - S * (1 / D))| <= 1b-@AREA_BITS@ }

mean - S * (1 / D) ->
  (mean - S * reciprocal) + (S * (1 / D)) * ((reciprocal - 1 / D) / (1 / D))
  { D <> 0 };
