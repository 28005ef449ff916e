#include "diagnose/evidence/discrepancy.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <map>
#include <numeric>

#include "numerics/in_parallel.hpp"

namespace secular {

using Eigen::Index;

namespace {

/// Step of a relative change of a natural frequency: turns of a long stretch stay in step.
constexpr double frequency_step = 1e-6;

/// Step of a delay, next to what it scatters by: a small part of a turn.
constexpr double delay_step = 1e-4;

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
  return sum - static_cast<Index>(nuisances_.delay_sd.size());  // a phase of each record's own
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
  nuisances_.records.clear();
  if (!nuisances_.any()) return;
  std::map<std::size_t, std::vector<Index>> rows_of;
  const std::vector<RowLabel> all = labels();
  for (std::size_t r = 0; r < all.size(); ++r) rows_of[all[r].record].push_back(static_cast<Index>(r));
  const Eigen::MatrixXd changes = changes_by_nuisances(unknowns, rows_of);
  if (!changes.allFinite()) return;
  for (auto& [record, rows] : rows_of) {
    const Eigen::MatrixXd own = changes(rows, Eigen::all);
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(own, Eigen::ComputeThinU);
    nuisances_.records.push_back(
        {std::move(rows), svd.matrixU(), (1 + svd.singularValues().array().square()).rsqrt()});
  }
}

void Discrepancy::admit_scatter(double relative_sd, std::size_t modes) {
  nuisances_.relative_sd = relative_sd;
  nuisances_.modes = modes;
}

void Discrepancy::admit_lateness(std::size_t delay, std::map<std::size_t, double> sd) {
  nuisances_.delay = delay;
  nuisances_.delay_sd = std::move(sd);
}

Eigen::MatrixXd Discrepancy::changes_by_nuisances(const Eigen::VectorXd& unknowns,
                                                  const std::map<std::size_t, std::vector<Index>>& rows_of) const {
  Eigen::MatrixXd changes(size(), 0);
  if (nuisances_.relative_sd > 0) changes = nuisances_.relative_sd * frequency_changes(unknowns, nuisances_.modes);
  if (nuisances_.delay_sd.empty()) return changes;
  double step = 0;
  for (const auto& [record, sd] : nuisances_.delay_sd) step = std::max(step, delay_step * sd);
  Eigen::VectorXd late = raw_slopes(unknowns, {nuisances_.delay}, Eigen::VectorXd::Constant(1, step), 1) / step;
  for (const auto& [record, rows] : rows_of) {
    const auto sd = nuisances_.delay_sd.find(record);
    late(rows) *= sd == nuisances_.delay_sd.end() ? 0 : sd->second;
  }
  changes.conservativeResize(Eigen::NoChange, changes.cols() + 1);
  changes.rightCols<1>() = late;
  return changes;
}

Eigen::MatrixXd Discrepancy::frequency_changes(const Eigen::VectorXd& unknowns, std::size_t modes) const {
  std::vector<std::size_t> which(modes);
  std::iota(which.begin(), which.end(), std::size_t{0});
  return slopes(unknowns, which, frequency_step * unknowns.head(static_cast<Index>(modes)), 1) / frequency_step;
}

void Discrepancy::allow_for_nuisances(Eigen::Ref<Eigen::MatrixXd> columns) const {
  for (const Nuisances::OfRecord& record : nuisances_.records) {
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
  if (!nuisances_.records.empty() && rows.allFinite()) allow_for_nuisances(rows);
  return rows;
}

Eigen::MatrixXd Discrepancy::slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                                    const Eigen::VectorXd& scale, unsigned threads) const {
  Eigen::MatrixXd columns = raw_slopes(unknowns, which, scale, threads);
  if (!nuisances_.records.empty()) allow_for_nuisances(columns);
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
