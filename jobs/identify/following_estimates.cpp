#include "jobs/identify/following_estimates.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace secular {
namespace {

using Numbers = std::map<std::string, double>;

// Over the standard deviation: what first order may leave of its own change.
constexpr double largest_following_deviation = 1.0 / 3;

// The estimated numbers that something follows from.
struct Sources {
  Numbers values;                  // with those that are fixed
  std::vector<std::string> names;  // with an error bar
  Eigen::VectorXd sd;
  Eigen::MatrixXd correlation;
};

Sources sources_of(const FollowingLaw& law, const Estimate& estimate, std::vector<FollowingCoefficient>& follow) {
  Sources sources;
  for (const EstimatedValue& value : estimate.parameters)
    if (value.value && (value.fixed || value.identifiable)) sources.values[value.name] = *value.value;
  follow = law(sources.values);
  std::vector<Eigen::Index> places;
  for (std::size_t p = 0; p < estimate.parameters.size(); ++p) {
    const EstimatedValue& value = estimate.parameters[p];
    const bool used = std::any_of(follow.begin(), follow.end(),
                                  [&](const FollowingCoefficient& c) { return c.slopes.contains(value.name); });
    if (!used || value.fixed || !(value.sd > 0)) continue;
    places.push_back(static_cast<Eigen::Index>(p));
    sources.names.push_back(value.name);
  }
  const auto n = static_cast<Eigen::Index>(places.size());
  sources.sd.resize(n);
  sources.correlation.setIdentity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    sources.sd(i) = estimate.parameters[static_cast<std::size_t>(places[static_cast<std::size_t>(i)])].sd;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      if (i != j)
        sources.correlation(i, j) =
            estimate.covariance(places[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(j)]) /
            (sources.sd(i) * sources.sd(j));
  return sources;
}

// Along principal directions (rows), of what follows (columns): the change to first order, and what that leaves of
// it on the worse side; infinite where there is no value.
struct Changes {
  Eigen::MatrixXd linear, off;
};

Changes changes_of(const FollowingLaw& law, const Sources& sources,
                   const std::vector<FollowingCoefficient>& follow) {
  const auto columns = static_cast<Eigen::Index>(follow.size());
  Changes changes{Eigen::MatrixXd::Zero(sources.sd.size(), columns),
                  Eigen::MatrixXd::Zero(sources.sd.size(), columns)};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> principal(sources.correlation);
  for (Eigen::Index d = 0; d < sources.sd.size(); ++d) {
    const double length = std::sqrt(std::max(0.0, principal.eigenvalues()(d)));
    const Eigen::VectorXd q = length * sources.sd.cwiseProduct(principal.eigenvectors().col(d));
    for (const double side : {-1.0, 1.0}) {
      Numbers moved = sources.values;
      for (std::size_t i = 0; i < sources.names.size(); ++i)
        moved[sources.names[i]] += side * q(static_cast<Eigen::Index>(i));
      const std::vector<FollowingCoefficient> there = law(moved);
      for (std::size_t c = 0; c < follow.size(); ++c) {
        const auto same = std::find_if(there.begin(), there.end(),
                                       [&](const FollowingCoefficient& f) { return f.name == follow[c].name; });
        double linear = 0;
        for (std::size_t i = 0; i < sources.names.size(); ++i)
          if (const auto slope = follow[c].slopes.find(sources.names[i]); slope != follow[c].slopes.end())
            linear += slope->second * side * q(static_cast<Eigen::Index>(i));
        const double left = same == there.end() ? INFINITY : std::abs(same->value - follow[c].value - linear);
        const auto column = static_cast<Eigen::Index>(c);
        changes.linear(d, column) = std::abs(linear);
        changes.off(d, column) = std::max(changes.off(d, column), left);
      }
    }
  }
  return changes;
}

// The first reason is kept.
void doubt(FollowingEstimate& following, const std::string& why) {
  if (!following.doubtful) following.doubtful_because = why;
  following.doubtful = true;
}

}  // namespace

std::vector<FollowingEstimate> following_estimates(const FollowingLaw& law, const Estimate& estimate) {
  std::vector<FollowingCoefficient> follow;
  const Sources sources = sources_of(law, estimate, follow);
  std::vector<FollowingEstimate> result;
  for (const FollowingCoefficient& coefficient : follow) {
    Eigen::VectorXd scaled = Eigen::VectorXd::Zero(sources.sd.size());
    for (std::size_t i = 0; i < sources.names.size(); ++i)
      if (const auto slope = coefficient.slopes.find(sources.names[i]); slope != coefficient.slopes.end())
        scaled(static_cast<Eigen::Index>(i)) = slope->second * sources.sd(static_cast<Eigen::Index>(i));
    const double variance = scaled.dot(sources.correlation * scaled);
    FollowingEstimate following{coefficient.name, coefficient.value, std::sqrt(std::max(0.0, variance))};
    for (const EstimatedValue& v : estimate.parameters)
      if (v.doubtful && coefficient.slopes.contains(v.name))
        doubt(following, "it follows from " + v.name + ", which is doubtful");
    result.push_back(std::move(following));
  }
  if (follow.empty() || sources.names.empty()) return result;
  const Changes changes = changes_of(law, sources, follow);
  for (Eigen::Index c = 0; c < changes.off.cols(); ++c) {
    Eigen::Index worst = 0;
    changes.off.col(c).maxCoeff(&worst);
    if (!(changes.off.col(c).norm() > largest_following_deviation * result[static_cast<std::size_t>(c)].sd))
      continue;
    for (Eigen::Index other = 0; other < changes.off.cols(); ++other) {
      FollowingEstimate& same = result[static_cast<std::size_t>(other)];
      if (other == c || changes.linear(worst, other) > largest_following_deviation * same.sd)
        doubt(same, "it is far from linear in what it follows from, within the error bars");
    }
  }
  return result;
}

}  // namespace secular
