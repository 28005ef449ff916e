// Numbers by the full equations of motion: sweeps, broadband records and impacts, alone and with dwells and decays.
#include "jobs/identify/full_equations.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/diagnosed_folder.hpp"

namespace secular {
namespace {

using Json = nlohmann::json;

const std::string broadband_record =
    "[[broadband]]\nlow_hz = 3.0\nhigh_hz = 25.0\nlines = 100\nrms = 4.0\nseed = 3\nsettle_s = 2.0\n"
    "duration_s = 16.0\n";
const std::string two_sweeps =
    "[[sweep]]\nfrom_hz = 8.5\nto_hz = 13.5\nrate_hz_per_s = 0.4\namplitude = 1.5\nsettle_s = 2.0\n"
    "[[sweep]]\nfrom_hz = 13.5\nto_hz = 8.5\nrate_hz_per_s = 0.4\namplitude = 1.5\nsettle_s = 2.0\n";
const std::string three_blows =
    "[[impact]]\npeak = 20.0\nat_s = 0.2\nwidth_s = 0.06\nduration_s = 4.0\n"
    "[[impact]]\npeak = 40.0\nat_s = 0.2\nwidth_s = 0.06\nduration_s = 4.0\n"
    "[[impact]]\npeak = 60.0\nat_s = 0.2\nwidth_s = 0.06\nduration_s = 4.0\n";
const std::string three_dwells =
    "[[dwell]]\nfrequencies_hz = [9.9, 10.1, 10.4]\namplitudes = [1.0]\nensembles = 5\nensemble_s = 2.0\n"
    "settle_s = 20.0\n";

struct Truth {
  const char* name;
  double value;
};
const std::vector<Truth> truths = {{"omega0", 62.8}, {"mu1", 0.6}, {"mu2", 20.0}, {"alpha3", 4e6}, {"eta1", 1.1}};

class FullEquations : public testing_support::DiagnosedFolder {
 protected:
  void write_model(const std::string& name, const std::string& damping, const std::string& spring,
                   const std::string& nominal = "[nominal]\nomega0 = 62.0\n") const {
    const std::string with_cubic = spring.empty() ? "" : ", alpha3 = 2";
    std::ofstream(folder_ / name)
        << "schema = 1\nname = \"struck\"\n[[mode]]\ncoordinate = \"v\"\nfrequency = \"omega0\"\n"
        << "equation = \"D2(v) + omega0^2*v = -2*mu1*D(v) - mu2*abs(D(v))*D(v)" << damping << spring
        << " + eta1*F*cos(Omega*t)\"\n"
        << "[[case]]\nname = \"primary\"\nrelations = [\"Omega = omega0 + eps^2*sigma\"]\n"
        << "order = { mu1 = 2, mu2 = 2, eta1 = 2" << (damping.empty() ? "" : ", mu0 = 2") << with_cubic
        << " }\nexpand_to = 2\n"
        << nominal;
  }

  void simulate(const std::string& records, int seed = 4) const {
    write_model("model.toml", "", " - alpha3*v^3");
    std::ofstream experiment(folder_ / "experiment.toml");
    experiment << "schema = 1\nname = \"made\"\nmodel = \"" << path("model.toml") << "\"\nsample_rate_hz = 200.0\n"
               << "[integrator]\nmethod = \"runge_kutta_4\"\nsteps_per_sample = 4\n[parameters]\n";
    for (const Truth& truth : truths) experiment << truth.name << " = " << truth.value << '\n';
    experiment << "[excitation]\nname = \"base\"\nquantity = \"acceleration\"\nunit = \"m/s^2\"\nnoise_sd = 0.004\n"
               << "[[response]]\nname = \"tip\"\nquantity = \"acceleration\"\nunit = \"m/s^2\"\nnoise_sd = 0.1\n"
               << records;
    experiment.close();
    ASSERT_EQ(run("simulate " + path("experiment.toml") + " --seed " + std::to_string(seed) + " --force -o " +
                  path("campaign")),
              0)
        << printed();
  }

  Json identified(const std::string& model = "model.toml", const std::string& options = "") const {
    run("identify " + path("campaign") + " --model " + path(model) + " " + options + " --force -o " + path("out"));
    std::ifstream in(folder_ / "out/estimate.json");
    return in ? Json::parse(in) : Json();
  }

