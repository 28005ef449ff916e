#include "motion/correction/held_out.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "measure/observe/modal_projection.hpp"
#include "motion/simulate/motion.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double state_periods = 10;  // fitted for the initial state
constexpr double fewest_periods = 5;  // worth predicting

}  // namespace

std::optional<HeldOutPrediction> predict_held_out_decay(const Campaign& campaign, const RecordReader& read_samples,
                                                        const ObservationSet& measured, std::size_t record,
                                                        const VectorXd& parameters, const Window& window) {
  const Observation* last = nullptr;
  for (const Observation& o : measured.observations)
    if (o.record == record) last = &o;
  if (!last || measured.model->modes() != 1) return std::nullopt;
  const Record samples = read_samples(record);
  const double rate = samples.sample_rate_hz;
  const double end = samples.start_s + static_cast<double>(samples.samples() - 1) / rate;
  const double period = two_pi / last->rate[0].imag();
  if (end - window.to_s < fewest_periods * period) return std::nullopt;

  const ModalProjection projection = modal_projection(campaign, *measured.model);
  VectorXd modal = VectorXd::Zero(static_cast<Index>(samples.samples()));
  for (std::size_t c = 0; c < projection.channels.size(); ++c)
    modal += projection.matrix(0, static_cast<Index>(c)) *
             Eigen::Map<const VectorXd>(samples.channels[projection.channels[c]].data(), modal.size());
  const auto index = [&](double t) { return static_cast<Index>(std::lround((t - samples.start_s) * rate)); };
  const Index split = index(window.to_s), first = index(window.to_s - state_periods * period);
  if (first < 0) return std::nullopt;

  const ExcitationSignal silent = [&](double, ExcitationSample* s) {
    for (std::size_t j = 0; j < measured.model->excitations.size(); ++j) s[j] = {};
  };
  const auto motion = [&](double q, double v, Index count) {
    VectorXd values(count);
    MotionState state{{q}, {v}};
    Index i = 0;
    integrate_motion({*measured.model, parameters.data(), silent},
                     {0, 0, 1 / rate, static_cast<std::size_t>(count)}, {}, state, [&](const MotionSample& sample) {
                       values(i++) = projection.derivatives == 2   ? sample.acceleration[0]
                                     : projection.derivatives == 1 ? sample.velocity[0]
                                                                   : sample.displacement[0];
                     });
    return values;
  };
  // Displacement and velocity at `first`, and a constant (a sensor's zero), by Gauss-Newton.
  const Index count = split - first;
  const std::complex<double> at_first =
      last->amplitude[0] *
      std::exp(last->rate[0] * (samples.start_s + static_cast<double>(first) / rate - last->centre_s));
  double q = 2 * at_first.real(), v = 2 * (last->rate[0] * at_first).real(), offset = 0;
  const double scale = 2 * std::abs(at_first);
  for (int iteration = 0; iteration < 12; ++iteration) {
    const VectorXd base = motion(q, v, count);
    const double dq = 1e-5 * scale, dv = dq * last->rate[0].imag();
    Eigen::MatrixXd slope(count, 3);
    slope.col(0) = (motion(q + dq, v, count) - base) / dq;
    slope.col(1) = (motion(q, v + dv, count) - base) / dv;
    slope.col(2).setOnes();
    const VectorXd step =
        slope.colPivHouseholderQr().solve(modal.segment(first, count) - base - VectorXd::Constant(count, offset));
    q += step(0);
    v += step(1);
    offset += step(2);
    if (std::abs(step(0)) < 1e-10 * scale) break;
  }
  const VectorXd predicted = motion(q, v, modal.size() - first);
  HeldOutPrediction result;
  result.record = record;
  result.from_s = samples.start_s + static_cast<double>(split) / rate;
  result.to_s = end;
  double square = 0;
  for (Index i = split; i < modal.size(); ++i) {
    result.time.push_back(samples.start_s + static_cast<double>(i) / rate);
    result.measured.push_back(modal(i) - offset);
    result.predicted.push_back(predicted(i - first));
    const double difference = result.measured.back() - result.predicted.back();
    square += difference * difference;
    result.amplitude = std::max(result.amplitude, std::abs(result.measured.back()));
  }
  result.rms = std::sqrt(square / static_cast<double>(modal.size() - split));
  return result;
}

}  // namespace secular
