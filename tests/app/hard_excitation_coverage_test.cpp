// Hard excitation, super- and subharmonics, from samples to error bars in several noise draws: the full equations
// are integrated once, everything after the noise is done again. SECULAR_COVERAGE_DRAWS asks for more draws than
// the few of a test run, SECULAR_COVERAGE_FIRST for those from this one on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "jobs/identify/identification.hpp"
#include "jobs/simulate/experiment_loading.hpp"
#include "numerics/confidence.hpp"
#include "tests/process_folder.hpp"
#include "tests/sensor_noise.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;
using testing_support::number_from;

constexpr const char* quadratic = "D2(x) + omega0^2*x = -2*mu*D(x) - a2*x^2 + e*F*cos(Omega*t)";
constexpr const char* cubic = "D2(x) + omega0^2*x = -2*mu*D(x) - a2*x^2 - a3*x^3 + e*F*cos(Omega*t)";

// An oscillator, the case that it is identified with, and what is measured of it. Dwells begin where most of them
// settle on the resonance, and last until a transient is far below the noise.
struct HardExcitation {
  std::string equation, relation, order;
  int expand_to = 1;
  std::string parameters;  // TOML
  double sample_rate_hz = 0, force_noise = 0, noise = 0;
  std::string dwells;  // TOML
};

class HardCampaign {
 public:
  explicit HardCampaign(const HardExcitation& test) : folder_(testing_support::process_folder() / "hard") {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(folder_ / "model.toml")
        << "schema = 1\nname = \"hard\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"omega0\"\nequation = \""
        << test.equation << "\"\n[[case]]\nname = \"hard\"\nrelations = [\"" << test.relation << "\"]\norder = { "
        << test.order << " }\nexpand_to = " << test.expand_to << "\n";
    std::ofstream(folder_ / "experiment.toml")
        << "schema = 1\nname = \"hard\"\nmodel = \"model.toml\"\nsample_rate_hz = " << test.sample_rate_hz
        << "\n[parameters]\n"
        << test.parameters
        << "\n[excitation]\nname = \"force\"\nquantity = \"force\"\nunit = \"N\"\nnoise_sd = " << test.force_noise
        << "\n[[response]]\nname = \"x\"\nquantity = \"displacement\"\nunit = \"m\"\nnoise_sd = " << test.noise
        << "\n[[dwell]]\n"
        << test.dwells << "\n";
    const LoadedExperiment loaded = load_experiment(folder_ / "experiment.toml", false, {});
    experiment_ = loaded.experiment;
    for (std::size_t p = 0; p < loaded.model->symbols.size(); ++p)
      truth_[std::string(loaded.model->symbols[p].name)] = experiment_.parameters(static_cast<Eigen::Index>(p));
    exact_ = run_virtual_test(testing_support::without_noise(experiment_), *loaded.model, 1, 2);
  }

  Estimate identified(int draw) const {
    IdentificationRequest request;
    request.model = (folder_ / "model.toml").string();
    request.threads = 2;
    const RecordReader read = [&](std::size_t r) {
      return testing_support::with_sensor_noise(exact_.samples[r], experiment_,
                                                static_cast<std::uint64_t>(draw) + 1, r);
    };
    return identify_by_modulation(request, exact_.campaign, read).estimate;
  }
  const std::map<std::string, double>& truth() const { return truth_; }

 private:
  fs::path folder_;
  Experiment experiment_;
  std::map<std::string, double> truth_;
  SimulatedCampaign exact_;
};

struct HardCoverage {
  int inside = 0, count = 0, doubtful = 0;
  double largest = 0, error = 0, square = 0, sd = 0;  // largest: in standard deviations, of what is not doubtful

  void add(const EstimatedValue& v, double truth) {
    const double off = *v.value - truth;
    const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
    inside += interval.low <= truth && truth <= interval.high;
    ++count;
    doubtful += v.doubtful;
    error += off;
    square += off * off;
    sd += v.sd;
    if (!v.doubtful) largest = std::max(largest, std::abs(off) / v.sd);
  }
};

// Every parameter has a number in every draw, and its intervals hold as often as they say (within four standard
// deviations of the share that independent draws scatter by: of eight draws three that miss are too many, which
// every second parameter shows whose intervals are half as long as they should be).
void expect_hard_intervals_to_hold(const HardExcitation& test) {
  const HardCampaign campaign(test);
  const int draws = number_from("SECULAR_COVERAGE_DRAWS", 8), first = number_from("SECULAR_COVERAGE_FIRST", 0);
  std::map<std::string, HardCoverage> table;
  int contradictions = 0;
  for (int draw = first; draw < first + draws; ++draw) {
    const Estimate estimate = campaign.identified(draw);
    contradictions += estimate.consistency.significant;
    for (const EstimatedValue& v : estimate.parameters) {
      ASSERT_TRUE(v.value) << "draw " << draw << ", " << v.name << ": " << v.from;
      const double truth = campaign.truth().at(v.name);
      table[v.name].add(v, truth);
      EXPECT_GT(two_sided_p_value((*v.value - truth) / v.sd, v.degrees_of_freedom), 1e-5)
          << "draw " << draw << ", " << v.name;
    }
  }
  EXPECT_LE(contradictions, std::max(1, draws / 50));
  const double least = 0.95 - 4 * std::sqrt(0.05 * 0.95 / draws);
  int inside = 0, count = 0, doubtful = 0;
  for (const auto& [name, c] : table) {
    EXPECT_GT(static_cast<double>(c.inside) / c.count, least) << name;
    std::printf("%-8s bias %10.3e scatter %9.3e mean sd %9.3e covered %5.1f %% of %d, largest %.2f sd\n",
                name.c_str(), c.error / c.count,
                std::sqrt(std::max(0.0, c.square / c.count - std::pow(c.error / c.count, 2))), c.sd / c.count,
                100.0 * c.inside / c.count, c.count, c.largest);
    inside += c.inside;
    count += c.count;
    doubtful += c.doubtful;
  }
  std::printf("all %d intervals: %.1f %% hold; %d doubtful; lumps contradict one another in %d of %d draws\n",
              count, 100.0 * inside / count, doubtful, contradictions, draws);
}

