#include "diagnose/evidence/observe_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "diagnose/evidence/observe_rows.hpp"
#include "diagnose/evidence/pooled_scatter.hpp"
#include "measure/data/campaign_clock.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Of rows that are repeats, in all, from which their scatter is read as noise (derived: four pairs know it to a
/// third, 1/sqrt(2*4)).
constexpr double fewest_degrees_of_repeats = 4;

enum class LineKind { mean, resonant, other };
constexpr LineKind line_kinds[] = {LineKind::mean, LineKind::resonant, LineKind::other};

// Errors of the means of dwells, from how ensembles scatter in all of them, by channel and kind of line.
class Repeatability {
 public:
  Repeatability(const std::vector<Dwell>& dwells, bool excitation) : excitation_(excitation) {
    if (dwells.empty()) return;
    for (Index c = 0; c < scatter(dwells.front()).rows(); ++c)
      for (const LineKind kind : line_kinds) {
        std::vector<LineScatter> lines;
        for (const Dwell& dwell : dwells)
          for (Index l = 0; l < scatter(dwell).cols(); ++l)
            if (kind_of(dwell, c, l) == kind && dwell.degrees_of_freedom > 0)
              lines.push_back(scatter_at(dwell, c, l));
        pooled_.try_emplace({c, kind}, std::move(lines));
      }
  }

  MatrixXd of(const Dwell& dwell) const {
    MatrixXd sd(scatter(dwell).rows(), scatter(dwell).cols());
    for (Index c = 0; c < sd.rows(); ++c)
      for (Index l = 0; l < sd.cols(); ++l) sd(c, l) = of_one(dwell, c, l);
    return sd / std::sqrt(static_cast<double>(dwell.ensembles));
  }

 private:
  double of_one(const Dwell& dwell, Index channel, Index column) const {
    const LineKind kind = kind_of(dwell, channel, column);
    const LineScatter own = scatter_at(dwell, channel, column);
    const double sd = pooled_.at({channel, kind}).sd(own);
    // A line near resonance varies with the structure; it is never quieter than the channel's other lines.
    return kind == LineKind::resonant ? std::max(sd, pooled_.at({channel, LineKind::other}).sd({own.frequency}))
                                      : sd;
  }

  LineScatter scatter_at(const Dwell& dwell, Index channel, Index column) const {
    return {std::abs(dwell.condition.line_rate(line(dwell, column)).imag()), scatter(dwell)(channel, column),
            (kind_of(dwell, channel, column) == LineKind::mean ? 1 : 2) * dwell.degrees_of_freedom};
  }
  const MatrixXd& scatter(const Dwell& dwell) const {
    return excitation_ ? dwell.excitation_scatter : dwell.response_scatter;
  }
  Index line(const Dwell& dwell, Index column) const {
    const Condition& c = dwell.condition;
    return (excitation_ ? c.excitation_lines : c.lines)[static_cast<std::size_t>(column)];
  }
  LineKind kind_of(const Dwell& dwell, Index channel, Index column) const {
    const Condition& c = dwell.condition;
    const Index line = this->line(dwell, column);
    if (line == 0) return LineKind::mean;
    const bool resonant = excitation_ ? line == c.tone_of(channel)
                                      : std::any_of(c.masters.begin(), c.masters.end(),
                                                    [&](const MasterLine& m) { return m.line == line; });
    return resonant ? LineKind::resonant : LineKind::other;
  }

  bool excitation_;
  std::map<std::pair<Index, LineKind>, PooledScatter> pooled_;
};

// Noise of a channel's samples: the median over all dwells, since the ones that saturate show less of it.
Eigen::VectorXd typical_noise(const std::vector<Dwell>& dwells) {
  // Rows of tables tell no noise of samples.
  const auto sampled =
      std::find_if(dwells.begin(), dwells.end(), [](const Dwell& dwell) { return dwell.noise.size() > 0; });
  if (sampled == dwells.end()) return {};
  Eigen::VectorXd noise(sampled->noise.size());
  for (Index c = 0; c < noise.size(); ++c) {
    std::vector<double> of_dwells;
    for (const Dwell& dwell : dwells)
      if (dwell.noise.size() > 0) of_dwells.push_back(dwell.noise(c));
    noise(c) = upper_median(std::move(of_dwells));
  }
  return noise;
}