  // Numbers of a model that holds.
  static void expect_right(const Json& estimate, const std::string& records) {
    ASSERT_TRUE(estimate.is_object());
    EXPECT_EQ(estimate["equations"], "full");
    EXPECT_EQ(estimate["quality"]["records"], records);
    EXPECT_FALSE(estimate["quality"]["lack_of_fit"][0]["significant"].get<bool>());
    ASSERT_EQ(estimate["estimates"].size(), truths.size());
    ASSERT_EQ(estimate["covariance"]["names"].size(), truths.size());
    for (std::size_t p = 0; p < truths.size(); ++p) {
      const Json& e = estimate["estimates"][p];
      EXPECT_EQ(e["name"], truths[p].name);
      ASSERT_TRUE(e["value"].is_number()) << truths[p].name;
      const double sd = e["sd"].get<double>();
      EXPECT_NEAR(e["value"].get<double>(), truths[p].value, 4 * sd) << truths[p].name;
      EXPECT_LT(sd, 0.2 * truths[p].value) << truths[p].name;
      EXPECT_NEAR(estimate["covariance"]["matrix"][p][p].get<double>(), sd * sd, 1e-9 * sd * sd);
    }
  }

  // What is left, in standard deviations.
  static double estimate_ratio(const Json& estimate) {
    return estimate["quality"]["lack_of_fit"][0]["misfit_ratio"].get<double>();
  }

