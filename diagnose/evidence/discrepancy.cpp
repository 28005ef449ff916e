#include "diagnose/evidence/discrepancy.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "diagnose/thresholds.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {

using Eigen::Index;

namespace {

/// Step of what is a record's own, next to its standard deviation: differences are as good as slopes.
constexpr double nuisance_step = 1e-4;

/// Rounds in which what is put into a record comes to where a step moves its rows by less than is seen: what is
/// left is linear.
constexpr int most_rounds = 4;

/// No record's frequency is put farther from that of all than this many standard deviations: once in 16,000.
constexpr auto& most_deviations = diagnose_thresholds().most_deviations;

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

void Discrepancy::admit(RecordNuisances nuisances) {
  nuisances_ = std::move(nuisances);
  in_reach_ = false;
  record_periods_.clear();
  for (const auto& [record, sd] : nuisances_.delay_sd) record_periods_[record] = std::sqrt(12.0) * sd;
}

void Discrepancy::add(std::unique_ptr<Evidence> evidence) {
  parts_.push_back(std::move(evidence));
}

bool Discrepancy::measures_errors() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->measures_errors(); });
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

Index Discrepancy::measured_rows() const {
  Index sum = 0;
  for (const auto& part : parts_) sum += part->measured_rows();
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

void Discrepancy::freeze(const Eigen::VectorXd& unknowns, double coarse, Lookout lookout) {
  // Records count as in step until numbers have been fitted, and are looked for anywhere once at least.
  const bool late = std::exchange(in_reach_, true) && !nuisances_.delay_sd.empty();
  if (late && record_late_s_.empty()) lookout = Lookout::anywhere;
  for (int round = 1; round <= most_rounds; ++round) {
    for (const auto& part : parts_) {
      part->set_frequency_offsets(frequency_offsets_);
      if (late)
        part->put_in_step(unknowns, coarse, round > 1 ? Lookout::close_by : lookout, record_periods_,
                          record_late_s_);
      part->freeze(unknowns, coarse);
    }
    take_directions(unknowns);
    if (round == most_rounds || !put_in_own(unknowns)) return;
  }
}

// Columns of a record: its lateness where that is admitted, what is between the samples of its blow, then its
// natural frequencies.
void Discrepancy::take_directions(const Eigen::VectorXd& unknowns) {
  directions_.clear();
  const BetweenSamples& blows = nuisances_.of_blows;
  if (!nuisances_.any() && blows.records.empty()) return;
  double step = 0;
  for (const auto& [record, sd] : nuisances_.delay_sd) step = std::max(step, nuisance_step * sd);
  Eigen::VectorXd by_delay = Eigen::VectorXd::Zero(size());
  if (step > 0)
    by_delay = raw_slopes(unknowns, {nuisances_.delay}, Eigen::VectorXd::Constant(1, step), 1).col(0) / step;
  std::vector<std::size_t> frequencies(static_cast<std::size_t>(modes()));
  std::iota(frequencies.begin(), frequencies.end(), std::size_t{0});
  const Eigen::VectorXd steps = nuisance_step * nuisances_.frequency_sd.cwiseProduct(unknowns.head(modes()));
  const Eigen::MatrixXd by_frequency = raw_slopes(unknowns, frequencies, steps, 1) / nuisance_step;
  Eigen::MatrixXd by_blow = Eigen::MatrixXd::Zero(size(), blows.records.empty() ? 0 : 2);
  Index first = 0;
  for (const auto& part : parts_) {
    const Eigen::MatrixXd of_part = part->between_samples(unknowns, blows);
    if (of_part.cols() > 0) by_blow.middleRows(first, part->size()) = of_part;
    first += part->size();
  }
  if (!by_blow.allFinite()) by_blow.setZero();
  if (!by_delay.allFinite() || !by_frequency.allFinite()) return;
  std::map<std::size_t, std::vector<Index>> rows_of;
  const std::vector<RowLabel> all = labels();
  for (std::size_t r = 0; r < all.size(); ++r)
    if (modes() > 0 || nuisances_.delay_sd.contains(all[r].record) || blows.records.contains(all[r].record))
      rows_of[all[r].record].push_back(static_cast<Index>(r));
  for (auto& [record, rows] : rows_of) {
    const auto late = nuisances_.delay_sd.find(record);
    const Index delays = late == nuisances_.delay_sd.end() ? 0 : 1;
    const Index of_blow = blows.records.contains(record) ? by_blow.cols() : 0;
    Eigen::MatrixXd columns(static_cast<Index>(rows.size()), delays + of_blow + modes());
    if (delays > 0) columns.col(0) = late->second * by_delay(rows);
    columns.middleCols(delays, of_blow) = by_blow(rows, Eigen::all).leftCols(of_blow);
    columns.rightCols(modes()) = by_frequency(rows, Eigen::all);
    if (columns.isZero(0)) continue;
    Eigen::VectorXd put_in = Eigen::VectorXd::Zero(columns.cols());
    if (const auto offset = frequency_offsets_.find(record); offset != frequency_offsets_.end() && modes() > 0)
      put_in.tail(modes()) = offset->second.cwiseQuotient(nuisances_.frequency_sd);
    directions_.emplace(record, RecordDirections(std::move(rows), std::move(columns), std::move(put_in)));
  }
}

// Whether a record's own frequencies moved so far that its directions are others now. What its lateness may differ
// by from where it was put may be anything again, and is left to its direction.
bool Discrepancy::put_in_own(const Eigen::VectorXd& unknowns) {
  if (directions_.empty() || modes() == 0) return false;
  const Eigen::VectorXd rows = raw_rows(unknowns);
  if (!rows.allFinite()) return false;
  bool moved = false;
  for (const auto& [record, directions] : directions_) {
    Eigen::VectorXd next = directions.likeliest(rows), before = Eigen::VectorXd::Zero(next.size());
    if (!next.allFinite()) continue;
    Eigen::VectorXd& offset = frequency_offsets_.try_emplace(record, Eigen::VectorXd::Zero(modes())).first->second;
    before.tail(modes()) = offset.cwiseQuotient(nuisances_.frequency_sd);
    next.tail(modes()) = next.tail(modes()).cwiseMax(-most_deviations).cwiseMin(most_deviations);
    next.head(next.size() - modes()).setZero();
    if (directions.length_of(next - before) < negligible_step) continue;
    offset = next.tail(modes()).cwiseProduct(nuisances_.frequency_sd);
    moved = true;
  }
  return moved;
}

std::vector<OwnLateness> Discrepancy::own_lateness() const {
  std::map<std::size_t, RowLabel> labels_of;
  for (const RowLabel& label : labels()) labels_of.emplace(label.record, label);
  std::vector<OwnLateness> told;
  const Eigen::VectorXd rows = Eigen::VectorXd::Zero(size());  // variances do not depend on them
  std::complex<double> mean = 0;
  double period = 0;
  for (const auto& [record, late_s] : record_late_s_) {
    const auto directions = directions_.find(record);
    if (directions == directions_.end()) continue;
    const double sd = nuisances_.delay_sd.at(record), variance = directions->second.told(rows, 0).variance;
    // A record at rest does not feel its excitation.
    if (!(variance < 1)) continue;
    const RowLabel& label = labels_of.at(record);
    told.push_back({record, late_s, sd * sd * variance, record_periods_.at(record), label.level, label.frequency});
    mean += std::polar(1.0, label.frequency * late_s);
    period += told.back().period_s;
  }
  const double centre = std::arg(mean) / (2 * std::numbers::pi) * period / static_cast<double>(told.size());
  for (OwnLateness& own : told) own.late_s = centre + std::remainder(own.late_s - centre, own.period_s);
  return told;
}

Eigen::VectorXd Discrepancy::raw_rows(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd rows(size());
  Index first = 0;
  for (const auto& part : parts_) {
    part->evaluate(unknowns, rows.segment(first, part->size()));
    first += part->size();
  }
  return rows;
}

Eigen::VectorXd Discrepancy::operator()(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd rows = raw_rows(unknowns);
  if (!directions_.empty() && rows.allFinite())
    for (const auto& [record, directions] : directions_) directions.whiten_rows(rows);
  return rows;
}

Eigen::MatrixXd Discrepancy::slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                                    const Eigen::VectorXd& scale, unsigned threads) const {
  Eigen::MatrixXd columns = raw_slopes(unknowns, which, scale, threads);
  for (const auto& [record, directions] : directions_) directions.whiten_slopes(columns);
  return columns;
}

