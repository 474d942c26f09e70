#@ -Eprecision=200 -Eno-auto-dichotomy
# ProjectivePlane: u = N / D, both affine over the polygon's rectangle, added up in double; unit
# 2^-32 texel. Or ruled_field: both quadratic in the row.
#   N = n0 + j (ny + j nyy) + l (nx + j nxy) + k (nx + j nxy) at the k-th pixel of the span that
#   starts l columns right of the rectangle's first pixel and j rows below it; likewise D. Of a plane
#   nxy and nyy are 0
#   S, T: the most that the terms' magnitudes and the like of D add up to in the rectangle
#   least: the least q of the vertices, as D counts it; U = 2^LANE_BITS >= |u|
# Claims: a value added up is off by at most SUM S, or SUM T. With reach = (S / U + T) / least a
# lane is off by at most PER_REACH reach, and with error = trunc(reach) + TRUNCATIONS the law of the
# filter holds: lane <= u < lane + 2 error.
# Used: src/mapper/projective_plane.h, src/mapper/projective_slab.h.
# By hand: a rounding is a factor 1 + r, for nothing is less than 2^-80 but 0; each term takes no more
# factors than `factor`, and fewer where products and sums are fused, and the terms' weights add up to
# 1. D is a mean of the vertices' q at the pixels, so D >= least, and T >= D. Where the reach is
# rounded, it stays within a factor 1 +- 2^-40; all is divided by the exact reach.

# Conversion; the unit; a column or row times the step; three sums. Where rows are ruled, a product
# and a sum more.
factor = (1 + conversion) * (1 + r1) * (1 + r2) * (1 + r3) * (1 + r4) * (1 + r5)
         * (1 + ruled1) * (1 + ruled2);

# n_off and d_off: by how much of S and of T the values are off. s = S / (U least reach),
# t = T / (least reach), n = |N| / (U D), d = D / least.
shift = (n_off * s + n * d_off * t) * (1 / (1 + d_off * t * reach / d)) / d;
roundings = n * ((1 + r6) * (1 + r7) - 1);
# u_double = (u + shift reach U) (1 + r6) (1 + r7), over the reach.
off = (shift * (1 + r6) * (1 + r7) + roundings / reach) * 1b@LANE_BITS@;

error = int<zr>(rounded_reach) + @TRUNCATIONS@;
u_double = u + off_reach;
lane = int<zr>(u_double) - error;

{ |conversion| <= @CONVERSION@
  /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53 /\ |r4| <= 1b-53 /\ |r5| <= 1b-53
  /\ |r6| <= 1b-53 /\ |r7| <= 1b-53 /\ |ruled1| <= @RULED@ /\ |ruled2| <= @RULED@
  /\ |n_off| <= @SUM@ /\ |d_off| <= @SUM@ /\ s in [0, 1] /\ t in [0, 1] /\ |n| <= 1
  /\ reach in [1, @MOST_REACH@] /\ d in [1, @MOST_REACH@]
  /\ |off_reach / reach| <= @PER_REACH@
  /\ |(rounded_reach - reach) / reach| <= 1b-40
  -> |factor - 1| <= @SUM@
  /\ |off| <= @PER_REACH@
  /\ (u - lane) / reach >= 0 /\ (lane + 2 * error - u) / reach >= 1b-@Q_BITS@ }

(u - lane) / reach -> rounded_reach / reach - off_reach / reach
    + (@TRUNCATIONS@ + (int<zr>(rounded_reach) - rounded_reach) - (int<zr>(u_double) - u_double))
    / reach { reach <> 0 };
(lane + 2 * error - u) / reach -> rounded_reach / reach + off_reach / reach
    + (@TRUNCATIONS@ + (int<zr>(rounded_reach) - rounded_reach) + (int<zr>(u_double) - u_double))
    / reach { reach <> 0 };
rounded_reach / reach -> 1 + (rounded_reach - reach) / reach { reach <> 0 };