// Rows of tables: those that know their errors are conditions as they are, the others are dwells whose ensembles
// they are, if any of them are repeats.
void add_rows(const DwellContext& context, const RecordReader& read, std::vector<Dwell>& dwells,
              ObservedConditions& observed) {
  std::vector<Dwell> scattering;
  double freedom = 0;
  for (const std::vector<std::size_t>& condition : row_conditions(context.campaign, context.window)) {
    std::vector<Record> records;
    std::vector<IndexedRow> rows;
    for (const std::size_t r : condition) records.push_back(read(r));
    for (std::size_t i = 0; i < condition.size(); ++i) rows.emplace_back(condition[i], records[i].row.get());
    std::optional<RowsDwell> found = observe_rows(context, rows, observed.warnings);
    if (!found) continue;
    Dwell& dwell = found->dwell;
    if (!found->errors_known) {
      freedom += dwell.degrees_of_freedom;
      scattering.push_back(std::move(dwell));
      continue;
    }
    const double root = std::sqrt(static_cast<double>(dwell.ensembles));
    dwell.condition.response_sd = dwell.response_scatter / root;
    dwell.condition.excitation_sd = dwell.excitation_scatter / root;
    observed.conditions.push_back(std::move(dwell.condition));
  }
  if (scattering.empty()) return;
  if (freedom < fewest_degrees_of_repeats) {
    observed.warnings.push_back(
        fmt::format("{} row{} of tables {} no standard deviations and have no repeats (rows with one label in a "
                    "column condition) "
                    "that tell them: what a model leaves cannot be compared with noise, left out. Add columns "
                    "CHANNEL.sd of every "
                    "channel, the excitation too",
                    scattering.size(), scattering.size() == 1 ? "" : "s", scattering.size() == 1 ? "says" : "say"));
    return;
  }
  std::move(scattering.begin(), scattering.end(), std::back_inserter(dwells));
}

}  // namespace

ObservedConditions observe_conditions(const DwellContext& context, const RecordReader& read) {
  const Campaign& campaign = context.campaign;
  ObservedConditions observed;
  std::vector<Dwell> dwells;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (entry.kind != RecordKind::dwell || !context.window.takes(r, entry.file)) continue;
    if (auto dwell = observe_dwell(context, r, read(r), observed.warnings)) dwells.push_back(std::move(*dwell));
  }
  add_rows(context, read, dwells, observed);
  const Repeatability responses(dwells, false), excitations(dwells, true);
  const Eigen::VectorXd noise = typical_noise(dwells);
  const auto channels = static_cast<Index>(context.sensors.responses.size());
  for (Dwell& dwell : dwells) {
    if (noise.size() > 0 && dwell.noise.size() > 0) {
      dwell.condition.response_noise = noise.head(channels);
      dwell.condition.excitation_noise = noise.tail(noise.size() - channels);
    }
    dwell.condition.response_sd = responses.of(dwell);
    dwell.condition.excitation_sd = excitations.of(dwell);
    observed.nonstationarity.insert(observed.nonstationarity.end(), dwell.nonstationarity.begin(),
                                    dwell.nonstationarity.end());
    observed.conditions.push_back(std::move(dwell.condition));
  }
  std::stable_sort(observed.conditions.begin(), observed.conditions.end(),
                   [](const Condition& a, const Condition& b) { return a.record < b.record; });
  const std::vector<double> began = record_times(campaign);
  for (Condition& condition : observed.conditions) condition.time_s += began[condition.record];
  return observed;
}

}  // namespace secular
