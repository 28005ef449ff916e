#include "measure/observe/mode_frequencies.hpp"

#include <Eigen/Dense>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd ModeFrequencies::observed(const VectorXd& u, const std::vector<double>& excitation) const {
  VectorXd f = coupling * u;
  for (std::size_t j = 0; j < excitation.size(); ++j) f += excitation[j] * forced.col(static_cast<Index>(j));
  for (std::size_t k = 0; k < oscillates.size(); ++k)
    if (!oscillates[k]) f(static_cast<Index>(k)) = 0;
  return f;
}

ModeFrequencies mode_frequencies(const CompiledModel& model, const CompiledCase& resonance) {
  const auto modes = static_cast<Index>(model.modes()), excitations = static_cast<Index>(model.excitations.size());
  MatrixXd natural(modes, modes);
  ModeFrequencies result;
  result.forced.resize(modes, excitations);
  for (Index k = 0; k < modes; ++k)
    for (Index i = 0; i < modes + excitations; ++i) {
      const Ratio r = resonance.observed_frequency[static_cast<std::size_t>(k * (modes + excitations) + i)];
      const double weight = static_cast<double>(r.numerator) / r.denominator;
      (i < modes ? natural(k, i) : result.forced(k, i - modes)) = weight;
    }
  result.oscillates.assign(model.modes(), false);
  const auto awake = [&](Index k) { return !resonance.mode_at_rest[static_cast<std::size_t>(k)]; };
  for (Index k = 0; k < modes; ++k) {
    const bool driven = !resonance.excited || (result.forced.row(k).array() != 0).any();
    if (awake(k) && driven) result.oscillates[static_cast<std::size_t>(k)] = true;
  }
  for (Index k = 0; k < modes; ++k)
    for (Index other = 0; other < modes; ++other) {
      const bool driven = result.oscillates[static_cast<std::size_t>(other)] && resonance.excited;
      const bool shares = (natural.row(k).array() * natural.row(other).array() != 0).any();
      if (awake(k) && other != k && driven && shares) result.oscillates[static_cast<std::size_t>(k)] = true;
    }
  // Independent columns of the free part, in order.
  MatrixXd kept(modes, 0);
  for (Index i = 0; i < modes; ++i) {
    MatrixXd candidate(modes, kept.cols() + 1);
    candidate << kept, natural.col(i);
    for (Index k = 0; k < modes; ++k)
      if (!result.oscillates[static_cast<std::size_t>(k)]) candidate.row(k).setZero();
    if (candidate.colPivHouseholderQr().rank() < candidate.cols()) continue;
    kept = candidate;
    result.free.push_back(static_cast<std::size_t>(i));
  }
  result.coupling = kept;
  return result;
}

}  // namespace secular
