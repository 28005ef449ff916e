#include "measure/observe/record_window.hpp"

#include <algorithm>
#include <cmath>

#include "measure/data/file_pattern.hpp"
#include "measure/data/time_span.hpp"
#include "numerics/hertz.hpp"

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd samples_of(const Record& record, const std::vector<std::size_t>& channels, Index first, Index count) {
  MatrixXd samples(count, static_cast<Index>(channels.size()));
  for (std::size_t c = 0; c < channels.size(); ++c)
    samples.col(static_cast<Index>(c)) =
        Eigen::Map<const Eigen::VectorXd>(record.channels[channels[c]].data() + first, count);
  return samples;
}

namespace {

// By row of the range: how much of the motion lies before it (range_of), from 0 to the number of channels.
Eigen::VectorXd motion_before(const Record& record, SampleRange range) {
  Eigen::VectorXd before = Eigen::VectorXd::Zero(range.count + 1);
  Eigen::ArrayXd usable = Eigen::ArrayXd::Ones(range.count);
  for (const std::size_t row : record.unusable)
    if (const Index at = static_cast<Index>(row) - range.first; at >= 0 && at < range.count) usable(at) = 0;
  std::vector<std::size_t> channels = record.moving;
  for (std::size_t c = 0; record.moving.empty() && c < record.channels.size(); ++c) channels.push_back(c);
  for (const std::size_t c : channels) {
    const Eigen::Map<const Eigen::ArrayXd> x(record.channels[c].data() + range.first, range.count);
    const double mean = (usable * x).sum() / std::max(1.0, usable.sum());
    const Eigen::ArrayXd squares = usable * (x - mean).square();
    const double total = squares.sum();
    if (!(total > 0)) continue;
    double sum = 0;
    for (Index i = 0; i < range.count; ++i) before(i + 1) += (sum += squares(i) / total);
  }
  return before;
}

}  // namespace

SampleRange range_of(const Record& record, const Window& window) {
  const SampleRange all = range_of(record.start_s, record.sample_rate_hz, record.samples(), window);
  if (record.unusable.empty() || all.count == 0) return all;
  const Eigen::VectorXd before = motion_before(record, all);
  SampleRange best{all.first, 0};
  double most = -1;
  Index begin = 0;
  const auto end_at = [&](Index end) {
    if (end > begin && before(end) - before(begin) > most) {
      most = before(end) - before(begin);
      best = {all.first + begin, end - begin};
    }
    begin = end + 1;
  };
  for (const std::size_t row : record.unusable) {
    const Index at = static_cast<Index>(row) - all.first;
    if (at >= 0 && at < all.count) end_at(at);
  }
  end_at(all.count);
  return best;
}

std::string too_short(const Record& record, const Window& window, Index usable, std::optional<Index> ensemble,
                      Index fewest) {
  const Index whole = range_of(record.start_s, record.sample_rate_hz, record.samples(), window).count,
              needed = ensemble.value_or(usable);
  if (needed >= fewest && usable >= needed && (ensemble || 2 * usable > whole)) return {};
  return usable < whole ? "no stretch without clipped, held or lost samples is as long as one ensemble"
                        : "shorter than one ensemble";
}

SampleRange range_of(double start_s, double sample_rate_hz, std::size_t samples, const Window& window) {
  // What is outside of the window has no say in what is used: the filter reaches nothing of it.
  const double reach =
      window.band ? static_cast<double>(band_pass_reach(*window.band, sample_rate_hz)) / sample_rate_hz : 0;
  const SpanOfSamples span =
      samples_within({window.from_s + reach, window.to_s - reach}, start_s, sample_rate_hz, samples);
  return {static_cast<Index>(span.first), static_cast<Index>(span.count)};
}

SlowAmplitude to_displacement(const SlowAmplitude& measured, double frequency, int derivatives) {
  SlowAmplitude tone = measured;
  const Complex s(0, frequency);
  // (s + L)^-1 = 1/s - L/s^2 + L^2/s^3.
  for (int d = 0; d < derivatives; ++d) {
    const Complex third = tone.curvature / s;
    tone.value = (tone.value - tone.slope / s + third / s) / s;
    tone.slope = (tone.slope - third) / s;
    tone.curvature = third;
  }
  return tone;
}

Complex project(const ModalProjection& projection, std::size_t mode, const Eigen::RowVectorXcd& amplitudes) {
  return (projection.matrix.row(static_cast<Index>(mode)).cast<Complex>().cwiseProduct(amplitudes)).sum();
}

double project_sd(const ModalProjection& projection, std::size_t mode, const Eigen::RowVectorXd& sds) {
  return projection.matrix.row(static_cast<Index>(mode)).cwiseProduct(sds).norm();
}

bool Window::takes(std::size_t record, const std::string& file) const {
  return matches_record(records, file) && (chosen.empty() || (record < chosen.size() && chosen[record]));
}

bool Window::passes(double frequency) const {
  return !band || (frequency >= two_pi * band->low_hz && frequency <= two_pi * band->high_hz);
}

double Window::noise_factor(double sample_rate_hz) const {
  return band ? 1 / std::sqrt(band_share_of_noise(*band, sample_rate_hz)) : 1;
}

}  // namespace secular
