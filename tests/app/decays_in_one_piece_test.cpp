// Free decays by the full equations of motion, one state for all of a decay: a pendulum with dry friction.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/diagnosed_folder.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Json = nlohmann::json;

struct Swing {
  double omega0 = 5.770615, alpha3 = -5.55, mu1 = 0.02, friction = 0.03, from = 0.6;
};

constexpr Index parameters = 4;
const char* const names[parameters] = {"omega0", "alpha3", "mu1", "fc"};
constexpr double noise_sd = 0.0025, duration_s = 40;  // of 0.6 rad at the begin; it rests after 39 s

VectorXd truth() {
  const Swing swing;
  return Eigen::Vector4d(swing.omega0, swing.alpha3, swing.mu1, swing.friction);
}

class DecaysInOnePiece : public testing_support::DiagnosedFolder {
 protected:
  void write_model(const std::string& name, const std::string& friction) const {
    std::ofstream(folder_ / name)
        << "schema = 1\nname = \"swing\"\n[[mode]]\ncoordinate = \"theta\"\nfrequency = \"omega0\"\n"
        << "equation = \"D2(theta) + omega0^2*theta = -alpha3*theta^3 - 2*mu1*D(theta)" << friction
        << "\"\n[[case]]\nname = \"free\"\nrelations = []\norder = { alpha3 = 1, mu1 = 2"
        << (friction.empty() ? "" : ", fc = 2") << " }\nexpand_to = 2\nexcitation = false\n"
        << "[nominal]\nomega0 = 5.77\n";
  }

  void simulate(const Swing& swing, double noise, int seed) const {
    write_model("model.toml", " - fc*sgn(D(theta))");
    std::ofstream experiment(folder_ / "experiment.toml");
    experiment.precision(17);
    experiment << "schema = 1\nname = \"made\"\nmodel = \"" << path("model.toml") << "\"\nsample_rate_hz = 100.0\n"
               << "[parameters]\nomega0 = " << swing.omega0 << "\nalpha3 = " << swing.alpha3
               << "\nmu1 = " << swing.mu1 << "\nfc = " << swing.friction
               << "\n[[response]]\nname = \"theta\"\nquantity = \"angle\"\nunit = \"rad\"\nnoise_sd = " << noise
               << "\n[[free_decay]]\ninitial_displacement = [" << swing.from << "]\nduration_s = " << duration_s
               << "\n";
    experiment.close();
    ASSERT_EQ(run("simulate " + path("experiment.toml") + " --seed " + std::to_string(seed) + " --force -o " +
                  path("campaign")),
              0)
        << printed();
  }

  Json identified(const std::string& model, const std::string& options = "") const {
    run("identify " + path("campaign") + " --model " + path(model) + " " + options + " --force -o " + path("out"));
    std::ifstream in(folder_ / "out/estimate.json");
    return in ? Json::parse(in) : Json();
  }

  VectorXd motion(const Swing& swing) const {
    simulate(swing, 0, 1);
    std::ifstream in(folder_ / "campaign/records/0001.csv");
    std::string line;
    std::getline(in, line);
    std::vector<double> values;
    while (std::getline(in, line)) values.push_back(std::stod(line.substr(line.find(',') + 1)));
    return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
  }

  // Of each parameter, beside an unknown state to begin with: the least standard deviation that an unbiased
  // estimate from all samples can have (Cramer and Rao).
  VectorXd bound() const {
    const auto slope = [&](double Swing::*of, double step) -> VectorXd {
      Swing up, down;
      up.*of += step;
      down.*of -= step;
      return (motion(up) - motion(down)) / (2 * step);
    };
    const VectorXd still = motion(Swing());
    const Index samples = still.size();
    MatrixXd slopes = MatrixXd::Zero(samples, parameters + 2);
    slopes.col(0) = slope(&Swing::omega0, 1e-5);
    slopes.col(1) = slope(&Swing::alpha3, 1e-3);
    slopes.col(2) = slope(&Swing::mu1, 1e-5);
    slopes.col(3) = slope(&Swing::friction, 1e-5);
    slopes.col(4) = slope(&Swing::from, 1e-4);
    // A later begin: the other direction of the state.
    slopes.col(5).segment(1, samples - 2) = still.tail(samples - 2) - still.head(samples - 2);
    const VectorXd lengths = slopes.colwise().norm().transpose();
    const MatrixXd unit = slopes * lengths.cwiseInverse().asDiagonal();
    const MatrixXd covariance = (unit.transpose() * unit).inverse();
    return noise_sd * covariance.diagonal().cwiseSqrt().cwiseQuotient(lengths).head(parameters);
  }
};

