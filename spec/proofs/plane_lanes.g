#@ -Eprecision=200 -Eno-auto-dichotomy
# Plane::lanes: the start and both gradients are floors, so that a lane is low, and by less than its
# margin, wherever its pixel lies right of and below the start: i columns and j rows of steps.
# u there is start + i x + j y, exactly; unit 2^-32 texel.
# Claim: lane <= u < lane + PER_STEP (i + j + further) with `further` >= 1.
# Used: src/mapper/plane.cpp, the law of the filter.
# By hand: the three are quotients of integers by a doubled area below 2^AREA_BITS, so their
# fractions lack that much to 1 at least. This is what makes the "<" strict.

lane = int<dn>(start) + i * int<dn>(x) + j * int<dn>(y);
u = start + i * x + j * y;
margin = @PER_STEP@ * (i + j + 1 + further);
start_lacks = 1 - (start - int<dn>(start));
x_lacks = 1 - (x - int<dn>(x));
y_lacks = 1 - (y - int<dn>(y));

{ i in [0, 0x1p16] /\ j in [0, 0x1p16] /\ further in [0, 0x1p16]
  /\ start_lacks >= 1b-@AREA_BITS@ /\ x_lacks >= 1b-@AREA_BITS@ /\ y_lacks >= 1b-@AREA_BITS@
  -> u - lane >= 0 /\ lane + margin - u >= 1b-@AREA_BITS@ }

u - lane -> (start - int<dn>(start)) + i * (x - int<dn>(x)) + j * (y - int<dn>(y));
lane + margin - u -> (start_lacks + (@PER_STEP@ - 1)) + i * (x_lacks + (@PER_STEP@ - 1))
                   + j * (y_lacks + (@PER_STEP@ - 1)) + @PER_STEP@ * further;
