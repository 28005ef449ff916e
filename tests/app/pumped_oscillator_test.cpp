// A force at Omega and a pump at 2*Omega, locked to it: simulated, predicted, identified and diagnosed.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/program_run.hpp"
#include "tests/campaign/temporary_folder.hpp"

namespace secular {
namespace pumped {
namespace {

constexpr double omega0 = 31, mu = 0.8, a3 = 2e4, pump = 1, rate_hz = 64, two_pi = 2 * std::numbers::pi;

const char* const pumped_model = R"toml(schema = 1
name = "pumped"
[[mode]]
coordinate = "x"
frequency = "omega0"
equation = "D2(x) + 2*mu*D(x) + omega0^2*x + a3*x^3 + p*x*F2*cos(Omega2*t) = eta*F*cos(Omega*t)"
[[case]]
name = "primary"
relations = ["Omega = omega0 + eps^2*sigma", "Omega2 = 2*Omega"]
order = { mu = 2, a3 = 2, p = 2, eta = 2 }
expand_to = 2
[nominal]
omega0 = 31
)toml";

std::string experiment(const std::string& noise, const std::string& programme) {
  const auto channel = [](const std::string& header, const std::string& name, const std::string& quantity,
                          const std::string& sd) {
    return "[[" + header + "]]\nname = \"" + name + "\"\nquantity = \"" + quantity + "\"\nnoise_sd = " + sd + "\n";
  };
  const std::string of_excitations = noise == "0.0" ? noise : "0.003";
  return "schema = 1\nname = \"pumped\"\nmodel = \"model.toml\"\nsample_rate_hz = 64.0\n[parameters]\nomega0 = 31\n"
         "mu = 0.8\na3 = 2e4\np = 1\neta = 1\n" +
         channel("excitation", "force", "acceleration", of_excitations) +
         channel("excitation", "pump", "acceleration", of_excitations) +
         channel("response", "x", "displacement", noise) + programme;
}

using State = std::array<double, 2>;
using Force = std::function<double(double)>;

// Displacements at begin, begin + 1/rate_hz, ... by Runge and Kutta in 32 parts of a sample.
std::vector<double> integrated(const Force& force, const Force& pumped, double begin, State y, std::size_t count) {
  const auto rate = [&](double t, const State& x) {
    return State{x[1],
                 force(t) - 2 * mu * x[1] - (omega0 * omega0 + pump * pumped(t)) * x[0] - a3 * x[0] * x[0] * x[0]};
  };
  const auto moved = [](const State& x, const State& k, double h) {
    return State{x[0] + h * k[0], x[1] + h * k[1]};
  };
  constexpr std::size_t parts = 32;
  constexpr double h = 1 / rate_hz / parts;
  std::vector<double> samples;
  for (std::size_t i = 0; samples.size() < count; ++i) {
    if (i % parts == 0) samples.push_back(y[0]);
    const double t = begin + static_cast<double>(i) * h;
    const State a = rate(t, y), b = rate(t + h / 2, moved(y, a, h / 2)), c = rate(t + h / 2, moved(y, b, h / 2)),
                d = rate(t + h, moved(y, c, h));
    for (std::size_t k = 0; k < 2; ++k) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
  }
  return samples;
}

class PumpedOscillator : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    write("model.toml", pumped_model);
    write("numbers.json", R"({"omega0":31,"mu":0.8,"a3":2e4,"p":1,"eta":1,"F":1,"F2":30})");
  }
  testing_support::Outcome run(const std::string& arguments) const {
    return testing_support::run_with_shared_cache(folder_, arguments);
  }
  // Column of a record.
  std::vector<double> recorded(const std::string& file, std::size_t column) const {
    std::istringstream lines(read(file));
    std::string line;
    std::vector<double> values;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      std::string cell;
      for (std::size_t c = 0; c <= column; ++c) std::getline(cells, cell, ',');
      values.push_back(std::stod(cell));
    }
    return values;
  }
  static void expect_same(const std::vector<double>& here, const std::vector<double>& there, double scale) {
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i) ASSERT_NEAR(here[i], there[i], 1e-6 * scale) << i;
  }
};

