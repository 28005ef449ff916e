// Predictions from an estimate.json have error bars; from a plain file of numbers they have none, and say why.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/campaign/temporary_folder.hpp"

namespace secular {
namespace {

using nlohmann::json;

// Growth (m/2) (1 - p a^2/4) of a motion that sustains itself.
const char* const rayleigh = R"toml(schema = 1
name = "sustained"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = m*(1 - p*x^2)*D(x)"
[[case]]
name = "free"
order = { m = 1, p = 0 }
expand_to = 1
excitation = false
)toml";

json entry(const char* name, double value, double sd) {
  return {{"name", name}, {"value", value}, {"sd", sd}, {"unit", "1/s"}};
}

class PredictionBands : public TemporaryFolder {
 protected:
  testing_support::Outcome predicted(const std::string& arguments) const {
    testing_support::Outcome outcome =
        testing_support::run_with_shared_cache(folder_, "predict " + arguments + " --force -o out");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return outcome;
  }
  json result() const { return json::parse(read("out/prediction.json")); }
};

TEST_F(PredictionBands, LimitCyclesHaveErrorBarsAndAreMarked) {
  write("model.toml", rayleigh);
  const double covariance = 0.5 * 0.02 * 0.04;  // of p and m: the amplitude knows p alone
  const json estimate = {
      {"estimates", {entry("w", 10, 0.01), entry("m", 0.4, 0.04), entry("p", 1, 0.02)}},
      {"coordinate_unit", "m"},
      {"covariance",
       {{"names", {"w", "m", "p"}}, {"matrix", {{1e-4, 0, 0}, {0, 1.6e-3, covariance}, {0, covariance, 4e-4}}}}}};
  write("estimate.json", estimate.dump());
  const testing_support::Outcome outcome = predicted("model.toml --parameters estimate.json");
  EXPECT_NE(outcome.output.find("limit cycle, stable: amplitude 2.000(20)"), std::string::npos) << outcome.output;
  const json backbone = result().at("backbones").at(0), cycle = backbone.at("limit_cycles").at(0);
  EXPECT_NEAR(cycle.at("amplitude_sd").get<double>(), 0.02, 1e-5);  // a = 2/sqrt(p)
  EXPECT_NEAR(cycle.at("frequency_sd").get<double>(), 0.01, 1e-5);
  const json& points = backbone.at("points");
  EXPECT_GT(points.back().at("amplitude").get<double>(), 2);  // the backbone goes beyond its cycle
  EXPECT_NEAR(points.front().at("growth_sd").get<double>(), 0.02, 1e-4);
  const std::string report = read("out/report.html");
  EXPECT_NE(report.find("A stable limit cycle of x"), std::string::npos);
  EXPECT_NE(report.find("limit cycle, stable"), std::string::npos);  // of the figure's legend
}

TEST_F(PredictionBands, ResponsesTakeOverWhatIsNotGivenExactly) {
  const json estimate = {{"estimates",
                          {entry("omega0", 100, 0.05), entry("mu", 0.5, 0.01), entry("a2", 0, 0),
                           entry("a3", 4e5, 2e4), entry("e", 1, 0.02)}},
                         {"covariance", {{"names", {"omega0", "mu"}}, {"matrix", {{2.5e-3, 0}, {0, 1e-4}}}}}};
  write("estimate.json", estimate.dump());
  const std::string line = "duffing --case primary --parameters estimate.json --at F=0.02 --vary Omega 97 103";
  predicted(line);
  json all = result();
  EXPECT_EQ(all.at("error_bars_of"), json({"omega0", "mu"}));
  // Nearly linear: the peak F/(2 mu omega0) is as uncertain as mu, and at half height omega0 counts.
  double largest = 0, sd = 0;
  for (const json& branch : all.at("branches"))
    for (const json& point : branch.at("points"))
      if (const double a = point.at("modes").at(0).at("amplitude"); a > largest) {
        largest = a;
        sd = point.at("modes").at(0).at("amplitude_sd");
      }
  EXPECT_NEAR(sd / largest, 0.02, 0.004);
  EXPECT_NE(read("out/report.html").find("two standard deviations on both sides"), std::string::npos);
  EXPECT_NE(read("out/prediction.csv").find(",amplitude_sd_x\n"), std::string::npos);
  // What is given exactly has no error bar.
  predicted(line + " --at mu=0.5");
  EXPECT_EQ(result().at("error_bars_of"), json({"omega0"}));
  predicted(line + " --at mu=0.5 --at omega0=100");
  EXPECT_FALSE(result().contains("error_bars_of"));
  EXPECT_NE(result().at("no_error_bars_because").get<std::string>().find("no parameter"), std::string::npos);
}

TEST_F(PredictionBands, AreMissingWithTheReason) {
  write("numbers.json", R"({"omega0": 100, "mu": 0.5, "a2": 0, "a3": 4e5, "e": 1})");
  const std::string rest = " --at F=0.02 --vary Omega 97 103";
  predicted("duffing --case primary --parameters numbers.json" + rest);
  EXPECT_EQ(result().at("no_error_bars_because"), "numbers.json holds no covariance");
  EXPECT_NE(read("out/report.html").find("No bands are drawn: numbers.json holds no covariance."),
            std::string::npos);
  EXPECT_EQ(read("out/prediction.csv").find("amplitude_sd"), std::string::npos);
  // What the estimate doubts is doubtful here, too.
  json doubtful = {{"estimates",
                    {entry("omega0", 100, 0.05), entry("mu", 0.5, 0.01), entry("a2", 0, 0), entry("a3", 4e5, 1),
                     entry("e", 1, 0.02)}},
                   {"covariance", {{"names", {"mu"}}, {"matrix", {{1e-4}}}}}};
  doubtful["estimates"][1]["doubtful"] = true;
  write("doubtful.json", doubtful.dump());
  EXPECT_NE(predicted("duffing --case primary --parameters doubtful.json" + rest)
                .errors.find("marks mu as doubtful: bands and error bars of the prediction are as doubtful"),
            std::string::npos);
  // A covariance that is no matrix is refused by name.
  doubtful["covariance"]["matrix"] = {{1e-4, 0}};
  write("bent.json", doubtful.dump());
  const testing_support::Outcome refused = testing_support::run_with_shared_cache(
      folder_, "predict duffing --case primary --parameters bent.json" + rest + " --force -o out");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("bent.json, key covariance, row 1: has not as many numbers as there are names"),
            std::string::npos)
      << refused.errors;
}

