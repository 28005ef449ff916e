#include "diagnose/evidence/observe_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "diagnose/evidence/dwell_ensembles.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

LineNumber number_of(const DwellLines& lines, Index line) {
  const int over = lines.torus->phase(line)[0], common = std::max(1, std::gcd(over, lines.layout.divisor));
  return {over / common, over == 0 ? 1 : lines.layout.divisor / common};
}

class RowsObserver {
 public:
  RowsObserver(const DwellContext& context, const std::vector<IndexedRow>& rows)
      : context_(context), rows_(rows), omega_(two_pi * rows.front().second->frequency_hz) {}

  std::optional<RowsDwell> observe() {
    const SensorModel& sensors = context_.sensors;
    if (sensors.excitations.empty()) return left_out("a table without an excitation channel");
    if (!context_.window.passes(omega_))
      return left_out(fmt::format("its excitation at {:.4g} Hz is outside of the band", omega_ / two_pi));
    for (const LineLayout& layout : possible_layouts(context_.natural_frequency, omega_)) {
      if (layout.dimensions != 1) continue;  // whose lines are at no multiples of the excitation's frequency
      const DwellLines lines = lines_of(layout);
      if (!lines.observes(lines.fundamental)) return left_out("it lacks a channel at the excitation's frequency");
      std::vector<LineEnsemble> ensembles;
      for (const auto& [record, row] : rows_) ensembles.push_back(ensemble_of(*row, lines));
      align(ensembles, lines);
      RowsDwell found;
      fill(ensembles, lines, found);
      Condition& c = found.dwell.condition;
      const bool whole = find_masters(lines, found, c);
      if (layout.divisor > 1 && (!whole || c.masters.empty())) continue;
      return found;
    }
    return left_out("its motion fits no resonance of model " + std::string(context_.model.name));
  }

  const std::string& reason() const { return reason_; }

 private:
  std::nullopt_t left_out(std::string reason) {
    reason_ = std::move(reason);
    return std::nullopt;
  }

  bool in_all(std::size_t channel, LineNumber number) const {
    return std::all_of(rows_.begin(), rows_.end(),
                       [&](const IndexedRow& row) { return row.second->find(channel, number) != nullptr; });
  }

  DwellLines lines_of(const LineLayout& layout) const {
    DwellLines lines;
    lines.layout = layout;
    lines.base = {omega_ / layout.divisor, 0};
    lines.torus = torus_of_turns(layout.divisor);
    lines.fundamental = *lines.torus->find(layout.excitation);
    for (Index l = 0; l < lines.torus->lines(); ++l) {
      const LineNumber number = number_of(lines, l);
      if (!context_.window.passes(number.of(omega_))) continue;
      if (l == 0 && any_wanders(context_.wandering, context_.sensors.responses)) continue;
      const auto there = [&](std::size_t channel) { return in_all(channel, number); };
      const SensorModel& sensors = context_.sensors;
      if (std::all_of(sensors.responses.begin(), sensors.responses.end(), there)) lines.observed.push_back(l);
      if (std::all_of(sensors.excitations.begin(), sensors.excitations.end(), there)) lines.excitation.push_back(l);
    }
    return lines;
  }

  LineEnsemble ensemble_of(const LineRow& row, const DwellLines& lines) const {
    const auto values = [&](const std::vector<std::size_t>& channels, const std::vector<Index>& at) {
      Eigen::MatrixXcd all(static_cast<Index>(channels.size()), static_cast<Index>(at.size()));
      for (std::size_t c = 0; c < channels.size(); ++c)
        for (std::size_t l = 0; l < at.size(); ++l) {
          const LineNumber number = number_of(lines, at[l]);
          all(static_cast<Index>(c), static_cast<Index>(l)) =
              row.find(channels[c], number)->amplitude * (number.is_mean() ? 1 : 0.5);
        }
      return all;
    };
    return {values(context_.sensors.responses, lines.observed),
            values(context_.sensors.excitations, lines.excitation),
            {}};
  }

  // By channel and line, of half of the peak, the root mean square over the rows; nothing where any is not known.
  std::optional<MatrixXd> stated(const std::vector<std::size_t>& channels, const std::vector<Index>& at,
                                 const DwellLines& lines) const {
    MatrixXd sd = MatrixXd::Zero(static_cast<Index>(channels.size()), static_cast<Index>(at.size()));
    for (std::size_t c = 0; c < channels.size(); ++c)
      for (std::size_t l = 0; l < at.size(); ++l) {
        const LineNumber number = number_of(lines, at[l]);
        double squares = 0;
        for (const auto& [record, row] : rows_) {
          const bool drives = context_.campaign.channels[channels[c]].role == ChannelRole::excitation;
          std::optional<double> line = row->sd_of(channels[c], number);
          if (!line && drives) line = 0;
          if (!line) return std::nullopt;
          squares += *line * *line;
        }
        sd(static_cast<Index>(c), static_cast<Index>(l)) =
            (number.is_mean() ? 1 : 0.5) * std::sqrt(squares / static_cast<double>(rows_.size()));
      }
    return sd;
  }

