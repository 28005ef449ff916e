#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace secular {

/// How a line's amplitude varies from ensemble to ensemble of one dwell, a straight line in time aside, against the
/// noise at frequencies beside it. A steady motion under a steady excitation varies by the noise alone.
struct Nonstationarity {
  std::size_t record = 0;  ///< index into Campaign::records
  double squares = 0;      ///< squared deviations over the noise's variance, summed
  double freedom = 0, noise_freedom = 0;
  bool dies_out = false;  ///< varies beyond noise in its first half, by far less in its second
};

/// `amplitude`: by ensemble, in order of time. `noise`: amplitudes beside the line, ensembles x frequencies, in the
/// same unit. Without noise, and of fewer than three ensembles, nothing: no freedom.
Nonstationarity nonstationarity_of(const Eigen::VectorXcd& amplitude, const Eigen::MatrixXcd& noise);

/// A test of all dwells together and of the worst alone.
struct NonstationarityTest {
  double p_value = 1;      ///< of both tests, corrected for their number
  double ratio = 1;        ///< root mean square deviation over that of the noise
  std::size_t record = 0;  ///< where it is largest
};

/// F law of the deviations over the noise. Dwells without freedom do not count; of none p is one.
NonstationarityTest test_nonstationarity(const std::vector<Nonstationarity>& dwells);

/// Whether one line of a dwell varies beyond the alarm.
bool is_unsteady(const Nonstationarity& nonstationarity);

}  // namespace secular
