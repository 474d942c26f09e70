#@ -Eprecision=200 -Eno-auto-dichotomy
# The bound of a row's chords in double, |K d'| N^2 / (4 least^3) with K = n' d - n d'.
#   M: the terms of K, without their signs; K, its error and what is added for it are taken over M, K
#   as if it were above 0. `slope` stands for |K|.
# Claims: each term of K is off by at most TERM of itself. So a slope, with SLOPE_ERROR M added, is not
# below |K|; nor is the bound that is made of it, with BEND_SLACK, below the true one; and where a
# length is chosen for a budget less BUDGET_SLACK, the bound told is within the budget.
# Used: src/mapper/bend.h, src/mapper/tolerance.h.
# By hand: a rounding is a factor 1 + r, for nothing is less than 2^-300 but 0; powers of two are
# exact. The unit of a plane is the same in all of its lines, and cancels. Along a row with lanes of
# its own there are fewer roundings than down the rows of a plane. Least denominators are off by less
# than 2^-26 of themselves: of a ratio up to 2^24 by four roundings of the greater one, of a plane's
# reach up to 2^12 by kPlaneRoundings and two. A product of factors that are not below the true ones
# is not below theirs.

# Two conversions, each times the unit; their product; a difference; times a row; a sum; and one more.
factor = (1 + c1) * (1 + r1) * (1 + c2) * (1 + r2) * (1 + r3) * (1 + r4) * (1 + r5) * (1 + r6);
error = @SLOPE_ERROR@ * (1 + m);
slope = (K + off + error) * (1 + r7);

one_px = (1 + c3) * (1 + r8) * (1 + r9) * (1 + r10) * @BEND_SLACK@;
cube = (1 + d) * (1 + d) * (1 + d) * (1 + r11) * (1 + r12);
bound = one_px * (1 + r13) * (1 + r14) / cube * (1 + r15);

# Of the budget: what is compared, or a root of it whose square is; the bound, divided again.
told = @BUDGET_SLACK@ * (1 + r8) * (1 + r9) * (1 + r10) * ((1 + r11) * (1 + r11)) * (1 + r12)
       * (1 + r13) * (1 + r14) * (1 + r15);

{ |c1| <= @CONVERSION@ /\ |c2| <= @CONVERSION@ /\ |c3| <= @CONVERSION@
  /\ |r1| <= 1b-53 /\ |r2| <= 1b-53 /\ |r3| <= 1b-53 /\ |r4| <= 1b-53 /\ |r5| <= 1b-53
  /\ |r6| <= 1b-53 /\ |r7| <= 1b-53 /\ |r8| <= 1b-53 /\ |r9| <= 1b-53 /\ |r10| <= 1b-53
  /\ |r11| <= 1b-53 /\ |r12| <= 1b-53 /\ |r13| <= 1b-53 /\ |r14| <= 1b-53 /\ |r15| <= 1b-53
  /\ K in [0, 1] /\ |off| <= 0xc.2p-53 /\ |m| <= 20b-53 /\ |d| <= 1b-26
  -> |factor - 1| <= 0xc.2p-53
  /\ slope - K >= 0 /\ bound - 1 >= 0 /\ told - 1 <= 0 }

slope - K -> (off + error) * (1 + r7) + K * r7;