double Discrepancy::share_of_records(Eigen::VectorXd column) const {
  const double all = column.squaredNorm();
  if (modes() == 0 || !(all > 0)) return 0;
  for (const auto& [record, directions] : directions_) directions.whiten_slopes(column);
  return 1 - column.squaredNorm() / all;
}

std::vector<OwnFrequency> Discrepancy::own_frequencies(const Eigen::VectorXd& unknowns) const {
  std::vector<OwnFrequency> told;
  if (modes() == 0) return told;
  const Eigen::VectorXd rows = raw_rows(unknowns);
  if (!rows.allFinite()) return told;
  for (const auto& [record, directions] : directions_)
    for (Index k = 0; k < modes(); ++k) {
      const RecordDirections::Told own = directions.told(rows, directions.size() - modes() + k);
      const double sd = nuisances_.frequency_sd(k);
      // Of others the rows tell less than is known without them.
      if (own.variance < 1)
        told.push_back({record, static_cast<std::size_t>(k), sd * own.value, sd * sd * own.variance});
    }
  return told;
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

Eigen::VectorXd Discrepancy::part_by_part(const Eigen::VectorXd& rows, RowsOfPart of_part) const {
  Eigen::VectorXd all(rows.size());
  Index first = 0;
  for (const auto& part : parts_) {
    all.segment(first, part->size()) = (*part.*of_part)(rows.segment(first, part->size()));
    first += part->size();
  }
  return all;
}

}  // namespace secular