TEST_F(PredictionBands, RefuseWhatIsNoCovariance) {
  json estimate = {{"estimates",
                    {entry("omega0", 100, 0.05), entry("mu", 0.5, 0.01), entry("a2", 0, 0), entry("a3", 4e5, 2e4),
                     entry("e", 1, 0.02)}}};
  const auto errors = [&](const json& names, const json& matrix) {
    estimate["covariance"] = {{"names", names}, {"matrix", matrix}};
    write("estimate.json", estimate.dump());
    const testing_support::Outcome refused = testing_support::run_with_shared_cache(
        folder_,
        "predict duffing --case primary --parameters estimate.json --at F=0.02 --vary Omega 97 103 -o bad");
    EXPECT_EQ(refused.status, 2) << matrix;
    return refused.errors;
  };
  const json two = {"omega0", "mu"};
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(errors(two, {{1e-4, 1e-5}, {2e-5, 1e-4}}), "row 2 (mu): differs from its column at omega0"));
  EXPECT_TRUE(has(errors(two, {{1e-4, 2e-4}, {2e-4, 1e-4}}), "a correlation beyond one with omega0"));
  EXPECT_TRUE(has(errors(two, {{-1e-4, 0}, {0, 1e-4}}), "row 1 (omega0): has a negative variance"));
  EXPECT_TRUE(has(errors({"mu", "mu"}, {{1e-4, 0}, {0, 1e-4}}), "names mu twice"));
  // What is not known is no number that is exact.
  estimate["covariance"] = {{"names", two}, {"matrix", {{nullptr, 0}, {0, 1e-4}}}};
  write("estimate.json", estimate.dump());
  predicted("duffing --case primary --parameters estimate.json --at F=0.02 --vary Omega 97 103");
  EXPECT_TRUE(has(result().at("no_error_bars_because").get<std::string>(), "entries that are no numbers"));
}

