// What the virtual test puts between the equations of motion and the data: memory, shaker, filters, sensors.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "motion/simulate/anti_alias_filter.hpp"
#include "motion/simulate/experiment.hpp"
#include "motion/simulate/motion.hpp"
#include "motion/simulate/sensor_placement.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/simulate/filter_response.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular {
namespace {

using testing_support::FilterResponse;

constexpr double pi = std::numbers::pi;
constexpr Integrator every_method[] = {Integrator::dormand_prince, Integrator::bulirsch_stoer,
                                       Integrator::runge_kutta_4, Integrator::dormand_prince_87};
constexpr std::string_view one_coordinate[] = {"x"};
constexpr std::string_view two_excitations[] = {"F", "S"};

using Acceleration = void (*)(const double*, const ExcitationSample*, const double*, const double*, double*);

CompiledModel model_with(Acceleration acceleration) {
  CompiledModel model;
  model.name = "hand_written";
  model.coordinates = one_coordinate;
  model.excitations = two_excitations;
  model.acceleration = acceleration;
  return model;
}

// A point that follows x = X cos(w t) whatever the element does.
constexpr double amplitude = 0.3, omega = 2;
const ExcitationSignal prescribed = [](double t, ExcitationSample* s) {
  s[0] = {-amplitude * omega * omega * std::cos(omega * t), 0, 0};
  s[1] = {};
};
const CompiledModel& free_point() {
  static const CompiledModel model = model_with(
      [](const double*, const ExcitationSample* u, const double*, const double*, double* a) { a[0] = u[0].value; });
  return model;
}

MotionSettings with_element(Integrator method, double slip) {
  MotionSettings settings;
  settings.method = method;
  settings.slip_elements = {{0, 1, slip}};
  return settings;
}

// Jenkins element at amplitude X > slip: 4*slip*(X - slip) a cycle and unit stiffness; nothing below.
TEST(Hysteresis, LoopAreaIsThatOfTheJenkinsElement) {
  constexpr std::size_t n = 20000;
  const double period = 2 * pi / omega, h = period / n;
  for (const Integrator method : every_method)
    for (const double slip : {0.05, 0.2, 0.29, 0.4}) {
      MotionSettings settings = with_element(method, slip);
      settings.fixed_step = period / 400;
      MotionState state{{amplitude}, {0}};
      double area = 0;
      integrate_motion({free_point(), nullptr, prescribed}, {0, 2 * period, h, n}, settings, state,
                       [&](const MotionSample& s) { area += s.excitation[1].value * s.velocity[0] * h; });
      const double expected = slip < amplitude ? 4 * slip * (amplitude - slip) : 0;
      EXPECT_NEAR(area, expected, 1e-6) << static_cast<int>(method) << " slip " << slip;
    }
}

// From a turning point at X on, z = max(slip - (X - x), -slip); and the mirror image on the way up.
TEST(Hysteresis, ElasticDisplacementIsExactAtEverySample) {
  const double period = 2 * pi / omega, slip = 0.1;
  for (const Integrator method :
       {Integrator::dormand_prince, Integrator::bulirsch_stoer, Integrator::dormand_prince_87}) {
    MotionState state{{amplitude}, {0}};
    integrate_motion({free_point(), nullptr, prescribed}, {0, period, period / 97, 200}, with_element(method, slip),
                     state, [&](const MotionSample& s) {
                       const double x = amplitude * std::cos(omega * s.time);
                       const bool down = std::fmod(s.time, period) < period / 2;
                       const double z =
                           down ? std::max(slip - (amplitude - x), -slip) : std::min(-slip + (amplitude + x), slip);
                       EXPECT_NEAR(s.excitation[1].value, z, 1e-8) << s.time;
                     });
  }
}

// A motion that is interrupted goes on with the same element.
TEST(Hysteresis, MemoryIsCarriedOn) {
  const auto run = [](const std::vector<std::size_t>& parts) {
    const CompiledModel model = model_with([](const double*, const ExcitationSample* u, const double* x,
                                              const double*, double* a) { a[0] = -x[0] - 2 * u[1].value; });
    const ExcitationSignal silent = [](double, ExcitationSample* s) { s[0] = s[1] = {}; };
    MotionState state{{1}, {0}};
    std::vector<double> seen;
    for (const std::size_t count : parts)
      integrate_motion({model, nullptr, silent}, {0, 0, 0.05, count + 1},
                       with_element(Integrator::dormand_prince, 0.3), state, [&](const MotionSample& s) {
                         if (s.time > 0) seen.push_back(s.displacement[0]);
                       });
    return seen;
  };
  const std::vector<double> whole = run({200}), parts = run({17, 50, 3, 130});
  ASSERT_EQ(whole.size(), parts.size());
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(whole[i], parts[i], 1e-7) << i;
}

// A spring and a damper in series on x = X cos(w t): z = X Re(i w tau/(1 + i w tau) exp(i w t)), from a relaxed
// beginning after some time constants, and also where the motion is interrupted.
TEST(Relaxation, StretchIsThatOfTheMaxwellElement) {
  for (const double tau : {0.05, 0.5, 3.0}) {
    MotionSettings settings;
    settings.relaxing_elements = {{0, 1, tau}};
    const std::complex<double> turn(0, omega * tau);
    MotionState state{{amplitude}, {0}};
    double phase_begun = 0;
    for (const double seconds : {20 * tau, 3.0}) {
      const double begun = phase_begun;
      const ExcitationSignal moved = [begun](double t, ExcitationSample* s) { prescribed(t + begun, s); };
      integrate_motion(
          {free_point(), nullptr, moved}, {0, 0, seconds / 50, 51}, settings, state, [&](const MotionSample& s) {
            if (begun == 0 && s.time < 20 * tau) return;
            const double z = (amplitude * turn / (1.0 + turn) * std::polar(1.0, omega * (s.time + begun))).real();
            EXPECT_NEAR(s.excitation[1].value, z, 1e-7 * amplitude) << tau << " s, at " << s.time;
          });
      phase_begun += seconds;
    }
  }
}

// omega = omega0*(1 + drift*t), to first order in the drift: the free vibration's period at campaign time t.
TEST(Drift, MovesTheFrequencyByTheStatedAmount) {
  const double w = 2 * pi * 10, drift = 1e-4;
  const double parameters[] = {w, drift};
  const CompiledModel model =
      model_with([](const double* p, const ExcitationSample* u, const double* x, const double*, double* a) {
        a[0] = -p[0] * p[0] * x[0] - 2 * p[0] * p[0] * p[1] * x[0] * u[1].value;
      });
  const ExcitationSignal silent = [](double, ExcitationSample* s) { s[0] = s[1] = {}; };
  for (const double started : {0.0, 50.0, 200.0}) {
    MotionSettings settings;
    settings.clocks = {1};
    settings.clock_origin = started;
    MotionState state{{1}, {0}};
    double last = 1, before = 0, first_crossing = 0, last_crossing = 0;
    int crossings = 0;
    integrate_motion({model, parameters, silent}, {0, 0, 1e-3, 1000}, settings, state, [&](const MotionSample& s) {
      const double x = s.displacement[0];
      if (last > 0 && x <= 0) {
        last_crossing = before + 1e-3 * last / (last - x);
        if (crossings++ == 0) first_crossing = last_crossing;
      }
      last = x;
      before = s.time;
    });
    const double measured = (crossings - 1) / (last_crossing - first_crossing);
    const double middle = started + 0.5 * (first_crossing + last_crossing);
    EXPECT_NEAR(measured, 10 * std::sqrt(1 + 2 * drift * middle), 1e-4) << started;
  }
}

TEST(Armature, IsASecondOrderSystemWithTheStructureOnIt) {
  // Mode D2(x) + 2 m D(x) + w^2 x = -u on a base of acceleration u that it pulls at: two complex equations.
  const double w = 30, m = 0.5, suspension = 20, damping = 0.4;
  const double parameters[] = {w, m};
  const CompiledModel model =
      model_with([](const double* p, const ExcitationSample* u, const double* x, const double* v, double* a) {
        a[0] = -p[0] * p[0] * x[0] - 2 * p[1] * v[0] - u[0].value;
      });
  for (const double command : {12.0, 40.0})
    for (const double feedback : {0.0, 0.3}) {
      const ExcitationSignal wave = [&](double t, ExcitationSample* s) {
        s[0] = {std::cos(command * t), -command * std::sin(command * t),
                -command * command * std::cos(command * t)};
        s[1] = {};
      };
      MotionSettings settings;
      settings.armature = Armature{suspension, damping, {feedback}};
      MotionState state{{0}, {0}};
      const std::complex<double> s(0, command), mode = s * s + 2 * m * s + w * w;
      const std::complex<double> free = (s * s + 2 * damping * suspension * s + suspension * suspension) / (s * s);
      const std::complex<double> u = 1.0 / (free - feedback * s * s / mode);
      double worst = 0;
      integrate_motion(
          {model, parameters, wave}, {0, 40, 0.003, 100}, settings, state, [&](const MotionSample& sample) {
            const std::complex<double> turned = u * std::polar(1.0, command * sample.time);
            worst = std::max({worst, std::abs(sample.excitation[0].value - turned.real()),
                              w * w * std::abs(sample.displacement[0] + (turned / mode).real())});
            if (feedback == 0)
              worst =
                  std::max(worst, std::abs(sample.excitation[0].first_derivative - (s * turned).real()) / command);
          });
      EXPECT_LT(worst, 1e-6 * std::abs(u)) << command << " " << feedback;
    }
}

TEST(AntiAlias, FiltersMeetTheirNames) {
  for (const std::size_t poles : {2UL, 4UL, 8UL, 12UL}) {
    const FilterResponse butterworth(FilterCascade({AntiAliasFilter::Kind::butterworth, poles, 100, 8}, 2048),
                                     2048);
    EXPECT_NEAR(std::abs(butterworth(0)), 1, 1e-12);
    EXPECT_NEAR(std::abs(butterworth(100)), std::sqrt(0.5), 1e-10);
    // |H|^2 = 1/(1 + (W/Wc)^2n) in the bilinear transform's frequency W = tan(pi f/fs).
    for (const double f : {40.0, 90.0, 150.0, 400.0}) {
      const double ratio = std::tan(pi * f / 2048) / std::tan(pi * 100 / 2048);
      EXPECT_NEAR(std::norm(butterworth(f)) * (1 + std::pow(ratio, 2 * static_cast<double>(poles))), 1, 1e-8);
    }
  }
  const FilterResponse elliptic(FilterCascade({AntiAliasFilter::Kind::elliptic, 8, 100, 8}, 2048), 2048);
  const double ripple = std::pow(10, 0.1 / 20);
  double top = 0, bottom = 2, stop = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double gain = std::abs(elliptic(0.1 * i));
    top = std::max(top, gain);
    bottom = std::min(bottom, gain);
    stop = std::max(stop, std::abs(elliptic(142 + 0.88 * i)));
  }
  // Eight poles, 0.1 dB, 80 dB: the degree equation puts the stop band's edge at 1.410 times the cut-off.
  // An even order starts in a trough of the ripple; its gain at zero frequency is one.
  EXPECT_NEAR(top, ripple, 1e-6);
  EXPECT_NEAR(bottom, 1, 1e-9);
  EXPECT_LT(stop, 1.001e-4 * ripple);
  EXPECT_GT(stop, 0.9e-4 * ripple);
}

