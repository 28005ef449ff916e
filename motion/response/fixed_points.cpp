#include "motion/response/fixed_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "motion/response/newton.hpp"
#include "motion/response/root_path.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

// Point `number` of Roberts' R sequence in [-1, 1]^n: multiples of powers of the root of g^(n+1) = g + 1.
VectorXd low_discrepancy(Index n, int number) {
  double root = 2;
  for (int i = 0; i < 60; ++i) root = std::pow(1 + root, 1.0 / static_cast<double>(n + 1));
  VectorXd point(n);
  for (Index i = 0; i < n; ++i) {
    const double along = 0.5 + static_cast<double>(number) * std::pow(root, -static_cast<double>(i + 1));
    point(i) = 2 * (along - std::floor(along)) - 1;
  }
  return point;
}

// Unknowns u in [-1, 1]^n over the box.
class RootFinder {
 public:
  RootFinder(const VectorField& field, const ConstVector& parameters, const FixedPointOptions& options)
      : field_(field),
        parameters_(parameters),
        options_(options),
        centre_(0.5 * (options.lower + options.upper)),
        half_(0.5 * (options.upper - options.lower)) {
    system_.value = [this](const VectorXd& u) { return field_.rate(state(u), parameters_); };
    system_.jacobian = [this](const VectorXd& u) -> MatrixXd {
      return field_.jacobian(state(u), parameters_) * half_.asDiagonal();
    };
  }
  RootFinder(const RootFinder&) = delete;
  RootFinder& operator=(const RootFinder&) = delete;

  // New roots from one start.
  bool search(const VectorXd& start) {
    bool any = add(descend(start, false));
    while (full() == false && !roots_.empty() && add(descend(start, true))) any = true;
    return any;
  }

  // New roots on the paths from all roots in one direction. Roots on one path need it only once.
  bool follow(const VectorXd& direction) {
    bool any = false;
    std::vector<bool> followed;
    for (std::size_t r = 0; r < roots_.size() && !full(); ++r) {
      followed.resize(roots_.size(), false);
      if (followed[r]) continue;
      const VectorXd root = roots_[r].first;
      for (const VectorXd& candidate : roots_on_path(system_, root, direction, 3)) {
        any = add(candidate) || any;
        followed.resize(roots_.size(), false);
        for (std::size_t other = 0; other < roots_.size(); ++other)
          if ((roots_[other].first - candidate).norm() < options_.distinct) followed[other] = true;
      }
    }
    return any;
  }

  bool full() const { return static_cast<int>(roots_.size()) >= options_.root_limit; }

  std::vector<FixedPoint> points() const {
    std::vector<std::pair<VectorXd, double>> sorted = roots_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.first.norm() < b.first.norm(); });
    std::vector<FixedPoint> points;
    for (const auto& [root, last_step] : sorted) {
      FixedPoint point;
      point.state = state(root);
      point.residual = field_.rate(point.state, parameters_).norm();
      point.last_step = last_step;
      const Spectrum spectrum = spectrum_of(field_.jacobian(point.state, parameters_));
      point.eigenvalues = spectrum.eigenvalues;
      point.unstable = spectrum.unstable;
      points.push_back(std::move(point));
    }
    return points;
  }

 private:
  VectorXd state(const VectorXd& u) const { return centre_ + half_.cwiseProduct(u); }

  // Newton's method with steps of at most half the box. Deflated, f is multiplied by m = product of
  // (1 + 1/|u - r|^2) over the roots r; that only changes the length of the step s: s / (1 - s . grad m / m).
  VectorXd descend(VectorXd u, bool deflated) const {
    for (int iteration = 0; iteration < 60; ++iteration) {
      VectorXd step = newton_step(system_.jacobian(u), system_.value(u));
      if (!step.allFinite()) return step;
      if (deflated) {
        double slope = 0;
        for (const auto& [root, last_step] : roots_) {
          const VectorXd away = u - root;
          const double square = std::max(away.squaredNorm(), 1e-24);
          slope -= 2 * away.dot(step) / (square * (1 + square));
        }
        step /= std::abs(1 - slope) > 1e-12 ? 1 - slope : 1e-12;
      }
      const double size = step.norm();
      u += size > 0.5 ? VectorXd(0.5 / size * step) : step;
      if (u.norm() > 1e3) return u;
      if (size < 1e-8) return u;
    }
    return u;
  }

  bool add(const VectorXd& candidate) {
    if (!candidate.allFinite() || candidate.cwiseAbs().maxCoeff() > 1.1) return false;
    const NewtonResult polished = newton(system_, candidate, 40);
    const VectorXd& u = polished.unknowns;
    if (!u.allFinite() || polished.last_step > options_.tolerance) return false;
    if (u.cwiseAbs().maxCoeff() > 1 + options_.tolerance) return false;
    for (const auto& [root, last_step] : roots_)
      if ((u - root).norm() < options_.distinct) return false;
    roots_.emplace_back(u, polished.last_step);
    return true;
  }

  const VectorField& field_;
  VectorXd parameters_;
  const FixedPointOptions& options_;
  VectorXd centre_, half_;
  EquationSystem system_;
  std::vector<std::pair<VectorXd, double>> roots_;  // and the last step of Newton's method there
};

void check(const VectorField& field, const ConstVector& parameters, const FixedPointOptions& options) {
  field.check(options.lower, parameters);
  field.check(options.upper, parameters);
  if (!(options.lower.array() < options.upper.array()).all())
    throw std::invalid_argument("a box of fixed points whose lower corner is not below the upper one");
  if (options.start_limit < 1 || options.quiet_starts < 1 || options.root_limit < 1 || options.paths < 0 ||
      !(options.decades >= 0) || !(options.distinct > 0) || !(options.tolerance > 0))
    throw std::invalid_argument("limits of a search for fixed points that are not positive");
}

}  // namespace

FixedPoints find_fixed_points(const VectorField& field, const ConstVector& parameters,
                              const FixedPointOptions& options) {
  check(field, parameters, options);
  RootFinder finder(field, parameters, options);
  FixedPoints result;
  // Sizes of the boxes in the order of use: every other start fills the whole box.
  constexpr int sizes = 6;
  int quiet = 0;
  for (result.starts = 0; result.starts < options.start_limit && quiet < options.quiet_starts && !finder.full();) {
    const int size = result.starts % 2 == 0 ? 0 : 1 + (result.starts / 2) % (sizes - 1);
    const double shrink = std::pow(10.0, -options.decades * size / (sizes - 1));
    const VectorXd start = result.starts == 0
                               ? VectorXd::Zero(field.dimension())
                               : VectorXd(shrink * low_discrepancy(field.dimension(), result.starts));
    quiet = finder.search(start) ? 0 : quiet + 1;
    ++result.starts;
  }
  for (int path = 0; path < options.paths && !finder.full(); ++path)
    finder.follow(low_discrepancy(field.dimension(), 1 + path));
  if (finder.full()) {
    result.status = FixedPointStatus::root_limit;
    result.reason = "as many roots as allowed; they may not be isolated";
  } else if (quiet >= options.quiet_starts) {
    result.status = FixedPointStatus::nothing_new;
    result.reason = "the last " + std::to_string(quiet) + " starts found nothing new";
  } else {
    result.reason = "limit of starts reached while roots still turned up";
  }
  result.points = finder.points();
  return result;
}

}  // namespace secular
