#@ -Eprecision=200 -Eno-auto-dichotomy
# Coarse lanes: 16 bits of which the highest, BITS of them, are a texel of a window; so the unit is
# 2^BITS of those of a lane of 16.16, which is the sum of an anchor and an offset. Both are floored.
#   within   what u is more than that sum, less than `lack`
# Unit that of the coarse lane; anchor and offset are whole multiples of 2^-BITS.
# Claim: coarse <= u <= coarse + TRUNCATIONS (1 - 2^-BITS) + lack, and u is less, as within is.
# Used: src/mapper/vector/coarse_lanes-inl.h, coarse_lack in src/mapper/vector/kernel.h.
# By hand: the value's texel begins at a whole unit, and so less than the bound above the lane: that
# many whole units at most is what the code adds. Sums modulo 2^16 are sums where the window holds the
# texels, and those that reach beyond it change the texel's bits.

anchor_lacks = 1 - (anchor - int<dn>(anchor));
offset_lacks = 1 - (offset - int<dn>(offset));
coarse = int<dn>(anchor) + int<dn>(offset);
u = (anchor + offset) + within;
bound = @TRUNCATIONS@ * (1 - 1b-@BITS@) + lack;

{ anchor_lacks >= 1b-@BITS@ /\ offset_lacks >= 1b-@BITS@ /\ within in [0, 0x1p32]
  /\ lack - within in [0, 0x1p32]
  -> u - coarse >= 0 /\ coarse + bound - u >= 0 }

u - coarse -> (anchor - int<dn>(anchor)) + (offset - int<dn>(offset)) + within;
coarse + bound - u -> (anchor_lacks - 1b-@BITS@) + (offset_lacks - 1b-@BITS@)
    + (@TRUNCATIONS@ - 2) * (1 - 1b-@BITS@) + (lack - within);
