#pragma once

#include <compare>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace secular {

class TermSum;

/// Functions of coordinates and velocities that an equation of motion may hold beside polynomials. `power` is one
/// to a number that is no positive integer: sqrt and quotients are powers, too.
enum class SmoothKind {
  sine,
  cosine,
  tangent,
  exponential,
  hyperbolic_sine,
  hyperbolic_cosine,
  hyperbolic_tangent,
  logarithm,
  arc_tangent,
  power,
};

/// As model text calls it; "" for a power.
std::string_view name_of(SmoothKind kind);
/// The one that model text calls so; nothing for other names. sqrt is a power.
std::optional<SmoothKind> smooth_kind(std::string_view name);

/// A smooth function of a sum of terms. `power` has an exponent, numerator and denominator.
class SmoothFunction {
 public:
  SmoothFunction() = default;  ///< none
  /// `text` says what the argument is: functions with the same text have the same argument.
  SmoothFunction(SmoothKind kind, std::pair<long, long> exponent, TermSum argument, std::string text);

  bool exists() const { return argument_ != nullptr; }
  SmoothKind kind() const { return kind_; }
  const std::pair<long, long>& exponent() const { return exponent_; }
  const TermSum& argument() const;
  /// As model text: "sin(x)", "(1 + x^2)^(-1)", "sqrt(1 + x)".
  std::string text() const;
  /// Its derivative by its argument, every term of it a product with a smooth function.
  TermSum slope() const;

  std::strong_ordering operator<=>(const SmoothFunction& other) const;
  bool operator==(const SmoothFunction& other) const { return (*this <=> other) == 0; }

 private:
  struct Argument;
  SmoothFunction with(SmoothKind kind, std::pair<long, long> exponent) const;

  SmoothKind kind_ = SmoothKind::power;
  std::pair<long, long> exponent_{1, 1};
  std::shared_ptr<const Argument> argument_;
};

}  // namespace secular
