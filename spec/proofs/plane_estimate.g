#@ -Eprecision=200 -Eno-auto-dichotomy
# find_lanes_scalar: estimates in double of a step, 2^(FRACTION + SUBPIXEL_BITS) A / D, and of the
# start, 2^FRACTION (dx A + dy B) / D. A, B, dx, dy and D are integers; unit 2^-32 texel.
# Claim: both are off by at most ERROR where every term is at most MOST.
# Used: src/mapper/plane_lanes.cpp: what is left to correct by the exact remainder.
# By hand: scaling by a power of two does not round. Terms that the code finds below MOST are below MOST (1 + 2^-50), and there the claim has
# room; the code bounds the sum of all four, not each.

@double = float<ieee_64, ne>;
texel = double(1b@FRACTION@ / double(D));
step = double(double(A) * texel);  # 2^SUBPIXEL_BITS times this
rise_x = double(double(double(dx) * double(A)) * texel);
rise_y = double(double(double(dy) * double(B)) * texel);
rise = double(rise_x + rise_y);

exact_step = A * (1b@FRACTION@ / D);
exact_x = dx * A * (1b@FRACTION@ / D);
exact_y = dy * B * (1b@FRACTION@ / D);

{ @FIX(A, 0) /\ @FIX(B, 0) /\ @FIX(D, 0) /\ @FIX(dx, 0) /\ @FIX(dy, 0)
  /\ D in [1, 1b@AREA_BITS@] /\ |dx| <= 1b@POSITION_BITS@ /\ |dy| <= 1b@POSITION_BITS@
  /\ |exact_step * 1b@SUBPIXEL_BITS@| <= @MOST@ /\ |exact_x| <= @MOST@ /\ |exact_y| <= @MOST@
  -> |(step - exact_step) * 1b@SUBPIXEL_BITS@| <= @ERROR@ /\ |rise - (exact_x + exact_y)| <= @ERROR@ }

rise - (exact_x + exact_y) -> (rise - (rise_x + rise_y)) + (rise_x - exact_x) + (rise_y - exact_y)
                           { D <> 0 };
