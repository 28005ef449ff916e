// `secular simulate` with effects of the catalogue switched on in the experiment file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "jobs/simulate/experiment_loading.hpp"
#include "tests/app/program_run.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* simulated_model_text = R"toml(schema = 1
name = "pair"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = "D2(x) + w1^2*x = -2*m1*D(x) + e1*F*cos(Omega*t)"
[[mode]]
coordinate = "y"
frequency = "w2"
equation = "D2(y) + w2^2*y = -2*m2*D(y) + e2*F*cos(Omega*t)"
[[case]]
name = "free"
order = { m1 = 2, m2 = 2, e1 = 1, e2 = 1 }
)toml";

std::string simulated_experiment_text(const std::string& more, const std::string& settle_s = "0.25") {
  return R"toml(schema = 1
name = "effects"
model = "pair.toml"
sample_rate_hz = 128.0
[parameters]
w1 = 60.0
w2 = 90.0
m1 = 1.0
m2 = 1.5
e1 = -1.0
e2 = 0.7
[excitation]
name = "base"
quantity = "acceleration"
[[response]]
name = "a"
quantity = "acceleration"
noise_sd = 0.01
[[response]]
name = "b"
quantity = "acceleration"
noise_sd = 0.01
[modal_basis]
mass_normalised_shapes = [[1.0, -0.5], [0.6, 1.2]]
[[dwell]]
frequencies_hz = [10.0, 12.0]
amplitudes = [1.0]
ensembles = 1
ensemble_s = 0.5
carry_state = true
settle_s = )toml" +
         settle_s + R"toml(
[[free_decay]]
initial_displacement = [1e-3, 2e-3]
duration_s = 0.2
)toml" + more;
}

class SimulateCommand : public TemporaryFolder {
 protected:
  LoadedExperiment loaded(const std::string& more, const std::string& settle_s) const {
    write("pair.toml", simulated_model_text);
    return load_experiment(write("experiment.toml", simulated_experiment_text(more, settle_s)), true, {});
  }
  SimulatedCampaign simulated(const std::string& more, unsigned threads = 1,
                              const std::string& settle_s = "0.25") const {
    const LoadedExperiment l = loaded(more, settle_s);
    return run_virtual_test(l.experiment, *l.model, 1, threads);
  }
  int run(const std::string& arguments) const { return testing_support::run_program(folder_, arguments).status; }
};

// Times in another unit than was meant: nothing that would never end, and no record without samples.
TEST_F(SimulateCommand, LengthsThatNobodyMeantAreRefused) {
  EXPECT_TRUE(
      contains(refusal([&] { loaded("", "1e15"); }), "settle_s of 1e+15 s at 128 Hz is more than 1e+09 samples"));
  for (const char* const length : {"1e9", "1e300"})
    EXPECT_TRUE(
        contains(refusal([&] { loaded(std::string("[[free_decay]]\nduration_s = ") + length + "\n", "0.25"); }),
                 "more than 1e+09 samples"));
  EXPECT_TRUE(
      contains(refusal([&] { loaded("[[free_decay]]\nduration_s = 1e-6\n", "0.25"); }), "fewer than two samples"));
}

