#@ -Eprecision=200 -Eno-auto-dichotomy
# AffineLanes: start and step are floors, so that a lane is low, and by less than its margin.
# u at pixel i of a span is start + i step, exactly; unit 2^-32 texel.
# Claim: lane <= u < lane + PER_PIXEL width at each pixel i of a span of `width` pixels.
# Used: src/mapper/lanes.h, the law of the filter.
# By hand: start and step are quotients of integers by a denominator of at most 2^DENOMINATOR_BITS,
# so their fractions lack that much to 1 at least. This is what makes the "<" strict.

lane = int<dn>(start) + i * int<dn>(step);
u = start + i * step;
width = i + 1 + further;  # i is a pixel of the span
margin = @PER_PIXEL@ * width;
start_lacks = 1 - (start - int<dn>(start));
step_lacks = 1 - (step - int<dn>(step));

{ i in [0, 0x1p16] /\ further in [0, 0x1p16]
  /\ start_lacks >= 1b-@DENOMINATOR_BITS@ /\ step_lacks >= 1b-@DENOMINATOR_BITS@
  -> u - lane >= 0 /\ lane + margin - u >= 1b-@DENOMINATOR_BITS@ }

u - lane -> (start - int<dn>(start)) + i * (step - int<dn>(step));
lane + margin - u -> (start_lacks + (@PER_PIXEL@ - 1)) + i * (step_lacks + (@PER_PIXEL@ - 1))
                   + @PER_PIXEL@ * further;
