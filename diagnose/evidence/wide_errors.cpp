#include "diagnose/evidence/wide_errors.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "diagnose/thresholds.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;

// Root mean square of the loudest channel, in units of its noise.
double loudness(const Segment& s) {
  return (s.response.rowwise().norm().array() / s.noise_sd.array()).maxCoeff() /
         std::sqrt(static_cast<double>(s.response.cols()));
}

}  // namespace

double widening(const Segment& s, double share) {
  return std::hypot(1.0, share * loudness(s));
}

Index beyond_horizon(const Segment& s, double share, double lowest) {
  if (s.excitation.cols() == 0) return 0;
  constexpr double whole_from = 0.01;  // the finest of wide errors
  const double turns = std::max(diagnose_thresholds().decay_turns,
                                diagnose_thresholds().driven_turns * std::min(1.0, whole_from / share));
  const double least = diagnose_thresholds().drives_from * s.excitation.cwiseAbs().maxCoeff();
  Index begin = 0;
  while (begin < s.response.cols() && !(s.excitation.col(2 * begin).cwiseAbs().maxCoeff() > least)) ++begin;
  const double counted = static_cast<double>(begin) + std::ceil(turns * two_pi / lowest / s.sample_s);
  return s.response.cols() - static_cast<Index>(std::min(static_cast<double>(s.response.cols()), counted));
}

}  // namespace secular
