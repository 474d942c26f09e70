#@ -Eno-auto-dichotomy
# The filter of the row kernel: which lanes already show the texel. Unit 2^-LANE_FRACTION texel.
# lane = texel 2^LANE_FRACTION + fraction in integers, and lane <= u < lane + margin by the law of
# the filter (affine_lanes.g, projective_lanes.g), no margin being above WIDEST.
# Claim: where fraction + margin is below 2^LANE_FRACTION, floor u is the lane's texel; elsewhere it
# is that or the next one, so that one comparison decides.
# Used: src/mapper/texel_index.h, is_near_tie and decide.
# By hand: u < lane + margin is written u <= lane + margin here, and "below" an integer as "at most
# one less", which is as good: fraction and margin are integers.

one = 1b@LANE_FRACTION@;
lane = texel * one + fraction;
room = one - 1 - margin - fraction;  # >= 0 where the lane is no near-tie
beyond = u - texel * one;            # floor u is texel where this is in [0, one)

{ fraction in [0, 0x1p40] /\ one - 1 - fraction >= 0 /\ margin in [1, @WIDEST@]
  /\ u - lane in [0, 0x1p40] /\ lane + margin - u >= 0
  -> beyond >= 0 /\ 2 * one - 1 - beyond >= 0 /\ (room >= 0 -> one - 1 - beyond >= 0) }

beyond -> fraction + (u - lane);
one - 1 - beyond -> room + (lane + margin - u);
2 * one - 1 - beyond -> (one - 1 - fraction) + (one - margin) + (lane + margin - u);
