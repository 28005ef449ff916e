#include "estimator/identification/record_order.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "numerics/quadratic_form.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Dwells of one excitation level: within this of the lowest of them, relative.
constexpr double one_level = 0.01;

template <class Value>
std::vector<std::size_t> ascending(std::size_t count, const Value& value) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return value(a) < value(b); });
  return order;
}

// By record, from the lowest on.
std::vector<std::size_t> levels_of_places(const std::vector<DwellPlace>& places) {
  std::vector<std::size_t> level(places.size());
  std::size_t now = 0;
  double lowest = 0;
  for (const std::size_t r : ascending(places.size(), [&](std::size_t at) { return places[at].level; })) {
    if (places[r].level > (1 + one_level) * lowest) {
      lowest = places[r].level;
      ++now;
    }
    level[r] = now;
  }
  return level;
}

// Of the sum of squared differences of records that follow one another in `order`, in the same `group`.
MatrixXd squared_differences(const std::vector<std::size_t>& order, const std::vector<std::size_t>& group) {
  const auto count = static_cast<Index>(order.size());
  MatrixXd form = MatrixXd::Zero(count, count);
  for (std::size_t n = 1; n < order.size(); ++n) {
    if (group[order[n]] != group[order[n - 1]]) continue;
    const auto a = static_cast<Index>(order[n - 1]), b = static_cast<Index>(order[n]);
    form(a, a) += 1;
    form(b, b) += 1;
    form(a, b) -= 1;
    form(b, a) -= 1;
  }
  return form;
}

}  // namespace

double order_p_value(const ScatterBetweenRecords& scatter, const std::vector<DwellPlace>& places) {
  const VectorXd shifts = Eigen::Map<const VectorXd>(scatter.shifts.data(), static_cast<Index>(places.size()));
  if (!(shifts.squaredNorm() > 0)) return 1;
  const auto tail = [&](const MatrixXd& form) {
    return form.isZero(0)
               ? 1
               : ratio_lower_tail(shifts.dot(form * shifts) / shifts.squaredNorm(), form, scatter.covariance);
  };
  const std::vector<std::size_t> level = levels_of_places(places), all(places.size(), 0);
  const auto in_time = ascending(places.size(), [&](std::size_t r) { return places[r].time; });
  const auto in_frequency =
      ascending(places.size(), [&](std::size_t r) { return std::pair(level[r], places[r].frequency); });
  return std::min(tail(squared_differences(in_time, all)), tail(squared_differences(in_frequency, level)));
}

}  // namespace secular
