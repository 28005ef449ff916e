#pragma once

#include <Eigen/Core>
#include <complex>

#include "diagnose/evidence/channel_cut.hpp"
#include "diagnose/evidence/condition.hpp"
#include "diagnose/evidence/sensor_model.hpp"

namespace secular {

/// Between motions and readings of one condition, both ways, for believed faults: with s the rate of a line, a
/// channel shows
///   cut((1 + gain) exp(-s delay) (shape s^derivatives x + cross F + extra mode)) + offset.
/// References condition, sensors and faults.
class ChannelReadings {
 public:
  ChannelReadings(const Condition& condition, const SensorModel& sensors, const Faults& faults);

  /// The excitation that was there, channel x excitation line: the fundamental as measured, harmonics in the ratio
  /// to it that the faults say, a mean only where the quantity can have one.
  const Eigen::MatrixXcd& true_excitation() const { return true_excitation_; }
  /// What the excitation channels should show of it.
  Eigen::MatrixXcd expected_excitation() const;
  /// What the response channels should show of displacements (modes x lines of the torus): channel x line.
  Eigen::MatrixXcd predicted_responses(const Eigen::MatrixXcd& displacement) const;
  /// Amplitudes of the masters, as measured; the rows of a motion with them. Of a channel that saturates what is
  /// cut off depends on the other lines of the motion: `displacement` (empty: none).
  Eigen::VectorXcd master_amplitudes(const Eigen::MatrixXcd& displacement) const;
  bool response_saturates() const;

 private:
  void restore_excitation();
  std::complex<double> excitation_at(Eigen::Index line) const;
  std::complex<double> extra_response(std::size_t channel, Eigen::Index line) const;
  Eigen::MatrixXcd uncut_responses(const Eigen::MatrixXcd& displacement) const;
  Eigen::VectorXcd uncut_shares(const Eigen::MatrixXcd& displacement) const;
  ChannelCut response_cut(Eigen::Index channel) const;
  ChannelCut excitation_cut(Eigen::Index channel) const;

  const Condition& c_;
  const SensorModel& sensors_;
  const Faults& faults_;
  Eigen::MatrixXd shapes_, filter_;
  Eigen::MatrixXcd true_excitation_;
};

}  // namespace secular