  // Every sample times 1 + 1e-9 u.
  void jitter(int seed) const {
    std::mt19937 engine(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (const auto& file : std::filesystem::directory_iterator(folder_ / "campaign/records")) {
      std::ifstream in(file.path());
      std::string line;
      std::getline(in, line);
      std::ostringstream all;
      all.precision(17);
      all << line << '\n';
      while (std::getline(in, line)) {
        std::istringstream cells(line);
        std::string cell;
        std::getline(cells, cell, ',');
        all << cell;
        while (std::getline(cells, cell, ',')) all << ',' << std::stod(cell) * (1 + 1e-9 * uniform(engine));
        all << '\n';
      }
      in.close();
      std::ofstream(file.path()) << all.str();
    }
  }
};

TEST_F(FullEquations, TellANumberFromABroadbandRecord) {
  simulate(broadband_record);
  expect_right(identified(), "1 broadband");
  EXPECT_NE(printed().find("by the full equations: 1 broadband"), std::string::npos) << printed();
  EXPECT_NE(testing_support::text_of(folder_ / "out/report.html").find("Measured and computed"), std::string::npos);
}

TEST_F(FullEquations, CountTheirFits) {
  simulate(broadband_record);
  IdentificationRequest request;
  request.model = path("model.toml");
  request.interpret = true;
  request.window.to_s = 2;
  std::size_t fits = 0, of = 1;
  request.progress = [&](std::size_t done, std::size_t expected) {
    EXPECT_TRUE(done == fits || done == fits + 1) << fits << " to " << done;
    EXPECT_NE(fits, of) << "counted on behind the end";
    fits = done;
    of = expected;
    EXPECT_LE(fits, of);
  };
  identify_by_full_equations(request, read_campaign(path("campaign")));
  EXPECT_GT(fits, 4U);  // one for each width of errors, at least
  EXPECT_EQ(fits, of);
}

TEST_F(FullEquations, TellANumberFromSweeps) {
  simulate(two_sweeps);
  expect_right(identified(), "2 sweeps");
}

// Without a nominal natural frequency, and with one that is half as large again (docs/inference.md (51)).
TEST_F(FullEquations, BeginAtTheResonanceThatDrivenRecordsShow) {
  simulate(two_sweeps);
  write_model("bare.toml", "", " - alpha3*v^3", "");
  expect_right(identified("bare.toml"), "2 sweeps");
  simulate(broadband_record);
  write_model("off.toml", "", " - alpha3*v^3", "[nominal]\nomega0 = 94.0\n");
  expect_right(identified("off.toml"), "1 broadband");
  EXPECT_NE(printed().find("omega0 is near 62"), std::string::npos) << printed();
}

TEST_F(FullEquations, TellANumberFromImpacts) {
  simulate(three_blows);
  expect_right(identified(), "3 impacts");
}

TEST_F(FullEquations, TakeAllKindsInOneLikelihood) {
  simulate(two_sweeps + three_blows + three_dwells);
  const Json all = identified();
  ASSERT_TRUE(all.is_object()) << printed();
  for (const Json& e : all["estimates"]) ASSERT_TRUE(e["value"].is_number()) << e["name"];
  expect_right(all, "3 dwells, 3 impacts, 2 sweeps");
}

// Of a record that a choice leaves out, and of dwells alone, nothing is different from what it was.
TEST_F(FullEquations, AndTheOthersTakeAllNumbersAsGiven) {
  simulate(three_dwells);
  std::string given;
  for (const Truth& truth : truths)
    given += " --fix " + std::string(truth.name) + "=" + std::to_string(truth.value);
  for (const char* by : {" --by full-equations", " --by modulation-equations"}) {
    const Json estimate = identified("model.toml", by + given);
    ASSERT_TRUE(estimate.is_object()) << by << '\n' << printed();
    for (std::size_t p = 0; p < truths.size(); ++p)
      EXPECT_DOUBLE_EQ(estimate["estimates"][p]["value"].get<double>(), truths[p].value) << by;
    std::ifstream page(folder_ / "out/report.html");
    const std::string html((std::istreambuf_iterator<char>(page)), {});
    EXPECT_NE(html.find("all parameters were given"), std::string::npos) << by;
  }
}

TEST_F(FullEquations, AreNotAskedWhereRecordsHaveAnExpansion) {
  simulate(
      "[[dwell]]\nfrequencies_hz = [9.6, 9.8, 9.9, 10.0, 10.1, 10.2, 10.3, 10.4, 10.6]\namplitudes = [1.0]\n"
      "ensembles = 5\nensemble_s = 2.0\nsettle_s = 20.0\n" +
      two_sweeps);  // records 10 and 11
  const Json dwells = identified("model.toml", "--records 'records/000?.csv'");
  ASSERT_TRUE(dwells.is_object()) << printed();
  EXPECT_FALSE(dwells.contains("equations"));
  const Json chosen = identified("model.toml", "--by modulation-equations");
  ASSERT_TRUE(chosen.is_object()) << printed();
  EXPECT_EQ(chosen["estimates"], dwells["estimates"]);
  // Not without a word where an option chooses.
  EXPECT_EQ(printed().find("leave out"), std::string::npos) << printed();
  const Json of_case = identified("model.toml", "--case primary");
  EXPECT_EQ(of_case["estimates"], dwells["estimates"]);
  EXPECT_NE(printed().find("--case is of the modulation equations, which leave out 2 sweeps"), std::string::npos)
      << printed();
}

TEST_F(FullEquations, SayFirstThatAModelWithoutItsSpringDoesNotHold) {
  simulate(broadband_record);
  write_model("linear.toml", "", "");
  const Json estimate = identified("linear.toml");
  ASSERT_TRUE(estimate.is_object()) << printed();
  EXPECT_TRUE(estimate["quality"]["lack_of_fit"][0]["significant"].get<bool>());
  EXPECT_EQ(estimate["quality"]["warnings"][0].get<std::string>().rfind("the model does not hold", 0), 0U)
      << printed();
  // Error bars allow for what the numbers may have taken up.
  for (const Json& e : estimate["estimates"])
    if (e["value"].is_number()) {
      EXPECT_GE(e["sd"].get<double>(), 0.5 * e["misfit"].get<double>());
      EXPECT_GT(e["misfit"].get<double>(), 10 * e["sd_by_noise"].get<double>() / estimate_ratio(estimate));
    }
}

TEST_F(FullEquations, SayWhichNumbersGoTogetherOnly) {
  simulate(broadband_record);
  write_model("twice.toml", " - 2*mu0*D(v)", " - alpha3*v^3");
  const Json estimate = identified("twice.toml");
  ASSERT_TRUE(estimate.is_object()) << printed();
  std::size_t without = 0;
  for (const Json& e : estimate["estimates"])
    if (e["name"] == "mu0" || e["name"] == "mu1") {
      ++without;
      EXPECT_TRUE(e["value"].is_null());
      EXPECT_FALSE(e["identifiable"].get<bool>());
      EXPECT_EQ(e["entangled_with"].size(), 1U);
    } else {
      EXPECT_TRUE(e["value"].is_number()) << e["name"];
    }
  EXPECT_EQ(without, 2U);
  EXPECT_EQ(estimate["quality"]["not_separated"].size(), 1U);
  // One of them known, the other has a number.
  const Json known = identified("twice.toml", "--fix mu0=0.1");
  for (const Json& e : known["estimates"])
    if (e["name"] == "mu1") {
      EXPECT_NEAR(e["value"].get<double>(), 0.5, 4 * e["sd"].get<double>());
    }
}

TEST_F(FullEquations, AreContinuousInTheSamples) {
  simulate(broadband_record);
  const Json before = identified();
  jitter(1);
  const Json after = identified();
  ASSERT_TRUE(before.is_object() && after.is_object()) << printed();
  for (std::size_t p = 0; p < truths.size(); ++p) {
    const double sd = before["estimates"][p]["sd"].get<double>();
    EXPECT_NEAR(after["estimates"][p]["value"].get<double>(), before["estimates"][p]["value"].get<double>(),
                0.01 * sd);
    EXPECT_NEAR(after["estimates"][p]["sd"].get<double>(), sd, 0.01 * sd);
  }
}

// What is printed where nobody looks is plain ASCII; options of the other way are refused with this one's name.
TEST_F(FullEquations, PrintPlainTextAndNameTheOtherWay) {
  simulate(broadband_record);
  identified();
  const std::string text = printed();
  EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; }))
      << text;
  EXPECT_EQ(run("identify " + path("campaign") + " --model " + path("model.toml") +
                " --by full-equations --case primary --force -o " + path("out")),
            2);
  EXPECT_NE(printed().find("--by modulation-equations"), std::string::npos) << printed();
  EXPECT_EQ(run("identify " + path("campaign") + " --model " + path("model.toml") + " --bootstrap 10 --force -o " +
                path("out")),
            2);
  EXPECT_NE(printed().find("cannot use the records of"), std::string::npos) << printed();
}

