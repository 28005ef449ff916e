#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "codegen/canonical/rational_function.hpp"
#include "perturb/derivation.hpp"

namespace secular {

/// Everything that is printed or emitted of a model, as plain data in a fixed order. See the GiNaC-side structures
/// of the same meaning in perturb/: Derivation, LumpEquations, TermSum.
struct CanonicalPowers {
  std::vector<int> amplitude, conjugate, modulus;  ///< by mode
  std::vector<int> forcing;                        ///< by excitation, power of F
  std::vector<int> phase;       ///< net multiples of all frequencies in true time (of exp(i phase.f t))
  std::vector<int> slow_phase;  ///< multiples of the case's relations
  auto operator<=>(const CanonicalPowers&) const = default;
};

struct CanonicalTerm {
  CanonicalPowers powers;
  int order = 0;
  RationalFunction real, imaginary;
};

struct CanonicalRatio {
  int numerator = 0, denominator = 1;
  bool operator==(const CanonicalRatio&) const = default;
};

/// Powers of each coordinate's unit, each excitation's unit, the second; nothing where equations do not fix them.
using CanonicalDimension = std::optional<std::vector<CanonicalRatio>>;

struct CanonicalLump {
  std::string name;
  RationalFunction definition;
  CanonicalDimension dimension;
};

struct CanonicalColumnTerm {
  RationalFunction factor;
  bool imaginary = false;
  CanonicalPowers powers;
};

struct CanonicalBlock {
  bool modulation = true;
  std::size_t mode = 0;
  int order = 0;  ///< lowest power of eps of its terms
  std::vector<int> phase;
  std::string name;  ///< "modulation of v", "harmonic Omega of v"
  struct Column {
    std::size_t lump = 0;
    std::vector<CanonicalColumnTerm> terms;
  };
  std::vector<Column> columns;
};

struct CanonicalRelation {
  std::vector<int> multiples;
  std::string detuning;
  int order = 0;
  CanonicalRatio coefficient;
  std::string text;
};

struct CanonicalMotionTerm;

/// One factor of a term of an equation of motion.
struct CanonicalFactor {
  enum class Kind {
    displacement,
    velocity,
    acceleration,
    excitation,
    absolute,
    sign,
    clock_cos,
    clock_sin,
    smooth
  };
  Kind kind = Kind::displacement;
  std::size_t index = 0;
  int derivative = 0;  ///< of an excitation, of the argument of abs or sgn
  int multiple = 1;    ///< of a clock
  int power = 1;
  /// abs and sgn of more than one coordinate: sum of ratio * ("v", "D(v)", a parameter's name or "1").
  std::vector<std::pair<std::string, CanonicalRatio>> argument;
  SmoothKind function = SmoothKind::power;  ///< of a smooth one
  CanonicalRatio exponent = {1, 1};         ///< of its `function`, where that is a power
  std::vector<CanonicalMotionTerm> inner;   ///< what it is a function of
};

struct CanonicalMotionTerm {
  RationalFunction coefficient;
  std::vector<CanonicalFactor> factors;
  std::optional<std::size_t>
      acceleration_of;  ///< linear in this mode's acceleration, which is not among the factors
};

/// A function of the equations of motion and its series about rest, as far as it counts in a case.
struct CanonicalSeries {
  CanonicalFactor function;
  int degree = 0;  ///< highest power of coordinates and velocities that counts
  std::vector<CanonicalMotionTerm> terms;
};

/// dA_mode/dt also holds (real + i imaginary) * mean over the fast phases of the factors * exp(-i w t), by
/// quadrature.
struct CanonicalQuadrature {
  std::size_t mode = 0;
  int order = 0;
  RationalFunction real, imaginary;
  std::vector<CanonicalFactor> factors;
};

struct CanonicalCertificate {
  bool holds = false;
  int order = 0;
  std::size_t coefficients_checked = 0;
  int nonsmooth_harmonics = 0;
  double nonsmooth_error = 0;  ///< a bound, not below what rounding makes
  std::vector<std::string> remainders;
};

struct CanonicalCase {
  std::string name;
  int expand_to = 2;
  bool excited = true;
  std::vector<bool> mode_at_rest;
  std::vector<CanonicalRelation> relations;
  std::vector<std::vector<CanonicalTerm>> slow_derivative;  ///< [mode]: terms of dA/dt with their orders
  std::vector<std::vector<CanonicalTerm>> harmonics;        ///< [mode]: every harmonic once, beyond A exp(i w t)
  std::vector<CanonicalQuadrature> quadratures;
  std::vector<CanonicalSeries> series;
  std::vector<std::vector<CanonicalRatio>> observed_frequency;  ///< [mode][frequency]; empty without a frame
  std::vector<CanonicalLump> lumps;
  std::vector<CanonicalBlock> blocks;
  CanonicalCertificate certificate;
  std::vector<std::string> warnings;
  std::map<std::string, int> chosen_orders;  ///< by coefficient, where `order` is "auto"; the others have 0
};

/// The value at rest of a function of coordinates: a symbol beside the parameters, which it follows from.
struct CanonicalRestValue {
  std::string name;
  SmoothKind function = SmoothKind::power;
  CanonicalRatio exponent = {1, 1};  ///< of a power
  RationalFunction argument;         ///< of parameters and the values before it
  RationalFunction slope;            ///< its derivative by the argument, of all symbols
};

/// A coefficient of a model as stated, which follows from its rest position and the other symbols.
struct CanonicalFollowing {
  std::string name;
  RationalFunction definition;
};

struct CanonicalModel {
  std::string name, source;
  std::vector<std::string> coordinates, natural_frequencies;
  std::vector<std::string> excitations, excitation_frequencies;
  std::vector<std::string> parameters;  ///< natural frequencies first, then coefficients
  std::vector<std::string> strengths;   ///< parameters without which an added effect has no terms
  std::vector<CanonicalDimension> parameter_dimensions;
  std::vector<std::optional<double>> nominal;            ///< by parameter
  std::vector<CanonicalRestValue> rest_values;           ///< of a model about its rest position
  std::vector<CanonicalFollowing> following;             ///< the same; for documents alone
  SymbolOrder order;                                     ///< what RationalFunctions refer to
  std::vector<std::vector<CanonicalMotionTerm>> motion;  ///< [mode]: sum of terms = 0
  std::vector<CanonicalCase> cases;
  std::string fingerprint;  ///< digest of everything above that code is made from