TEST(AntiAlias, ASettledFilterAndASteadyToneFollowTheResponse) {
  FilterCascade filter({AntiAliasFilter::Kind::elliptic, 6, 20, 8}, 500);
  filter.settle(3);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(filter(3), 3, 1e-10);
  FilterCascade fresh({AntiAliasFilter::Kind::elliptic, 6, 20, 8}, 500);
  const std::complex<double> gain = FilterResponse(fresh, 500)(13);
  for (int i = 0; i < 3000; ++i) {
    const double y = fresh(std::cos(2 * pi * 13 * i / 500));
    if (i > 2000) {
      EXPECT_NEAR(y, (gain * std::polar(1.0, 2 * pi * 13 * i / 500)).real(), 1e-9);
    }
  }
  FilterCascade coupling = FilterCascade::high_pass(0.5, 500);
  const FilterResponse of_coupling(coupling, 500);
  EXPECT_NEAR(std::abs(of_coupling(0)), 0, 1e-14);
  EXPECT_NEAR(std::abs(of_coupling(0.5)), std::sqrt(0.5), 1e-12);
  coupling.settle(7);
  EXPECT_NEAR(coupling(7), 0, 1e-12);
}

std::string linear_experiment(const std::string& more) {
  return R"(schema = 1
name = "linear"
model = "two_mass_mode1"
sample_rate_hz = 256.0
[parameters]
omega0 = 77.85
mu1 = 2.0
mu2 = 0.0
mu3 = 0.0
alpha2 = 0.0
alpha3 = 0.0
delta2 = 0.0
delta3 = 0.0
eta1 = -1.0
eta2 = 0.0
[excitation]
name = "base"
quantity = "acceleration"
)" + more;
}

