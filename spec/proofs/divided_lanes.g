#@ -Eprecision=200
# Divided lanes: 16.16 in 32 bits, the floor of an estimate in double that is lowered by its error.
# `estimate` is off from u by less than `error`, whole multiples of 2^-SHIFT; lowered, in double, by
# SLACK of those multiples more, so that the subtraction's own rounding never lifts it above u. Unit
# 2^-16 texel, |estimate| <= 2^LANE_BITS of them.
# Claim: lane <= u < lane + 2 error + 2 SLACK multiples + TRUNCATIONS - 1.
# Used: src/mapper/vector_projective_wide-inl.h, DividedVectors.
# By hand: the code adds the floor of 2 error + 2 SLACK multiples to TRUNCATIONS, which is more. The
# floor of a double below 2^31 is exact, as is the conversion.

@double = float<ieee_64, ne>;

slack = @SLACK@ * 1b-@SHIFT@;
lowered double= estimate - (error + slack);
lane = int<dn>(lowered);
rounded = lowered - (estimate - (error + slack));
off = u - estimate;

{ |estimate| <= 1b@LANE_BITS@ /\ error in [0, 1b@LANE_BITS@]
  /\ off + error in [0, 0x1p40] /\ error - off in [0, 0x1p40]
  -> u - lane >= 0 /\ lane + 2 * error + 2 * slack + (@TRUNCATIONS@ - 1) - u >= 0 }

u - lane -> (off + error) + (slack - rounded) + (lowered - lane);
lane + 2 * error + 2 * slack + (@TRUNCATIONS@ - 1) - u
  -> (error - off) + (slack + rounded) + (@TRUNCATIONS@ - 1 - (lowered - lane));
