#@ -Eprecision=200 -Eno-auto-dichotomy
# The forms of small triangles in perspective, u q over D, in double.
#   w        u q at the first vertex; a, b: its changes to the other two
#   x, y     places, from the first vertex: of the other two, of the part's first pixel, of a pixel
#            from there
#   D        the doubled area
# Unit 2^-16 texel times the greatest q.
# Claim: a form is off by at most FORM at a pixel.
# Used: src/mapper/vector/small_projective-inl.h, small_projective_exact-inl.h.
# By hand: roundings do not depend on the unit, and whole numbers of up to 53 bits are exact. u q,
# its changes, D and q's form are such. Fused products are not rounded before. Where texels are found
# in double the last two sums are rounded as well, 1 over q's form, and the quotient: that is less
# than 2^-5 of the unit over D, of which the code leaves half.

@double = float<ieee_64, ne>;

along_x = double(a * y3 - double(b * y2));
along_y = double(b * x2 - double(a * x3));
start = double(w * D + double(dx * along_x + double(dy * along_y)));

exact_x = a * y3 - b * y2;
exact_y = b * x2 - a * x3;
off = (start + (right * along_x + down * along_y))
      - (w * D + (dx * exact_x + dy * exact_y) + (right * exact_x + down * exact_y));

{ |w| <= 1b@TEXEL_BITS@ /\ |a| <= 1b@TEXEL_BITS@ /\ |b| <= 1b@TEXEL_BITS@
  /\ |x2| <= 1b@PLACE_BITS@ /\ |x3| <= 1b@PLACE_BITS@ /\ |y2| <= 1b@PLACE_BITS@ /\ |y3| <= 1b@PLACE_BITS@
  /\ |dx| <= 1b@PLACE_BITS@ /\ |dy| <= 1b@PLACE_BITS@ /\ |right| <= 1b@PLACE_BITS@ /\ |down| <= 1b@PLACE_BITS@
  /\ |D| <= 1b@AREA_BITS@
  -> |off| <= @FORM@ }
