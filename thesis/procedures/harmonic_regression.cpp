#include "thesis/procedures/harmonic_regression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace secular {

using Eigen::Index;

HarmonicFit harmonic_regression(const HarmonicData& data) {
  const Index rows = data.target.size(), columns = data.columns.cols();
  if (data.columns.rows() != rows || data.condition.size() != static_cast<std::size_t>(rows) || rows == 0)
    throw std::invalid_argument("a harmonic regression needs equal numbers of rows everywhere, and some");
  Eigen::MatrixXd design(2 * rows, columns);
  Eigen::VectorXd response(2 * rows);
  std::vector<int> cluster;
  for (Index r = 0; r < rows; ++r) {
    design.row(2 * r) = data.columns.row(r).real();
    design.row(2 * r + 1) = data.columns.row(r).imag();
    response.segment<2>(2 * r) << data.target(r).real(), data.target(r).imag();
    cluster.insert(cluster.end(), 2, data.condition[static_cast<std::size_t>(r)]);
  }
  HarmonicFit result;
  result.pooled = linear_fit(design, response, cluster);
  for (const int label : data.condition)
    if (std::find(result.conditions.begin(), result.conditions.end(), label) == result.conditions.end())
      result.conditions.push_back(label);
  const auto conditions = static_cast<Index>(result.conditions.size());
  result.by_condition.resize(conditions, columns);
  for (Index c = 0; c < conditions; ++c) {
    std::vector<Index> chosen;
    for (Index r = 0; r < 2 * rows; ++r)
      if (cluster[static_cast<std::size_t>(r)] == result.conditions[static_cast<std::size_t>(c)])
        chosen.push_back(r);
    const std::vector<int> alone(chosen.size(), 0);
    result.by_condition.row(c) =
        linear_fit(design(chosen, Eigen::all), response(chosen), alone).coefficients.transpose();
  }
  result.mean = result.by_condition.colwise().mean().transpose();
  const Eigen::MatrixXd centred = result.by_condition.rowwise() - result.mean.transpose();
  result.sd =
      conditions > 1
          ? Eigen::VectorXd(
                (centred.colwise().squaredNorm() / static_cast<double>(conditions - 1)).cwiseSqrt().transpose())
          : Eigen::VectorXd::Constant(columns, std::numeric_limits<double>::quiet_NaN());
  return result;
}

}  // namespace secular