  void fill(const std::vector<LineEnsemble>& ensembles, const DwellLines& lines, RowsDwell& found) const {
    Dwell& dwell = found.dwell;
    Condition& c = dwell.condition;
    const auto count = static_cast<double>(ensembles.size());
    dwell.ensembles = ensembles.size();
    dwell.degrees_of_freedom = count - 1;
    c.response = ensembles.front().response;
    c.excitation = ensembles.front().excitation;
    const bool repeats = ensembles.size() > 1;
    if (repeats) {
      const EnsembleStatistics statistics = statistics_of(ensembles, lines);
      c.response = statistics.response;
      c.excitation = statistics.excitation;
      dwell.response_scatter = statistics.response_scatter;
      dwell.excitation_scatter = statistics.excitation_scatter;
    } else {
      dwell.response_scatter = MatrixXd::Zero(c.response.rows(), c.response.cols());
      dwell.excitation_scatter = MatrixXd::Zero(c.excitation.rows(), c.excitation.cols());
    }
    const auto responses = stated(context_.sensors.responses, lines.observed, lines),
               excitations = stated(context_.sensors.excitations, lines.excitation, lines);
    found.errors_known = responses && excitations;
    if (found.errors_known) {
      dwell.response_scatter = *responses;
      dwell.excitation_scatter = *excitations;
    }
    c.samples = static_cast<Index>(ensembles.size());
    c.record = rows_.front().first;
    c.fold = static_cast<int>(c.record);
    c.torus = lines.torus;
    c.rate = {Complex(0, lines.base[0]), Complex(0, lines.base[1])};
    c.fundamental = lines.fundamental;
    c.lines = lines.observed;
    c.excitation_lines = lines.excitation;
  }

  // Whether every resonance of the layout shows.
  bool find_masters(const DwellLines& lines, const RowsDwell& found, Condition& c) const {
    bool whole = true;
    for (const LineLayout::Resonance& resonance : lines.layout.resonances) {
      const auto line = lines.torus->find(resonance.line);
      if (!line || !lines.observes(*line)) {
        whole = false;
        continue;
      }
      const Index column = lines.column(*line);
      const Eigen::RowVectorXd weights = context_.sensors.filter.row(static_cast<Index>(resonance.mode));
      const double amplitude = std::abs((weights.cast<Complex>() * c.response.col(column))(0));
      const double sd = weights.cwiseProduct(found.dwell.response_scatter.col(column).transpose()).norm() /
                        std::sqrt(static_cast<double>(found.dwell.ensembles));
      if (!(amplitude > diagnose_thresholds().present * sd)) {
        whole = false;
        c.resting.push_back({resonance.mode, *line});
        continue;
      }
      c.masters.push_back({resonance.mode, *line});
      c.amplitude_drift_rate.emplace_back();
      c.amplitude_drift_rate_sd.push_back(0);
    }
    return whole;
  }

  const DwellContext& context_;
  const std::vector<IndexedRow>& rows_;
  double omega_;
  std::string reason_;
};

}  // namespace

std::optional<RowsDwell> observe_rows(const DwellContext& context, const std::vector<IndexedRow>& rows,
                                      std::vector<std::string>& warnings) {
  RowsObserver observer(context, rows);
  std::optional<RowsDwell> dwell = observer.observe();
  if (!dwell)
    warnings.push_back(context.campaign.records[rows.front().first].file + ": " + observer.reason() + ", left out");
  return dwell;
}

std::vector<std::vector<std::size_t>> row_conditions(const Campaign& campaign, const Window& window) {
  std::vector<std::vector<std::size_t>> conditions;
  std::map<std::pair<std::string, long long>, std::size_t> labelled;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (!entry.row || !window.takes(r, entry.file)) continue;
    if (entry.row->condition) {
      const auto [at, is_new] = labelled.try_emplace({entry.row->table, *entry.row->condition}, conditions.size());
      if (!is_new) {
        conditions[at->second].push_back(r);
        continue;
      }
    }
    conditions.push_back({r});
  }
  return conditions;
}

}  // namespace secular
