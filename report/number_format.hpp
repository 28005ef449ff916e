#pragma once

#include <string>
#include <string_view>

/// Numbers as a person reads them: as many digits as the uncertainty justifies, a true minus sign (U+2212), powers
/// of ten as superscripts (1.3 × 10⁻⁶). Independent of the locale; the same input gives the same bytes.
namespace secular::report {

/// While one lives, functions of this file give plain ASCII instead, which programs read and terminals without
/// UTF-8 show: -0.002(42), 1.30e-06, 0.22 +- 0.01, m/s^2. One thread at a time.
class PlainNumbers {
 public:
  explicit PlainNumbers(bool wanted = true);
  ~PlainNumbers();
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;

 private:
  bool before_;
};

enum class UncertaintyStyle {
  parentheses,  ///< 0.2220(13): the standard uncertainty in units of the last digits
  plus_minus    ///< 0.2220 ± 0.0013
};

/// `value` with `significant` digits, trailing zeros kept ("0.2220"); a power of ten below 0.001 and from 10^6 on.
/// NaN gives "n/a".
std::string format_number(double value, int significant = 4);

/// Value and standard uncertainty `sd`, both cut at the second significant digit of sd. A power of ten is used from
/// 10^5 on, below 0.001, and where those digits would need filling zeros. An sd that is zero, negative or not
/// finite says nothing about the digits: the value is then given alone with six of them (marked "± ?" where sd is
/// NaN).
std::string format_uncertain(double value, double sd, UncertaintyStyle style = UncertaintyStyle::parentheses);

/// The same with a unit: "77.850(12) rad/s", and "(77.850 ± 0.012) rad/s".
std::string format_quantity(double value, double sd, std::string_view unit,
                            UncertaintyStyle style = UncertaintyStyle::parentheses);

/// "[0.2194, 0.2246]": as many digits as tell the ends apart to two digits of the interval's width.
std::string format_interval(double low, double high);

/// "98.2 %" of a fraction, with `decimals` digits after the point.
std::string format_percent(double fraction, int decimals = 1);

/// A unit as it is printed: "m/s^2" -> "m/s²", "s^-1" -> "s⁻¹"; "1" and "" (no unit) -> "". Other text is kept.
std::string pretty_unit(std::string_view unit);

/// An integer as superscript characters: -3 -> "⁻³".
std::string superscript(int number);

/// Decimal digits with a true minus sign: fixed notation, `decimals` digits after the point.
std::string format_fixed(double value, int decimals);

/// "p = 0.012"; one that rounding takes to zero is said to be small, not none: "p < 1e-15".
std::string format_p(double probability);

}  // namespace secular::report
