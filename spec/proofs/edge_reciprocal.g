#@ -Eprecision=200 -Eno-auto-dichotomy
# Columns of the vector kernels: a product with a rounded reciprocal, rounded. h is n + 1/2, D the
# divisor of an edge; both n and D are integers, and n / D is at most 2^COLUMN_BITS.
# Claim: the product is off by less than half of the reciprocal of the greatest divisor.
# Used: src/mapper/vector/edge_lines-inl.h.
# By hand: h / D is at least 1 / (2 D) from each whole number, so its floor is that of n / D, and
# so is the floor of what is off by less.

@double = float<ieee_64, ne>;
reciprocal = double(1 / D);
column = double(h * reciprocal);

{ @FIX(h, -1) /\ @FIX(D, 0) /\ D in [1, 1b@DIVISOR_BITS@] /\ |h * (1 / D)| <= 1b@COLUMN_BITS@
  -> |2 * (column - h * (1 / D))| <= 1b-@DIVISOR_BITS@ }

column - h * (1 / D) ->
  (column - h * reciprocal) + (h * (1 / D)) * ((reciprocal - 1 / D) / (1 / D))
  { D <> 0 };
