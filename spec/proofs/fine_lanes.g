#@ -Eprecision=200 -Eno-auto-dichotomy
# Lanes of the rows of one window: 8.24 in 32 bits, the floor of a 32.32 anchor, those of a step right
# and of one down, taken i and j times, and that of the steps of a vector's lanes from there.
# The 32.32 lane of the same pixel is anchor + i right + j down + steps, for which the law of the
# filter holds with `margin`: u - lane = within. Unit 2^-24 texel; 32.32 values are whole multiples
# of 2^-SHIFT.
# Claim: fine <= u < fine + TRUNCATIONS + i + j + margin.
# Used: fine_lack_fx24, whose steps are i + j at least.
# By hand: the code adds the floor of `margin` and 1, which is more. Sums modulo 2^32 are sums, for
# the texels of a window are less than 2^31 from its origin; the floor of a vector's steps is taken
# as so many whole ones and the floor of their fractions.

fine = int<dn>(anchor) + i * int<dn>(right) + j * int<dn>(down) + int<dn>(steps);
u = (anchor + i * right + j * down + steps) + within;
bound = @TRUNCATIONS@ + i + j + margin;
anchor_lacks = 1 - (anchor - int<dn>(anchor));
right_lacks = 1 - (right - int<dn>(right));
down_lacks = 1 - (down - int<dn>(down));
steps_lack = 1 - (steps - int<dn>(steps));

{ i in [0, 0x1p16] /\ j in [0, 0x1p16]
  /\ anchor_lacks >= 1b-@SHIFT@ /\ right_lacks >= 1b-@SHIFT@ /\ down_lacks >= 1b-@SHIFT@
  /\ steps_lack >= 1b-@SHIFT@ /\ within in [0, 0x1p32] /\ margin - within in [0, 0x1p32]
  -> u - fine >= 0 /\ fine + bound - u >= 1b-@SHIFT@ }

u - fine -> (anchor - int<dn>(anchor)) + i * (right - int<dn>(right)) + j * (down - int<dn>(down))
          + (steps - int<dn>(steps)) + within;
fine + bound - u -> anchor_lacks + steps_lack + (@TRUNCATIONS@ - 2) + i * right_lacks
                  + j * down_lacks + (margin - within);
