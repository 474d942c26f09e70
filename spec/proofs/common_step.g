#@ -Eprecision=200 -Eno-auto-dichotomy
# Lanes of a row that go on from a pixel's own, i pixels of it, by the least step of some rows and
# not by the row's, `step`. By its own they would hold the law of the filter: u - own = within.
# `apart` is how far the greatest step of the rows is from the least, LAST the most pixels of a
# vector from its first. Unit 2^-32 texel.
# Claim: lane <= u < lane + margin + STEPS apart.
# Used: src/mapper/vector/ruled_strips-inl.h, the law of the filter.

own = first + i * step;
lane = first + i * least;
u = own + within;
bound = margin + @STEPS@ * apart;

{ i in [0, @LAST@]
  /\ step - least in [0, 0x1p64] /\ apart - (step - least) in [0, 0x1p64]
  /\ within in [0, 0x1p32] /\ margin - within in [1b-64, 0x1p64]
  -> u - lane >= 0 /\ lane + bound - u >= 1b-64 }

u - lane -> i * (step - least) + within;
lane + bound - u -> @STEPS@ * (apart - (step - least)) + (@STEPS@ - i) * (step - least)
                  + (margin - within);
