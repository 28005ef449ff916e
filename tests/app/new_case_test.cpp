// A resonance that no shipped model lists costs one [[case]] block.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::text_of;

class SlowNewCase : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  int run(const std::string& arguments) const {
    return testing_support::run_with_shared_cache(folder_, arguments).status;
  }
  std::string output() const { return text_of(folder_ / "stdout.txt"); }
  std::string errors() const { return text_of(folder_ / "stderr.txt"); }

  fs::path folder_ = testing_support::process_folder() / "new-case";
};

// The difference resonance on the physics of the shipped two-mode model.
TEST_F(SlowNewCase, DifferenceResonanceOfTheShippedTwoModePhysics) {
  // The physics up to the first case, with the orders of the additive combination.
  const std::string shipped = text_of(testing_support::source_folder() / "models" / "two_mass.toml");
  const std::size_t additive = shipped.find("additive_combination"), order = shipped.find("order", additive);
  const std::string orders = shipped.substr(order, shipped.find('\n', order) - order);
  std::ofstream(folder_ / "my_two_mass.toml") << shipped << "\n[[case]]\nname = \"difference\"\n"
                                              << "relations = [\"Omega = omega2 - omega1 + eps^2*sigma\"]\n"
                                              << orders << "\nexpand_to = 2\n";
  ASSERT_EQ(run("derive my_two_mass.toml --case difference"), 0) << errors();
  EXPECT_NE(output().find("ertificate"), std::string::npos);

  // Coupling by the quadratic terms alone: with p_k = eta_k1 F/(w_k^2 - Omega^2), the forced motion of mode k, the
  // equation of mode 2 holds 2 (alpha22 p_1 + alpha23 p_2) cos(Omega t) v_1, so that
  // dA_2/dt = i (alpha22 p_1 + alpha23 p_2)/(2 w_2) A_1; that of mode 1 the same with v_2, and 1/(2 w_1).
  const double w1 = 70, w2 = 200, alpha22 = 3e5, alpha23 = -2e5, eta11 = 0.4, eta21 = 0.7;
  ASSERT_EQ(run("evaluate my_two_mass.toml --case difference --at values.json"), 2);  // there are none yet
  nlohmann::json values = {{"F", 1}, {"sigma", 0.3}, {"Omega", w2 - w1}};
  std::ifstream stream(testing_support::source_folder() / "models" / "two_mass.toml");
  for (std::size_t at = orders.find('{') + 1; at < orders.size();) {
    const std::size_t equals = orders.find(" =", at);
    if (equals == std::string::npos) break;
    const std::size_t begin = orders.find_last_of(" ,{", equals - 1) + 1;
    values[orders.substr(begin, equals - begin)] = 0;
    at = equals + 2;
  }
  for (const auto& [name, value] : std::map<std::string, double>{{"omega1", w1},
                                                                 {"omega2", w2},
                                                                 {"alpha22", alpha22},
                                                                 {"alpha23", alpha23},
                                                                 {"eta11", eta11},
                                                                 {"eta21", eta21}})
    values[name] = value;
  std::ofstream(folder_ / "values.json") << values;
  ASSERT_EQ(run("evaluate my_two_mass.toml --case difference --at values.json"), 0) << errors();
  const auto modulation = nlohmann::json::parse(output()).at("modulation");
  const auto term = [&](const char* mode, const std::map<std::string, int>& powers, int slow) {
    for (const auto& entry : modulation.at(mode))
      if (entry.at("powers").get<std::map<std::string, int>>() == powers &&
          entry.at("slow_phase").value("sigma", 0) == slow)
        return std::complex<double>(entry.at("value")[0].get<double>(), entry.at("value")[1].get<double>());
    ADD_FAILURE() << "no such term in the modulation of " << mode << ": " << modulation.at(mode);
    return std::complex<double>();
  };
  const double omega = w2 - w1, p1 = eta11 / (w1 * w1 - omega * omega), p2 = eta21 / (w2 * w2 - omega * omega);
  const double coupling = alpha22 * p1 + alpha23 * p2;
  const std::complex<double> second = term("v2", {{"A_v1", 1}, {"F", 1}}, 1),
                             first = term("v1", {{"A_v2", 1}, {"F", 1}}, -1);
  EXPECT_NEAR(second.real(), 0, 1e-12 * std::abs(coupling));
  EXPECT_NEAR(second.imag() / (coupling / (2 * w2)), 1, 1e-12);
  EXPECT_NEAR(first.imag() / (coupling / (2 * w1)), 1, 1e-12);
}

}  // namespace
}  // namespace secular
