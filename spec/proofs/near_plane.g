#@ -Eprecision=200 -Eno-auto-dichotomy
# Lanes of a plane near a polygon. Each vertex is off it by what lies in [least, most]: an edge by a
# and b at its ends, another one by c and d, and in between as the shares s and t tell; a pixel by
# what both are off in its row, as the share w tells. Unit 2^-32 texel; the ends of the bounds are
# whole multiples of 2^-SHIFT. Lanes count from the plane's value, which drops out.
# Claim: floor(least) <= u < floor(least) + margin, with margin = floor(most) - floor(least) + TRUNCATION.
# Used: src/mapper/near_plane.cpp, the law of the filter.
# By hand: along an edge, and along a row between two edges, u is linear and so is the plane; shares
# are in [0, 1], for rows lie within their edges and pixels between them.

off = w * (s * a + (1 - s) * b) + (1 - w) * (t * c + (1 - t) * d);
lane = int<dn>(least);
margin = int<dn>(most) - int<dn>(least) + @TRUNCATION@;
lacks = 1 - (most - int<dn>(most));

{ s in [0, 1] /\ t in [0, 1] /\ w in [0, 1] /\ lacks >= 1b-@SHIFT@
  /\ a - least in [0, 0x1p64] /\ b - least in [0, 0x1p64] /\ c - least in [0, 0x1p64]
  /\ d - least in [0, 0x1p64] /\ most - a in [0, 0x1p64] /\ most - b in [0, 0x1p64]
  /\ most - c in [0, 0x1p64] /\ most - d in [0, 0x1p64]
  -> off - lane >= 0 /\ lane + margin - off >= 1b-@SHIFT@ }

off - lane -> (least - int<dn>(least)) + w * (s * (a - least) + (1 - s) * (b - least))
            + (1 - w) * (t * (c - least) + (1 - t) * (d - least));
lane + margin - off -> lacks + (@TRUNCATION@ - 1) + w * (s * (most - a) + (1 - s) * (most - b))
                     + (1 - w) * (t * (most - c) + (1 - t) * (most - d));
