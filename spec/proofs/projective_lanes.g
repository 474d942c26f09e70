#@ -Eprecision=200 -Eno-auto-dichotomy
# ProjectiveLanes: u = N / D, both linear along the span, evaluated in double; unit 2^-32 texel.
# N0, dN, D0, dD: value at the span's start and change a pixel, integers (N times 2^LANE_FRACTION);
# least, most: the denominators at the span's ends; |u| <= 2^LANE_BITS.
# Claim: the double is off by at most PER_RATIO most / least, and with
# error = trunc(most / least) + TRUNCATIONS the law of the filter holds: lane <= u < lane + 2 error.
# Used: src/mapper/lanes.h.
# By hand: D is linear and positive, so it lies between its ends, whose ratio is at most 2^Q_BITS;
# |N| <= 2^LANE_BITS D at the pixels. The claims are divided by most / least, which is positive.

@double = float<ieee_64, ne>;
N = N0 + i * dN;
D = D0 + i * dD;
n_sum = double(N0) + double(i * double(dN));
d_sum = double(D0) + double(i * double(dD));
n = double(n_sum);
d = double(d_sum);
u = double(n * double(1 / d));
ratio = double(double(most) / double(least));
error = int<zr>(ratio) + @TRUNCATIONS@;
lane = int<zr>(u) - error;

# What n_sum and d_sum are off by, relative to `most`; u without its last two roundings.
n_off = (double(N0) - N0) / most + (double(i * double(dN)) - i * dN) / most;
d_off = (double(D0) - D0) / most + (double(i * double(dD)) - i * dD) / most;
scale = least / most;
quotient = n * (1 / d);

{ @FIX(N0, @LANE_FRACTION@) /\ @FIX(dN, @LANE_FRACTION@) /\ @FIX(i, 0)
  /\ @FIX(D0, 0) /\ @FIX(dD, 0) /\ @FIX(most, 0) /\ @FIX(least, 0)
  /\ most in [1, 1b@DENOMINATOR_BITS@] /\ least in [1, 1b@DENOMINATOR_BITS@] /\ D >= 1
  /\ scale in [1b-@Q_BITS@, 1] /\ most / least in [1, 1b@Q_BITS@]
  /\ D0 / most in [0, 1] /\ D / most in [0, 1] /\ D / least in [1, 1b@Q_BITS@]
  /\ |N0 / most| <= 1b@LANE_BITS@ /\ |N / most| <= 1b@LANE_BITS@ /\ |N / D| <= 1b@LANE_BITS@
  -> |(u - N / D) * scale| <= @PER_RATIO@
  /\ (N / D - lane) * scale >= 0 /\ (lane + 2 * error - N / D) * scale >= 1b-@Q_BITS@ }

i * dN / most -> N / most - N0 / most { most <> 0 };
n_sum / most -> N / most + n_off { most <> 0 };
(n - N) / most -> (n - n_sum) / most + n_off { most <> 0 };
i * dD / most -> D / most - D0 / most { most <> 0 };
d_sum / most -> D / most + d_off { most <> 0 };
(d - D) / most -> (d - d_sum) / most + d_off { most <> 0 };

d / least -> D / least + (d - D) / most / scale { least <> 0, most <> 0 };
d -> least * (d / least) { least <> 0 };
(quotient - N / D) * scale -> ((n - N) / most - N / D * ((d - D) / most)) / (d / least)
    { d <> 0, D <> 0, most <> 0, least <> 0 };
quotient -> N / D + (quotient - N / D) * scale / scale { scale <> 0, D <> 0 };
(u - N / D) * scale -> (u - quotient) * scale + (quotient - N / D) * scale { D <> 0, most <> 0 };

ratio * scale -> 1 + (ratio - most / least) / (most / least) { least <> 0, most <> 0 };
(N / D - lane) * scale -> ratio * scale - (u - N / D) * scale
    + scale * (@TRUNCATIONS@ + (int<zr>(ratio) - ratio) - (int<zr>(u) - u)) { D <> 0, most <> 0 };
(lane + 2 * error - N / D) * scale -> ratio * scale + (u - N / D) * scale
    + scale * (@TRUNCATIONS@ + (int<zr>(ratio) - ratio) + (int<zr>(u) - u)) { D <> 0, most <> 0 };
