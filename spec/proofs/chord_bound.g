#@ -Eprecision=200 -Eno-auto-dichotomy
# The bound of a row's chord in double: change ratio (ratio - 1) / 4, for R the true ratio of the
# row's greatest denominator to its least, and `change` not below the true change of u.
# Claim: with the slack of the ratio it is not below the true bound, change R (R - 1) / 4.
# Used: src/mapper/tolerance.cpp.
# By hand: the denominators are off by less than 2^-26 of themselves: of a ratio up to 2^24 by four
# roundings of the greater one, of a plane's reach up to 2^12 by kPlaneRoundings and two; so one is a
# factor 1 + d1, and one over the other 1 + d2 with a little more. Each further operation in double
# is a factor 1 + r with |r| <= 2^-53, powers of two are exact; `by_R` are numbers over R, and
# one_over_R is 1 / R. The product of two factors that are not below the true ones, times `factor`,
# is not below theirs.

ratio_by_R = (1 + d1) * (1 + d2) * (1 + r3) * @RATIO_SLACK@ * (1 + r4);
less_by_R = (ratio_by_R - one_over_R) * (1 + r5);
factor = ratio_by_R * (1 + r6) * (1 + r7) * (1 + r8);

{ one_over_R in [1b-24, 1]
  /\ |d1| <= 1b-26 /\ |d2| <= 0x1.1p-26 /\ |r3| <= 1b-53 /\ |r4| <= 1b-53
  /\ |r5| <= 1b-53 /\ |r6| <= 1b-53 /\ |r7| <= 1b-53 /\ |r8| <= 1b-53
  -> less_by_R - (1 - one_over_R) >= 0 /\ factor - 1 >= 0 }

less_by_R - (1 - one_over_R) -> (ratio_by_R - 1) + r5 * (ratio_by_R - one_over_R);
