#include "diagnose/evidence/foreign_content.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "diagnose/evidence/error_directions.hpp"
#include "diagnose/evidence/segment.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// What comes before the cosines: a constant, a slope and a bend. With these the cosines of a smooth course, which
/// begins and ends anywhere, fall with the fourth power of their number.
constexpr Index even_terms = 3;

/// A cosine and a sine, and both with sizes that grow evenly: mains change their frequency while a record lasts,
/// and a line tells it to a part of its width only.
constexpr Index tone_terms = 4;

// Terms of a zero's course that a stretch shows: cosines up to its fastest.
Index slow_terms(const Segment& segment, Index samples) {
  return even_terms +
         static_cast<Index>(2 * segment.zeros_below_hz * segment.sample_s * static_cast<double>(samples));
}

// Orthonormal, each as slow as can be beside those before it.
MatrixXd slow_columns(const Segment& segment) {
  const Index samples = segment.response.cols();
  MatrixXd terms(samples, slow_terms(segment, samples));
  for (Index i = 0; i < samples; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(samples);
    terms.row(i).head<even_terms>() << 1, place, place * place;
    for (Index k = even_terms; k < terms.cols(); ++k)
      terms(i, k) = std::cos(std::numbers::pi * static_cast<double>(k - even_terms + 1) * place);
  }
  return orthonormal_beyond(MatrixXd(), std::move(terms));
}

}  // namespace

MatrixXd wander_columns(const Segment& segment, Index channel) {
  const Index samples = segment.response.cols();
  const MatrixXd slow = slow_columns(segment);
  MatrixXd columns = MatrixXd::Zero(segment.response.rows() * samples, slow.cols());
  columns.middleRows(channel * samples, samples) = slow;
  return columns;
}

Index zero_count(const Segment& segment, Index samples) {
  return slow_terms(segment, samples) * static_cast<Index>(segment.wandering.size());
}

MatrixXd foreign_columns(const Segment& segment) {
  const Index samples = segment.response.cols();
  MatrixXd columns =
      MatrixXd::Zero(segment.response.rows() * samples,
                     zero_count(segment, samples) + tone_terms * static_cast<Index>(segment.tones.size()));
  Index next = 0;
  const MatrixXd slow = segment.wandering.empty() ? MatrixXd() : slow_columns(segment);
  for (Index k = 0; k < slow.cols(); ++k)
    for (const Index channel : segment.wandering)
      columns.col(next++).segment(channel * samples, samples) = slow.col(k);
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
