#include "jobs/predict/expansion_range.hpp"

#include <algorithm>
#include <optional>

namespace secular {
namespace {

using Amplitudes = std::vector<std::complex<double>>;
using Eigen::Index;
using Eigen::VectorXd;

/// A motion by this share of itself is as good as linear: what is not is quadratic at least.
constexpr double small = 1e-3;

/// Shares of a natural frequency by which rounding of balances moves a rate.
constexpr double rounding = 1e-10;

}  // namespace

bool ExpansionRange::excludes(const VectorXd& parameters, const Amplitudes& amplitude) const {
  const auto symbols = static_cast<Index>(model_.symbols.size());
  const Amplitudes forces = forcing(parameters);
  const ExpansionSizes::State state{parameters.data(), parameters.data() + symbols, amplitude.data(),
                                    forces.data()};
  if (sizes_.outside(state)) return true;
  return sizes_.tells_rates() && remainder_.known() && remainder_exceeds(parameters, amplitude, state);
}

bool ExpansionRange::remainder_exceeds(const VectorXd& parameters, const Amplitudes& amplitude,
                                       const ExpansionSizes::State& state) const {
  const std::vector<double> largest = sizes_.largest_rates(state);
  const std::optional<Amplitudes> whole = remainder_.at(parameters, amplitude);
  if (!whole) return true;
  std::optional<Amplitudes> linear;
  if (sizes_.linear_when_small()) linear = linear_remainder(parameters, amplitude);
  if (linear && sizes_.rest_size(state) > 0) {
    const std::vector<double> all = sizes_.all_rates(state);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (std::abs((*linear)[k]) > all[k]) return true;
  }
  for (std::size_t k = 0; k < largest.size(); ++k)
    if (std::abs((*whole)[k] - (linear ? (*linear)[k] : 0.0)) > largest[k]) return true;
  return false;
}

// lim R(s*a)/s for s -> 0
std::optional<Amplitudes> ExpansionRange::linear_remainder(const VectorXd& parameters,
                                                           const Amplitudes& amplitude) const {
  VectorXd shrunk = parameters;
  shrunk.tail(static_cast<Index>(model_.excitations.size())) *= small;
  Amplitudes less = amplitude;
  for (std::complex<double>& a : less) a *= small;
  std::optional<Amplitudes> remainder = remainder_.at(shrunk, less);
  if (remainder)
    for (std::complex<double>& rate : *remainder) rate /= small;
  return remainder;
}

Amplitudes ExpansionRange::forcing(const VectorXd& parameters) const {
  const std::size_t excitations = model_.excitations.size(), before = model_.symbols.size() + excitations;
  Amplitudes forces(excitations);
  for (std::size_t j = 0; j < excitations && resonance_.excited; ++j)
    forces[j] = parameters(static_cast<Index>(before + j));
  return forces;
}

double ExpansionRange::rest_size(const VectorXd& parameters, const Amplitudes& amplitude) const {
  const Amplitudes forces = forcing(parameters);
  return sizes_.rest_size(
      {parameters.data(), parameters.data() + model_.symbols.size(), amplitude.data(), forces.data()});
}

// Symbols without which the rest position is moved less; nonlinear ones among them do not act in the limit of small
// motion about no load.
VectorXd ExpansionRange::without_loads(const VectorXd& parameters, const Amplitudes& amplitude) const {
  const double moved = rest_size(parameters, amplitude);
  VectorXd unloaded = parameters;
  for (Index s = 0; s < static_cast<Index>(model_.symbols.size()); ++s) {
    VectorXd without = parameters;
    without(s) = 0;
    if (rest_size(without, amplitude) < moved) unloaded(s) = 0;
  }
  return unloaded;
}

std::optional<double> ExpansionRange::rest_shift(const VectorXd& parameters, const Amplitudes& amplitude) const {
  if (!remainder_.known() || !(rest_size(parameters, amplitude) > 0)) return std::nullopt;
  const std::optional<Amplitudes> with = linear_remainder(parameters, amplitude),
                                  without = linear_remainder(without_loads(parameters, amplitude), amplitude);
  if (!with || !without) return std::nullopt;
  const auto modes = static_cast<Index>(amplitude.size());
  // Natural frequencies are the first symbols.
  double shift = 0, lacking = rounding * parameters.head(modes).cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < amplitude.size(); ++k) {
    if (amplitude[k] == 0.0) continue;
    shift = std::max(shift, std::abs(((*with)[k] - (*without)[k]) / amplitude[k]));
    lacking = std::max(lacking, std::abs((*without)[k] / amplitude[k]));
  }
  return shift > lacking ? std::optional(shift) : std::nullopt;
}

}  // namespace secular
