#include "jobs/predict/response_band.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace secular {
namespace {

using Eigen::Vector2d;

/// Standard deviations on each side.
constexpr double band_width = 2;
/// Share of the figure within which two lines are one to the eye.
constexpr double one_to_the_eye = 1e-3;

// A stretch of a curve in units of the figure, and its edges.
struct Stretch {
  std::vector<Vector2d> middle, one, other;
};

bool lies_on(const Vector2d& point, const Stretch& drawn) {
  for (std::size_t i = 1; i < drawn.middle.size(); ++i) {
    const Vector2d from = drawn.middle[i - 1], chord = drawn.middle[i] - from;
    const double share = chord.isZero(0) ? 0 : std::clamp(chord.dot(point - from) / chord.squaredNorm(), 0.0, 1.0);
    if ((from + share * chord - point).norm() < one_to_the_eye) return true;
  }
  return false;
}

// Of the circle through three neighbours: 4 area = product of the sides / radius.
double radius_of_bend(const Vector2d& before, const Vector2d& at, const Vector2d& after) {
  const Vector2d b = before - at, a = after - at;
  const double twice_area = std::abs(b.x() * a.y() - b.y() * a.x());
  return twice_area > 0 ? b.norm() * a.norm() * (a - b).norm() / (2 * twice_area)
                        : std::numeric_limits<double>::infinity();
}

// Collects stretches. A branch that passes through rest goes back along solutions that differ in phase alone: it
// ends a stretch there, and what is drawn already is not drawn again.
class Strips {
 public:
  void put(const Vector2d& at, Vector2d across) {
    std::vector<Vector2d>& middle = now_.middle;
    const std::size_t count = middle.size();
    if (count > 1 && (at - middle[count - 1]).dot(middle[count - 1] - middle[count - 2]) < 0) end();
    if (across.dot(across_) < 0) across = -across;  // the normal stays on its side of the curve
    across_ = across;
    middle.push_back(at);
    now_.one.emplace_back(at + band_width * across);
    now_.other.emplace_back(at - band_width * across);
  }

  void end() {
    const std::vector<Vector2d>& middle = now_.middle;
    const auto is_drawn = [&](std::size_t i) {
      return std::any_of(done_.begin(), done_.end(),
                         [&](const Stretch& drawn) { return lies_on(middle[i], drawn); });
    };
    const std::size_t last = middle.size();
    if (last > 1 && !(is_drawn(last / 4) && is_drawn(last / 2) && is_drawn(3 * last / 4))) split_at_bends();
    now_ = {};
    across_.setZero();
  }

  const std::vector<Stretch>& done() const { return done_; }

 private:
  // A band is as far from its curve as the curve moves to first order, along the normal. Where that is more than
  // the curve's radius, as at the tip of a response that leans over, the normals cross, and it says nothing.
  void split_at_bends() {
    const std::vector<Vector2d>& middle = now_.middle;
    Stretch part;
    const auto end_part = [&] {
      if (part.middle.size() > 1) done_.push_back(std::move(part));
      part = {};
    };
    for (std::size_t i = 0; i < middle.size(); ++i) {
      const double radius = i > 0 && i + 1 < middle.size() ? radius_of_bend(middle[i - 1], middle[i], middle[i + 1])
                                                           : std::numeric_limits<double>::infinity();
      if ((now_.one[i] - middle[i]).norm() > radius) {
        end_part();
        continue;
      }
      part.middle.push_back(middle[i]);
      part.one.push_back(now_.one[i]);
      part.other.push_back(now_.other[i]);
    }
    end_part();
  }

  std::vector<Stretch> done_;
  Stretch now_;
  Vector2d across_ = Vector2d::Zero();
};

}  // namespace

std::optional<report::Series> response_band(const Prediction& prediction, std::size_t mode) {
  const Vector2d unit(prediction.vary->to - prediction.vary->from, prediction.diagram.scale);
  Strips strips;
  for (const ResponseBranch& branch : prediction.diagram.branches) {
    for (const ResponsePoint& at : branch.points) {
      Vector2d across = Vector2d::Zero();
      if (mode < at.spread.size() && !at.outside)
        across = Vector2d(at.spread[mode].across_parameter, at.spread[mode].across_amplitude).cwiseQuotient(unit);
      if (across.allFinite() && !across.isZero(0))
        strips.put(Vector2d(at.parameter, std::abs(at.modes.amplitude[mode])).cwiseQuotient(unit), across);
      else
        strips.end();
    }
    strips.end();
  }
  report::Series band;
  band.name = band_name;
  band.style = report::SeriesStyle::region;
  const auto put =
      [&](const Vector2d& corner) {  // amplitudes are no less than zero; what is beyond is not computed
        const Vector2d at = corner.cwiseProduct(unit);
        band.x.push_back(std::clamp(at.x(), prediction.vary->from, prediction.vary->to) / prediction.axis);
        band.y.push_back(2 * std::max(at.y(), 0.0));
      };
  for (const Stretch& stretch : strips.done()) {
    std::for_each(stretch.one.begin(), stretch.one.end(), put);
    std::for_each(stretch.other.rbegin(), stretch.other.rend(), put);
    band.x.push_back(std::numeric_limits<double>::quiet_NaN());
    band.y.push_back(std::numeric_limits<double>::quiet_NaN());
  }
  if (band.x.empty()) return {};
  return band;
}

}  // namespace secular
