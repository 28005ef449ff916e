// Dwells beside a resonance whose natural frequency differs from dwell to dwell, made by the modulation equations
// themselves: the motion follows what the frequency is off.
#include "estimator/identification/instrument_motions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>
#include <random>
#include <vector>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "numerics/confidence.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

// A softening spring; half of the bandwidth is 0.7 rad/s, the largest amplitude about 1.
struct SofteningDwells {
  const CompiledModel& model = *generated::find_compiled_model("duffing");
  const CompiledCase& resonance = case_named(model, "primary");
  std::vector<double> parameters = symbols({{"omega0", 76}, {"mu", 0.7}, {"a2", 0}, {"a3", -182}, {"e", 76}});
  double noise = 5e-4;
  int dwells = 20, repeats = 3;

  std::vector<double> symbols(const std::map<std::string, double>& values) const {
    std::vector<double> result;
    for (const CompiledSymbol& symbol : model.symbols) result.push_back(values.at(std::string(symbol.name)));
    return result;
  }

  double lump(const std::string& name) const {
    std::vector<double> values(resonance.lumps.size());
    resonance.evaluate_lumps(parameters.data(), values.data());
    for (std::size_t l = 0; l < values.size(); ++l)
      if (resonance.lumps[l].name == name) return values[l];
    throw std::out_of_range(name);
  }

  // By Newton's method, from the motion at a frequency nearby; where there is none, from where that leads to.
  Complex next(Complex motion, double frequency, double force, double higher) const {
    std::vector<double> here = parameters;
    here[0] += higher;
    const Complex forcing = force;
    for (int step = 0; step < 40; ++step) {
      Complex rate;
      double slope[4];
      resonance.modulation(here.data(), &frequency, &motion, &forcing, &rate);
      resonance.modulation_jacobian(here.data(), &frequency, &motion, &forcing, slope);
      const double determinant = slope[0] * slope[3] - slope[1] * slope[2];
      const Complex change((slope[3] * rate.real() - slope[1] * rate.imag()) / determinant,
                           (slope[0] * rate.imag() - slope[2] * rate.real()) / determinant);
      motion -= change;
      if (std::abs(change) < 1e-13) break;
    }
    return motion;
  }

  // The motion that a sweep from below or from above leads to.
  Complex motion(double frequency, double force, double higher, bool from_below) const {
    const double far = from_below ? -4 : 3, step = from_below ? 0.02 : -0.02;
    double here = parameters[0] + far;
    Complex motion = next(Complex(0.5 * force / far, 0), here, force, higher);
    for (; from_below ? here + step < frequency : here + step > frequency; here += step)
      motion = next(motion, here + step, force, higher);
    return next(motion, frequency, force, higher);
  }

  ObservationSet set(unsigned seed, double scatter) const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    ObservationSet result;
    result.model = &model;
    result.resonance = &resonance;
    for (int d = 0; d < dwells; ++d) {
      const double force = 0.5 + 0.5 * static_cast<double>(d % 3),
                   frequency = parameters[0] - 2 + 3.5 * uniform(random);
      const double higher = scatter * normal(random);
      const Complex exact = motion(frequency, force, higher, uniform(random) < 0.5);
      for (int e = 0; e < repeats; ++e) {
        Observation o;
        o.condition = d;
        o.record = static_cast<std::size_t>(d);
        o.centre_s = e;
        o.excitation_frequency = {frequency};
        o.excitation_frequency_sd = {1e-7};
        o.forcing = {force};
        o.forcing_sd = {1e-6};
        o.amplitude = {exact + noise * Complex(normal(random), normal(random))};
        o.amplitude_sd = {noise};
        o.rate = {Complex(0, frequency)};
        o.growth_sd = {1e-6};
        o.frequency_sd = {0};
        o.harmonic.assign(resonance.blocks.size(), Complex());
        o.harmonic_sd.assign(resonance.blocks.size(), -1.0);
        result.observations.push_back(std::move(o));
      }
    }
    if (scatter > 0) result.frequency_scatter = {scatter};
    return result;
  }

  CaseFit fitted(const ObservationSet& set, const RegressionState* start = nullptr) const {
    CaseKnowledge known;
    known.natural_frequency = {parameters[0]};
    return fit_case(set, {0}, known, {.start = start});
  }
};

// `set` with columns at motions by numbers of `fit`.
ObservationSet with_instruments(ObservationSet set, const EquationPoint& point) {
  const std::vector<InstrumentMotion> motions = instrument_motions(set, {0}, point);
  for (std::size_t i = 0; i < motions.size(); ++i)
    set.observations[i].instrument = std::make_shared<InstrumentMotion>(motions[i]);
  return set;
}