constexpr const char* one_dwell = R"([[dwell]]
frequencies_hz = [60.0]
amplitudes = [2.0]
ensembles = 1
ensemble_s = 1.0
settle_s = 6.0
)";
constexpr const char* plain_response = "[[response]]\nname = \"v\"\nquantity = \"acceleration\"\n";

class Sensors : public TemporaryFolder {
 protected:
  Experiment experiment(const std::string& text) const {
    return read_experiment(write("experiment.toml", text), model());
  }
  SimulatedCampaign simulated(const std::string& more) const {
    return run_virtual_test(experiment(linear_experiment(more)), model(), 1, 1);
  }
  static const CompiledModel& model() { return *generated::find_compiled_model("two_mass_mode1"); }
  // Amplitude and phase of a whole number of hertz in a record of whole seconds.
  static std::complex<double> line(const std::vector<double>& samples, double hz) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      sum += samples[i] * std::polar(1.0, -2 * pi * hz * static_cast<double>(i) / 256);
    return 2.0 * sum / static_cast<double>(samples.size());
  }
  void refused(const std::string& more, const std::string& part) const {
    try {
      experiment(linear_experiment(more));
      ADD_FAILURE() << "no complaint about " << more;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
};

// The shaker's third harmonic, 180 Hz, would appear at 256 - 180 = 76 Hz.
TEST_F(Sensors, AntiAliasFilterStopsWhatWouldFoldBack) {
  const std::string shaker = "[shaker]\nharmonics = [0.0, 0.5]\n";
  const std::string filter = "[anti_alias]\nfilter = \"elliptic\"\ncut_off_hz = 100.0\noversampling = 8\n";
  const Record folded = simulated(std::string(plain_response) + one_dwell + shaker).samples[0];
  const Record clean = simulated(std::string(plain_response) + one_dwell + shaker + filter).samples[0];
  EXPECT_NEAR(std::abs(line(folded.channels[0], 76)), 1.0, 1e-6);
  const FilterResponse stated(FilterCascade({AntiAliasFilter::Kind::elliptic, 8, 100, 8}, 2048), 2048);
  EXPECT_NEAR(std::abs(line(clean.channels[0], 76)), std::abs(stated(180)), 1e-7);
  EXPECT_LT(std::abs(line(clean.channels[1], 76)) / std::abs(line(folded.channels[1], 76)), 1.02e-4);
  // In the pass band: gain and lag of the filter, the same on every channel.
  for (std::size_t c = 0; c < 2; ++c) {
    const std::complex<double> gain = line(clean.channels[c], 60) / line(folded.channels[c], 60);
    EXPECT_NEAR(std::abs(gain - stated(60)), 0, 1e-6) << c;
  }
}

TEST_F(Sensors, AcCouplingTakesTheMeanAway) {
  const std::string coupled = std::string(plain_response) + "high_pass_hz = 2.0\n";
  const Record plain = simulated(std::string(plain_response) + one_dwell).samples[0];
  const Record record = simulated(coupled + one_dwell).samples[0];
  const FilterResponse stated(FilterCascade::high_pass(2, 256), 256);
  EXPECT_NEAR(std::abs(line(record.channels[1], 60) / line(plain.channels[1], 60) - stated(60)), 0, 1e-6);
}

TEST_F(Sensors, ShakerArmatureIsWhatIsMeasured) {
  const std::string shaker = "[shaker]\narmature_hz = 80.0\narmature_damping = 0.3\n";
  const Record record = simulated(std::string(plain_response) + one_dwell + shaker).samples[0];
  const double r = 60.0 / 80;
  const double gain = r * r / std::hypot(1 - r * r, 0.6 * r);
  EXPECT_NEAR(std::abs(line(record.channels[0], 60)), 2 * gain, 1e-6);
  // The response belongs to the measured base acceleration, not to the command.
  const double w = 2 * pi * 60;
  const std::complex<double> transfer =
      w * w / (77.85 * 77.85 - w * w + std::complex<double>(0, 2 * 2.0 * w));  // eta1 = -1, acceleration -w^2 v
  EXPECT_NEAR(std::abs(line(record.channels[1], 60) / line(record.channels[0], 60) - transfer), 0, 1e-6);
}

TEST_F(Sensors, PositionAndOrientationGiveTheShape) {
  const std::string bodies = R"([structure]
base_direction = [0.0, 0.0, 2.0]
[[body]]
name = "upper"
point = [0.0, 0.0, 0.2]
translation = [[1.1, 0.2, 0.0]]
rotation = [[0.0, 3.0, 0.5]]
[[response]]
name = "x"
quantity = "acceleration"
body = "upper"
position = [0.05, 0.0, 0.215]
orientation = [2.0, 0.0, 0.0]
[[response]]
name = "slanted"
quantity = "acceleration"
body = "upper"
position = [0.05, 0.01, 0.2]
orientation = [0.0, 3.0, 4.0]
)";
  const Experiment e = experiment(linear_experiment(bodies + one_dwell));
  // u = t + r x d: d = (0.05, 0, 0.015): x: 1.1 + 3*0.015. d = (0.05, 0.01, 0): y: 0.2 + 0.5*0.05, z: -3*0.05.
  EXPECT_NEAR(e.responses[0].shape[0], 1.1 + 0.045, 1e-15);
  EXPECT_NEAR(e.responses[0].base, 0, 1e-15);
  EXPECT_NEAR(e.responses[1].shape[0], 0.6 * 0.225 - 0.8 * 0.15, 1e-15);
  EXPECT_NEAR(e.responses[1].base, 0.8, 1e-15);
  ASSERT_TRUE(e.modal_basis.has_value());
  EXPECT_EQ(e.modal_basis->mass_normalised_shapes[0][0], e.responses[0].shape[0]);
  const Record record = run_virtual_test(e, model(), 1, 1).samples[0];
  const Record modal = simulated(std::string(plain_response) + one_dwell).samples[0];
  for (std::size_t i = 0; i < record.samples(); ++i) {
    EXPECT_NEAR(record.channels[1][i], e.responses[0].shape[0] * modal.channels[1][i], 1e-9);
    EXPECT_NEAR(record.channels[2][i], e.responses[1].shape[0] * modal.channels[1][i] + 0.8 * modal.channels[0][i],
                1e-9);
  }
}

