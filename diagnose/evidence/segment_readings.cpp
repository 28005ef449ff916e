#include "diagnose/evidence/segment_readings.hpp"

#include <algorithm>

#include "diagnose/evidence/saturation.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;

// Measured late: the true signal is ahead by the delay, in steps of the samples given.
void advance(Eigen::Ref<RowVectorXd, 0, Eigen::InnerStride<>> signal, double steps) {
  const RowVectorXd late = signal;
  for (Index i = 0; i < late.size(); ++i) {
    const double at = std::clamp(static_cast<double>(i) + steps, 0.0, static_cast<double>(late.size() - 1));
    const auto low = std::min<Index>(static_cast<Index>(at), late.size() - 2);
    signal(i) = late(low) + (at - static_cast<double>(low)) * (late(low + 1) - late(low));
  }
}

// The reading is late by so many samples, to first order.
void delay(RowVectorXd& reading, double samples) {
  const RowVectorXd prompt = reading;
  for (Index i = 0; i < reading.size(); ++i) {
    const Index low = std::clamp<Index>(i, 1, reading.size() - 2);
    reading(i) = prompt(i) - samples * 0.5 * (prompt(low + 1) - prompt(low - 1));
  }
}

}  // namespace

DrivingSignal true_signal(const Segment& segment, const std::vector<ChannelFaults>& excitation) {
  DrivingSignal signal{segment.excitation, segment.sample_s};
  for (Index j = 0; j < signal.half_steps.rows(); ++j) {
    const ChannelFaults& fault = excitation[static_cast<std::size_t>(j)];
    if (fault.offset != 0) signal.half_steps.row(j).array() -= fault.offset;
    if (fault.gain != 0) signal.half_steps.row(j) /= 1 + fault.gain;
    if (fault.delay != 0) advance(signal.half_steps.row(j), fault.delay / (0.5 * segment.sample_s));
  }
  return signal;
}

bool drive_alike(const Segment& segment, const std::vector<ChannelFaults>& these,
                 const std::vector<ChannelFaults>& those) {
  const auto channels = static_cast<std::ptrdiff_t>(segment.excitation.rows());
  return std::equal(these.begin(), these.begin() + channels, those.begin(),
                    [](const ChannelFaults& a, const ChannelFaults& b) {
                      return a.offset == b.offset && a.gain == b.gain && a.delay == b.delay;
                    });
}

Eigen::VectorXd reading_errors(const Segment& segment, const SensorModel& sensors, const Faults& faults,
                               const DrivingSignal& signal, const StretchOfMotion& motion) {
  MatrixXd shapes = sensors.shapes;
  if (!faults.mixing.isZero(0)) shapes += sensors.shapes * faults.mixing;
  const MatrixXd seen = shapes * (sensors.derivatives == 2   ? motion.acceleration
                                  : sensors.derivatives == 1 ? motion.velocity
                                                             : motion.displacement);
  const Index samples = seen.cols();
  Eigen::VectorXd errors(seen.size());
  for (Index c = 0; c < seen.rows(); ++c) {
    const auto channel = static_cast<std::size_t>(c);
    const ChannelFaults& fault = faults.response[channel];
    RowVectorXd reading = seen.row(c);
    if (motion.side.size() > 0) reading += faults.extra.amplitude[channel] * motion.side;
    if (fault.cross != 0 && signal.half_steps.rows() > 0)
      for (Index i = 0; i < samples; ++i) reading(i) += fault.cross * signal.half_steps(0, 2 * i);
    if (fault.delay != 0) delay(reading, fault.delay / segment.sample_s);
    reading *= 1 + fault.gain;
    if (fault.saturates())
      for (double& value : reading) value = saturated(value, fault.level(), segment.noise_sd(c));
    reading.array() += fault.offset;
    errors.segment(c * samples, samples) =
        (segment.response.row(c).head(samples) - reading).transpose() / segment.noise_sd(c);
  }
  return errors;
}

}  // namespace secular
