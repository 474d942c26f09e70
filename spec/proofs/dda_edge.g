#@ -Eno-auto-dichotomy
# How far a texture coordinate stepped down an edge is from the exact one; unit 1/65536 texel.
#   abrash56  u0 + n step                 against  u0 + n D / h
#   abrash57  u0 + (step >> 1) + n step   against  u0 + (n + 1/2) D / h
# An edge of h rows along which u changes by D, after n steps of trunc(D / h); all integers.
# Claim: off by at most ROW n in the first, ROW n + PRESTEP in the second.
# Used: spec/dda_bounds.h, by spec/reach.cpp.

step = int<zr>(D / h);
half = int<dn>(step * 0.5);  # step >> 1
error_56 = n * step - n * (D / h);
error_57 = half + n * step - (n + 0.5) * (D / h);

most_56 = @ROW@ * n;
most_57 = @ROW@ * n + @PRESTEP@;
cut = step - D / h;
start = (half - step * 0.5) + cut * 0.5;

{ n in [0, 0x1p16] /\ h in [1, 0x1p16]
  -> most_56 - error_56 >= 0 /\ most_56 + error_56 >= 0
  /\ most_57 - error_57 >= 0 /\ most_57 + error_57 >= 0 }

most_56 - error_56 -> n * (@ROW@ - cut) { h <> 0 };
most_56 + error_56 -> n * (@ROW@ + cut) { h <> 0 };
most_57 - error_57 -> n * (@ROW@ - cut) + (@PRESTEP@ - start) { h <> 0 };
most_57 + error_57 -> n * (@ROW@ + cut) + (@PRESTEP@ + start) { h <> 0 };
