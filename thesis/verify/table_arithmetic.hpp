#pragma once

#include "thesis/verify/printed_source.hpp"

namespace secular::verify {

/// An interval that holds every number which prints as the same digits: half a unit of the last one to both sides.
struct RoundedNumber {
  double low = 0, high = 0;
};
RoundedNumber rounded_number(const std::string& digits);

/// What the entry could be, given that every number it is made from was rounded; and whether its printed digits are
/// among them.
struct ArithmeticCheck {
  RoundedNumber expected, printed;
  bool agrees = false;
};
ArithmeticCheck check_arithmetic(const PrintedArithmetic& arithmetic);

}  // namespace secular::verify
