#@ -Eprecision=200 -Eno-auto-dichotomy
# Anchored lanes: 16.16 in 32 bits, counted from the first of some pixels, the anchor.
#   u0, d0   the true value and denominator there; u0 is estimated in double, off by at most `error`
#   x        i turn, by how much the denominator changes to the i-th pixel, as a share of d0
#   delta    i rise / (1 + x), by how much u does, at most `walk`
# Unit 2^-16 texel.
# Claims: what is added in single precision is off by less than ROUNDINGS 2^-24 of the walk, so that
# with `low`, twice the error, those roundings and SLACK, lane <= u < lane + 2 low + TRUNCATIONS - 1.
# Used: src/mapper/vector/projective_anchors-inl.h, projective_pairs-inl.h there; are_anchored and
# are_pairs_anchored in src/mapper/vector/kernel.h.
# By hand: a rounding is a factor 1 + r, and i is exact. An anchor that is off by e is off by
# e (1 - i d' / d_i) = e / (1 + x) at the i-th pixel. `error` is larger than it has to be by more than
# what turns are rounded by. d0 is at least 1/2 in units of the least denominator, and off by less
# than 2^-32, a share of the turn. The gradients in double are off by less than 2^-48 of |n'| + |u d'|
# over d0: as |u| < 2^31 and |x| <= 1/2, that is less than 2^-48 (2 walk + 2^31) < 2^-16 at the i-th
# pixel; 2^-12 is allowed. Products and sums may be fused: then some factor is 1. A float between 2^23
# and 2^24 is a whole number, so that the last sum rounds to the nearest, be it that of the walk and
# 3 2^22 or of the walk and a whole number there. The code adds the floor of 2 low to TRUNCATIONS,
# which is more.

@double = float<ieee_64, ne>;

# What is added, over what it should be, less 1; in units of 2^-24.
# (1 + x (1 + turn_r) (1 + product_r)) (1 + sum_r) = (1 + x) (1 + ratio_r)
ratio_r = x * (1 / (1 + x)) * ((1 + turn_r) * (1 + product_r) - 1) * (1 + sum_r) + sum_r;
off = ((1 + rise_r) * (1 + division_r) * (1 + share_r) / (1 + ratio_r) - 1) * 1b24;

low = 2 * error + @ROUNDINGS@ * 1b-24 * walk + @SLACK@;
lowered double= u0_double - low_double;
anchor = int<dn>(lowered);
rounded = lowered - (u0_double - low_double);
low_r = low_double - low;
half = whole - added;
lane = anchor + whole;
# What the anchor's error is at the pixel; what is added, in units of 2^-24 of the walk.
at_anchor = error * anchor_off / (1 + x);
u = u0_double + at_anchor + added + added_off * 1b-24 * walk + gradients_off;

{ |x| <= @MOST_TURN@
  /\ |turn_r| <= 0x1.01p-24 /\ |rise_r| <= 1b-24
  /\ |product_r| <= 1b-24 /\ |sum_r| <= 1b-24 /\ |division_r| <= 1b-24 /\ |share_r| <= 1b-24
  /\ |gradients_off| <= 1b-12
  /\ walk in [0, @MOST_WALK@] /\ error in [0, 4]
  /\ |u0_double| <= 1b@LANE_BITS@ /\ |low_r| <= 1b-20
  /\ |half| <= 0.5
  /\ |anchor_off| <= 1
  /\ |added_off| <= @ROUNDINGS@
  -> |off| <= @ROUNDINGS@
  /\ u - lane >= 0 /\ lane + 2 * low + (@TRUNCATIONS@ - 1) - u >= 0 }

u - lane -> (2 * error + at_anchor) + (@ROUNDINGS@ + added_off) * (1b-24 * walk)
    + (@SLACK@ + low_r - rounded - half + gradients_off) + (lowered - anchor) { 1 + x <> 0 };
lane + 2 * low + (@TRUNCATIONS@ - 1) - u
  -> (2 * error - at_anchor) + (@ROUNDINGS@ - added_off) * (1b-24 * walk)
    + (@SLACK@ - low_r + rounded + half - gradients_off) + (@TRUNCATIONS@ - 1 - (lowered - anchor)) { 1 + x <> 0 };
2 * error + at_anchor -> error * (2 + anchor_off / (1 + x)) { 1 + x <> 0 };
2 * error - at_anchor -> error * (2 - anchor_off / (1 + x)) { 1 + x <> 0 };
