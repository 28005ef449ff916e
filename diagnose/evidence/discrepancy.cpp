#include "diagnose/evidence/discrepancy.hpp"

#include "numerics/in_parallel.hpp"

namespace secular {

using Eigen::Index;

bool has_frequencies(const Eigen::VectorXd& unknowns, std::size_t modes) {
  return (unknowns.head(static_cast<Index>(modes)).array() > 0).all();
}

Eigen::MatrixXd Evidence::slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                                 const Eigen::VectorXd& scale, unsigned threads) const {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(size(), static_cast<Index>(which.size()));
  in_parallel(which.size(), threads, [&](std::size_t i) {
    const auto column = static_cast<Index>(i), u = static_cast<Index>(which[i]);
    Eigen::VectorXd moved = unknowns, up(size()), down(size());
    moved(u) = unknowns(u) + 0.5 * scale(column);
    evaluate(moved, up);
    moved(u) = unknowns(u) - 0.5 * scale(column);
    evaluate(moved, down);
    up -= down;
    if (up.allFinite()) columns.col(column) = up;
  });
  return columns;
}

void Discrepancy::add(std::unique_ptr<Evidence> evidence) {
  parts_.push_back(std::move(evidence));
}

Index Discrepancy::size() const {
  Index sum = 0;
  for (const auto& part : parts_) sum += part->size();
  return sum;
}

Index Discrepancy::freedom() const {
  Index sum = 0;
  for (const auto& part : parts_) sum += part->freedom();
  return sum;
}

std::vector<RowLabel> Discrepancy::labels() const {
  std::vector<RowLabel> all;
  for (const auto& part : parts_) all.insert(all.end(), part->labels().begin(), part->labels().end());
  return all;
}

void Discrepancy::approach(const Eigen::VectorXd& unknowns) {
  for (const auto& part : parts_) part->approach(unknowns);
}

void Discrepancy::freeze(const Eigen::VectorXd& unknowns, double coarse) {
  for (const auto& part : parts_) part->freeze(unknowns, coarse);
}

Eigen::VectorXd Discrepancy::operator()(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd rows(size());
  Index first = 0;
  for (const auto& part : parts_) {
    part->evaluate(unknowns, rows.segment(first, part->size()));
    first += part->size();
  }
  return rows;
}

Eigen::MatrixXd Discrepancy::slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                                    const Eigen::VectorXd& scale, unsigned threads) const {
  Eigen::MatrixXd columns(size(), static_cast<Index>(which.size()));
  Index first = 0;
  for (const auto& part : parts_) {
    columns.middleRows(first, part->size()) = part->slopes(unknowns, which, scale, threads);
    first += part->size();
  }
  return columns;
}

Eigen::VectorXd Discrepancy::unmixed(const Eigen::VectorXd& rows) const {
  Eigen::VectorXd all(rows.size());
  Index first = 0;
  for (const auto& part : parts_) {
    all.segment(first, part->size()) = part->unmixed(rows.segment(first, part->size()));
    first += part->size();
  }
  return all;
}

}  // namespace secular
