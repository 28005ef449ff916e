#include "diagnose/evidence/observe_conditions.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/evidence/campaign_clock.hpp"
#include "diagnose/evidence/observe_dwell.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Error of one ensemble by channel and class of line (mean, resonant, other), pooled over all dwells by the median,
// so that one disturbed dwell does not speak for all; the error of a dwell's own mean follows from it.
class PooledScatter {
 public:
  PooledScatter(const std::vector<Dwell>& dwells, bool excitation) : excitation_(excitation) {
    if (dwells.empty()) return;
    const Index channels = scatter(dwells.front()).rows();
    sd_ = MatrixXd::Zero(channels, 3);
    for (Index c = 0; c < channels; ++c)
      for (int kind = 0; kind < 3; ++kind) {
        double squares = 0, freedom = 0;
        std::vector<double> typical;
        for (const Dwell& dwell : dwells)
          for (Index l = 0; l < scatter(dwell).cols(); ++l)
            if (kind_of(dwell, l) == kind) typical.push_back(scatter(dwell)(c, l));
        const double middle = typical.empty() ? 0 : upper_median(typical);
        for (const Dwell& dwell : dwells)
          for (Index l = 0; l < scatter(dwell).cols(); ++l)
            if (kind_of(dwell, l) == kind && scatter(dwell)(c, l) <= 4 * middle) {
              squares += scatter(dwell)(c, l) * scatter(dwell)(c, l) * dwell.degrees_of_freedom;
              freedom += dwell.degrees_of_freedom;
            }
        sd_(c, kind) = freedom > 0 ? std::sqrt(squares / freedom) : 0;
      }
    // A line near resonance varies with the structure; it is never quieter than the channel's other lines.
    for (Index c = 0; c < channels; ++c) sd_(c, 1) = std::max(sd_(c, 1), sd_(c, 2));
  }

  MatrixXd of(const Dwell& dwell) const {
    MatrixXd sd(scatter(dwell).rows(), scatter(dwell).cols());
    for (Index c = 0; c < sd.rows(); ++c)
      for (Index l = 0; l < sd.cols(); ++l)
        sd(c, l) = sd_(c, kind_of(dwell, l)) / std::sqrt(static_cast<double>(dwell.ensembles));
    return sd;
  }

 private:
  const MatrixXd& scatter(const Dwell& dwell) const {
    return excitation_ ? dwell.excitation_scatter : dwell.response_scatter;
  }
  int kind_of(const Dwell& dwell, Index column) const {
    const Condition& c = dwell.condition;
    const Index line = (excitation_ ? c.excitation_lines : c.lines)[static_cast<std::size_t>(column)];
    if (line == 0) return 0;
    if (excitation_) return line == c.fundamental ? 1 : 2;
    return std::any_of(c.masters.begin(), c.masters.end(), [&](const MasterLine& m) { return m.line == line; }) ? 1
                                                                                                                : 2;
  }

  bool excitation_;
  MatrixXd sd_;
};

// Noise of a channel's samples: the median over all dwells, since the ones that saturate show less of it.
Eigen::VectorXd typical_noise(const std::vector<Dwell>& dwells) {
  if (dwells.empty()) return {};
  Eigen::VectorXd noise(dwells.front().noise.size());
  for (Index c = 0; c < noise.size(); ++c) {
    std::vector<double> of_dwells;
    for (const Dwell& dwell : dwells) of_dwells.push_back(dwell.noise(c));
    noise(c) = upper_median(std::move(of_dwells));
  }
  return noise;
}

}  // namespace

ObservedConditions observe_conditions(const Campaign& campaign, const RecordReader& read,
                                      const CompiledModel& model, const SensorModel& sensors,
                                      const std::vector<double>& natural_frequency, const Window& window) {
  ObservedConditions observed;
  std::vector<Dwell> dwells;
  const DwellContext context{campaign, model, sensors, natural_frequency, window};
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (entry.kind != RecordKind::dwell || !window.takes(r, entry.file)) continue;
    if (auto dwell = observe_dwell(context, r, read(r), observed.warnings)) dwells.push_back(std::move(*dwell));
  }
  const PooledScatter responses(dwells, false), excitations(dwells, true);
  const Eigen::VectorXd noise = typical_noise(dwells);
  const auto channels = static_cast<Index>(sensors.responses.size());
  for (Dwell& dwell : dwells) {
    dwell.condition.response_noise = noise.head(channels);
    dwell.condition.excitation_noise = noise.tail(noise.size() - channels);
    dwell.condition.response_sd = responses.of(dwell);
    dwell.condition.excitation_sd = excitations.of(dwell);
    observed.nonstationarity.insert(observed.nonstationarity.end(), dwell.nonstationarity.begin(),
                                    dwell.nonstationarity.end());
    observed.conditions.push_back(std::move(dwell.condition));
  }
  const std::vector<double> began = record_times(campaign);
  for (Condition& condition : observed.conditions) condition.time_s += began[condition.record];
  return observed;
}

}  // namespace secular
