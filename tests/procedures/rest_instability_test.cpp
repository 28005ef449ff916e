// Where rest is most unstable, against the lumps that shift it.
#include "thesis/procedures/rest_instability.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "estimator/model/by_name.hpp"
#include "tests/identification/virtual_campaign.hpp"
#include "thesis/procedures/engine_lumps.hpp"

namespace secular {
namespace {

using testing_support::shipped_experiment;

// At rest (6.51) leaves w1 w2 sigma = (w2 Gamma_1 + w1 Gamma_7) + (w2 Gamma_4 + w1 Gamma_10) F^2 in the middle
// between the jumps, where the radicand's term vanishes; what damping that differs between the modes does is of
// fourth order.
TEST(RestInstability, IsShiftedBySecondOrderLumps) {
  const Experiment e = shipped_experiment("thesis_chapter6");
  const CompiledModel& model = *generated::find_compiled_model(e.model);
  const CompiledCase& resonance = case_named(model, "additive_combination");
  const Eigen::VectorXd lumps = two_mode_lumps(model, resonance, e.parameters);
  const double w1 = e.parameters(0), w2 = e.parameters(1);
  for (const double forcing : {22.0, 23.3, 26.0}) {
    const double expected = (lumps(static_cast<Eigen::Index>(TwoModeLump::linear_sum)) +
                             lumps(static_cast<Eigen::Index>(TwoModeLump::forcing_sum)) * forcing * forcing) /
                            (w1 * w2);
    const double shift = most_unstable_excitation(model, resonance, e.parameters, forcing) - w1 - w2;
    EXPECT_LT(shift, -0.2);
    EXPECT_NEAR(shift, expected, 0.01 * std::abs(expected)) << forcing;
  }
}

TEST(RestInstability, OfOneModeIsTwiceItsFrequency) {
  const Experiment e = shipped_experiment("thesis_chapter5");
  const CompiledModel& model = *generated::find_compiled_model(e.model);
  const double found =
      most_unstable_excitation(model, case_named(model, "principal_parametric"), e.parameters, 22.55);
  EXPECT_NEAR(found, 2 * e.parameters(0), 1e-3);
}

TEST(RestInstability, RefusesWhatIsNoParametricResonance) {
  const Experiment e = shipped_experiment("thesis_chapter5");
  const CompiledModel& model = *generated::find_compiled_model(e.model);
  EXPECT_THROW(most_unstable_excitation(model, case_named(model, "free"), e.parameters, 1), std::invalid_argument);
}

}  // namespace
}  // namespace secular
