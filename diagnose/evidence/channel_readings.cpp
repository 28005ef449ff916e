#include "diagnose/evidence/channel_readings.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "diagnose/evidence/saturation.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Without the channel's gain and delay (cut-off and cross-axis sensitivity are taken care of by the caller).
Complex restored(Complex measured, const ChannelFaults& fault, Complex rate) {
  return measured * std::exp(rate * fault.delay) / (1 + fault.gain);
}

ChannelCut cut_of(const ChannelFaults& fault, const VectorXd& noise, Index channel) {
  return {fault.saturates() ? fault.level() : 0, noise.size() > 0 ? noise(channel) : 0};
}

// The line on which a channel shows most, by its place among the observed ones; the mean does not count.
Index strongest_line(const Condition& c, Index channel) {
  Index strongest = 0;
  for (Index l = 0; l < c.response.cols(); ++l)
    if (c.lines[static_cast<std::size_t>(l)] != 0 &&
        std::abs(c.response(channel, l)) >= std::abs(c.response(channel, strongest)))
      strongest = l;
  return strongest;
}

}  // namespace

ChannelReadings::ChannelReadings(const Condition& condition, const SensorModel& sensors, const Faults& faults)
    : c_(condition), sensors_(sensors), faults_(faults), shapes_(sensors.shapes), filter_(sensors.filter) {
  if (!faults.mixing.isZero(0)) {
    shapes_ += sensors.shapes * faults.mixing;
    filter_ = shapes_.completeOrthogonalDecomposition().pseudoInverse();
  }
  restore_excitation();
}

bool ChannelReadings::response_saturates() const {
  return std::any_of(faults_.response.begin(), faults_.response.end(),
                     [](const ChannelFaults& fault) { return fault.saturates(); });
}

ChannelCut ChannelReadings::response_cut(Index channel) const {
  return cut_of(faults_.response[static_cast<std::size_t>(channel)], c_.response_noise, channel);
}

ChannelCut ChannelReadings::excitation_cut(Index channel) const {
  return cut_of(faults_.excitation[static_cast<std::size_t>(channel)], c_.excitation_noise, channel);
}

void ChannelReadings::restore_excitation() {
  true_excitation_ = c_.excitation;
  for (Index j = 0; j < c_.excitation.rows(); ++j) {
    const ChannelFaults& fault = faults_.excitation[static_cast<std::size_t>(j)];
    const ChannelCut cut = excitation_cut(j);
    const Index own = c_.tone_of(j);
    Complex fundamental = 0;
    for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
      if (c_.excitation_lines[l] == own) {
        fundamental = c_.excitation(j, static_cast<Index>(l));
        if (fault.saturates())
          fundamental *=
              unsaturated_amplitude(std::abs(fundamental), cut.level, cut.noise_sd) / std::abs(fundamental);
        fundamental = restored(fundamental, fault, c_.line_rate(own));
      }
    const Complex turned = fundamental == 0.0 ? Complex(1) : fundamental / std::abs(fundamental);
    for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l) {
      const Index line = c_.excitation_lines[l];
      Complex& value = true_excitation_(j, static_cast<Index>(l));
      if (line == 0) {
        value = sensors_.excitation_derivatives > 0
                    ? Complex(0)
                    : (c_.excitation(j, static_cast<Index>(l)) - fault.offset) / (1 + fault.gain);
      } else if (line == own) {
        value = fundamental;
      } else {
        const std::size_t counted = c_.torus->phase(line)[1] != 0 ? 1 : 0;
        const int turns = c_.torus->phase(line)[counted], own_turns = c_.torus->phase(own)[counted];
        const int order = turns % own_turns == 0 ? turns / own_turns : 0;
        value = order < 2 ? Complex(0)
                          : faults_.shaker_harmonic[static_cast<std::size_t>(order - 2)] * std::abs(fundamental) *
                                std::pow(turned, order);
      }
    }
  }
}

