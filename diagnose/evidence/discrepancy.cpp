#include "diagnose/evidence/discrepancy.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "numerics/in_parallel.hpp"

namespace secular {

using Eigen::Index;

namespace {

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
  return sum - static_cast<Index>(delay_sd_.size());  // a phase of each record's own
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
  late_.clear();
  if (delay_sd_.empty()) return;
  double step = 0;
  for (const auto& [record, sd] : delay_sd_) step = std::max(step, delay_step * sd);
  const Eigen::VectorXd by_delay =
      raw_slopes(unknowns, {delay_}, Eigen::VectorXd::Constant(1, step), 1).col(0) / step;
  if (!by_delay.allFinite()) return;
  std::map<std::size_t, std::vector<Index>> rows_of;
  const std::vector<RowLabel> all = labels();
  for (std::size_t r = 0; r < all.size(); ++r)
    if (delay_sd_.contains(all[r].record)) rows_of[all[r].record].push_back(static_cast<Index>(r));
  for (auto& [record, rows] : rows_of) {
    const Eigen::VectorXd own = delay_sd_.at(record) * by_delay(rows);
    const double size = own.norm();
    if (size > 0) late_.push_back({std::move(rows), own / size, 1 / std::sqrt(1 + size * size)});
  }
}

void Discrepancy::admit_lateness(std::size_t delay, std::map<std::size_t, double> sd) {
  delay_ = delay;
  delay_sd_ = std::move(sd);
}

void Discrepancy::allow_for_lateness(Eigen::Ref<Eigen::MatrixXd> columns) const {
  for (const LateRecord& record : late_) {
    const Eigen::MatrixXd own = columns(record.rows, Eigen::all);
    columns(record.rows, Eigen::all) =
        own - (1 - record.kept) * record.direction * (record.direction.transpose() * own);
  }
}

Eigen::VectorXd Discrepancy::operator()(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd rows(size());
  Index first = 0;
  for (const auto& part : parts_) {
    part->evaluate(unknowns, rows.segment(first, part->size()));
    first += part->size();
  }
  if (!late_.empty() && rows.allFinite()) allow_for_lateness(rows);
  return rows;
}

Eigen::MatrixXd Discrepancy::slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                                    const Eigen::VectorXd& scale, unsigned threads) const {
  Eigen::MatrixXd columns = raw_slopes(unknowns, which, scale, threads);
  if (!late_.empty()) allow_for_lateness(columns);
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
