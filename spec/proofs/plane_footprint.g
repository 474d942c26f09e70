#@ -Eprecision=200 -Eno-auto-dichotomy
# PlaneFootprint: a side is T / d^2 with T = |J_x| + |J_y| and the denominator d, both in the units of
# least_q, added up in double.
#   M: the most that T can be in the rectangle, terms without their signs; T and all of its errors are
#   taken over M here. reach R >= d >= 1, as in projective_plane.g; error_fx32 = trunc(R) + TRUNCATIONS
# Claims: a J is off by at most `factor` - 1 of its terms, which is 11 units of 2^-53; and
# (T - slack) / d^2, rounded as kernels do it, is not above T / d^2, (T + slack) / d^2 not below it,
# where slack = ROUNDINGS 2^-53 (error_fx32 + 1) M.
# Used: src/mapper/plane_footprint.h.
# By hand: a rounding is a factor 1 + r, for nothing is less than 2^-160 but 0. Each term takes no
# more factors than `factor`, and fewer where products and sums are fused; terms' magnitudes add up to
# M at most, and M's own are rounded likewise. ||x| - |y|| <= |x - y|. d < 2^40, for it is at most the
# reach. LEAST_SHARE is below 1 / (the most reach + 2). Where the reach is rounded, it stays
# within a factor 1 +- 2^-40. Boxes of a row are the least where the ends' are: |J_y| is greatest and
# d is least at an end.

# Conversion; times the unit; a column or row times the step; three sums. The unit, 1 / (D q^2), has
# a rounded product and a rounded quotient.
factor = (1 + conversion) * (1 + r1) * (1 + r2) * (1 + r3) * (1 + r4) * (1 + r5)
         * (1 + r6) / (1 + r7);

# What a kernel has for T, and for d as projective_plane.g bounds it, but that the unit does not
# cancel. share = 1 / (reach + 2).
reach = 1 / share - 2;
sum = (T + off) * (1 + r8);
x = d_off / d * reach;
denominator = d * (1 + x) * (1 + r9) / (1 + r10);
weight = 1 / denominator * (1 + r11);
error = int<zr>(rounded_reach) + @TRUNCATIONS@;
slack = @ROUNDINGS@ * 1b-53 * (error + 1) * (1 + m) * (1 + r12);
low = (sum - slack) * (1 + r13) * weight * (1 + r14) * weight * (1 + r15);
high = (sum + slack) * (1 + r13) * weight * (1 + r14) * weight * (1 + r15);

a = (1 + r10) / (1 + r9) * (1 + r11);
g = a / (1 + x);  # weight d
k = (1 + r13) * (1 + r14) * (1 + r15);
f = k * (g * g);

{ |conversion| <= @CONVERSION@
  /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53 /\ |r4| <= 1b-53 /\ |r5| <= 1b-53
  /\ |r6| <= 1b-53 /\ |r7| <= 1b-53 /\ |r8| <= 1b-53 /\ |r9| <= 1b-53 /\ |r10| <= 1b-53
  /\ |r11| <= 1b-53 /\ |r12| <= 1b-53 /\ |r13| <= 1b-53 /\ |r14| <= 1b-53 /\ |r15| <= 1b-53
  /\ T in [0, 1] /\ |off| <= 11b-53 /\ |m| <= 11b-53
  /\ |d_off| <= @SUM@ /\ d in [1, 0x1p40]
  /\ share in [@LEAST_SHARE@, 0.334]
  /\ |(rounded_reach - reach) / reach| <= 1b-40
  -> |factor - 1| <= 11b-53
  /\ (T / (d * d) - low) * (d * d) * share * 1b53 >= 0
  /\ (high - T / (d * d)) * (d * d) * share * 1b53 >= 0 }

(high - T / (d * d)) * (d * d) * share * 1b53
  -> (slack * share * 1b53 + (sum - T) * share * 1b53) * f + T * ((f - 1) * share * 1b53)
  { d <> 0, 1 + x <> 0, 1 + r9 <> 0, 1 + r10 <> 0, share <> 0 };
(T / (d * d) - low) * (d * d) * share * 1b53
  -> (slack * share * 1b53 - (sum - T) * share * 1b53) * f - T * ((f - 1) * share * 1b53)
  { d <> 0, 1 + x <> 0, 1 + r9 <> 0, 1 + r10 <> 0, share <> 0 };
slack * share * 1b53 -> @ROUNDINGS@ * ((error + 1) * share) * (1 + m) * (1 + r12);
(error + 1) * share -> (1 - 2 * share) * (1 + (rounded_reach - reach) / reach)
    + share * (@TRUNCATIONS@ + 1 + (int<zr>(rounded_reach) - rounded_reach))
    { share <> 0, reach <> 0 };
(sum - T) * share * 1b53 -> share * ((T + off) * r8 * 1b53 + off * 1b53);
(f - 1) * share * 1b53 -> k * ((g - 1) * share * 1b53) * (g + 1) + (k - 1) * 1b53 * share
    { d <> 0, 1 + x <> 0, 1 + r9 <> 0, share <> 0 };
(g - 1) * share * 1b53 -> ((a - 1) * 1b53 * share - d_off * 1b53 / d * (1 - 2 * share)) / (1 + x)
    { d <> 0, 1 + x <> 0, 1 + r9 <> 0, share <> 0 };
$ share;
