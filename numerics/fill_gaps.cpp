#include "numerics/fill_gaps.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Coefficients of the model, and samples of a block: gaps that begin in one share the coefficients that it and its
/// neighbours give.
constexpr std::size_t order = 2 * longest_filled, around = 1024;
constexpr auto delays = static_cast<Index>(order + 1);  // with none

/// Gaps that hang together are found together, up to so many samples.
constexpr std::size_t most_together = 64;

/// Next to the mean square of the samples: tones without noise would leave the coefficients open.
constexpr double ridge = 1e-10;

// Places whose rows of prediction have samples in common.
struct Cluster {
  std::vector<std::size_t> places;
  std::size_t longest = 0;  // run of neighbours
};

std::vector<Cluster> clusters_of(const std::vector<std::size_t>& missing) {
  std::vector<Cluster> clusters;
  std::size_t run = 0;
  for (std::size_t i = 0; i < missing.size(); ++i) {
    if (i == 0 || missing[i] - missing[i - 1] > order) clusters.emplace_back();
    run = i > 0 && missing[i] == missing[i - 1] + 1 ? run + 1 : 1;
    clusters.back().places.push_back(missing[i]);
    clusters.back().longest = std::max(clusters.back().longest, run);
  }
  return clusters;
}

// H_ij = sum of x_(t-i) x_(t-j) over the rows t from `begin` to before `end`, delays i, j from 0 to `order`; x from
// begin - order on. Along a diagonal H differs by the products at both ends alone.
MatrixXd products_of(std::span<const double> x, std::size_t begin, std::size_t end) {
  const auto rows = static_cast<Index>(end - begin);
  const auto from = [&](std::size_t place) { return Eigen::Map<const VectorXd>(x.data() + place, rows); };
  MatrixXd h(delays, delays);
  for (std::size_t j = 0; j <= order; ++j) h(static_cast<Index>(j), 0) = from(begin).dot(from(begin - j));
  const auto enters = [&](Index delay) { return x[begin - 1 - static_cast<std::size_t>(delay)]; };
  const auto leaves = [&](Index delay) { return x[end - 1 - static_cast<std::size_t>(delay)]; };
  for (Index j = 0; j + 1 < delays; ++j)
    for (Index i = j; i + 1 < delays; ++i)
      h(i + 1, j + 1) = h(i, j) + enters(i) * enters(j) - leaves(i) * leaves(j);
  return h.selfadjointView<Eigen::Lower>();
}

// x_t - sum_k a_k x_(t-k) over complete rows of a block and its neighbours; empty where there are too few.
VectorXd coefficients(std::span<const double> x, const std::vector<bool>& lacks, std::size_t block) {
  const std::size_t begin = std::max(order, block > 0 ? (block - 1) * around : 0),
                    end = std::min(x.size(), (block + 2) * around);
  MatrixXd sum = MatrixXd::Zero(delays, delays);
  std::size_t rows = 0, run = begin - order;  // of samples without a gap: where it begins
  for (std::size_t t = run; t <= end; ++t) {
    if (t < end && !lacks[t]) continue;
    if (t > run + order) {
      sum += products_of(x, run + order, t);
      rows += t - run - order;
    }
    run = t + 1;
  }
  if (rows < 2 * order) return {};
  constexpr auto size = static_cast<Index>(order);
  MatrixXd gram = sum.bottomRightCorner(size, size);
  gram.diagonal().array() += ridge * gram.trace() / static_cast<double>(size);
  return gram.ldlt().solve(sum.col(0).tail(size));
}

bool fill(std::span<double> x, const VectorXd& a, const Cluster& cluster) {
  const std::size_t first = cluster.places.front(), last = cluster.places.back();
  if (a.size() == 0 || cluster.longest > longest_filled || cluster.places.size() > most_together) return false;
  const std::size_t begin = std::max(first, order), end = std::min(x.size(), last + order + 1);
  if (begin >= end) return false;
  const auto unknowns = static_cast<Index>(cluster.places.size());
  MatrixXd design = MatrixXd::Zero(static_cast<Index>(end - begin), unknowns);
  VectorXd known(design.rows());
  for (std::size_t t = begin; t < end; ++t) {
    const auto row = static_cast<Index>(t - begin);
    double error = 0;
    for (std::size_t k = 0; k <= order; ++k) {
      const double weight = k == 0 ? 1 : -a(static_cast<Index>(k - 1));
      const std::size_t at = t - k;
      const auto place = std::lower_bound(cluster.places.begin(), cluster.places.end(), at);
      if (place != cluster.places.end() && *place == at)
        design(row, place - cluster.places.begin()) += weight;
      else
        error += weight * x[at];
    }
    known(row) = error;
  }
  const VectorXd found = design.colPivHouseholderQr().solve(VectorXd(-known));
  if (!found.allFinite()) return false;
  for (Index u = 0; u < unknowns; ++u) x[cluster.places[static_cast<std::size_t>(u)]] = found(u);
  return true;
}

// Gaps before the first row of prediction, backwards: there they are gaps near the end.
bool fill_head(std::span<double> samples, const std::vector<bool>& lacks, const Cluster& cluster) {
  const std::size_t length = std::min(samples.size(), 3 * around);
  std::vector<double> back(length);
  std::vector<bool> lacks_back(length);
  for (std::size_t i = 0; i < length; ++i) {
    back[i] = samples[length - 1 - i];
    lacks_back[i] = lacks[length - 1 - i];
  }
  Cluster turned = cluster;
  for (std::size_t& place : turned.places) place = length - 1 - place;
  std::reverse(turned.places.begin(), turned.places.end());
  if (!fill(back, coefficients(back, lacks_back, turned.places.front() / around), turned)) return false;
  for (const std::size_t place : cluster.places) samples[place] = back[length - 1 - place];
  return true;
}

}  // namespace

std::vector<std::size_t> fill_gaps(std::span<double> samples, const std::vector<std::size_t>& missing) {
  std::vector<bool> lacks(samples.size(), false);
  for (const std::size_t place : missing) lacks[place] = true;
  std::vector<std::size_t> left;
  VectorXd a;
  std::size_t block = samples.size();  // none yet
  for (const Cluster& cluster : clusters_of(missing)) {
    if (const std::size_t here = cluster.places.front() / around; here != block) {
      block = here;
      a = coefficients(samples, lacks, block);
    }
    const bool at_head = cluster.places.front() < order && cluster.places.back() + 2 * order < samples.size();
    if (!(at_head ? fill_head(samples, lacks, cluster) : fill(samples, a, cluster)))
      left.insert(left.end(), cluster.places.begin(), cluster.places.end());
  }
  return left;
}

}  // namespace secular
