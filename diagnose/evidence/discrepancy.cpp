#include "diagnose/evidence/discrepancy.hpp"

#include <Eigen/SVD>
#include <map>
#include <numeric>

#include "numerics/in_parallel.hpp"

namespace secular {

using Eigen::Index;

namespace {

/// Step of a relative change of a natural frequency: turns of a long stretch stay in step.
constexpr double frequency_step = 1e-6;

}  // namespace

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
  scatter_.records.clear();
  if (scatter_.relative_sd == 0) return;
  const Eigen::MatrixXd changes = scatter_.relative_sd * frequency_changes(unknowns, scatter_.modes);
  if (!changes.allFinite()) return;
  std::map<std::size_t, std::vector<Index>> rows_of;
  const std::vector<RowLabel> all = labels();
  for (std::size_t r = 0; r < all.size(); ++r) rows_of[all[r].record].push_back(static_cast<Index>(r));
  for (auto& [record, rows] : rows_of) {
    const Eigen::MatrixXd own = changes(rows, Eigen::all);
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(own, Eigen::ComputeThinU);
    scatter_.records.push_back(
        {std::move(rows), svd.matrixU(), (1 + svd.singularValues().array().square()).rsqrt()});
  }
}

void Discrepancy::admit_scatter(double relative_sd, std::size_t modes) {
  scatter_ = {relative_sd, modes, {}};
}

Eigen::MatrixXd Discrepancy::frequency_changes(const Eigen::VectorXd& unknowns, std::size_t modes) const {
  std::vector<std::size_t> which(modes);
  std::iota(which.begin(), which.end(), std::size_t{0});
  return raw_slopes(unknowns, which, frequency_step * unknowns.head(static_cast<Index>(modes)), 1) / frequency_step;
}

void Discrepancy::allow_for_scatter(Eigen::Ref<Eigen::MatrixXd> columns) const {
  for (const Scatter::OfRecord& record : scatter_.records) {
    Eigen::MatrixXd own = columns(record.rows, Eigen::all);
    const Eigen::MatrixXd along = record.directions.transpose() * own;
    own -= record.directions * ((1 - record.kept.array()).matrix().asDiagonal() * along);
    columns(record.rows, Eigen::all) = own;
  }
}

Eigen::VectorXd Discrepancy::operator()(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd rows(size());
  Index first = 0;
  for (const auto& part : parts_) {
    part->evaluate(unknowns, rows.segment(first, part->size()));
    first += part->size();
  }
  if (!scatter_.records.empty() && rows.allFinite()) allow_for_scatter(rows);
  return rows;
}

Eigen::MatrixXd Discrepancy::slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                                    const Eigen::VectorXd& scale, unsigned threads) const {
  Eigen::MatrixXd columns = raw_slopes(unknowns, which, scale, threads);
  if (!scatter_.records.empty()) allow_for_scatter(columns);
  return columns;
}

Eigen::MatrixXd Discrepancy::raw_slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
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
