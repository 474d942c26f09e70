#@ -Eprecision=200 -Eno-auto-dichotomy
# AffineSlab::find_lanes: rows under maps of their own, by estimates in double; unit 2^-32 texel.
# Of an edge, u times its height is p = first + down, over U times the height; the other one's is o.
# t and 1 - t: the edges' weights times their heights over the width W, which is 1 here; both are
# within [0, 1] at a pixel between the edges. g = 256 / width, at most 1 where there are two pixels.
#   u = p t + o (1 - t)        step = (o - p) g        over U = 2^LANE_BITS >= |u|
# Claims: both estimates are off by at most ERROR; lowered by SLACK and floored, or one less
# than that where they are whole, they are low, and the lane by less than PER_PIXEL a pixel:
# lane <= u < lane + PER_PIXEL width at each pixel of a span of `width` pixels.
# Used: src/mapper/affine_slab.h, the law of the filter.
# By hand: x, the weights and the heights are exact in double; scaling by powers of two is exact, and
# nothing is less than 2^-80 but 0. Rows lie within the edge: |first| <= 1 and |down| <= 2.

p = first_p + down_p;
o = first_o + down_o;
p_double = (first_p * (1 + p1) + down_p * (1 + p2)) * (1 + p3);
o_double = (first_o * (1 + o1) + down_o * (1 + o2)) * (1 + o3);
p_off = first_p * p1 + down_p * p2 + (p + first_p * p1 + down_p * p2) * p3;
o_off = first_o * o1 + down_o * o2 + (o + first_o * o1 + down_o * o2) * o3;

# The width is 1 + width_off, its reciprocal 1 + reciprocal_off.
width_off = t * w1 + (1 - t) * w2 + (1 + t * w1 + (1 - t) * w2) * w3;
reciprocal_off = (w4 - width_off) / (1 + width_off);

mean = p * t + o * (1 - t);
mean_off = (p * t * n1 + o * (1 - t) * n2) + (p_off * t * (1 + n1) + o_off * (1 - t) * (1 + n2));
sum_off = mean_off + (mean + mean_off) * n3;
scale_off = reciprocal_off + n4 + reciprocal_off * n4;
start_off = (sum_off + (mean + sum_off) * scale_off) * 1b@LANE_BITS@;

change = o - p;
change_off = (o * s1 - p * s2) + (o_off * (1 + s1) - p_off * (1 + s2));
all_off = change_off + (change + change_off) * s3;
step_scale_off = reciprocal_off + s4 + reciprocal_off * s4;
step_off = (all_off + (change + all_off) * step_scale_off) * g * 1b@LANE_BITS@;

# What the lane loses: lowered is (u + start_off - SLACK) rounded, and the floor takes up to 1.
start_low = @SLACK@ - start_err - start_rounding + start_floor;
step_low = @SLACK@ - step_err - step_rounding + step_floor;
width = i + 1 + further;  # i is a pixel of the span
low = start_low + i * step_low;
spare = (@PER_PIXEL@ - start_low) + i * (@PER_PIXEL@ - step_low) + @PER_PIXEL@ * further;

{ |p1| <= 1b-53 /\ |p2| <= 1b-53 /\ |p3| <= 1b-53 /\ |o1| <= 1b-53 /\ |o2| <= 1b-53 /\ |o3| <= 1b-53
  /\ |w1| <= 1b-53 /\ |w2| <= 1b-53 /\ |w3| <= 1b-53 /\ |w4| <= 1b-53
  /\ |n1| <= 1b-53 /\ |n2| <= 1b-53 /\ |n3| <= 1b-53 /\ |n4| <= 1b-53
  /\ |s1| <= 1b-53 /\ |s2| <= 1b-53 /\ |s3| <= 1b-53 /\ |s4| <= 1b-53
  /\ |first_p| <= 1 /\ |down_p| <= 2 /\ |first_o| <= 1 /\ |down_o| <= 2
  /\ |p| <= 1 /\ |o| <= 1 /\ t in [0, 1] /\ g in [0, 1]
  /\ |start_err| <= @ERROR@ /\ |step_err| <= @ERROR@
  /\ |start_rounding| <= 1b-5 /\ |step_rounding| <= 1b-5
  /\ start_floor in [0, 1] /\ step_floor in [0, 1]
  /\ i in [0, 0x1p16] /\ further in [0, 0x1p16]
  -> |start_off| <= @ERROR@ /\ |step_off| <= @ERROR@
  /\ low >= 0 /\ spare >= 0x1p-5 }
