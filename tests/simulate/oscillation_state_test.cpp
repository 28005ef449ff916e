// A motion that has settled is put together again from the amplitudes of its modes alone.
#include "motion/correction/oscillation_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "motion/simulate/motion.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

struct Driven {
  const CompiledModel& model;
  const CompiledCase& resonance;
  Eigen::VectorXd parameters;
  double frequency = 0, force = 0;  // rad/s; unit of the excitation
  std::vector<double> start;        // displacements
};

Driven driven(const std::string& model_name, const std::string& resonance,
              const std::vector<std::pair<std::string, double>>& values) {
  const CompiledModel& model = *generated::find_compiled_model(model_name);
  Driven d{model,
           case_named(model, resonance),
           Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.symbols.size())),
           0,
           0,
           {}};
  for (const auto& [name, value] : values)
    d.parameters(static_cast<Eigen::Index>(symbol_named(model, name))) = value;
  return d;
}

// Largest difference between the state of the settled motion and the one that its modes' amplitudes and frequencies
// give, at some times, relative to the motion. Amplitudes are read off by Gaussian windows that no other line
// reaches.
double missed(const Driven& d) {
  constexpr double settled = 80, step = 1.0 / 512, width = 1.6, half = 6.5 * width, centre = settled + half;
  const auto count = static_cast<std::size_t>(std::lround(2 * half / step)) + 1;
  const ExcitationSignal wave = [&](double t, ExcitationSample* s) {
    const double w = d.frequency, angle = w * (t - centre);
    s[0] = {d.force * std::cos(angle), -w * d.force * std::sin(angle), -w * w * d.force * std::cos(angle)};
  };
  MotionState moving{d.start, std::vector<double>(d.model.modes(), 0.0)};
  std::vector<MotionSample> samples;
  MotionSettings settings;
  settings.relative_tolerance = 1e-11;
  integrate_motion({d.model, d.parameters.data(), wave}, {0, settled, step, count}, settings, moving,
                   [&](const MotionSample& s) { samples.push_back(s); });

  Observation o;
  o.excitation_frequency = {d.frequency};
  o.forcing = {d.force};
  for (std::size_t k = 0; k < d.model.modes(); ++k) {
    double frequency = d.parameters(static_cast<Eigen::Index>(k));
    Complex amplitude;
    for (int pass = 0; pass < 4; ++pass) {
      Complex displacement = 0, velocity = 0;
      double weight = 0;
      for (const MotionSample& s : samples) {
        const double t = s.time - centre, window = std::exp(-0.5 * t * t / (width * width));
        displacement += window * s.displacement[k] * std::polar(1.0, -frequency * t);
        velocity += window * s.velocity[k] * std::polar(1.0, -frequency * t);
        weight += window;
      }
      frequency = (velocity / displacement).imag();
      amplitude = displacement / weight;
    }
    o.amplitude.push_back(amplitude);
    o.rate.emplace_back(0, frequency);
  }
  double worst = 0, size = 0;
  for (const std::size_t i : {count / 2, count / 2 + 7, count / 2 + 200}) {
    const OscillationState state =
        OscillationStates(d.model, d.resonance).at(d.parameters, o, samples[i].time - centre);
    for (std::size_t k = 0; k < d.model.modes(); ++k) {
      const double speed = o.rate[k].imag();
      worst = std::max({worst, std::abs(state.displacement[k] - samples[i].displacement[k]),
                        std::abs(state.velocity[k] - samples[i].velocity[k]) / speed});
      size = std::max(size, 2 * std::abs(o.amplitude[k]));
    }
  }
  return worst / size;
}

// Static offset, second and third harmonics are of the order of a tenth of the motion.
TEST(OscillationState, StrongPrimaryResonance) {
  Driven d = driven("duffing", "primary", {{"omega0", 20}, {"mu", 0.2}, {"a2", 120}, {"a3", 300}, {"e", 1}});
  d.frequency = 20.3;
  d.force = 6;
  d.start = {0.3};
  EXPECT_LT(missed(d), 1e-6);
}

// The mode is locked to half of the excitation, which acts on it directly, too.
TEST(OscillationState, SubharmonicBesideAForcedMotion) {
  Driven d = driven("two_mass_mode1", "principal_parametric",
                    {{"omega0", 77.85},
                     {"mu1", 0.22},
                     {"mu3", 30},
                     {"alpha2", 3e4},
                     {"alpha3", 4e6},
                     {"delta2", 5},
                     {"eta1", 0.3},
                     {"eta2", 15}});
  d.frequency = 155.9;
  d.force = 20;
  d.start = {0.003};
  EXPECT_LT(missed(d), 1e-6);
}

// Two incommensurate frequencies whose sum is the excitation's. Lines end at sixth order in the two amplitudes.
TEST(OscillationState, AdditiveCombination) {
  Driven d = driven("two_mass", "additive_combination",
                    {{"omega1", 77.85},
                     {"omega2", 208.67},
                     {"mu11", 0.27},
                     {"mu22", 0.29},
                     {"mu12", -1.2},
                     {"mu21", 3.1},
                     {"mu13", 229},
                     {"mu23", 1006},
                     {"alpha21", -1e4},
                     {"alpha22", 8e6},
                     {"alpha23", 1.07e7},
                     {"alpha31", 4.1e9},
                     {"alpha33", -4.7e9},
                     {"alpha35", 2.1e9},
                     {"delta21", 0.5},
                     {"eta11", -0.028},
                     {"eta12", 7.6},
                     {"eta21", -0.0013},
                     {"eta22", 192}});
  d.frequency = 286.1;
  d.force = 30;
  d.start = {1e-4, 5e-5};
  EXPECT_LT(missed(d), 2e-5);
}

// More independent frequencies than a balance takes: what the expansion has, here of a decay without excitation.
TEST(OscillationState, DecayOfThreeModes) {
  const CompiledModel& model = *generated::find_compiled_model("three_modes");
  const auto free =
      std::find_if(model.cases.begin(), model.cases.end(), [](const CompiledCase& c) { return !c.excited; });
  ASSERT_NE(free, model.cases.end());
  Eigen::VectorXd linear = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.symbols.size()));
  Observation o;
  for (int k = 0; k < 3; ++k) {
    linear(k) = 10 + 7 * k;
    o.amplitude.push_back(std::polar(1e-3, 0.4 * k));
    o.rate.emplace_back(-0.3, linear(k));
  }
  const OscillationState state = OscillationStates(model, *free).at(linear, o, 0.21);
  for (std::size_t k = 0; k < 3; ++k) {
    const Complex value = o.amplitude[k] * std::exp(0.21 * o.rate[k]);
    EXPECT_DOUBLE_EQ(state.displacement[k], 2 * value.real());
    EXPECT_DOUBLE_EQ(state.velocity[k], 2 * (o.rate[k] * value).real());
  }
}

}  // namespace
}  // namespace secular