// What was simulated, the records drawn, units; and not inside of the campaign, which holds what was measured
// alone.
TEST_F(SimulateCommand, AReportSaysWhatWasSimulated) {
  write("pair.toml", simulated_model_text);
  write("experiment.toml", simulated_experiment_text("", "0.25"));
  ASSERT_EQ(run("simulate experiment.toml -o made --report made.html --seed 7"), 0);
  const std::string page = read("made.html");
  for (const char* const text :
       {"A virtual test on the full equations of motion of pair.toml: 2 dwells, 1 free decay, ",
        "with the measurement noise of seed 7", "mass_normalised_shapes = [[1.0, -0.5], [0.6, 1.2]]", "<svg",
        "records/0003.csv", "m/s\u00b2"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  EXPECT_EQ(run("simulate experiment.toml -o other --report other/report.html"), 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "other"));
}

std::string effect(const std::string& name, const std::string& keys) {
  return "[[effect]]\nname = \"" + name + "\"\n" + keys + "\n";
}

/// Every name of the catalogue with the keys it needs.
const std::vector<std::pair<std::string, std::string>>& catalogue() {
  static const std::vector<std::pair<std::string, std::string>> effects = {
      {"viscous_damping", "mode = \"x\"\nstrength = 0.5"},
      {"quadratic_damping", "mode = \"x\"\nstrength = 50.0"},
      {"cubic_damping", "mode = \"y\"\nstrength = 5000.0"},
      {"coulomb_friction", "mode = \"x\"\nstrength = 0.1"},
      {"amplitude_dependent_damping", "mode = \"x\"\nstrength = 1e4"},
      {"quadratic_stiffness", "mode = \"x\"\nstrength = 1e4"},
      {"cubic_stiffness", "mode = \"x\"\nstrength = 1e6"},
      {"quintic_stiffness", "mode = \"y\"\nstrength = 1e9"},
      {"bilinear_stiffness", "mode = \"x\"\nstrength = 500.0"},
      {"freeplay", "mode = \"x\"\ngap = 1e-4\nstrength = 500.0"},
      {"one_sided_stop", "mode = \"x\"\ngap = 1e-4\nstrength = 500.0"},
      {"two_sided_stop", "mode = \"x\"\ngap = 1e-4\nstrength = 500.0"},
      {"saturating_stiffness", "mode = \"x\"\nv0 = 1e-4\nstrength = 500.0"},
      {"stribeck_friction", "mode = \"x\"\ns = 0.5\nv0 = 0.01\nstrength = 0.1"},
      {"power_damping", "mode = \"x\"\np = 1.5\nstrength = 5.0"},
      {"relaxation", "mode = \"x\"\ntau = 0.01\nstrength = 100.0"},
      {"level_stiffness", "mode = \"x\"\nstrength = 100.0"},
      {"cubic_base_excitation", "mode = \"x\"\nstrength = 1e6"},
      {"quadratic_inertia", "mode = \"x\"\nstrength = 10.0"},
      {"cubic_inertia", "mode = \"x\"\nstrength = 1e3"},
      {"hysteresis", "mode = \"y\"\nslip = 1e-4\nstrength = 500.0"},
      {"direct_excitation", "mode = \"x\"\nstrength = 0.3"},
      {"parametric_excitation", "mode = \"x\"\nstrength = 20.0"},
      {"damping_coupling", "mode = \"x\"\nother = \"y\"\nstrength = 1.0"},
      {"quadratic_coupling", "mode = \"x\"\nother = \"y\"\nstrength = 1e3"},
      {"cubic_coupling", "mode = \"x\"\nother = \"y\"\nform = 1\nstrength = 1e5"},
      {"inertia_coupling", "mode = \"x\"\nother = \"y\"\nform = 1\nstrength = 20.0"},
      {"parametric_coupling", "mode = \"x\"\nother = \"y\"\nstrength = 20.0"},
      {"extra_mode", "frequency_hz = 10.0\ndamping = 1.0\nshape = [1.0, 0.0]\nstrength = 0.5"},
      {"natural_frequency_drift", "mode = \"x\"\nstrength = 1e-3"},
      {"shaker_harmonics", "strength = 0.1"},
      {"sensor_gain", "channel = \"a\"\nstrength = 1.1"},
      {"sensor_offset", "channel = \"a\"\nstrength = 0.5"},
      {"sensor_cross_axis", "channel = \"a\"\nstrength = 0.1"},
      {"channel_skew", "channel = \"b\"\nstrength = 1e-3"},
      {"clipping", "channel = \"a\"\nstrength = 0.3"},
      {"mode_shape_error", "strength = 0.1"},
      {"parameters", "symbol = \"m1\"\nstrength = 0.2"},
  };
  return effects;
}

TEST_F(SimulateCommand, EveryEffectOfTheCatalogueChangesTheCampaign) {
  const SimulatedCampaign plain = simulated("");
  for (const auto& [name, keys] : catalogue()) {
    SCOPED_TRACE(name);
    const SimulatedCampaign changed = simulated(effect(name, keys));
    ASSERT_EQ(changed.samples.size(), plain.samples.size()) << name;
    EXPECT_EQ(changed.campaign.channels.size(), 3u) << name;
    ASSERT_TRUE(changed.campaign.modal_basis) << name;
    EXPECT_EQ(changed.campaign.modal_basis->modes.size(), 2u) << name;  // an extra mode stays unknown to it
    const bool same_samples = changed.samples[0].channels == plain.samples[0].channels;
    const bool same_basis =
        changed.campaign.modal_basis->mass_normalised_shapes == plain.campaign.modal_basis->mass_normalised_shapes;
    EXPECT_EQ(same_samples, name == "mode_shape_error") << name;
    EXPECT_EQ(same_basis, name != "mode_shape_error") << name;
  }
}

TEST_F(SimulateCommand, StrengthZeroChangesNothing) {
  const SimulatedCampaign plain = simulated("");
  for (const auto& [name, keys] : catalogue()) {
    if (name == "sensor_gain" || name == "clipping") continue;  // a factor and a level
    const SimulatedCampaign changed =
        simulated(effect(name, keys.substr(0, keys.rfind("strength")) + "strength = 0.0"));
    for (std::size_t c = 0; c < 3; ++c) {
      double worst = 0, size = 0;
      for (std::size_t i = 0; i < plain.samples[0].samples(); ++i) {
        worst = std::max(worst, std::abs(changed.samples[0].channels[c][i] - plain.samples[0].channels[c][i]));
        size = std::max(size, std::abs(plain.samples[0].channels[c][i]));
      }
      // Steps of the integration may end elsewhere: its tolerance is 1e-10 a step.
      EXPECT_LT(worst, 1e-6 * size) << name << " channel " << c;
    }
  }
}

// Driven at its own frequency: acceleration -W^2 x of D2(x) + W^2 x + 2 mu D(x) = eta F.
TEST_F(SimulateCommand, AnExtraModeIsSeenThroughItsShape) {
  const SimulatedCampaign plain = simulated("", 1, "3.0");
  const SimulatedCampaign changed = simulated(
      effect("extra_mode", "frequency_hz = 10.0\ndamping = 2.0\nshape = [1.0, -0.25]\nstrength = 0.5"), 1, "3.0");
  const auto line = [](const std::vector<double>& samples) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      sum += samples[i] * std::polar(1.0, -2 * std::numbers::pi * 10 * static_cast<double>(i) / 128);
    return 2.0 * sum / static_cast<double>(samples.size());
  };
  // After 3 s of settling exp(-2*3) of the start is left in both.
  const double omega = 20 * std::numbers::pi;
  const double steady = omega * 0.5 / (2 * 2.0);
  const std::complex<double> a = line(changed.samples[0].channels[1]) - line(plain.samples[0].channels[1]);
  const std::complex<double> b = line(changed.samples[0].channels[2]) - line(plain.samples[0].channels[2]);
  EXPECT_NEAR(std::abs(a), steady, 2 * std::exp(-6) * steady);
  EXPECT_NEAR(std::abs(b), 0.25 * steady, 0.5 * std::exp(-6) * steady);
}

