#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "motion/correction/replay.hpp"
#include "motion/correction/truncation_correction.hpp"
#include "tests/sensor_noise.hpp"
#include "virtual_campaign.hpp"

// Shipped experiments, simulated and identified as `secular identify` does it.
namespace secular::testing_support {

/// A simulated campaign of one case: the model's first one of that kind of records, or the named one.
struct MadeCampaign {
  Experiment experiment;
  const CompiledModel* model = nullptr;
  const CompiledCase* resonance = nullptr;
  SimulatedCampaign simulated;
};

inline MadeCampaign make_campaign(Experiment experiment, std::uint64_t seed, const std::string& resonance = "") {
  MadeCampaign made;
  made.experiment = std::move(experiment);
  made.model = generated::find_compiled_model(made.experiment.model);
  made.simulated = run_virtual_test(made.experiment, *made.model, seed, 2);
  const bool dwells = made.simulated.campaign.records.front().kind == RecordKind::dwell;
  for (const CompiledCase& candidate : made.model->cases)
    if (resonance.empty() ? candidate.excited == dwells && !made.resonance : candidate.name == resonance)
      made.resonance = &candidate;
  return made;
}

inline MadeCampaign make_campaign(const std::string& name, std::uint64_t seed, const std::string& resonance = "") {
  return make_campaign(shipped_experiment(name), seed, resonance);
}

/// A shipped experiment whose motions are integrated once: what its sensors add is drawn for every seed, the same
/// as in a simulation with that seed.
class DrawnCampaign {
 public:
  explicit DrawnCampaign(const std::string& name, const std::string& resonance = "")
      : experiment_(shipped_experiment(name)), quiet_(make_campaign(without_noise(experiment_), 1, resonance)) {}

  MadeCampaign drawn(std::uint64_t seed) const {
    MadeCampaign made = quiet_;
    made.experiment = experiment_;
    std::vector<Record>& records = made.simulated.samples;
    for (std::size_t r = 0; r < records.size(); ++r)
      records[r] = with_sensor_noise(std::move(records[r]), experiment_, seed, r);
    return made;
  }

 private:
  Experiment experiment_;
  MadeCampaign quiet_;
};

struct Recovered {
  Experiment experiment;
  const CompiledModel* model = nullptr;
  const CompiledCase* resonance = nullptr;
  ObservationSet measured;
  Estimate estimate;

  const EstimatedValue& value(const std::string& name) const { return value_of(estimate, name); }
  double truth(const std::string& name) const { return truth_of(*model, *resonance, experiment.parameters, name); }
};

inline Recovered recover(const MadeCampaign& made, const EstimateOptions& options = {}) {
  Recovered r{
      made.experiment, made.model, made.resonance, observed(made.simulated, *made.model, *made.resonance), {}};
  const MeasuredUnits units{modal_projection(made.simulated.campaign, *r.model).unit, {"m/s^2"}};
  const Estimate raw = estimate(std::span(&r.measured, 1), units, options);
  const auto replay = [&](const ObservationSet& measured, const Eigen::VectorXd& parameters) {
    return observe_replay(made.simulated.campaign, measured, parameters, 2);
  };
  r.estimate =
      correct_truncation(std::span(&r.measured, 1), raw, units, options, replay, [](const char*) {}).estimate;
  return r;
}

inline Recovered recover(const std::string& name, std::uint64_t seed, const EstimateOptions& options = {}) {
  return recover(make_campaign(name, seed), options);
}

}  // namespace secular::testing_support
