#include "app/predict/expansion_range.hpp"

#include <algorithm>
#include <optional>

namespace secular::app {
namespace {

using Amplitudes = std::vector<std::complex<double>>;
using Eigen::Index;
using Eigen::VectorXd;

/// A motion by this share of itself is as good as linear: what is not is quadratic at least.
constexpr double small = 1e-3;

}  // namespace

bool ExpansionRange::excludes(const VectorXd& parameters, const Amplitudes& amplitude) const {
  const auto symbols = static_cast<Index>(model_.symbols.size());
  const std::size_t excitations = model_.excitations.size();
  Amplitudes forcing(excitations);
  for (std::size_t j = 0; j < excitations && resonance_.excited; ++j)
    forcing[j] = parameters(symbols + static_cast<Index>(excitations + j));
  const ExpansionSizes::State state{parameters.data(), parameters.data() + symbols, amplitude.data(),
                                    forcing.data()};
  if (sizes_.outside(state)) return true;
  return sizes_.tells_rates() && remainder_.known() &&
         remainder_exceeds(parameters, amplitude, sizes_.largest_rates(state));
}

bool ExpansionRange::remainder_exceeds(const VectorXd& parameters, const Amplitudes& amplitude,
                                       const std::vector<double>& largest) const {
  const std::optional<Amplitudes> whole = remainder_.at(parameters, amplitude);
  if (!whole) return true;
  std::optional<Amplitudes> linear;
  if (sizes_.linear_when_small()) {
    VectorXd shrunk = parameters;
    shrunk.tail(static_cast<Index>(model_.excitations.size())) *= small;
    Amplitudes less = amplitude;
    for (std::complex<double>& a : less) a *= small;
    linear = remainder_.at(shrunk, less);
  }
  for (std::size_t k = 0; k < largest.size(); ++k)
    if (std::abs((*whole)[k] - (linear ? (*linear)[k] / small : 0.0)) > largest[k]) return true;
  return false;
}

}  // namespace secular::app
