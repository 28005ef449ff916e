#include "estimator/identification/unit_text.hpp"

#include <cctype>
#include <cstdlib>
#include <map>
#include <numeric>

namespace secular {
namespace {

struct Fraction {
  long numerator = 0, denominator = 1;
};

Fraction reduced(long n, long d) {
  const long g = std::gcd(n, d);
  if (g == 0) return {0, 1};
  return d < 0 ? Fraction{-n / g, -d / g} : Fraction{n / g, d / g};
}

using Powers = std::map<std::string, Fraction>;

void multiply(Powers& powers, const std::string& base, Fraction exponent) {
  if (base == "1" || base.empty()) return;
  Fraction& old = powers[base];
  old = reduced(old.numerator * exponent.denominator + exponent.numerator * old.denominator,
                old.denominator * exponent.denominator);
}

// "kg^(1/2) m", "m/s^2": factors separated by blanks, '*' or '/'.
void multiply_unit(Powers& powers, const std::string& unit, Fraction exponent) {
  long sign = 1;
  for (std::size_t i = 0; i < unit.size();) {
    if (unit[i] == '/') sign = -1;
    if (!std::isalpha(static_cast<unsigned char>(unit[i])) && unit[i] != '%') {
      ++i;
      continue;
    }
    std::string base;
    while (i < unit.size() && (std::isalpha(static_cast<unsigned char>(unit[i])) || unit[i] == '%'))
      base += unit[i++];
    Fraction power{1, 1};
    if (i < unit.size() && unit[i] == '^') {
      ++i;
      const bool bracket = i < unit.size() && unit[i] == '(';
      if (bracket) ++i;
      char* end = nullptr;
      power.numerator = std::strtol(unit.c_str() + i, &end, 10);
      i = static_cast<std::size_t>(end - unit.c_str());
      if (bracket && i < unit.size() && unit[i] == '/') {
        power.denominator = std::strtol(unit.c_str() + i + 1, &end, 10);
        i = static_cast<std::size_t>(end - unit.c_str());
      }
      if (bracket && i < unit.size() && unit[i] == ')') ++i;
      if (power.denominator == 0) power.denominator = 1;
    }
    multiply(powers, base,
             reduced(sign * power.numerator * exponent.numerator, power.denominator * exponent.denominator));
  }
}

std::string one_side(const Powers& powers, long sign, int& count) {
  std::string text;
  for (const auto& [base, exponent] : powers) {
    if (exponent.numerator * sign <= 0) continue;
    ++count;
    text += (text.empty() ? "" : " ") + base;
    const long n = std::abs(exponent.numerator);
    if (exponent.denominator != 1)
      text += "^(" + std::to_string(n) + "/" + std::to_string(exponent.denominator) + ")";
    else if (n != 1)
      text += "^" + std::to_string(n);
  }
  return text;
}

}  // namespace

std::string unit_text(std::span<const Ratio> dimension, const std::vector<std::string>& coordinate_units,
                      const std::vector<std::string>& excitation_units) {
  if (dimension.empty()) return {};
  Powers powers;
  std::size_t i = 0;
  const auto next = [&] {
    const Ratio r = dimension[i++];
    return Fraction{r.numerator, r.denominator};
  };
  for (const std::string& unit : coordinate_units) multiply_unit(powers, unit, next());
  for (const std::string& unit : excitation_units) multiply_unit(powers, unit, next());
  multiply(powers, "s", next());
  int above = 0, below = 0;
  const std::string up = one_side(powers, 1, above), down = one_side(powers, -1, below);
  if (below == 0) return above == 0 ? "1" : up;
  return (above == 0 ? "1" : up) + "/" + (below > 1 ? "(" + down + ")" : down);
}

}  // namespace secular