// Of one lump over draws: its distance from the truth in standard deviations, and how often its interval holds
// that.
struct Score {
  double sum = 0, held = 0, farthest = 0;
  void count(const SofteningDwells& dwells, const CaseFit& fit, const std::string& name) {
    for (std::size_t c = 0; c < fit.columns.size(); ++c) {
      if (fit.columns[c].kind != CaseColumn::Kind::lump) continue;
      if (dwells.resonance.lumps[fit.columns[c].index].name != name) continue;
      const auto at = static_cast<Index>(c);
      const double z = (fit.fit.coefficients(at) - dwells.lump(name)) / std::sqrt(fit.fit.covariance(at, at));
      sum += z;
      held += two_sided_p_value(z, fit.fit.degrees_of_freedom) > 0.05;
      farthest = std::max(farthest, std::abs(z));
    }
  }
};

// Scatter of 0.43 half bandwidths. Least squares is more than one standard deviation off, and in some draws
// collapses to nothing. What instruments tell holds within what as many draws leave open, and is never far off.
TEST(InstrumentMotions, MakeColumnsThatDoNotKnowWhatARecordIsOff) {
  const SofteningDwells dwells;
  constexpr int draws = 80, rounds = 2;
  Score strength, damping, plain;
  int told = 0;
  for (unsigned seed = 1; seed <= draws; ++seed) {
    const ObservationSet set = dwells.set(seed, 0.3);
    ObservationSet alike = set;
    alike.frequency_scatter.clear();
    CaseFit fit = dwells.fitted(alike);
    plain.count(dwells, fit, "e");
    ObservationSet by_instruments;
    for (int round = 0; round < rounds; ++round) {
      by_instruments = with_instruments(set, fit.state.at);
      fit = dwells.fitted(by_instruments, &fit.state);
    }
    if (!instruments_tell(fit)) continue;
    ++told;
    strength.count(dwells, fit, "e");
    damping.count(dwells, fit, "mu");
  }
  EXPECT_GT(told, draws / 2);
  for (const Score& score : {strength, damping}) {
    EXPECT_NEAR(score.sum / told, 0, 0.2 + 3 / std::sqrt(told));
    EXPECT_GT(score.held / told, 0.95 - 3 * std::sqrt(0.95 * 0.05 / told));
    EXPECT_LT(score.farthest, 6);
  }
  EXPECT_LT(plain.sum / draws, -0.7);
}

// Numbers near zero, at which no dwell moves as it was measured: no record has an instrument, and none tells.
TEST(InstrumentMotions, TellNothingAtNumbersThatHaveNoSuchMotions) {
  const SofteningDwells dwells;
  const ObservationSet set = dwells.set(6, 0.3);
  EquationPoint point{std::vector<double>(dwells.resonance.lumps.size(), 0.0), {dwells.parameters[0]}};
  const ObservationSet without = with_instruments(set, point);
  EXPECT_FALSE(instruments_tell(dwells.fitted(without)));
}

// The motion that a dwell would have without noise, whatever its record is off.
TEST(InstrumentMotions, AreThoseOfTheCommonFrequency) {
  SofteningDwells dwells;
  dwells.noise = 1e-9;
  ObservationSet off = dwells.set(3, 0.1);
  off.frequency_scatter = {0.1};
  EquationPoint point{{}, {dwells.parameters[0]}};
  point.lump.resize(dwells.resonance.lumps.size());
  dwells.resonance.evaluate_lumps(dwells.parameters.data(), point.lump.data());
  const std::vector<InstrumentMotion> common = instrument_motions(off, {0}, point);
  double moved = 0;
  for (std::size_t i = 0; i < common.size(); ++i) {
    const Observation& o = off.observations[i];
    const Complex found = common[i].amplitude[0];
    const Complex truth = dwells.next(o.amplitude[0], o.excitation_frequency[0], o.forcing[0].real(), 0);
    // Columns at measured frequencies know omega0 to 1e-3.
    EXPECT_TRUE(common[i].found) << i;
    EXPECT_LT(std::abs(found - truth), 2e-3 * std::abs(truth)) << i;
    moved = std::max(moved, std::abs(found - o.amplitude[0]) / std::abs(truth));
    EXPECT_LT(std::abs(common[i].rate[0] - o.rate[0]), 1e-9);
  }
  EXPECT_GT(moved, 0.1);
}

// Where scatter begins nothing jumps.
TEST(InstrumentMotions, AreTheMeasuredOnesWhereRecordsDoNotDiffer) {
  const SofteningDwells dwells;
  ObservationSet set = dwells.set(5, 0);
  const CaseFit plain = dwells.fitted(set);
  set.frequency_scatter = {1e-9};
  const CaseFit begun = dwells.fitted(with_instruments(set, plain.state.at));
  for (Index c = 0; c < plain.fit.coefficients.size(); ++c)
    EXPECT_NEAR(begun.fit.coefficients(c), plain.fit.coefficients(c), 1e-4 * std::sqrt(plain.fit.covariance(c, c)));
}

}  // namespace
}  // namespace secular
