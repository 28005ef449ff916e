#include "measure/observe/record_window.hpp"

#include <algorithm>
#include <cmath>

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
  const auto samples = static_cast<double>(record.samples());
  const double begin = std::clamp((window.from_s - record.start_s) * record.sample_rate_hz, 0.0, samples);
  const double end = std::clamp((window.to_s - record.start_s) * record.sample_rate_hz + 1, 0.0, samples);
  const auto first = static_cast<Index>(std::ceil(begin - 1e-6));
  return {first, std::max<Index>(0, static_cast<Index>(std::floor(end + 1e-6)) - first)};
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

bool matches_pattern(const std::string& pattern, const std::string& file) {
  // Linear in time with one remembered star.
  std::size_t p = 0, f = 0, star = std::string::npos, resume = 0;
  while (f < file.size()) {
    if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == file[f])) {
      ++p;
      ++f;
    } else if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = f;
    } else if (star != std::string::npos) {
      p = star + 1;
      f = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace secular
