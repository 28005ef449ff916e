// Lumps of several cases that share a name and are different combinations.

#include <gtest/gtest.h>

#include <complex>
#include <map>
#include <string>
#include <vector>

#include "estimator/identification/estimate.hpp"
#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "motion/simulate/noise.hpp"
#include "tests/identification/virtual_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

// Duffing's oscillator under hard excitation at one level of force, of which observations are made by the
// modulation equation itself. The forced motion shifts the frequency by F^2 times a lump that no such test parts
// from the natural frequency, and that is known from its symbols. It has the same name in both cases and is 81
// times smaller in one.
class HardExcitation : public ::testing::Test {
 protected:
  const CompiledModel& model_ = *generated::find_compiled_model("duffing");
  const Eigen::VectorXd truth_ = (Eigen::VectorXd(5) << 10, 0.1, 0, 40, 2).finished();  // omega0, mu, a2, a3, e
  static constexpr double force_ = 6, sd_ = 1e-6;

  Observation observation(const CompiledCase& resonance, int condition, int ensemble) const {
    std::size_t b = 0;
    while (resonance.blocks[b].kind != BlockKind::modulation) ++b;
    const RegressorBlock& block = resonance.blocks[b];
    std::vector<double> lumps(resonance.lumps.size());
    resonance.evaluate_lumps(truth_.data(), lumps.data());
    const double excitation = resonance.name == "superharmonic_3" ? truth_(0) / 3 : 3 * truth_(0);
    Observation o;
    o.condition = condition;
    o.record = static_cast<std::size_t>(condition);
    o.centre_s = ensemble;
    o.forcing = {std::polar(force_, 0.3 * condition)};
    o.amplitude = {std::polar(0.1 + 0.03 * condition, 1.1 * condition)};
    std::vector<std::complex<double>> values(block.lumps.size());
    std::vector<std::complex<double>*> columns;
    for (std::complex<double>& v : values) columns.push_back(&v);
    const std::complex<double>*amplitude = o.amplitude.data(), *forcing = o.forcing.data();
    const double* frequency = &excitation;
    block.columns({1, truth_.data(), &frequency, &amplitude, &forcing}, columns.data());
    std::complex<double> rate = std::complex<double>(0, truth_(0)) * o.amplitude[0];
    for (std::size_t j = 0; j < values.size(); ++j)
      rate += lumps[static_cast<std::size_t>(block.lumps[j])] * values[j];
    NoiseStream noise(1, static_cast<std::uint64_t>(condition), static_cast<std::uint64_t>(ensemble));
    o.rate = {rate / o.amplitude[0] + sd_ * std::complex<double>(noise.gaussian(), noise.gaussian())};
    o.excitation_frequency = {excitation};
    o.excitation_frequency_sd = {1e-9};
    o.forcing_sd = {1e-7};
    o.amplitude_sd = {1e-9};
    o.growth_sd = {sd_};
    o.frequency_sd = {sd_};
    o.harmonic.assign(resonance.blocks.size(), std::complex<double>());
    o.harmonic_sd.assign(resonance.blocks.size(), -1.0);
    return o;
  }

  ObservationSet set_of(const std::string& name) const {
    ObservationSet set;
    set.model = &model_;
    set.resonance = &case_named(model_, name);
    for (int condition = 0; condition < 8; ++condition)
      for (int ensemble = 0; ensemble < 4; ++ensemble)
        set.observations.push_back(observation(*set.resonance, condition, ensemble));
    return set;
  }

  static EstimateOptions known_force() {
    EstimateOptions options;
    options.fixed["e"] = 2;
    return options;
  }
};

TEST_F(HardExcitation, EachCaseTakesItsOwnLumpOfTheSameName) {
  const std::vector<ObservationSet> sets = {set_of("superharmonic_3"), set_of("subharmonic_3")};
  const double super = truth_of(model_, *sets[0].resonance, truth_, "conservative_x_A_x_F2"),
               sub = truth_of(model_, *sets[1].resonance, truth_, "conservative_x_A_x_F2");
  ASSERT_NEAR(super, 81 * sub, 1e-12);
  for (const std::vector<ObservationSet>& measured : {sets, std::vector<ObservationSet>{sets[1], sets[0]}}) {
    const EstimateOptions options = known_force();
    Estimate both = estimate(measured, {"m", {"N"}}, options);
    // The lumps depend on the natural frequency, which depends on them: each estimate goes on from the last one, as
    // the passes of the truncation's correction do.
    for (int pass = 0; pass < 3; ++pass) both = estimate(measured, {"m", {"N"}}, options, {.start = both.state});
    for (const EstimatedValue& lump : both.lumps)
      if (lump.name == "conservative_x_A_x_F2") {
        EXPECT_EQ(lump.from, "follows from its symbols") << lump.resonance;
      }
    // With the other case's value it would be off by half their difference times F^2.
    ASSERT_GT((super - sub) * force_ * force_, 0.05);
    EXPECT_NEAR(*value_of(both, "omega0").value, truth_(0), 1e-5);
    EXPECT_NEAR(*value_of(both, "a3").value, truth_(3), 1e-2);
    EXPECT_FALSE(both.consistency.significant) << both.consistency.chi_squared;
  }
}

