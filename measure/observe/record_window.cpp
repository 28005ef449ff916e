#include "measure/observe/record_window.hpp"

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

SampleRange range_of(const Record& record, const Window& window) {
  return range_of(record.start_s, record.sample_rate_hz, record.samples(), window);
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
  return matches_pattern(records, file) && (chosen.empty() || (record < chosen.size() && chosen[record]));
}

bool Window::passes(double frequency) const {
  return !band || (frequency >= two_pi * band->low_hz && frequency <= two_pi * band->high_hz);
}

double Window::noise_factor(double sample_rate_hz) const {
  return band ? 1 / std::sqrt(band_share_of_noise(*band, sample_rate_hz)) : 1;
}

}  // namespace secular
