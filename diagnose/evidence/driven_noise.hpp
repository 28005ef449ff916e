#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/evidence/segment_model.hpp"

namespace secular {

/// Noise in what was read of the excitation. The structure does not feel it, but the motion that is computed from
/// the readings does, and swings with it: errors of a driven segment are white only beside that motion. Linear
/// about the motion, with states x of displacements and velocities, noise n_i of standard deviation one in sample i
/// (b_i, d_i hold its size) and errors e_i of the responses in units of their own white noise v_i,
///   e_i = H_i (x_i + g_i n_i/2) + d_i n_i + v_i,   x_(i+1) = Phi_i (x_i + g_i n_i),   g_i = h [0; b_i],   x_0 = 0,
/// (docs/inference.md (33)), h the time of a sample (interpolated between samples, its noise acts half before it
/// and half after). Their innovations over the standard deviations of these are white (B. D. O. Anderson, J. B.
/// Moore, Optimal Filtering, 1979, sections 5.3 and 5.5). Coloured noise
/// of a response (Segment::coloured) is one state more, of which an error reads all:
///   c_(i+1) = exp(-h/T) c_i + what keeps its variance.
class DrivenNoise {
 public:
  /// Leaves errors as they are.
  DrivenNoise() = default;
  /// About the motion of a trial of a whole segment. `at_jumps`: samples whose errors do not count. Leaves errors
  /// as they are where no noise of the excitation is known, and where motions run together that begin apart.
  DrivenNoise(const SegmentModel& model, const SegmentTrial& trial, const std::vector<Eigen::Index>& at_jumps);

  /// Whether a noise of the excitation is known.
  bool is_of_excitation() const { return inputs_ > 0; }

  /// Errors, channel after channel.
  Eigen::VectorXd whitened(Eigen::VectorXd error) const;

  /// What errors say of the noise, from what whitened() makes of them: its expectation given all of them,
  /// excitations x samples, in its standard deviations. Backwards from the last sample, with w_i the innovations
  /// over their standard deviations, L_i, K_i the gain by these, Z_i and T_i what reads (x_i, n_i) and carries them
  /// on,
  ///   q_i = u_i + Z_i^T L_i^-T (w_i - K_i^T u_i),   u_i = T_i^T (first parts of q_(i+1)),   u_last = 0,
  /// of which the last parts belong to n_i (P. de Jong, JASA 84, 1989, 1085-1088). Empty where nothing is whitened.
  Eigen::MatrixXd expected(const Eigen::VectorXd& white) const;

 private:
  struct Step {
    Eigen::MatrixXd transition, reading;  ///< of (x_i, n_i)
    Eigen::MatrixXd lower, gain;          ///< L of S = L L^T, the innovation's covariance; of the innovation over L
  };
  std::vector<Step> steps_;  // by sample; empty: white
  Eigen::Index inputs_ = 0;  // excitations whose noise is known
};

}  // namespace secular
