# floor_quotient of the edges: a quotient of integers, rounded once to double, floors right. Columns
# are at most 2^COLUMN_BITS with divisors up to 2^COLUMN_DIVISOR_BITS, steps at most 2^STEP_BITS with
# divisors up to 2^STEP_DIVISOR_BITS.
# Claim: rounding moves the quotient by less than half of the reciprocal of the greatest divisor.
# Used: src/mapper/edge.cpp.
# By hand: a quotient that is not whole is at least 1 / divisor from the next whole number, so
# rounding cannot take it there or past it; a whole one is a double, and stays.

@double = float<ieee_64, ne>;

{ |column| <= 1b@COLUMN_BITS@ /\ |step| <= 1b@STEP_BITS@
  -> |2 * (double(column) - column)| <= 1b-@COLUMN_DIVISOR_BITS@
  /\ |2 * (double(step) - step)| <= 1b-@STEP_DIVISOR_BITS@ }