TEST_F(PumpedOscillator, RecordsAreMotionsUnderBothExcitations) {
  write("experiment.toml",
        experiment("0.0",
                   "[[dwell]]\nfrequencies_hz = [[4.9, 9.8], [5.0, 10.0]]\namplitudes = [[2.0, 60.0]]\n"
                   "phases = [0.3, 0.7]\nensemble_s = 3.0\nsettle_s = 2.0\ncarry_state = true\n"
                   "[[sweep]]\nfrom_hz = [4.8, 9.6]\nto_hz = [5.0, 10.0]\nrate_hz_per_s = 0.1\n"
                   "amplitude = [1.0, 30.0]\nsettle_s = 1.0\n"));
  const testing_support::Outcome outcome = run("simulate experiment.toml -o campaign");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto tone = [](double amplitude, double hz, double phase) {
    return [=](double t) { return amplitude * std::cos(two_pi * hz * t + phase); };
  };
  const Force force = tone(2, 4.9, 0.3), pumped = tone(60, 9.8, 0.7);
  const std::vector<double> all = integrated(force, pumped, 0, {}, 320),
                            x = recorded("campaign/records/0001.csv", 3);
  expect_same({all.begin() + 128, all.end()}, x, 0.05);
  const std::vector<double> forces = recorded("campaign/records/0001.csv", 1),
                            pumps = recorded("campaign/records/0001.csv", 2);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = 2 + static_cast<double>(i) / rate_hz;
    ASSERT_NEAR(forces[i], force(t), 1e-9) << i;
    ASSERT_NEAR(pumps[i], pumped(t), 1e-8) << i;
  }
  // The excitations of the next dwell go on without a jump of their phases.
  const double end = 2 + 191 / rate_hz;
  EXPECT_NEAR(recorded("campaign/records/0002.csv", 2)[0], 60 * std::cos(two_pi * (10.0 * 2 + 9.8 * end) + 0.7),
              1e-6);
  const auto swept = [](double amplitude, double hz, double hz_per_s) {
    return [=](double t) { return amplitude * std::cos(two_pi * (hz * t + (t > 0 ? 0.5 * hz_per_s * t * t : 0))); };
  };
  const std::vector<double> sweep = integrated(swept(1, 4.8, 0.05), swept(30, 9.6, 0.1), -1, {}, 64 + 257);
  expect_same({sweep.begin() + 64, sweep.end()}, recorded("campaign/records/0003.csv", 3), 0.05);
}

TEST_F(PumpedOscillator, ResponsesArePredictedWithThePumpFollowing) {
  testing_support::Outcome outcome =
      run("predict model.toml --parameters numbers.json --vary Omega 30.6 31.4 --sweep up --sweep-steps 3 -o out");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const nlohmann::json document = nlohmann::json::parse(read("out/prediction.json"));
  // Peak at the excitation's frequency once the motion has settled: exp(-mu*10) < 4e-4.
  const auto settled = [](double omega) {
    const Force force = [=](double t) { return std::cos(omega * t); };
    const Force pumped = [=](double t) { return 30 * std::cos(2 * omega * t); };
    const std::vector<double> x = integrated(force, pumped, 0, {}, 1280);
    std::complex<double> sum = 0;
    for (std::size_t i = 640; i < 1280; ++i) {
      const double t = static_cast<double>(i) / rate_hz, weight = 1 - std::cos(two_pi * (t - 10) / 10);  // Hann
      sum += weight * x[i] * std::polar(1.0, -omega * t);
    }
    return 2 * std::abs(sum) / 640;
  };
  const nlohmann::json& points = document.at("branches").at(0).at("points");
  for (std::size_t i = 0; i < points.size(); i += 10) {
    const double omega = points[i].at("Omega").get<double>();
    const double predicted = points[i].at("modes").at(0).at("amplitude").get<double>();
    // Left out is the next order: twice the parameters that are small at order 2. Without its pump the motion would
    // be wrong by up to a quarter.
    const double left_out = 2 * (std::abs(omega / omega0 - 1) + pump * 30 / (4 * omega0 * omega0));
    EXPECT_NEAR(predicted, settled(omega), left_out * predicted) << omega;
  }
  for (const auto& point : document.at("simulated_sweeps").at(0).at("points")) {
    const double simulated = point.at("amplitude").at(0).get<double>();
    EXPECT_NEAR(simulated, settled(point.at("Omega").get<double>()), 3e-3 * simulated);
  }
  // The pump's frequency is the relation's.
  outcome = run("predict model.toml --parameters numbers.json --vary Omega2 61 63 -o no");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.errors.find("follows from the relations: Omega2 = 2*Omega"), std::string::npos)
      << outcome.errors;
  outcome = run("predict model.toml --parameters numbers.json --at Omega=31 --at Omega2=61 --vary F 0.1 1 -o no");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.errors.find("is 61 rad/s, and Omega2 = 2*Omega makes it 62 rad/s"), std::string::npos)
      << outcome.errors;
}

TEST_F(PumpedOscillator, IsIdentifiedAndLeavesNoGap) {
  write(
      "experiment.toml",
      experiment("1e-6",
                 "[[dwell]]\nfrequencies_hz = [[4.85, 9.7], [4.93, 9.86], [5.0, 10.0]]\n"
                 "amplitudes = [[2.0, 60.0], [1.0, 30.0]]\nphases = [0.0, 0.7]\nensembles = 4\nsettle_s = 15.0\n"));
  ASSERT_EQ(run("simulate experiment.toml -o campaign").status, 0);
  testing_support::Outcome outcome = run("identify campaign --model model.toml -o estimate");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const nlohmann::json estimate = nlohmann::json::parse(read("estimate/estimate.json"));
  const std::map<std::string, double> truth{{"omega0", omega0}, {"mu", mu}, {"a3", a3}, {"p", pump}, {"eta", 1}};
  ASSERT_EQ(estimate.at("estimates").size(), truth.size());
  for (const auto& entry : estimate.at("estimates")) {
    const double value = truth.at(entry.at("name").get<std::string>()), sd = entry.at("sd").get<double>();
    EXPECT_NEAR(entry.at("value").get<double>(), value, 4 * sd) << entry.at("name");
    EXPECT_LT(sd, 1e-3 * value) << entry.at("name");
  }
  outcome = run("diagnose campaign --model model.toml -o diagnosis");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("gap: no"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace pumped
}  // namespace secular