// States of segments' own take up nearly all of what friction does.
TEST_F(DecaysInOnePiece, SayThatAModelWithoutItsFrictionDoesNotHold) {
  ASSERT_NO_FATAL_FAILURE(simulate(Swing(), noise_sd, 1));
  write_model("without.toml", "");
  const Json estimate = identified("without.toml", "--by full-equations");
  ASSERT_TRUE(estimate.is_object()) << printed();
  EXPECT_TRUE(estimate["quality"]["lack_of_fit"][0]["significant"].get<bool>());
  for (const Json& e : estimate["estimates"])
    if (e["name"] == "mu1") {
      EXPECT_TRUE(e["doubtful"].get<bool>());
      EXPECT_NEAR(e["value"].get<double>(), Swing().mu1, 2 * e["sd"].get<double>());
    }
}

Json named(const Json& estimate, const std::string& name) {
  for (const Json& e : estimate["estimates"])
    if (e["name"] == name) return e;
  return {};
}

TEST_F(DecaysInOnePiece, RefineTheModulationEquationsWhereTheyHold) {
  ASSERT_NO_FATAL_FAILURE(simulate(Swing(), noise_sd, 2));
  const Json estimate = identified("model.toml", "--by both-equations"),
             rough = identified("model.toml", "--by modulation-equations"),
             full = identified("model.toml", "--by full-equations");
  ASSERT_TRUE(estimate.is_object()) << printed();
  EXPECT_TRUE(estimate["quality"]["refinement"]["taken"].get<bool>());
  EXPECT_FALSE(rough["quality"].contains("refinement"));
  EXPECT_EQ(estimate["lumps"], rough["lumps"]);
  for (Index p = 0; p < parameters; ++p) {
    const Json e = named(estimate, names[p]), before = named(rough, names[p]);
    EXPECT_EQ(e["value"], named(full, names[p])["value"]) << names[p];
    EXPECT_LT(e["sd"].get<double>(), 0.5 * before["sd"].get<double>()) << names[p];
    EXPECT_NEAR(e["value"].get<double>(), truth()(p), 4 * e["sd"].get<double>()) << names[p];
    EXPECT_EQ(estimate["quality"]["refinement"]["parameters"][static_cast<std::size_t>(p)]
                      ["by_modulation_equations"]["value"],
              before["value"]);
  }
}

TEST_F(DecaysInOnePiece, SayByBothThatAModelWithoutItsFrictionDoesNotHold) {
  ASSERT_NO_FATAL_FAILURE(simulate(Swing(), noise_sd, 1));
  write_model("without.toml", "");
  const Json estimate = identified("without.toml", "--by both-equations");
  ASSERT_TRUE(estimate.is_object()) << printed();
  EXPECT_FALSE(estimate["quality"]["refinement"]["taken"].get<bool>());
  const Json& tests = estimate["quality"]["lack_of_fit"];
  EXPECT_TRUE(std::any_of(tests.begin(), tests.end(), [](const Json& t) { return t["significant"].get<bool>(); }));
  EXPECT_TRUE(named(estimate, "mu1").value("doubtful", false));
}

// Mains, which keep their course over a segment only.
TEST_F(DecaysInOnePiece, LeaveTheModulationEquationsWhereAToneStandsBesideTheMotion) {
  ASSERT_NO_FATAL_FAILURE(simulate(Swing(), noise_sd, 1));
  const std::string file = path("campaign/records/0001.csv");
  std::ifstream in(file);
  std::string line, all;
  std::getline(in, line);
  all = line + "\n";
  while (std::getline(in, line)) {
    const std::size_t comma = line.find(',');
    const double t = std::stod(line);
    std::ostringstream text;
    text.precision(17);
    text << t << ',' << std::stod(line.substr(comma + 1)) + 0.01 * std::cos(2 * 3.141592653589793 * 16.7 * t)
         << '\n';
    all += text.str();
  }
  in.close();
  std::ofstream(file) << all;
  const Json estimate = identified("model.toml", "--by both-equations"),
             rough = identified("model.toml", "--by modulation-equations");
  ASSERT_TRUE(estimate.is_object()) << printed();
  EXPECT_FALSE(estimate["quality"]["refinement"]["taken"].get<bool>());
  EXPECT_EQ(estimate["estimates"], rough["estimates"]);
}

