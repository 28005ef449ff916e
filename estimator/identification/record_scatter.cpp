#include "estimator/identification/record_scatter.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A record's rows, of the column x of one natural frequency.
struct RecordPart {
  double squares = 0;                                  // |x_r|^2
  double product = 0;                                  // x_r'e
  VectorXd seen;                                       // U_r'x_r
  std::map<int, std::pair<double, double>> stretches;  // |x_g|^2, x_g'e
};

std::map<std::size_t, RecordPart> parts_of(const CaseFit& fit, Index column) {
  std::map<std::size_t, RecordPart> records;
  for (Index row = 0; row < fit.system.design.rows(); ++row) {
    const auto at = static_cast<std::size_t>(row);
    const double x = fit.system.design(row, column), e = fit.fit.residual(row);
    if (x == 0) continue;
    RecordPart& part = records[fit.set->observations[fit.system.observation[at]].record];
    if (part.seen.size() == 0) part.seen = VectorXd::Zero(fit.fit.rank);
    auto& [squares, product] = part.stretches[fit.system.condition[at]];
    squares += x * x;
    product += x * e;
    part.squares += x * x;
    part.product += x * e;
    part.seen += x * fit.fit.orthonormal.row(row).transpose();
  }
  return records;
}

// Variance V of x_r'e by what the stretches of the record scatter about their common shift: with shares w_g of
// |x_r|^2, sum (x_g'e - w_g x_r'e)^2 is (1 - sum w_g^2) V on average. Infinite where one stretch is all.
double variance_of_product(const RecordPart& part) {
  double sum = 0, left = 1;
  for (const auto& [label, stretch] : part.stretches) {
    const double share = stretch.first / part.squares;
    sum += std::pow(stretch.second - share * part.product, 2);
    left -= share * share;
  }
  return left > 1e-6 ? sum / left : std::numeric_limits<double>::infinity();
}

// Variance of the natural frequency between records, by moments: what x_r'e show of it beyond the scatter of
// stretches.
double variance_between(const std::map<std::size_t, RecordPart>& records) {
  double excess = 0, share = 0;
  for (const auto& [index, part] : records) {
    const double leverage = part.seen.squaredNorm() / part.squares;
    const double by_stretches = variance_of_product(part);
    if (!std::isfinite(by_stretches)) return 0;
    excess += (part.product * part.product - by_stretches * (1 - leverage)) / part.squares;
    for (const auto& [other, of_other] : records) {
      const double own = index == other ? part.squares : 0;
      share += std::pow(own - part.seen.dot(of_other.seen), 2) / part.squares;
    }
  }
  return share > 0 ? excess / share : 0;
}

}  // namespace

std::size_t count_of_records(const ObservationSet& set) {
  std::set<std::size_t> records;
  for (const Observation& o : set.observations) records.insert(o.record);
  return records.size();
}

MatrixXd record_scatter(const CaseFit& fit) {
  MatrixXd moves(fit.fit.coefficients.size(), 0);
  if (fit.set->resonance->excited || fit.fit.rank == 0) return moves;
  const Eigen::LDLT<MatrixXd> kept(fit.fit.kept);
  for (std::size_t c = 0; c < fit.columns.size(); ++c) {
    if (fit.columns[c].kind != CaseColumn::Kind::natural_frequency) continue;
    const std::map<std::size_t, RecordPart> records = parts_of(fit, static_cast<Index>(c));
    if (records.size() < 2) continue;
    const double variance = variance_between(records);
    if (!(variance > 0)) continue;
    for (const auto& [index, part] : records) {
      moves.conservativeResize(Eigen::NoChange, moves.cols() + 1);
      moves.rightCols(1) = std::sqrt(variance) * (fit.fit.basis * kept.solve(part.seen));
    }
  }
  return moves;
}

}  // namespace secular
