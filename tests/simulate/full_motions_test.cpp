// Motions of the full equations by balance, against the same by integration.
#include "motion/correction/full_motions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "estimator/model/by_name.hpp"
#include "motion/correction/replay.hpp"
#include "tests/identification/virtual_campaign.hpp"

namespace secular {
namespace {

struct Tested {
  const CompiledModel* model = nullptr;
  Experiment experiment;
  SimulatedCampaign simulated;
  ObservationSet measured;
  int replays = 0;
  ReplaySet replay;

  // A shipped experiment, as far as `shorten` leaves it.
  Tested(const std::string& name, void (*shorten)(Experiment&))
      : experiment(testing_support::shipped_experiment(name)) {
    model = generated::find_compiled_model(experiment.model);
    shorten(experiment);
    simulated = run_virtual_test(experiment, *model, 1, 2);
    measured = testing_support::observed(
        simulated, *model, *std::find_if(model->cases.begin(), model->cases.end(), [&](const auto& c) {
          return c.excited == !experiment.dwells.empty();
        }));
    replay = [this](const ObservationSet& set, const Eigen::VectorXd& parameters) {
      ++replays;
      return observe_replay(simulated.campaign, set, parameters, 2);
    };
  }

  FullMotions motions() const { return {std::span(&measured, 1), replay, 2}; }

  Eigen::VectorXd with(const std::string& symbol, double factor) const {
    Eigen::VectorXd parameters = experiment.parameters;
    parameters(static_cast<Eigen::Index>(symbol_named(*model, symbol))) *= factor;
    return parameters;
  }
};

// Three dwells of the thesis's parametric resonance.
void few_dwells(Experiment& e) {
  e.dwells.resize(1);
  e.dwells[0].frequencies_hz.resize(std::min<std::size_t>(3, e.dwells[0].frequencies_hz.size()));
  e.dwells[0].amplitudes.resize(1);
  e.dwells[0].ensembles = 2;
}

struct Difference {
  double rate = 0, harmonic = 0;  // largest; rates in 1/s, harmonics relative to the mode's amplitude
};

Difference difference(const ObservationSet& a, const ObservationSet& b) {
  Difference largest;
  EXPECT_EQ(a.observations.size(), b.observations.size());
  for (std::size_t i = 0; i < a.observations.size(); ++i) {
    const Observation &x = a.observations[i], &y = b.observations[i];
    for (std::size_t k = 0; k < x.rate.size(); ++k)
      largest.rate = std::max(largest.rate, std::abs(x.rate[k] - y.rate[k]));
    for (std::size_t h = 0; h < x.harmonic.size(); ++h)
      if (x.harmonic_sd[h] >= 0)
        largest.harmonic =
            std::max(largest.harmonic, std::abs(x.harmonic[h] - y.harmonic[h]) / std::abs(x.amplitude[0]));
  }
  return largest;
}

TEST(FullMotions, BalanceIsTheReplayOfASteadyMotion) {
  const Tested t("principal_parametric", few_dwells);
  ASSERT_FALSE(t.measured.observations.empty());
  const auto balanced = t.motions().at(t.experiment.parameters);
  ASSERT_TRUE(balanced);
  EXPECT_EQ(t.replays, 0);
  const Difference d = difference((*balanced)[0], t.replay(t.measured, t.experiment.parameters));
  // What noise leaves of drift: the amplitudes are those of ensembles in noise, and their mean is steady to that.
  EXPECT_LT(d.rate, 2e-3);
  EXPECT_LT(d.harmonic, 2e-4);
}

// Damping and stiffness that are not the structure's make motions drift from where they were measured. At the
// amplitudes that a replay has in its middle, the balance has its rates.
TEST(FullMotions, RatesOfADriftingMotionAreTheReplays) {
  const Tested t("principal_parametric", few_dwells);
  for (const auto& [symbol, factor] : {std::pair{"mu1", 1.2}, std::pair{"omega0", 1.0005}}) {
    const Eigen::VectorXd other = t.with(symbol, factor);
    const ObservationSet there = t.replay(t.measured, other);
    const double drift = difference(t.replay(t.measured, t.experiment.parameters), there).rate;
    EXPECT_GT(drift, 0.003) << symbol;
    const auto balanced = BalancedSet(there, 2).at(other);
    ASSERT_TRUE(balanced);
    EXPECT_LT(difference(*balanced, there).rate, 0.06 * drift) << symbol;
  }
}

TEST(FullMotions, ReplaysAreFewAndCountedFrom) {
  const Tested t("principal_parametric", few_dwells);
  FullMotions motions = t.motions();
  const Eigen::VectorXd here = t.with("mu1", 1.02), other = t.with("mu1", 1.04);
  motions.replay(here);
  const ObservationSet counted = motions.at(here)->front(), beyond = motions.at(other)->front();
  EXPECT_EQ(t.replays, 1);
  // From there on the balance's difference: 2% more damping takes as much off the growth.
  const double more = 0.02 * t.experiment.parameters(1);
  for (std::size_t i = 0; i < counted.observations.size(); ++i)
    EXPECT_NEAR((counted.observations[i].rate[0] - beyond.observations[i].rate[0]).real(), more, 0.02 * more);
}

// Windows of a decay are at the amplitudes of the replay, and have its rates, with what the length of a window
// does.
TEST(FullMotions, OfADecayEveryWindowIsInBalance) {
  const Tested t("pendulum_decay", [](Experiment&) {});
  ASSERT_GT(t.measured.observations.size(), 20U);
  FullMotions motions = t.motions();
  motions.replay(t.experiment.parameters);
  EXPECT_LT(difference(motions.at(t.experiment.parameters)->front(), motions.replays().front()).rate, 1e-9);
  const Eigen::VectorXd other = t.with("omega0", 1.001);
  const auto balanced = motions.at(other);
  ASSERT_TRUE(balanced);
  EXPECT_EQ(t.replays, 1);
  const ObservationSet there = t.replay(t.measured, other);
  const double change = difference(motions.replays().front(), there).rate;
  EXPECT_GT(change, 0);
  EXPECT_LT(difference((*balanced)[0], there).rate, 0.1 * change);
}

}  // namespace
}  // namespace secular
