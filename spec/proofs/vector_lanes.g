#@ -Eprecision=200 -Eno-auto-dichotomy
# Vector lanes: 16.16 in 32 bits, the floor of a vector's 32.32 anchor and that of i steps from it,
# with one down where the anchor is of two rows; or 8.24, and then the unit is 2^-24 texel for
# 2^-16.
# `lane` is the 32.32 lane of the same pixel, anchor + i step, for which the law of the filter holds
# with `margin`: u - lane = within. Unit 2^-16 texel; 32.32 values are whole multiples of 2^-SHIFT.
# Claim: narrow <= u < narrow + TRUNCATIONS + margin.
# Used: src/mapper/vector/affine_lanes-inl.h, law of the lanes;
# src/mapper/vector/blend_affine_windows-inl.h, of 8.24.
# By hand: the code adds the floor of `margin` and 1 to TRUNCATIONS, which is more. Sums modulo 2^32
# are sums, for |u| < 2^31 in fx16, and lanes of 8.24 are less than 2^31 from their window's origin;
# the floor of steps is taken as their whole units and the floor of the sum of their fractions.

anchor_lacks = 1 - (anchor - int<dn>(anchor));
steps_lack = 1 - (steps - int<dn>(steps));
narrow = int<dn>(anchor) + int<dn>(steps);
u = (anchor + steps) + within;
bound = @TRUNCATIONS@ + margin;

{ anchor_lacks >= 1b-@SHIFT@ /\ steps_lack >= 1b-@SHIFT@ /\ within in [0, 0x1p32]
  /\ margin - within in [0, 0x1p32]
  -> u - narrow >= 0 /\ narrow + bound - u >= 1b-@SHIFT@ }

u - narrow -> (anchor - int<dn>(anchor)) + (steps - int<dn>(steps)) + within;
narrow + bound - u -> anchor_lacks + steps_lack + (@TRUNCATIONS@ - 2) + (margin - within);
