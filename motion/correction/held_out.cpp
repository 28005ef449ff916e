#include "motion/correction/held_out.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "measure/observe/modal_projection.hpp"
#include "motion/simulate/motion.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double state_periods = 10;  // fitted for the initial state
constexpr double fewest_periods = 5;  // worth predicting

/// A record of one mode as its modal coordinate.
struct ModalRecord {
  const CompiledModel& model;
  VectorXd modal;
  double start_s = 0, rate_hz = 1;
  int derivatives = 0;  ///< of the displacement that `modal` is

  Index index(double t) const { return static_cast<Index>(std::lround((t - start_s) * rate_hz)); }
  double time(Index i) const { return start_s + static_cast<double>(i) / rate_hz; }
};

ModalRecord modal_record(const Campaign& campaign, const Record& samples, const CompiledModel& model) {
  const ModalProjection projection = modal_projection(campaign, model);
  VectorXd modal = VectorXd::Zero(static_cast<Index>(samples.samples()));
  for (std::size_t c = 0; c < projection.channels.size(); ++c)
    modal += projection.matrix(0, static_cast<Index>(c)) *
             Eigen::Map<const VectorXd>(samples.channels[projection.channels[c]].data(), modal.size());
  return {model, std::move(modal), samples.start_s, samples.sample_rate_hz, projection.derivatives};
}

/// The motion from a state, as it would be measured.
VectorXd motion_from(const ModalRecord& record, const VectorXd& parameters, double q, double v, Index count) {
  const ExcitationSignal silent = [&](double, ExcitationSample* s) {
    for (std::size_t j = 0; j < record.model.excitations.size(); ++j) s[j] = {};
  };
  VectorXd values(count);
  MotionState state{{q}, {v}};
  Index i = 0;
  integrate_motion({record.model, parameters.data(), silent},
                   {0, 0, 1 / record.rate_hz, static_cast<std::size_t>(count)}, {}, state,
                   [&](const MotionSample& sample) {
                     values(i++) = record.derivatives == 2   ? sample.acceleration[0]
                                   : record.derivatives == 1 ? sample.velocity[0]
                                                             : sample.displacement[0];
                   });
  return values;
}

/// Samples of a record: the state is fitted over `fitted` of them from `first` on, errors count from `shown` on.
struct Span {
  Index first = 0, fitted = 0, shown = 0, end = 0;
};

HeldOutPrediction followed(const ModalRecord& record, const VectorXd& parameters, const Observation& near,
                           const Span& span) {
  // Displacement and velocity at `first`, and a constant (a sensor's zero), by Gauss-Newton.
  const std::complex<double> at_first =
      near.amplitude[0] * std::exp(near.rate[0] * (record.time(span.first) - near.centre_s));
  double q = 2 * at_first.real(), v = 2 * (near.rate[0] * at_first).real(), offset = 0;
  const double scale = 2 * std::abs(at_first);
  const Index count = span.fitted;
  for (int iteration = 0; iteration < 12; ++iteration) {
    const VectorXd base = motion_from(record, parameters, q, v, count);
    const double dq = 1e-5 * scale, dv = dq * near.rate[0].imag();
    Eigen::MatrixXd slope(count, 3);
    slope.col(0) = (motion_from(record, parameters, q + dq, v, count) - base) / dq;
    slope.col(1) = (motion_from(record, parameters, q, v + dv, count) - base) / dv;
    slope.col(2).setOnes();
    const VectorXd step = slope.colPivHouseholderQr().solve(
        VectorXd(record.modal.segment(span.first, count) - base - VectorXd::Constant(count, offset)));
    q += step(0);
    v += step(1);
    offset += step(2);
    if (std::abs(step(0)) < 1e-10 * scale) break;
  }
  const VectorXd predicted = motion_from(record, parameters, q, v, span.end - span.first);
  HeldOutPrediction result;
  result.from_s = record.time(span.shown);
  result.to_s = record.time(span.end - 1);
  double square = 0;
  for (Index i = span.shown; i < span.end; ++i) {
    result.time.push_back(record.time(i));
    result.measured.push_back(record.modal(i) - offset);
    result.predicted.push_back(predicted(i - span.first));
    const double difference = result.measured.back() - result.predicted.back();
    square += difference * difference;
    result.amplitude = std::max(result.amplitude, std::abs(result.measured.back()));
  }
  result.rms = std::sqrt(square / static_cast<double>(span.end - span.shown));
  return result;
}

/// First and last window of a record; null: there is none, or the model has not one mode.
std::pair<const Observation*, const Observation*> windows_of(const ObservationSet& measured, std::size_t record) {
  std::pair<const Observation*, const Observation*> ends;
  if (measured.model->modes() != 1) return ends;
  for (const Observation& o : measured.observations) {
    if (o.record != record) continue;
    if (!ends.first) ends.first = &o;
    ends.second = &o;
  }
  return ends;
}

}  // namespace

std::optional<HeldOutPrediction> predict_held_out_decay(const Campaign& campaign, const RecordReader& read_samples,
                                                        const ObservationSet& measured, std::size_t record,
                                                        const VectorXd& parameters, const Window& window) {
  const Observation* last = windows_of(measured, record).second;
  if (!last) return std::nullopt;
  const ModalRecord samples = modal_record(campaign, read_samples(record), *measured.model);
  const double period = two_pi / last->rate[0].imag();
  if (samples.time(samples.modal.size() - 1) - window.to_s < fewest_periods * period) return std::nullopt;
  const Index split = samples.index(window.to_s), first = samples.index(window.to_s - state_periods * period);
  if (first < 0) return std::nullopt;
  HeldOutPrediction result =
      followed(samples, parameters, *last, {first, split - first, split, samples.modal.size()});
  result.record = record;
  return result;
}

std::optional<HeldOutPrediction> follow_decay(const Campaign& campaign, const RecordReader& read_samples,
                                              const ObservationSet& measured, std::size_t record,
                                              const VectorXd& parameters) {
  const auto [near, last] = windows_of(measured, record);
  if (!near) return std::nullopt;
  const ModalRecord samples = modal_record(campaign, read_samples(record), *measured.model);
  const double period = two_pi / near->rate[0].imag(), from = near->centre_s - 0.5 * near->length_s;
  const Index first = std::max<Index>(0, samples.index(from)),
              end = std::min(samples.modal.size(), samples.index(last->centre_s + 0.5 * last->length_s) + 1),
              fitted = samples.index(from + state_periods * period) - first;
  if (samples.time(end - 1) - from < (state_periods + fewest_periods) * period || first + fitted > end)
    return std::nullopt;
  HeldOutPrediction result = followed(samples, parameters, *near, {first, fitted, first, end});
  result.record = record;
  return result;
}

}  // namespace secular
