#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace secular {

/// A delay by a part of a sample that leaves the amplitudes of all frequencies, and so white noise, as they are:
/// the all-pass whose delay is maximally flat at zero frequency (J.-P. Thiran, Recursive digital filters with
/// maximally flat group delay, IEEE Transactions on Circuit Theory 18, 1971). It delays a tone of four samples a
/// turn to 1e-7 of its amplitude.
class AllPassDelay {
 public:
  static constexpr std::size_t order = 24;

  /// `share`: of a sample, from -1/2 to 1/2.
  explicit AllPassDelay(double share);

  /// y[n] = x(n - order - share), as if there had been nothing before the first of the samples.
  std::vector<double> operator()(const std::vector<double>& samples) const;

  /// From which sample on nothing is left of what was before the first one.
  std::size_t settled() const { return settled_; }

 private:
  std::array<double, order + 1> coefficients_{};
  std::size_t settled_ = 0;
};

}  // namespace secular