// One case's lump is given, not that of the other case which has the same name, and parameters make both.
TEST_F(HardExcitation, AGivenLumpIsThatOfItsCase) {
  const std::vector<ObservationSet> sets = {set_of("superharmonic_3"), set_of("subharmonic_3")};
  const double super = truth_of(model_, *sets[0].resonance, truth_, "conservative_x_A_x_F2");
  EstimateOptions options = known_force();
  options.fixed["superharmonic_3:conservative_x_A_x_F2"] = super;
  const auto with_given = [&] {
    Estimate both = estimate(sets, {"m", {"N"}}, options);
    for (int pass = 0; pass < 3; ++pass) both = estimate(sets, {"m", {"N"}}, options, {.start = both.state});
    return both;
  };
  const Estimate both = with_given();
  for (const EstimatedValue& lump : both.lumps)
    if (lump.name == "conservative_x_A_x_F2") {
      EXPECT_EQ(lump.fixed, lump.resonance == "superharmonic_3") << lump.resonance;
      if (lump.fixed) {
        EXPECT_EQ(*lump.value, super);
        EXPECT_EQ(lump.from, "given");
      }
    }
  EXPECT_NEAR(*value_of(both, "omega0").value, truth_(0), 1e-5);
  EXPECT_NEAR(*value_of(both, "a3").value, truth_(3), 1e-2);
  EXPECT_FALSE(both.consistency.significant) << both.consistency.chi_squared;
  // A value that is not that of the parameters contradicts the lumps that were measured.
  options.fixed["superharmonic_3:conservative_x_A_x_F2"] = 1.5 * super;
  EXPECT_TRUE(with_given().consistency.significant);
}

TEST_F(HardExcitation, AGivenSymbolIsGivenInEveryCaseAndALumpIsNoSymbol) {
  const std::vector<ObservationSet> sets = {set_of("superharmonic_3"), set_of("subharmonic_3")};
  EstimateOptions options = known_force();
  options.fixed["mu"] = truth_(1);
  const Estimate both = estimate(sets, {"m", {"N"}}, options);
  int given = 0;
  for (const EstimatedValue& lump : both.lumps)
    if (lump.name == "mu" && lump.fixed) ++given;
  EXPECT_EQ(given, 2);
  options.fixed = {{"conservative_x_A_x_F2", 0.0}};
  try {
    estimate(sets, {"m", {"N"}}, options);
    FAIL() << "the name means three different lumps";
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const char* part :
         {"a lump of each of several cases", "superharmonic_3:conservative_x_A_x_F2 = 243*a3*e^2",
          "subharmonic_3:conservative_x_A_x_F2 = 3*a3*e^2", "given as CASE:NAME=VALUE"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
  options.fixed = {{"primary:conservative_x_A_x_F2", 0.0}};
  EXPECT_THROW(estimate(sets, {"m", {"N"}}, options), InputError) << "no record is of that case";
}

// A correction may take the last observations of a case: a computation that leads no further, and no bad input.
TEST_F(HardExcitation, WithoutObservationsThereIsNothingToEstimateFrom) {
  std::vector<ObservationSet> sets = {set_of("superharmonic_3"), set_of("subharmonic_3")};
  EstimateOptions options = known_force();
  options.fixed["superharmonic_3:conservative_x_A_x_F2"] = 1;
  sets[0].observations.clear();
  EXPECT_THROW(estimate(sets, {"m", {"N"}}, options), NothingObserved) << "a lump of a case without observations";
  sets[1].observations.clear();
  sets[1].warnings = {"a dwell is left out"};
  try {
    estimate(sets, {"m", {"N"}}, known_force());
    FAIL() << "nothing is left";
  } catch (const NumericalFailure& failure) {
    EXPECT_STREQ(
        failure.what(),
        "case superharmonic_3, subharmonic_3: no observations are left to identify it from; a dwell is left "
        "out");
  }
}

}  // namespace
}  // namespace secular
