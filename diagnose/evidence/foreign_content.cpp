#include "diagnose/evidence/foreign_content.hpp"

#include <Eigen/QR>
#include <cmath>
#include <numbers>

#include "diagnose/evidence/segment.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// A zero that wanders is what cosines of up to two periods a record make of it (slow_terms of its row in the
/// catalogue of disturbances), as far as the part of the record shows them: what is a smaller share of them is
/// left.
constexpr Index slow_cosines = 4;
constexpr double shown = 1e-3;

/// A cosine and a sine, and both with sizes that grow evenly: mains change their frequency while a record lasts,
/// and a line tells it to a part of its width only.
constexpr Index tone_terms = 4;

// Orthonormal.
MatrixXd slow_columns(const Segment& segment) {
  const Index samples = segment.response.cols();
  MatrixXd cosines(samples, slow_cosines + 1);
  for (Index k = 0; k <= slow_cosines; ++k)
    for (Index i = 0; i < samples; ++i) {
      const double place = segment.begin_in_record +
                           segment.share_of_record * (static_cast<double>(i) + 0.5) / static_cast<double>(samples);
      cosines(i, k) = std::cos(std::numbers::pi * static_cast<double>(k) * place);
    }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(cosines);
  qr.setThreshold(shown);
  return qr.householderQ() * MatrixXd::Identity(samples, qr.rank());
}

}  // namespace

MatrixXd wander_columns(const Segment& segment, Index channel) {
  const Index samples = segment.response.cols();
  const MatrixXd slow = slow_columns(segment);
  MatrixXd columns = MatrixXd::Zero(segment.response.rows() * samples, slow.cols());
  columns.middleRows(channel * samples, samples) = slow;
  return columns;
}

Index tone_count(const Segment& segment) {
  return tone_terms * static_cast<Index>(segment.tones.size());
}

MatrixXd foreign_columns(const Segment& segment) {
  const Index samples = segment.response.cols();
  const MatrixXd slow = segment.wandering.empty() ? MatrixXd(samples, 0) : slow_columns(segment);
  MatrixXd columns =
      MatrixXd::Zero(segment.response.rows() * samples,
                     slow.cols() * static_cast<Index>(segment.wandering.size()) + tone_count(segment));
  Index next = 0;
  for (const Index channel : segment.wandering) {
    columns.block(channel * samples, next, samples, slow.cols()) = slow;
    next += slow.cols();
  }
  for (const ForeignTone& tone : segment.tones) {
    const auto first = static_cast<Index>(tone.channel) * samples;
    for (Index i = 0; i < samples; ++i) {
      const double from_middle = static_cast<double>(i) - 0.5 * static_cast<double>(samples - 1),
                   phase = tone.frequency * segment.sample_s * from_middle,
                   size = std::exp(-tone.rate * segment.sample_s * static_cast<double>(i));
      const Eigen::RowVector2d wave(size * std::cos(phase), size * std::sin(phase));
      columns.row(first + i).segment<tone_terms>(next) << wave, from_middle * wave;
    }
    next += tone_terms;
  }
  columns.colwise().normalize();
  return columns;
}

}  // namespace secular
