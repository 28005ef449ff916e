#include "estimator/identification/phase_problem.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "estimator/identification/equation_data.hpp"
#include "numerics/unit_scale.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::vector<RecordMembers> members_of(const ObservationSet& set, const std::vector<std::size_t>& blocks) {
  const EquationData data(set, blocks, EquationData::Errors::none);
  std::map<std::size_t, RecordMembers> by_record;
  for (std::size_t i = 0; i < set.observations.size(); ++i) {
    const Index rows = data.row_count(i);
    if (rows == 0) continue;
    RecordMembers& record = by_record[set.observations[i].record];
    record.record = set.observations[i].record;
    if (!record.observations.empty() && data.row_count(record.observations.front()) != rows) {
      if (data.row_count(record.observations.front()) > rows) continue;
      record.observations.clear();
    }
    record.observations.push_back(i);
  }
  std::vector<RecordMembers> records;
  for (auto& [number, record] : by_record) records.push_back(std::move(record));
  return records;
}

}  // namespace

PhaseProblem::PhaseProblem(const ObservationSet& observed, std::vector<std::size_t> regressed,
                           const CaseKnowledge& given, unsigned with_threads)
    : set(observed),
      blocks(std::move(regressed)),
      known(given),
      threads(with_threads),
      records(members_of(observed, blocks)) {}

void turn(ObservationSet& set, const std::vector<RecordMembers>& records, const std::vector<double>& ahead) {
  std::map<std::size_t, double> by_record;
  for (std::size_t r = 0; r < records.size(); ++r) by_record[records[r].record] = ahead[r];
  for (Observation& o : set.observations)
    for (std::size_t j = 0; j < o.forcing.size(); ++j) o.forcing[j] *= put_ahead(o, j, by_record[o.record]);
}

ObservationSet turned(const PhaseProblem& problem, const std::vector<double>& ahead) {
  ObservationSet result = problem.set;
  turn(result, problem.records, ahead);
  return result;
}

void add_to(Equations& sum, double share, const Equations& part) {
  if (sum.response.size() == 0)
    sum = {MatrixXd::Zero(part.design.rows(), part.design.cols()), VectorXd::Zero(part.response.size())};
  sum.design += share * part.design;
  sum.response += share * part.response;
}

Equations stacked(const std::vector<const Equations*>& parts) {
  Index rows = 0;
  for (const Equations* part : parts) rows += part->response.size();
  Equations all{MatrixXd(rows, parts.front()->design.cols()), VectorXd(rows)};
  Index begin = 0;
  for (const Equations* part : parts) {
    all.design.middleRows(begin, part->design.rows()) = part->design;
    all.response.segment(begin, part->response.size()) = part->response;
    begin += part->response.size();
  }
  return all;
}

Solution least_squares(const Equations& all) {
  const VectorXd scale = unit_scale(all.design);
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(1e-9);
  solver.compute(all.design * scale.asDiagonal());
  Solution result;
  result.values = scale.cwiseProduct(VectorXd(solver.solve(all.response)));
  result.sum_of_squares = (all.response - all.design * result.values).squaredNorm();
  result.rank = solver.rank();
  return result;
}

bool agree(const std::vector<double>& a, const std::vector<double>& b, double enough) {
  return agree(a, b, std::vector<double>(a.size(), enough));
}

bool agree(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& enough) {
  for (std::size_t r = 0; r < a.size(); ++r)
    if (std::abs(std::remainder(a[r] - b[r], 2 * std::numbers::pi)) > enough[r]) return false;
  return true;
}

}  // namespace secular
