// Two excitations of any frequencies whose difference is near the natural one, integrated by hand: identified as
// dwells by the modulation equations and as broadband records by the full ones.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

const char* const two_excitations = R"toml(schema = 1
name = "two"
[[mode]]
coordinate = "x"
frequency = "omega0"
equation = "D2(x) + 2*mu*D(x) + omega0^2*x + a3*x^3 + a2*x^2 = eta*F*cos(Omega*t) + eta2*F2*cos(Omega2*t)"
[[case]]
name = "difference"
relations = ["Omega2 - Omega = omega0 + eps^2*sigma"]
order = { mu = 2, a3 = 2, a2 = 1, eta = 0, eta2 = 0 }
expand_to = 2
[nominal]
omega0 = 31
)toml";

class TwoExcitations : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "dwells" / "records");
    std::ofstream(folder_ / "two.toml") << two_excitations;
    std::string records;
    for (const double detuning : {-0.8, -0.3, 0.2, 0.7}) records += record(detuning);
    const auto channel = [](const char* name, const char* rest) {
      return std::string("[[channel]]\nname = \"") + name + "\"\n" + rest + "\n";
    };
    const std::string base = "role = \"excitation\"\nquantity = \"acceleration\"\nunit = \"m/s^2\"";
    std::ofstream(folder_ / "dwells" / "campaign.toml")
        << "schema = 1\nname = \"two\"\nsample_rate_hz = 64.0\n" + channel("b1", base.c_str()) +
               channel("b2", base.c_str()) +
               channel("x", "role = \"response\"\nquantity = \"displacement\"\nunit = \"m\"") + records;
  }
  void TearDown() override { fs::remove_all(folder_); }
  int run(const std::string& arguments) const {
    return testing_support::run_with_shared_cache(folder_, arguments).status;
  }
  std::string errors() const { return testing_support::text_of(folder_ / "stderr.txt"); }

  // Sixteen seconds after ten that settle, by Runge and Kutta in sixteenths of a sample; its [[record]].
  std::string record(double detuning) {
    const double first = 2 * std::numbers::pi * 3.1, second = first + omega0 + detuning;
    const auto f1 = [&](double t) { return 4 * std::cos(first * t); };
    const auto f2 = [&](double t) { return 6 * std::cos(second * t); };
    using State = std::array<double, 2>;
    const auto rate = [&](double t, const State& y) {
      return State{y[1], -omega0 * omega0 * y[0] - 2 * mu * y[1] - a3 * y[0] * y[0] * y[0] - a2 * y[0] * y[0] +
                             f1(t) + eta2 * f2(t)};
    };
    const auto moved = [](const State& y, const State& k, double h) {
      return State{y[0] + h * k[0], y[1] + h * k[1]};
    };
    constexpr int parts = 16, settling = 640, samples = 1024;
    const double h = 1.0 / 64 / parts;
    const std::string file = "records/" + std::to_string(++records_) + ".csv";
    std::ofstream csv(folder_ / "dwells" / file);
    csv.precision(12);
    csv << "t,b1,b2,x\n";
    State y{};
    for (int i = 0; i < (settling + samples) * parts; ++i) {
      const double t = i * h;
      if (i % parts == 0 && i >= settling * parts)
        csv << t << ',' << f1(t) + 0.003 * normal_(random_) << ',' << f2(t) + 0.003 * normal_(random_) << ','
            << y[0] + 1e-6 * normal_(random_) << '\n';
      const State a = rate(t, y), b = rate(t + h / 2, moved(y, a, h / 2)), c = rate(t + h / 2, moved(y, b, h / 2)),
                  d = rate(t + h, moved(y, c, h));
      for (std::size_t k = 0; k < 2; ++k) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    return "[[record]]\nfile = \"" + file +
           "\"\nkind = \"dwell\"\nensemble_s = 4.0\nexcitation_frequency_hz = 3.1\n";
  }

  void expect_truth(const char* folder) const {
    const nlohmann::json estimate =
        nlohmann::json::parse(testing_support::text_of(folder_ / folder / "estimate.json"));
    int seen = 0;
    for (const auto& [name, truth, share] : {std::tuple{"omega0", omega0, 1e-3},
                                             {"mu", mu, 0.02},
                                             {"a2", a2, 0.05},
                                             {"eta", 1.0, 0.01},
                                             {"eta2", eta2, 0.01}})
      for (const auto& entry : estimate.at("estimates")) {
        if (entry.at("name") != name) continue;
        ++seen;
        ASSERT_FALSE(entry.at("value").is_null()) << name;
        const double sd = entry.at("sd").get<double>();
        EXPECT_LT(sd, share * std::abs(truth)) << name;
        EXPECT_NEAR(entry.at("value").get<double>(), truth, 4 * sd) << name;
      }
    EXPECT_EQ(seen, 5);
  }

  static constexpr double omega0 = 31, mu = 0.8, a2 = -300, a3 = 2e4, eta2 = 0.8;
  const fs::path folder_ = testing_support::process_folder() / "two-excitations";
  std::mt19937_64 random_{5};
  std::normal_distribution<double> normal_;
  int records_ = 0;
};

TEST_F(TwoExcitations, AreIdentifiedEachAtItsOwnFrequency) {
  ASSERT_EQ(run("identify dwells --model two.toml -o estimate"), 0) << errors();
  expect_truth("estimate");
  // Lines of one dwell are multiples of one frequency.
  EXPECT_EQ(run("diagnose dwells --model two.toml -o diagnosis"), 2);
  EXPECT_NE(errors().find("kind = \"broadband\" compares it sample by sample"), std::string::npos) << errors();
  const fs::path campaign = folder_ / "dwells" / "campaign.toml";
  std::string text = testing_support::text_of(campaign);
  for (const auto& [dwell, other] :
       {std::pair{"kind = \"dwell\"\nensemble_s = 4.0\nexcitation_frequency_hz = 3.1", "kind = \"broadband\""}})
    for (std::size_t at = 0; (at = text.find(dwell, at)) != std::string::npos;)
      text.replace(at, std::string(dwell).size(), other);
  std::ofstream(campaign) << text;
  ASSERT_EQ(run("identify dwells --model two.toml -o by_samples"), 0) << errors();
  expect_truth("by_samples");
}

}  // namespace
}  // namespace secular
