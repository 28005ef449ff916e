#include "diagnose/verdict/first_frequencies.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/inference/fitter.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Square of the share of the motion that counts as unknown over one turn (docs/inference.md (40): c = 0.4).
constexpr double over_one_turn = 0.16;

}  // namespace

std::vector<Segment> first_turns(std::vector<Segment> segments, const std::vector<double>& natural_frequency) {
  const double lowest = *std::min_element(natural_frequency.begin(), natural_frequency.end());
  std::erase_if(segments, [](const Segment& s) { return s.excitation.cols() > 0; });
  for (Segment& s : segments) {
    const auto turn = static_cast<Index>(std::ceil(two_pi / lowest / s.sample_s));
    s.response.conservativeResize(Eigen::NoChange, std::min(turn, s.response.cols()));
  }
  return segments;
}

VectorXd first_frequencies(Discrepancy& turns, const VectorXd& start, const std::vector<std::size_t>& which,
                           unsigned threads) {
  const double near_enough = 1 / (2 * diagnose_thresholds().decay_turns);
  const Refit found = Fitter(turns, start.size(), threads).at_level(start, which, over_one_turn).fit;
  VectorXd taken = start;
  if (found.ending != SolverEnding::converged) return taken;
  const double dispersion = dispersion_of(found.chi_squared, static_cast<double>(turns.freedom() - found.rank));
  for (std::size_t i = 0; i < found.free.size(); ++i) {
    const auto mode = static_cast<Index>(found.free[i]), at = static_cast<Index>(i);
    const double ratio = found.unknowns(mode) / start(mode),
                 sd = std::sqrt(dispersion * found.covariance(at, at)) / start(mode);
    const bool told = found.identifiable[i] && sd < near_enough;
    if (told && ratio > 0.5 && ratio < 2 && std::abs(ratio - 1) > near_enough) taken(mode) = found.unknowns(mode);
  }
  return taken;
}

}  // namespace secular