TEST_F(SimulateCommand, MemoryAndThreads) {
  const std::string effects = effect("hysteresis", "mode = \"x\"\nstrength = 800.0\nslip = 1e-4") +
                              effect("natural_frequency_drift", "mode = \"y\"\nstrength = 1e-4") +
                              "[anti_alias]\nfilter = \"butterworth\"\ncut_off_hz = 50.0\n"
                              "[shaker]\narmature_hz = 5.0\narmature_damping = 0.3\nfeedback = [0.1, 0.05]\n";
  const SimulatedCampaign one = simulated(effects, 1), three = simulated(effects, 3);
  for (std::size_t r = 0; r < one.samples.size(); ++r)
    EXPECT_EQ(one.samples[r].channels, three.samples[r].channels);
}

TEST_F(SimulateCommand, TheProgramWritesTheCampaignOrSaysWhatIsWrong) {
  write("pair.toml", simulated_model_text);
  write("good.toml", simulated_experiment_text(effect("cubic_stiffness", "mode = \"x\"\nstrength = 1e6")));
  const std::string at = folder_.string() + "/";
  EXPECT_EQ(run("simulate --interpret " + at + "good.toml -o " + at + "campaign"), 0) << read("stderr.txt");
  EXPECT_TRUE(fs::exists(folder_ / "campaign/campaign.toml"));
  const auto complaint = [&](const std::string& more, const std::string& part) {
    write("bad.toml", simulated_experiment_text(more));
    EXPECT_EQ(run("simulate --interpret " + at + "bad.toml -o " + at + "none"), 2);
    EXPECT_NE(read("stderr.txt").find(part), std::string::npos) << read("stderr.txt");
    EXPECT_NE(read("stderr.txt").find("line "), std::string::npos) << read("stderr.txt");
    EXPECT_FALSE(fs::exists(folder_ / "none"));
  };
  complaint(effect("rust", "strength = 1.0"), "natural_frequency_drift, shaker_harmonics");
  complaint(effect("cubic_damping", "strength = 1.0"), "does not say at which mode");
  complaint(effect("cubic_damping", "mode = \"z\"\nstrength = 1.0"), "its coordinates are x, y");
  complaint(effect("extra_mode", "frequency_hz = 10.0\ndamping = 1.0\nshape = [1.0]\nstrength = 1.0"),
            "one for each of the 2 responses");
}

// The same effects in a derivation, with its certificate.
TEST_F(SimulateCommand, DeriveTakesEffectsToo) {
  EXPECT_EQ(run("derive two_mass_mode1 --case principal_parametric --with-effect coulomb_friction "
                "--with-effect quintic_stiffness:v"),
            0);
  const std::string text = read("stdout.txt");
  for (const char* const part : {"fc_v", "alpha5_v", "holds: put back into the original equation"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  EXPECT_EQ(run("derive two_mass --with-effect coulomb_friction"), 2);
  EXPECT_NE(read("stderr.txt").find("write coulomb_friction:v1"), std::string::npos) << read("stderr.txt");
}

}  // namespace
}  // namespace secular::app