// A coefficient of |v'|v' that is not significant makes the branch turn back at 4e-7 m, next to the threshold: that
// is not told apart, and the threshold is said once, with the state of rest. One that is large turns it back in
// earnest.
TEST_F(PredictionBands, AThresholdHasNoTwin) {
  const auto kinds = [&](const char* mu2) {
    predicted(
        std::string("two_mass_mode1 --case principal_parametric --parameters predictions/table_5_4 --at F=22.55 "
                    "--vary Omega 24.3 25.1 --hz --at mu2=") +
        mu2);
    std::map<std::string, int> found;
    const json all = result();
    for (const json& branch : all.at("branches"))
      for (const json& special : branch.at("special_points")) ++found[special.at("kind").get<std::string>()];
    return found;
  };
  const std::map<std::string, int> usual = {{"saddle_node", 1}, {"threshold", 2}};
  EXPECT_EQ(kinds("0"), usual);
  EXPECT_EQ(kinds("1e-3"), usual);
  EXPECT_EQ(kinds("-1e-3"), usual);
  const std::map<std::string, int> turned = {{"saddle_node", 2}, {"threshold", 2}};
  EXPECT_EQ(kinds("1"), turned);
}

// The largest amplitude of a duffing oscillator that stiffens is next to its fold. Its error bars are those of
// whole runs with parameters moved, and it does not hang on the range, which the points of the curve do.
TEST_F(PredictionBands, TheLargestAmplitudeIsPolishedAndHasErrorBarsBesideFolds) {
  std::map<std::string, double> values = {{"omega0", 100}, {"mu", 0.5}, {"a2", 3000}, {"a3", 4e6}, {"e", 1}};
  const std::map<std::string, double> sds = {{"omega0", 0.05}, {"mu", 0.01}, {"a3", 1e5}};
  const auto largest = [&](const std::string& range) {
    json estimate = {
        {"estimates", json::array()},
        {"covariance",
         {{"names", {"omega0", "mu", "a3"}}, {"matrix", {{2.5e-3, 0, 0}, {0, 1e-4, 0}, {0, 0, 1e10}}}}}};
    for (const auto& [name, value] : values)
      estimate["estimates"].push_back(entry(name.c_str(), value, sds.contains(name) ? sds.at(name) : 0));
    write("estimate.json", estimate.dump());
    predicted("duffing --case primary --parameters estimate.json --at F=2 --vary Omega " + range);
    EXPECT_EQ(result().at("largest").size(), 1U);
    return result().at("largest").at(0);
  };
  const json given = largest("88 113");
  EXPECT_NE(read("out/report.html").find("largest at 16.870(46) Hz, with a peak amplitude of 0.02000(40)"),
            std::string::npos);
  EXPECT_EQ(given.at("kind"), "peak");
  const auto number = [](const json& of, const char* key) { return of.at(key).get<double>(); };
  EXPECT_NEAR(number(given, "amplitude"), 0.02, 1e-12);  // F/(2 mu omega0)
  const json other = largest("90.3 111.7");
  EXPECT_NEAR(number(other, "amplitude"), 0.02, 1e-12);
  EXPECT_NEAR(number(other, "Omega"), number(given, "Omega"), 1e-8);
  double amplitude = 0, place = 0;
  for (const auto& [name, sd] : sds) {
    constexpr double h = 0.02;
    values.at(name) += h * sd;
    const json plus = largest("88 113");
    values.at(name) -= 2 * h * sd;
    const json minus = largest("88 113");
    values.at(name) += h * sd;
    amplitude += std::pow((number(plus, "amplitude") - number(minus, "amplitude")) / (2 * h), 2);
    place += std::pow((number(plus, "Omega") - number(minus, "Omega")) / (2 * h), 2);
  }
  EXPECT_NEAR(number(given, "amplitude_sd") / std::sqrt(amplitude), 1, 1e-4);
  EXPECT_NEAR(number(given, "Omega_sd") / std::sqrt(place), 1, 1e-4);
  // Where the range ends before the peak that is said, and where it lies is exact.
  const json cut = largest("88 103");
  EXPECT_EQ(cut.at("kind"), "range_end");
  EXPECT_FALSE(cut.contains("Omega_sd"));
  EXPECT_TRUE(cut.contains("amplitude_sd"));
  EXPECT_NE(read("out/report.html").find("largest at 16.3930 Hz, where the range ends, with"), std::string::npos);
}

