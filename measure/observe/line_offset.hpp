#pragma once

#include <Eigen/Core>

namespace secular {

/// The strongest line about a frequency, docs/inference.md (70).
struct LineOffset {
  double turn = 0;      ///< by which its phase gains on that frequency's within a window, rad; negative: loses
  double gain = 0;      ///< its power over that at the frequency itself, less one
  double resolved = 1;  ///< how many lines were compared
};

/// Of equally long windows of one motion (samples x windows), whose powers add up. Lines within `reach` of
/// `frequency` (rad/s), as a share of it, but no more than 64 bins (1 over the length) to either side.
LineOffset line_offset(const Eigen::Ref<const Eigen::MatrixXd>& windows, double sample_rate_hz, double frequency,
                       double reach);

/// Share of its amplitude that a line loses where a tone is fitted whose phase it leaves by `turn` within the
/// window: 1 - |sin(turn/2)/(turn/2)|.
double lost_by_turn(double turn);

}  // namespace secular
