#pragma once

#include <ginac/ginac.h>

#include <compare>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "perturb/model.hpp"
#include "perturb/smooth_function.hpp"

namespace secular {

/// What a term of an equation of motion is made of besides its coefficient.
struct Factor {
  enum class Kind {
    coordinate,  ///< v, D(v), D2(v): `index` mode, `derivative` 0, 1, 2
    excitation,  ///< F*cos(Omega*t) and its derivatives: `index` excitation
    clock_cos,   ///< cos(multiple*Omega*t) without F: `index` excitation
    clock_sin,   ///< sin(multiple*Omega*t)
    absolute,    ///< abs of a coordinate factor, or of `argument`
    sign,        ///< sgn of a coordinate factor, or of `argument`
    smooth,      ///< `function` of coordinates and velocities
  };
  /// A rational weight, numerator and denominator.
  using Weight = std::pair<long, long>;
  Kind kind = Kind::coordinate;
  int index = 0;
  int derivative = 0;
  int multiple = 1;
  /// abs and sgn of more than one coordinate factor: sum of weight * ("v", "D(v)", a parameter's name or "1").
  /// Empty where `index` and `derivative` say it all; otherwise they name the first coordinate factor in it.
  std::map<std::string, Weight> argument = {};
  SmoothFunction function = {};
  auto operator<=>(const Factor&) const = default;
  bool nonsmooth() const { return kind == Kind::absolute || kind == Kind::sign; }
  bool compound() const { return !argument.empty(); }
};

/// Factors with positive powers.
using FactorProduct = std::map<Factor, int>;

/// A sum of terms coefficient * factors: the polynomial form of an equation, in coordinates and smooth functions of
/// them. Coefficients hold parameters and frequencies only.
class TermSum {
 public:
  TermSum() = default;
  static TermSum constant(const GiNaC::ex& value);
  static TermSum factor(const Factor& factor);

  TermSum& operator+=(const TermSum& other);
  friend TermSum operator*(const TermSum& left, const TermSum& right);
  TermSum scaled(const GiNaC::ex& scale) const;
  TermSum power(int exponent) const;  ///< 1 for an exponent that is not positive
  /// Total time derivative by the product rule.
  TermSum time_derivative() const;
  /// Partial derivative with respect to one coordinate factor, through smooth functions as well.
  TermSum partial(const Factor& by) const;

  const std::map<FactorProduct, GiNaC::ex>& terms() const { return terms_; }
  bool empty() const { return terms_.empty(); }
  /// The coefficient of no factors.
  GiNaC::ex constant_part() const;

  void add(const FactorProduct& product, const GiNaC::ex& coefficient);

 private:
  std::map<FactorProduct, GiNaC::ex> terms_;
};

/// The equations of motion as "left - right", one per mode; for a Lagrangian model d/dt(dT/dq') - dT/dq + dV/dq -
/// force. Throws InputError at the offending piece.
std::vector<TermSum> equations_of_motion(const Model& model);

}  // namespace secular