// docs/inference.md (60): what the integrator makes of a frequency stays far below the noise, however little that
// is. Without friction, at whose reversals no step is fine enough.
TEST_F(DecaysInOnePiece, AreIntegratedInStepsThatTheirNoiseDoesNotNotice) {
  Swing smooth;
  smooth.friction = 0;
  ASSERT_NO_FATAL_FAILURE(simulate(smooth, 1e-3 * noise_sd, 5));
  write_model("without.toml", "");
  const Json estimate = identified("without.toml", "--by full-equations");
  ASSERT_TRUE(estimate.is_object()) << printed();
  for (Index p = 0; p < 3; ++p) {
    const Json e = named(estimate, names[p]);
    ASSERT_TRUE(e["value"].is_number()) << names[p];
    EXPECT_NEAR(e["value"].get<double>(), truth()(p), 4 * e["sd"].get<double>()) << names[p];
    EXPECT_LT(e["sd"].get<double>(), 1e-4 * std::abs(truth()(p))) << names[p];
  }
}

// Six turns hardly show this friction, all of a decay does; without it there is none.
TEST_F(DecaysInOnePiece, ShowAFrictionThatSegmentsDoNot) {
  write_model("without.toml", "");
  for (const double friction : {0.0, 0.003}) {
    Swing swing;
    swing.mu1 = 0.01;
    swing.friction = friction;
    swing.from = 0.5;
    ASSERT_NO_FATAL_FAILURE(simulate(swing, 1e-3, 3));
    ASSERT_EQ(run("diagnose " + path("campaign") + " --model " + path("without.toml") + " --force -o " +
                  path("diagnosis")),
              0)
        << printed();
    std::ifstream in(folder_ / "diagnosis/diagnosis.json");
    const Json diagnosis = Json::parse(in);
    EXPECT_EQ(diagnosis["decays_in_one_piece"], friction > 0);
    if (friction > 0) {
      EXPECT_EQ(diagnosis["verdict"], "set");
      EXPECT_EQ(diagnosis["set"][0], "coulomb_friction");
    } else {
      EXPECT_EQ(diagnosis["verdict"], "no_gap");
    }
  }
}

class SlowDecaysInOnePiece : public DecaysInOnePiece {};

TEST_F(SlowDecaysInOnePiece, AreAsSharpAsTheirSamplesAllow) {
  const VectorXd least = bound();
  constexpr int draws = 32;
  MatrixXd errors(parameters, draws), sds(parameters, draws);  // over the bound
  int held = 0, alarms = 0;
  for (int draw = 0; draw < draws; ++draw) {
    ASSERT_NO_FATAL_FAILURE(simulate(Swing(), noise_sd, 100 + draw));
    const Json estimate = identified("model.toml", "--by both-equations");
    ASSERT_TRUE(estimate.is_object()) << printed();
    alarms += estimate["quality"]["lack_of_fit"][0]["significant"].get<bool>();
    for (Index p = 0; p < parameters; ++p) {
      const Json& e = estimate["estimates"][static_cast<std::size_t>(p)];
      ASSERT_EQ(e["name"], names[p]);
      ASSERT_TRUE(e["value"].is_number()) << draw << ' ' << names[p];
      errors(p, draw) = (e["value"].get<double>() - truth()(p)) / least(p);
      sds(p, draw) = e["sd"].get<double>() / least(p);
      held += e["ci95"][0].get<double>() <= truth()(p) && truth()(p) <= e["ci95"][1].get<double>();
    }
  }
  // Numbers of a draw are not independent: they count as one.
  EXPECT_GT(held / static_cast<double>(parameters * draws), 0.95 - 2.6 * std::sqrt(0.95 * 0.05 / draws));
  EXPECT_LE(alarms, 1);
  for (Index p = 0; p < parameters; ++p) {
    const double rms = errors.row(p).norm() / std::sqrt(static_cast<double>(draws)), sd = sds.row(p).mean();
    // Squares add up to chi-squared with as many degrees of freedom, of 32 draws below 66.6 but for 0.03 %.
    EXPECT_LT(rms, std::sqrt(66.6 / draws)) << names[p];
    EXPECT_GT(sd, 0.95) << names[p];
    // A tenth more by (43), a tenth by (67), and by (76) the root of 1 + 0.48 b^2 where a law that is told apart
    // from the model's moves a number by b = 2 of its deviations for each of its own.
    EXPECT_LT(sd, 1.1 * 1.1 * std::sqrt(1 + 0.48 * 4)) << names[p];
  }
}

}  // namespace
}  // namespace secular
