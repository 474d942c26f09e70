#@ -Eprecision=200 -Eno-auto-dichotomy
# Divided lanes: 16.16 in 32 bits, the floor of an estimate in double that is lowered by its error.
# `estimate` is off from u by less than `error`, whole multiples of 2^-SHIFT, and SPARE of those
# multiples less, so that the subtraction's own rounding never lifts it above u. Unit 2^-16 texel,
# |estimate| <= 2^LANE_BITS of them.
# Claim: lane <= u < lane + 2 error + TRUNCATIONS - 1.
# Used: src/mapper/vector/projective_wide-inl.h, DividedVectors; with 8.24 and units of 2^-24 texel
# src/mapper/vector/blend_projective_windows-inl.h, whose sum AVX-512 does not even round.
# By hand: error is the floor of a bound of what `estimate` is off by, and kProjectiveTruncations_fx32
# units more, of which the floor takes one and SPARE are left. The code adds the floor of 2 error to
# TRUNCATIONS, which is more. The floor of a double below 2^31 is exact, as is the conversion.

@double = float<ieee_64, ne>;

spare = @SPARE@ * 1b-@SHIFT@;
lowered double= estimate - error;
lane = int<dn>(lowered);
rounded = lowered - (estimate - error);
off = u - estimate;

{ |estimate| <= 1b@LANE_BITS@ /\ error in [0, 1b@LANE_BITS@]
  /\ off + error - spare in [0, 0x1p40] /\ error - off - spare in [0, 0x1p40]
  -> u - lane >= 0 /\ lane + 2 * error + (@TRUNCATIONS@ - 1) - u >= 0 }

u - lane -> (off + error - spare) + (spare - rounded) + (lowered - lane);
lane + 2 * error + (@TRUNCATIONS@ - 1) - u
  -> (error - off - spare) + (spare + rounded) + (@TRUNCATIONS@ - 1 - (lowered - lane));
