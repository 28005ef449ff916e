#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "measure/data/campaign.hpp"

namespace secular {

/// How the channels of a campaign see the coordinates of a model.
struct SensorModel {
  std::vector<std::size_t> responses, excitations;  ///< indices into Campaign::channels
  std::vector<std::string> response_names, excitation_names;
  Eigen::MatrixXd shapes;  ///< responses x modes: displacement of the channel per modal displacement
  Eigen::MatrixXd filter;  ///< modes x responses: modal displacement from the channels' (the modal filter)
  int derivatives = 0;     ///< how often a response channel's quantity is differentiated: 2 for accelerations
  int excitation_derivatives = 0;  ///< likewise; a channel that is differentiated has no steady mean
};

/// `excitations`: how many of the model's excitations are measured, the first ones; others carry signals with
/// memory. Throws InputError where channels and model do not fit together.
SensorModel sensor_model(const Campaign& campaign, const CompiledModel& model, std::size_t excitations);

/// Faults of one channel: measured(t) = clip((1 + gain)*(true + cross*excitation)(t - delay)) + offset.
struct ChannelFaults {
  double gain = 0, cross = 0, delay = 0, offset = 0;
  double inverse_level = 0;  ///< 1/level of saturation; 0: none

  bool saturates() const { return inverse_level > 0; }
  double level() const { return 1 / inverse_level; }  ///< where it saturates
};

/// A mode that is in the responses and not in the model: channel c gets amplitude[c] times the acceleration (or
/// whatever the channels measure) of x'' + 2 damping frequency x' + frequency^2 x = F.
struct ExtraMode {
  double frequency = 1, damping = 0.01;
  std::vector<double> amplitude;

  /// On a line that turns at `rate` (1/s), for channels that measure this derivative of the displacement.
  std::complex<double> response(std::size_t channel, std::complex<double> rate, int derivatives,
                                std::complex<double> excitation) const;
};

/// base to the power 0, 1 or 2: what a derivative does to a line.
std::complex<double> derivative_power(std::complex<double> base, int exponent);

/// Everything that can be wrong with excitation and measurement, and how natural frequencies drift; all zero:
/// nothing.
struct Faults {
  std::vector<ChannelFaults> response, excitation;
  Eigen::MatrixXd mixing;  ///< modes x modes: the true shapes are shapes*(1 + mixing)
  /// Second and third harmonic of the excitation over its fundamental, phases counted from the fundamental's.
  std::array<std::complex<double>, 2> shaker_harmonic{};
  std::vector<double> frequency_drift;  ///< by mode: relative change of the natural frequency, 1/s
  ExtraMode extra;
};

/// Names of the faults of a campaign and their places in one vector of unknowns behind the model's symbols.
class FaultTable {
 public:
  FaultTable(const CompiledModel& model, const SensorModel& sensors);

  /// By place: "gain(base)", "mixing(v, w)", ...
  const std::vector<std::string>& names() const { return names_; }
  std::size_t size() const { return names_.size(); }
  /// `values`: this table's part of the unknowns.
  Faults faults(const double* values) const;

  // Places, counted from the table's start. Channels: responses first, then excitations.
  std::size_t gain(std::size_t channel) const { return 5 * channel; }
  std::size_t cross(std::size_t channel) const { return 5 * channel + 1; }
  std::size_t delay(std::size_t channel) const { return 5 * channel + 2; }
  std::size_t offset(std::size_t channel) const { return 5 * channel + 3; }
  std::size_t inverse_level(std::size_t channel) const { return 5 * channel + 4; }
  std::size_t mixing(std::size_t row, std::size_t column) const { return after_channels_ + row * modes_ + column; }
  std::size_t frequency_drift(std::size_t mode) const { return after_channels_ + modes_ * modes_ + mode; }
  /// Real part of the second, its imaginary part, then those of the third.
  std::size_t shaker_harmonic(std::size_t part) const { return after_channels_ + modes_ * modes_ + modes_ + part; }
  std::size_t extra_frequency() const { return shaker_harmonic(4); }
  std::size_t extra_damping() const { return shaker_harmonic(5); }
  std::size_t extra_amplitude(std::size_t response) const { return shaker_harmonic(6) + response; }

 private:
  std::size_t responses_, excitations_, modes_, after_channels_;
  std::vector<std::string> names_;
};

}  // namespace secular
