#pragma once

#include "thesis/verify/printed_source.hpp"

namespace secular::verify {

/// An interval that holds every number which prints as the same digits: half a unit of the last one to both sides.
struct RoundedNumber {
  double low = 0, high = 0;
};
RoundedNumber rounded_number(const std::string& digits);

/// What the entry could be, given that every number it is made from was rounded; and whether its printed digits are
/// among them, or no less or no more than one of them where the entry is a bound.
struct ArithmeticCheck {
  RoundedNumber expected, printed;
  bool agrees = false;
};
ArithmeticCheck check_arithmetic(const PrintedArithmetic& arithmetic);

/// The entries of a printed matrix that cannot come from the matrices it is made of, as text; empty if all can.
/// What rounding leaves open is the sum of what each rounded number alone moves an entry by, which is exact for
/// formulas that are linear over the rounding. Throws InputError where the formula makes a matrix of another size.
std::vector<std::string> wrong_entries(const PrintedMatrix& matrix);

}  // namespace secular::verify
