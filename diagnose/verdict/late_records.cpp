#include "diagnose/verdict/late_records.hpp"

#include <Eigen/Core>

#include "diagnose/evidence/record_directions.hpp"
#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// That lateness differs by chance.
constexpr auto& lateness_alarm = diagnose_thresholds().scatter_alarm;

/// Of lateness beside its functions: the F law (5 %) with six of these sees what makes 0.6 of the variance.
constexpr Index plain_freedom = 12;

VectorXd settings(const OwnLateness& own) {
  const double level = own.level, w = own.frequency;
  return VectorXd{{1, level * level, w, static_cast<double>(own.record), level, level * w, w * w}};
}

}  // namespace

LateRecords lateness_about(const Discrepancy& discrepancy) {
  LateRecords result;
  result.records = discrepancy.own_lateness();
  if (result.records.empty()) return result;
  std::vector<VectorXd> of_records;
  VectorXd late_s(static_cast<Index>(result.records.size())), variance(late_s.size());
  for (const OwnLateness& own : result.records) {
    late_s(static_cast<Index>(of_records.size())) = own.late_s;
    variance(static_cast<Index>(of_records.size())) = own.variance;
    of_records.push_back(settings(own));
  }
  const Between between = between_records(late_s, variance, MatrixXd::Ones(late_s.size(), 1));
  result.differ = between.p_value < lateness_alarm;
  const MatrixXd functions = independent_functions(of_records);
  result.plain = late_s.size() - functions.cols() >= plain_freedom;
  // Beside functions as beside a mean, errors differ: a record that is hardly known hides no law in the others.
  const double sd = between_records(late_s, variance, functions).sd;
  const VectorXd weight = (variance.array() + sd * sd).rsqrt();
  result.following = follows_settings(weight.cwiseProduct(late_s), weight.asDiagonal() * functions);
  return result;
}

}  // namespace secular