class SlowFullEquations : public FullEquations {};

// Of 24 draws with five numbers each, which are not independent: those of a draw count as one.
TEST_F(SlowFullEquations, IntervalsHoldTheTruth) {
  constexpr int draws = 24;
  int held = 0, alarms = 0;
  for (int draw = 0; draw < draws; ++draw) {
    simulate(broadband_record, 100 + draw);
    const Json estimate = identified();
    ASSERT_TRUE(estimate.is_object()) << printed();
    alarms += estimate["quality"]["lack_of_fit"][0]["significant"].get<bool>();
    for (std::size_t p = 0; p < truths.size(); ++p) {
      const Json& ci = estimate["estimates"][p]["ci95"];
      if (ci[0].get<double>() <= truths[p].value && truths[p].value <= ci[1].get<double>()) ++held;
    }
  }
  const auto numbers = static_cast<double>(truths.size());
  const double share = held / (numbers * draws);
  EXPECT_GT(share, 0.95 - 2.6 * std::sqrt(0.95 * 0.05 / draws));
  // At the level of a gap two of 24 are a matter of 0.2 %.
  EXPECT_LE(alarms, 1);
}

// d of a law of v/d at zero: the law is that of a step there, whatever d is. `nominal`: rough numbers that are
// said.
class LawOfAStep : public FullEquations {
 protected:
  int identified_with(const std::string& nominal) const {
    write_model("saturating.toml", "", " - k*tanh(v/d)");
    std::ifstream in(folder_ / "saturating.toml");
    std::string text((std::istreambuf_iterator<char>(in)), {});
    text.replace(text.find(", alpha3 = 2"), 12, "");
    std::ofstream(folder_ / "saturating.toml") << text << nominal;
    return run("identify " + path("campaign") + " --model " + path("saturating.toml") + " --force -o " +
               path("out"));
  }
};

TEST_F(LawOfAStep, AsksForASymbolThatNoFitCanBeginWithAtZero) {
  ASSERT_NO_FATAL_FAILURE(simulate(three_blows));
  EXPECT_EQ(identified_with(""), 2);
  EXPECT_NE(printed().find("no start for d:"), std::string::npos) << printed();
}

// The fit that goes on is one as others of these tests are, and takes a hundred times as long as the refusal.
TEST_F(LawOfAStep, GoesOnWithARoughNumber) {
  ASSERT_NO_FATAL_FAILURE(simulate(three_blows));
  EXPECT_NE(identified_with("k = 1.0\nd = 0.01\n"), 2) << printed();
}

}  // namespace
}  // namespace secular
