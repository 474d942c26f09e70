#@ -Eprecision=200 -Eno-auto-dichotomy
# floor_quotient of the vector kernels: a quotient 2^SHIFT n / D in double, the reciprocal rounded,
# then the product and a sum that makes it whole rounded together. n and D are integers; unit 2^-32
# texel where the shift says so.
# Claim: it is off by at most ERROR where it is at most MOST.
# Used: src/mapper/vector/plane_quotient-inl.h: the remainder's sign makes the floor of it.
# By hand: scaling by a power of two does not round. What the code finds below half of MOST is below
# MOST. The remainder is a whole multiple of 2^-SHIFT, below D, so that a fused product and
# subtraction do not round it. Between ERROR below the quotient and as much above it, 1 apart, the
# whole number's floor is itself or the one before, which the sign tells.

@double = float<ieee_64, ne>;
reciprocal = double(1b@SHIFT@ / D);
rounded = double(n * reciprocal + @ROUND_TO_WHOLE@);

{ @FIX(n, 0) /\ @FIX(D, 0) /\ D in [1, 1b@AREA_BITS@] /\ |n * (1b@SHIFT@ / D)| <= @MOST@
  -> |(rounded - @ROUND_TO_WHOLE@) - n * (1b@SHIFT@ / D)| <= @ERROR@ }

(rounded - @ROUND_TO_WHOLE@) - n * (1b@SHIFT@ / D) ->
  (rounded - (n * reciprocal + @ROUND_TO_WHOLE@)) + (n * (1b@SHIFT@ / D)) * ((reciprocal - 1b@SHIFT@ / D) / (1b@SHIFT@ / D))
  { D <> 0 };