TEST_F(Sensors, EveryIntegratorGivesTheSameRecord) {
  const Record reference = simulated(std::string(plain_response) + one_dwell).samples[0];
  for (const char* const method : {"method = \"bulirsch_stoer\"", "method = \"dormand_prince_87\"",
                                   "method = \"runge_kutta_4\"\nsteps_per_sample = 40"}) {
    const Record record =
        simulated(std::string(plain_response) + one_dwell + "[integrator]\n" + method + "\n").samples[0];
    const double size = std::abs(line(reference.channels[1], 60));
    for (std::size_t i = 0; i < record.samples(); ++i)
      EXPECT_NEAR(record.channels[1][i], reference.channels[1][i], 1e-6 * size) << method;
  }
}

TEST_F(Sensors, EffectsOfTheMeasurement) {
  const std::string programme = std::string(plain_response) + one_dwell;
  const auto effect = [&](const std::string& keys) { return programme + "[[effect]]\n" + keys; };
  const Record plain = simulated(programme).samples[0];
  const Record gain = simulated(effect("name = \"sensor_gain\"\nchannel = \"v\"\nstrength = 1.25\n")).samples[0];
  for (std::size_t i = 0; i < plain.samples(); ++i) EXPECT_EQ(gain.channels[1][i], 1.25 * plain.channels[1][i]);
  const Record harmonics =
      simulated(effect("name = \"shaker_harmonics\"\nharmonics = [1.0, 0.0]\nstrength = 0.05\n")).samples[0];
  EXPECT_NEAR(std::abs(line(harmonics.channels[0], 120)), 0.1, 1e-9);
  const Experiment moved =
      experiment(linear_experiment(effect("name = \"parameters\"\nsymbol = \"mu1\"\nstrength = -0.25\n")));
  EXPECT_DOUBLE_EQ(moved.parameters(1), 1.5);
}

