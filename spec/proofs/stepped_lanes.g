#@ -Eprecision=200 -Eno-auto-dichotomy
# Stepped rows: 16.16 lanes along a segment of L pixels between two values that are low by little.
# Unit 2^-16 texel. a, b: what the segment starts and ends with, in double, low by up to `margin`, as
# ProjectiveLanes are; u: the chord of the true values at pixel i = share L, the j-th of its group.
# Claim: lane - STEP_ERROR L / 2^SHIFT <= u <= lane + TRUNCATIONS + margin + STEP_ERROR L / 2^SHIFT.
# Used: src/mapper/stepped.h, src/mapper/tolerance.h.
# By hand: three roundings in double lead from a and b to the step, of the difference, of 1 / L and of
# the product, each a factor 1 + r with |r| <= 2^-53; steps are below 2^30, so whole part and fraction
# are exact.

step = (b - a) * ((1 + r1) * (1 + r2) * (1 + r3)) / L;
step32 = fixed<-@SHIFT@, dn>(step);
js = j * step32;
anchor = int<dn>(a) + (share * L - j) * step32;
lane = int<dn>(anchor) + int<dn>(js);
u = (a + a_lacks) + share * ((b + b_lacks) - (a + a_lacks));
lacks = (1 - share) * a_lacks + share * b_lacks;
floors = (a - int<dn>(a)) + (anchor - int<dn>(anchor)) + (js - int<dn>(js));
off = share * (b - a) * ((1 + r1) * (1 + r2) * (1 + r3) - 1);
slack = @STEP_ERROR@ * 1b-@SHIFT@;

{ L in [1, 65536] /\ share in [0, 1] /\ |b - a| <= 0x1p32
  /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53
  /\ a_lacks in [0, 1024] /\ b_lacks in [0, 1024]
  /\ margin - a_lacks in [0, 1024] /\ margin - b_lacks in [0, 1024]
  -> u - lane + slack * L >= 0 /\ @TRUNCATIONS@ + margin + slack * L - (u - lane) >= 0 }

u - lane + slack * L ->
    floors + lacks - off + L * (slack + share * (step - step32)) { L <> 0 };
@TRUNCATIONS@ + margin + slack * L - (u - lane) ->
    (@TRUNCATIONS@ - floors) + ((1 - share) * (margin - a_lacks) + share * (margin - b_lacks)) + off
    + L * (slack - share * (step - step32)) { L <> 0 };
