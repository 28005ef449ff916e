#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "measure/signal/circular_moments.hpp"
#include "measure/signal/pole.hpp"

namespace secular {

/// A window folded about its centre: every function of Eq. (4.3) is even or odd there, so that sums over the window
/// split into two over half of it, and products of an even and an odd function vanish. The map (y(t) +
/// y(-t))/sqrt2, (y(t) - y(-t))/sqrt2 is orthogonal: least squares do not change.
struct FoldedWindow {
  FoldedWindow(Eigen::Index samples, double sample_rate_hz);

  Eigen::MatrixXd even(const Eigen::Ref<const Eigen::MatrixXd>& channels) const;  ///< rows x channels
  Eigen::MatrixXd odd(const Eigen::Ref<const Eigen::MatrixXd>& channels) const;   ///< rows x channels
  /// samples x channels, from both halves.
  Eigen::MatrixXd unfold(const Eigen::MatrixXd& even, const Eigen::MatrixXd& odd) const;

  Eigen::Index samples = 0, rows = 0, first = 0;  ///< `first` is the sample at or after the centre
  double rate = 1, half = 1;                      ///< Hz; s, from the centre to the last sample
  Eigen::VectorXd weight;                         ///< [row] sqrt2, one at a sample in the centre
  Eigen::VectorXd time;                           ///< [row] in half windows
};

/// The functions of poles in a folded window. Time is counted in half windows.
struct FoldedFunctions {
  /// The window must outlive the functions.
  FoldedFunctions(std::span<const Pole> poles, const FoldedWindow& window);

  Eigen::MatrixXd even, odd;                  ///< rows x number of such functions
  std::vector<Eigen::Index> even_at, odd_at;  ///< place of each in the order of the poles
  std::optional<TimedMoments> closed;         ///< of cosines, sines and constants alone
  const FoldedWindow* window;

  Eigen::MatrixXd gram() const;  ///< G^T G
  /// With `zeroth` left empty: that is gram().
  TimedMoments timed_moments() const;
  /// G^T y and (time G)^T y for folded channels: functions x channels.
  Eigen::MatrixXd project(const Eigen::MatrixXd& even_part, const Eigen::MatrixXd& odd_part) const;
  Eigen::MatrixXd project_timed(const Eigen::MatrixXd& even_part, const Eigen::MatrixXd& odd_part) const;
  /// Subtracts G * amplitudes.
  void subtract(const Eigen::MatrixXd& amplitudes, Eigen::MatrixXd& even_part, Eigen::MatrixXd& odd_part) const;
};

}  // namespace secular
