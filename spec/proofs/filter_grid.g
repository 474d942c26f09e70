#@ -Eno-auto-dichotomy
# The coordinate stage of the filters: which lanes already show the point on the grid of 1/256 texel.
# Unit 2^-32 texel, a step of the grid being 2^GRID_FRACTION; lane = point 2^GRID_FRACTION + fraction
# in integers, and lane <= u < lane + margin, no margin being above WIDEST.
# Claim: where fraction + margin is below a step, the floor of u is the lane's point; elsewhere it is
# that or one of the next three.
# Used: src/mapper/filter_point.h, is_near_grid and decide_fx8.
# By hand: u < lane + margin is written u <= lane + margin here, and "below" an integer as "at most
# one less", which is as good: fraction and margin are integers.

step = 1b@GRID_FRACTION@;
lane = point * step + fraction;
room = step - 1 - margin - fraction;  # >= 0 where the lane is no near-tie
beyond = u - point * step;            # the floor of u is the point where this is in [0, step)

{ fraction in [0, 0x1p40] /\ step - 1 - fraction >= 0 /\ margin in [1, @WIDEST@]
  /\ u - lane in [0, 0x1p40] /\ lane + margin - u >= 0
  -> beyond >= 0 /\ 4 * step - 1 - beyond >= 0 /\ (room >= 0 -> step - 1 - beyond >= 0) }

beyond -> fraction + (u - lane);
step - 1 - beyond -> room + (lane + margin - u);
4 * step - 1 - beyond -> (step - 1 - fraction) + (3 * step - margin) + (lane + margin - u);