  std::string frequency_name(std::size_t i) const {
    return i < natural_frequencies.size() ? natural_frequencies[i]
                                          : excitation_frequencies[i - natural_frequencies.size()];
  }
};

/// Whether its equations of motion, or values at rest, hold any.
bool has_smooth_functions(const CanonicalModel& model);

/// What is wanted of a model: all, or what code is made of, without the list of harmonics that documents show.
enum class CanonicalContent { all, code };

/// Derives, certifies and flattens. `only_case` empty: all cases. Throws InputError from the derivation; a
/// certificate that does not hold is recorded, not thrown. `progress` is told what is done of how many steps.
using CanonicalProgress = std::function<void(std::size_t done, std::size_t total)>;
CanonicalModel canonical_model(const Model& model, const std::string& only_case = {},
                               CanonicalContent content = CanonicalContent::all,
                               const CanonicalProgress& progress = {});

/// Harmonic and modulation terms of one derivation in listing order, with their coefficients as they stand.
struct UnreducedTerm {
  CanonicalPowers powers;
  int order = 0;
  GiNaC::ex coefficient;
};
std::vector<UnreducedTerm> modulation_terms(const Derivation& derivation, std::size_t mode);
std::vector<UnreducedTerm> harmonic_terms(const Derivation& derivation, std::size_t mode);
/// The same with coefficients in canonical form; terms that are identically zero are left out.
std::vector<CanonicalTerm> canonical_modulation(const Derivation& derivation, std::size_t mode,
                                                const SymbolOrder& order);
std::vector<CanonicalTerm> canonical_harmonics(const Derivation& derivation, std::size_t mode,
                                               const SymbolOrder& order);
/// Natural and excitation frequencies, then the other symbols as the model declares them, then pi.
SymbolOrder symbol_order(const Model& model);

}  // namespace secular
