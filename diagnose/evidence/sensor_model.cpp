#include "diagnose/evidence/sensor_model.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "input/input_error.hpp"
#include "measure/observe/modal_projection.hpp"

namespace secular {
namespace {

using Eigen::Index;

int derivatives_of(Quantity quantity) {
  return quantity == Quantity::acceleration ? 2 : quantity == Quantity::velocity ? 1 : 0;
}

}  // namespace

std::complex<double> derivative_power(std::complex<double> base, int exponent) {
  return exponent == 0 ? std::complex<double>(1) : exponent == 1 ? base : base * base;
}

std::complex<double> ExtraMode::response(std::size_t channel, std::complex<double> rate, int derivatives,
                                         std::complex<double> excitation) const {
  return amplitude[channel] * derivative_power(rate, derivatives) * excitation /
         (frequency * frequency + 2 * damping * frequency * rate + rate * rate);
}

SensorModel sensor_model(const Campaign& campaign, const CompiledModel& model, std::size_t excitations) {
  const ModalProjection projection = modal_projection(campaign, model);
  SensorModel sensors;
  sensors.responses = projection.channels;
  sensors.derivatives = projection.derivatives;
  sensors.filter = projection.matrix;
  sensors.shapes = projection.matrix.completeOrthogonalDecomposition().pseudoInverse();
  sensors.excitations = channels_of(campaign, ChannelRole::excitation);
  sensors.excitations.resize(std::min(excitations, sensors.excitations.size()));
  const bool dwells = std::any_of(campaign.records.begin(), campaign.records.end(), [](const RecordEntry& entry) {
    return is_steady(entry.kind) || entry.kind == RecordKind::sweep || entry.kind == RecordKind::broadband;
  });
  if (dwells && sensors.excitations.size() < excitations)
    throw InputError((campaign.folder / "campaign.toml").string(), "",
                     "has " + std::to_string(sensors.excitations.size()) + " excitation channels, model " +
                         std::string(model.name) + " needs " + std::to_string(excitations),
                     "give the channel that records the excitation role = \"excitation\"");
  for (const std::size_t c : sensors.responses) sensors.response_names.push_back(campaign.channels[c].name);
  for (const std::size_t c : sensors.excitations) {
    sensors.excitation_names.push_back(campaign.channels[c].name);
    sensors.excitation_derivatives = derivatives_of(campaign.channels[c].quantity);
  }
  return sensors;
}

FaultTable::FaultTable(const CompiledModel& model, const SensorModel& sensors)
    : responses_(sensors.responses.size()),
      excitations_(sensors.excitations.size()),
      modes_(model.modes()),
      after_channels_(5 * (responses_ + excitations_)) {
  std::vector<std::string> channels = sensors.response_names;
  channels.insert(channels.end(), sensors.excitation_names.begin(), sensors.excitation_names.end());
  for (const std::string& channel : channels)
    for (const char* fault : {"gain", "cross_axis", "delay", "offset", "inverse_level"})
      names_.push_back(std::string(fault) + "(" + channel + ")");
  for (std::size_t i = 0; i < modes_; ++i)
    for (std::size_t k = 0; k < modes_; ++k)
      names_.push_back("mixing(" + std::string(model.coordinates[i]) + ", " + std::string(model.coordinates[k]) +
                       ")");
  for (std::size_t k = 0; k < modes_; ++k) names_.push_back("drift(" + std::string(model.symbols[k].name) + ")");
  for (const char* part : {"2, real", "2, imaginary", "3, real", "3, imaginary"})
    names_.push_back("shaker_harmonic(" + std::string(part) + ")");
  names_.emplace_back("extra_frequency");
  names_.emplace_back("extra_damping");
  for (const std::string& channel : sensors.response_names) names_.push_back("extra_amplitude(" + channel + ")");
}

Faults FaultTable::faults(const double* values) const {
  Faults faults;
  for (std::size_t c = 0; c < responses_ + excitations_; ++c) {
    const ChannelFaults fault{values[gain(c)], values[cross(c)], values[delay(c)], values[offset(c)],
                              values[inverse_level(c)]};
    (c < responses_ ? faults.response : faults.excitation).push_back(fault);
  }
  faults.mixing.resize(static_cast<Index>(modes_), static_cast<Index>(modes_));
  for (std::size_t i = 0; i < modes_; ++i)
    for (std::size_t k = 0; k < modes_; ++k)
      faults.mixing(static_cast<Index>(i), static_cast<Index>(k)) = values[mixing(i, k)];
  for (std::size_t h = 0; h < 2; ++h)
    faults.shaker_harmonic[h] = {values[shaker_harmonic(2 * h)], values[shaker_harmonic(2 * h + 1)]};
  for (std::size_t k = 0; k < modes_; ++k) faults.frequency_drift.push_back(values[frequency_drift(k)]);
  faults.extra.frequency = values[extra_frequency()];
  faults.extra.damping = values[extra_damping()];
  for (std::size_t c = 0; c < responses_; ++c) faults.extra.amplitude.push_back(values[extra_amplitude(c)]);
  return faults;
}

}  // namespace secular