TEST_F(Sensors, MistakesAreNamed) {
  const std::string programme = std::string(plain_response) + one_dwell;
  refused(programme + "[[effect]]\nname = \"rust\"\nstrength = 1.0\n", "known are viscous_damping");
  refused(programme + "[[effect]]\nname = \"cubic_damping\"\nstrength = 1.0\n", "is not in the model");
  refused(programme + "[[effect]]\nname = \"freeplay\"\nstrength = 1.0\n", "gap");
  refused(programme + "[[effect]]\nname = \"sensor_gain\"\nstrength = 1.0\nchannel = \"w\"\n", "'w'");
  refused(programme + "[[effect]]\nname = \"cubic_damping\"\nstrength = 1.0\ngap = 1.0\n", "gap");
  refused(programme + "[[effect]]\nname = \"mode_shape_error\"\nstrength = 0.1\n", "modal basis");
  refused(programme + "[[effect]]\nname = \"parameters\"\nsymbol = \"mu9\"\nstrength = 0.1\n", "'mu9'");
  refused(programme + "[anti_alias]\nfilter = \"brick\"\ncut_off_hz = 100.0\n", "'brick'");
  refused(programme + "[anti_alias]\nfilter = \"elliptic\"\ncut_off_hz = 100.0\npoles = 7\n", "out of range");
  refused(programme + "[anti_alias]\nfilter = \"elliptic\"\ncut_off_hz = 200.0\n", "half the sample rate");
  refused(programme + "[integrator]\nmethod = \"euler\"\n", "'euler'");
  refused(programme + "[integrator]\nsteps_per_sample = 4\n", "runge_kutta_4");
  refused(programme + "[shaker]\nfeedback = [0.1]\n", "armature_hz");
  refused(std::string(plain_response) + "body = \"upper\"\n" + one_dwell, "there is no [[body]]");
}

}  // namespace
}  // namespace secular