// Where two error bars of the amplitude exceed it, first order says nothing of the place either.
TEST_F(PredictionBands, TheLargestAmplitudeHasBothErrorBarsOrNone) {
  for (const double share : {0.1, 0.45, 0.55}) {
    const json estimate = {
        {"estimates",
         {entry("omega0", 100, 0.05), entry("mu", 0.5, 0.5 * share), entry("a2", 3000, 0), entry("a3", 4e6, 0),
          entry("e", 1, 0)}},
        {"covariance", {{"names", {"omega0", "mu"}}, {"matrix", {{2.5e-3, 0}, {0, 0.25 * share * share}}}}}};
    write("estimate.json", estimate.dump());
    predicted("duffing --case primary --parameters estimate.json --at F=2 --vary Omega 88 113");
    const json largest = result().at("largest").at(0);
    EXPECT_EQ(largest.at("kind"), "peak");
    EXPECT_EQ(largest.contains("amplitude_sd"), share < 0.5) << share;
    EXPECT_EQ(largest.contains("Omega_sd"), share < 0.5) << share;
  }
}

// Of two modes that are tied to each other, both amplitudes are largest at one point.
TEST_F(PredictionBands, TwoModesHaveTheirPeaksAtOnePoint) {
  write("pair.toml", R"toml(schema = 1
name = "pair"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = "D2(x) + w1^2*x = -2*mu*D(x) - c1*D(x)^3 - b1*x^3 + p*y*F*cos(Omega*t)"
[[mode]]
coordinate = "y"
frequency = "w2"
equation = "D2(y) + w2^2*y = -2*mu*D(y) - c2*D(y)^3 - b5*y^3 + q*x*F*cos(Omega*t)"
[[case]]
name = "additive"
relations = ["Omega = w1 + w2 + eps*sigma"]
order = { mu = 1, c1 = 1, c2 = 1, b1 = 1, b5 = 1, p = 1, q = 1 }
expand_to = 1
)toml");
  const json estimate = {
      {"estimates",
       {entry("w1", 10, 0.01), entry("w2", 27, 0), entry("mu", 0.05, 0.001), entry("c1", 0.0729, 0),
        entry("c2", 0.01, 0), entry("b1", 10, 0), entry("b5", 27, 0), entry("p", 10, 0), entry("q", 27, 0)}},
      {"covariance", {{"names", {"w1", "mu"}}, {"matrix", {{1e-4, 0}, {0, 1e-6}}}}}};
  write("estimate.json", estimate.dump());
  predicted("pair.toml --parameters estimate.json --at F=1 --vary Omega 36 38");
  const json largest = result().at("largest");
  ASSERT_EQ(largest.size(), 2U);
  for (const json& of : largest) {
    EXPECT_EQ(of.at("kind"), "peak") << of;
    EXPECT_TRUE(of.contains("amplitude_sd") && of.contains("Omega_sd")) << of;
    EXPECT_NEAR(of.at("Omega").get<double>(), largest.at(0).at("Omega").get<double>(), 1e-5) << of;
  }
}

// Beyond a threshold the mode that is driven is saturated: it stays as it is over F, and has no peak.
TEST_F(PredictionBands, ASaturatedAmplitudeHasNoPeak) {
  write("saturated.toml", R"toml(schema = 1
name = "saturated"
[lagrangian]
kinetic = "D(x)^2/2 + D(y)^2/2"
potential = "w1^2*x^2/2 + w2^2*y^2/2 + a2*x^2*y"
[[mode]]
coordinate = "x"
frequency = "w1"
force = "-2*mu1*D(x)"
[[mode]]
coordinate = "y"
frequency = "w2"
force = "-2*mu2*D(y) + e*F*cos(Omega*t)"
[[case]]
name = "one_to_two"
relations = ["w2 = 2*w1 + eps*sigma1", "Omega = w2 + eps*sigma2"]
order = { mu1 = 1, mu2 = 1, a2 = 1, e = 1 }
expand_to = 1
)toml");
  const json estimate = {
      {"estimates",
       {entry("w1", 10, 0.01), entry("w2", 20, 0), entry("mu1", 0.05, 0.001), entry("mu2", 0.1, 0),
        entry("a2", 20, 0.1), entry("e", 1, 0)}},
      {"covariance", {{"names", {"w1", "mu1", "a2"}}, {"matrix", {{1e-4, 0, 0}, {0, 1e-6, 0}, {0, 0, 0.01}}}}}};
  write("estimate.json", estimate.dump());
  predicted("saturated.toml --parameters estimate.json --at Omega=20.1 --vary F 0 20");
  const json largest = result().at("largest");
  for (const json& of : largest) {
    EXPECT_NE(of.at("kind"), "peak") << of;
    EXPECT_FALSE(of.contains("F_sd")) << of;
  }
  EXPECT_EQ(largest.size(), 2U);
}

}  // namespace
}  // namespace secular
