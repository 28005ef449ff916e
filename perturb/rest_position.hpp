#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

#include "perturb/following_coefficient.hpp"
#include "perturb/model.hpp"
#include "perturb/smooth_function.hpp"

namespace secular {

/// A coefficient that follows from where a model rests and how fast it oscillates there.
struct HeldCoefficient {
  std::string name;
  GiNaC::ex value;   ///< of the rest position, natural frequencies and the other coefficients, see RestPosition
  std::string text;  ///< as model text
};

/// The value at rest of a function of coordinates, a symbol of its own in coefficients: sin_x_rest is sin(x_rest).
struct RestValue {
  std::string name;
  SmoothKind kind = SmoothKind::power;
  std::pair<long, long> exponent = {1, 1};
  Expression argument;  ///< of rest positions, coefficients and values before it in RestPosition::values
};

/// What `reference = "rest"` makes of a model. Coordinates count from the rest position: x stands for x_rest + x in
/// the equations as stated. The rest position and the natural frequencies of small oscillations about it are
/// parameters; as many coefficients, of the static load and of the stiffness, follow from them. With the equations
/// F_k at rest, that is without motion and excitation, and the inertia M_k of mode k there,
///   F_k(x_rest) = 0,   dF_k/dx_k(x_rest) = omega_k^2 M_k,
/// which are linear in these coefficients. Nothing is solved but linear equations, and nothing is approximated.
struct RestPosition {
  std::vector<RestValue> values;
  std::vector<std::string> symbols;    ///< by mode: of its rest position; empty where it rests at zero
  std::vector<HeldCoefficient> held;   ///< coefficients that follow
  std::vector<std::string> frequency;  ///< by mode: of the natural frequency; empty where it is stated
  /// As stated, with rest positions as symbols: F_k, and dF_k/dx_k and M_k, by mode.
  std::vector<GiNaC::ex> force, stiffness, inertia;
  SymbolTable stated;  ///< symbols of the expressions above

  bool holds(const std::string& name) const;     ///< among `held`
  bool is_value(const std::string& name) const;  ///< among `values`
  /// Derivative of a value by its argument: of symbols among them its own and that of another value.
  Expression slope(const RestValue& value) const;
};

/// The model about its rest position. `stated`: with symbols, without cases. `asked`: by mode, the name that the
/// file gives to its rest position; empty where it gives none: such a coordinate rests at zero unless a constant
/// force moves it. Throws InputError where nothing moves it, a name is taken, or no coefficient can follow.
Model about_rest(Model stated, const std::vector<std::string>& asked);

/// Numbers of coefficients as stated become those of the model about its rest position: where `values` gives all
/// coefficients that follow, they give way to the rest position and the natural frequencies. Of several rest
/// positions it is the one that is reached from zero while the load grows from nothing or, where `values` gives a
/// rest position as well, the one near that: what is reached from there, by stable positions alone, while the load
/// that would hold it there is taken away (docs/inference.md (R5)). `values` that give none of these coefficients
/// stay. Numbers that `values` lacks are the model's nominal ones. `where` is what messages call the values. Throws
/// InputError where some are missing, or the model has no rest position there or is not stable in it. Returns what
/// it found, in words.
std::string take_rest_position(const Model& model, std::map<std::string, double>& values, const std::string& where);

/// The values of functions at rest that go with the rest position and the coefficients among `values`, beside them.
void add_values_at_rest(const Model& model, std::map<std::string, double>& values);

/// The coefficients that follow from the rest position and natural frequencies among `values`, by name; those that
/// depend on a number that is not there are left out.
std::vector<FollowingCoefficient> following_coefficients(const Model& model,
                                                         const std::map<std::string, double>& values);

}  // namespace secular
