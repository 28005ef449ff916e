#include "diagnose/evidence/noise_of_decays.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "diagnose/evidence/noise_levels.hpp"
#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A transform has as many numbers as the square of this.
constexpr Index most_cosines = 4096;

// Those of decays that are as long as the first one; none if they are too few, too long for a transform, or of one
// record.
std::vector<std::size_t> alike_segments(std::span<const FrozenSegment> segments) {
  std::vector<std::size_t> alike;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i].segment.excitation.cols() == 0 &&
        (alike.empty() || segments[i].samples() == segments[alike.front()].samples()))
      alike.push_back(i);
  if (alike.size() < diagnose_thresholds().fewest_segments || segments[alike.front()].samples() > most_cosines ||
      segments[alike.front()].segment.record == segments[alike.back()].segment.record)
    return {};
  return alike;
}

// Of a channel in these segments.
CosineStretches stretches_of(std::span<const FrozenSegment> segments, std::span<const LeftOfSegment> left,
                             const std::vector<std::size_t>& alike, const MatrixXd& transform, Index channel) {
  const Index samples = transform.rows(), count = static_cast<Index>(alike.size());
  const auto of_channel = Eigen::seqN(channel * samples, samples);
  CosineStretches stretches{MatrixXd(samples, count), MatrixXd::Ones(samples, count)};
  for (Index i = 0; i < count; ++i) {
    const std::size_t segment = alike[static_cast<std::size_t>(i)];
    const FrozenSegment& f = segments[segment];
    stretches.values.col(i) = transform * left[segment].rest(of_channel);
    stretches.freedom.col(i).array() -= static_cast<double>(f.silent.size()) / static_cast<double>(samples);
    for (const MatrixXd* basis : {&f.directions.of_state, &f.directions.of_change})
      stretches.freedom.col(i) -= (transform * (*basis)(of_channel, Eigen::all)).rowwise().squaredNorm();
  }
  return stretches;
}

}  // namespace

std::shared_ptr<const NoiseInCosines> noise_of_decays(std::span<const FrozenSegment> segments,
                                                      std::span<const LeftOfSegment> left,
                                                      const VectorXd& natural_frequency) {
  const std::vector<std::size_t> alike = alike_segments(segments);
  if (alike.empty()) return nullptr;
  std::vector<double> rest, white;
  for (const std::size_t i : alike) {
    rest.push_back(left[i].rest_rms);
    white.push_back(left[i].white);
  }
  NoiseInCosines noise;
  noise.least = white_level(white);
  if (!(lower_quartile(std::move(rest)) > noise.least)) return nullptr;
  const FrozenSegment& first = segments[alike.front()];
  const Index samples = first.samples(), channels = first.segment.response.rows();
  std::vector<Index> of_motion;
  for (const double w : natural_frequency)
    of_motion.push_back(std::lround(w * first.segment.sample_s * static_cast<double>(samples) / std::numbers::pi));
  noise.cosines = cosines(samples);
  noise.sd.resize(samples, channels);
  for (Index c = 0; c < channels; ++c)
    noise.sd.col(c) = noise_by_band(stretches_of(segments, left, alike, noise.cosines, c), of_motion, noise.least);
  return std::make_shared<const NoiseInCosines>(std::move(noise));
}

VectorXd sd_along(const NoiseInCosines& noise, const MatrixXd& columns) {
  const Index samples = noise.cosines.rows();
  VectorXd squares = VectorXd::Zero(columns.cols());
  for (Index c = 0; c < noise.sd.cols(); ++c)
    squares += (noise.sd.col(c).asDiagonal() * noise.cosines * columns.middleRows(c * samples, samples))
                   .colwise()
                   .squaredNorm()
                   .transpose();
  return squares.cwiseSqrt();
}

}  // namespace secular