HardExcitation superharmonic_two(int expand_to) {
  return {.equation = quadratic,
          .relation = "2*Omega = omega0 + eps*sigma",
          .order = "mu = 1, a2 = 1, e = 0",
          .expand_to = expand_to,
          .parameters = "omega0 = 1.0\nmu = 0.02\na2 = 0.1\ne = 1.0",
          .sample_rate_hz = 2,
          .force_noise = 3e-5,
          .noise = 3e-5,
          .dwells =
              "frequencies_hz = [0.0748, 0.0764, 0.0780, 0.0788, 0.0796, 0.0804, 0.0812, "
              "0.0820, 0.0828]\namplitudes = [0.05, 0.1]\nensembles = 4\n"
              "ensemble_s = 256.0\nsettle_s = 500.0\ninitial_displacement = [0.0]"};
}

TEST(SlowHardCoverage, SuperharmonicTwo) {
  expect_hard_intervals_to_hold(superharmonic_two(2));
}

// The superharmonic is up to forty times smaller than the forced line, which is no sign of another motion.
TEST(SlowHardCoverage, SuperharmonicTwoToFirstOrder) {
  expect_hard_intervals_to_hold(superharmonic_two(1));
}

TEST(SlowHardCoverage, SuperharmonicTwoWithCubicTerm) {
  expect_hard_intervals_to_hold(
      {.equation = cubic,
       .relation = "2*Omega = omega0 + eps*sigma",
       .order = "mu = 1, a2 = 1, a3 = 1, e = 0",
       .expand_to = 2,
       .parameters = "omega0 = 1.0\nmu = 0.02\na2 = 0.2\na3 = 0.3\ne = 1.0",
       .sample_rate_hz = 2,
       .force_noise = 1e-4,
       .noise = 1e-4,
       .dwells = "frequencies_hz = [0.0770, 0.0780, 0.0788, 0.0796, 0.0804, 0.0812, 0.0820]\n"
                 "amplitudes = [0.1, 0.15, 0.2]\nensembles = 3\nensemble_s = 256.0\nsettle_s = 800.0\n"
                 "initial_displacement = [0.0]"});
}

TEST(SlowHardCoverage, SuperharmonicThree) {
  expect_hard_intervals_to_hold(
      {.equation = cubic,
       .relation = "3*Omega = omega0 + eps*sigma",
       .order = "mu = 1, a2 = 1, a3 = 1, e = 0",
       .expand_to = 1,
       .parameters = "omega0 = 1.0\nmu = 0.01\na2 = 0.05\na3 = 0.3\ne = 1.0",
       .sample_rate_hz = 2,
       .force_noise = 3e-4,
       .noise = 1e-4,
       .dwells = "frequencies_hz = [0.0530, 0.0535, 0.0540, 0.0545, 0.0550, 0.0555, 0.0560]\n"
                 "amplitudes = [0.3, 0.4, 0.5]\nensembles = 3\nensemble_s = 256.0\nsettle_s = 1500.0\n"
                 "initial_displacement = [0.0]"});
}

TEST(SlowHardCoverage, SubharmonicTwo) {
  expect_hard_intervals_to_hold({.equation = cubic,
                                 .relation = "Omega = 2*omega0 + eps*sigma",
                                 .order = "mu = 1, a2 = 1, a3 = 1, e = 0",
                                 .expand_to = 2,
                                 .parameters = "omega0 = 1.0\nmu = 0.005\na2 = 0.1\na3 = 0.1\ne = 1.0",
                                 .sample_rate_hz = 4,
                                 .force_noise = 3e-4,
                                 .noise = 1e-4,
                                 .dwells = "frequencies_hz = [0.3175, 0.3185, 0.3195, 0.3205, 0.3215, 0.3225]\n"
                                           "amplitudes = [0.5, 0.7, 0.9]\nensembles = 3\nensemble_s = 256.0\n"
                                           "settle_s = 3000.0\ninitial_displacement = [0.5]"});
}

HardExcitation subharmonic_three(int expand_to) {
  return {.equation = cubic,
          .relation = "Omega = 3*omega0 + eps*sigma",
          .order = "mu = 1, a2 = 1, a3 = 1, e = 0",
          .expand_to = expand_to,
          .parameters = "omega0 = 1.0\nmu = 0.005\na2 = 0.05\na3 = 0.2\ne = 1.0",
          .sample_rate_hz = 8,
          .force_noise = 2e-3,
          .noise = 3e-4,
          .dwells =
              "frequencies_hz = [0.493, 0.496, 0.500, 0.505, 0.510, 0.515, 0.520]\n"
              "amplitudes = [3.0, 4.0, 5.0]\nensembles = 3\nensemble_s = 256.0\nsettle_s = 3000.0\n"
              "initial_displacement = [1.3]"};
}

TEST(SlowHardCoverage, SubharmonicThree) {
  expect_hard_intervals_to_hold(subharmonic_three(1));
}

// To second order the modulation equation holds the square of a2 alone: harmonics tell a2 and its sign.
TEST(SlowHardCoverage, SubharmonicThreeToSecondOrder) {
  expect_hard_intervals_to_hold(subharmonic_three(2));
}

}  // namespace
}  // namespace secular::app