MatrixXcd ChannelReadings::expected_excitation() const {
  MatrixXcd expected = MatrixXcd::Zero(c_.excitation.rows(), c_.excitation.cols());
  for (Index j = 0; j < expected.rows(); ++j) {
    const ChannelFaults& fault = faults_.excitation[static_cast<std::size_t>(j)];
    MatrixXcd lines = MatrixXcd::Zero(1, c_.torus->lines());
    for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l) {
      const Index line = c_.excitation_lines[l];
      lines(0, line) = true_excitation_(j, static_cast<Index>(l)) * (1 + fault.gain) *
                       std::exp(-c_.line_rate(line) * fault.delay);
    }
    if (fault.saturates()) excitation_cut(j).apply(*c_.torus, lines, 0);
    lines(0, 0) += fault.offset;
    for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
      expected(j, static_cast<Index>(l)) = lines(0, c_.excitation_lines[l]);
  }
  return expected;
}

Complex ChannelReadings::excitation_at(Index line) const {
  if (true_excitation_.rows() == 0) return 0;
  for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
    if (c_.excitation_lines[l] == line) return true_excitation_(0, static_cast<Index>(l));
  return 0;
}

Complex ChannelReadings::extra_response(std::size_t channel, Index line) const {
  if (faults_.extra.amplitude[channel] == 0 || line == 0) return 0;
  return faults_.extra.response(channel, c_.line_rate(line), sensors_.derivatives, excitation_at(line));
}

// What the channels would show if they had no limits and no offsets: channel x line of the torus.
MatrixXcd ChannelReadings::uncut_responses(const MatrixXcd& displacement) const {
  MatrixXcd lines = shapes_ * displacement;
  for (Index l = 0; l < lines.cols(); ++l) {
    const Complex s = c_.line_rate(l);
    lines.col(l) *= derivative_power(s, sensors_.derivatives);
    for (Index c = 0; c < lines.rows(); ++c) {
      const ChannelFaults& fault = faults_.response[static_cast<std::size_t>(c)];
      Complex& value = lines(c, l);
      value += fault.cross * excitation_at(l) + extra_response(static_cast<std::size_t>(c), l);
      value *= (1 + fault.gain) * std::exp(-s * fault.delay);
    }
  }
  return lines;
}

MatrixXcd ChannelReadings::predicted_responses(const MatrixXcd& displacement) const {
  MatrixXcd lines = uncut_responses(displacement);
  for (Index c = 0; c < lines.rows(); ++c) {
    const ChannelFaults& fault = faults_.response[static_cast<std::size_t>(c)];
    if (fault.saturates()) response_cut(c).apply(*c_.torus, lines, c);
    lines(c, 0) += fault.offset;
  }
  return lines;
}

// By channel, what its strongest line was before the cut over what it shows; the others are taken in the same
// ratio.
VectorXcd ChannelReadings::uncut_shares(const MatrixXcd& displacement) const {
  const Index channels = c_.response.rows();
  VectorXcd shares = VectorXcd::Ones(channels);
  if (!response_saturates()) return shares;
  const MatrixXcd lines =
      displacement.size() > 0 ? uncut_responses(displacement) : MatrixXcd::Zero(channels, c_.torus->lines());
  for (Index c = 0; c < channels; ++c) {
    if (!faults_.response[static_cast<std::size_t>(c)].saturates()) continue;
    const Index column = strongest_line(c_, c);
    shares(c) = response_cut(c).uncut_share(*c_.torus, lines.row(c), c_.lines[static_cast<std::size_t>(column)],
                                            c_.response(c, column));
  }
  return shares;
}

VectorXcd ChannelReadings::master_amplitudes(const MatrixXcd& displacement) const {
  const Index channels = c_.response.rows();
  const VectorXcd uncut = uncut_shares(displacement);
  VectorXcd amplitudes(static_cast<Index>(c_.masters.size()));
  for (std::size_t m = 0; m < c_.masters.size(); ++m) {
    const MasterLine& master = c_.masters[m];
    const auto column =
        static_cast<Index>(std::find(c_.lines.begin(), c_.lines.end(), master.line) - c_.lines.begin());
    VectorXcd seen(channels);
    for (Index c = 0; c < channels; ++c) {
      const ChannelFaults& fault = faults_.response[static_cast<std::size_t>(c)];
      seen(c) = restored(uncut(c) * c_.response(c, column), fault, c_.line_rate(master.line)) -
                fault.cross * excitation_at(master.line) - extra_response(static_cast<std::size_t>(c), master.line);
    }
    amplitudes(static_cast<Index>(m)) = (filter_.row(static_cast<Index>(master.mode)).cast<Complex>() * seen)(0) /
                                        derivative_power(c_.line_rate(master.line), sensors_.derivatives);
  }
  return amplitudes;
}

}  // namespace secular
