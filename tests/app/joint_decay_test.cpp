// Two modes that ring together after a pluck, from experiment to estimates: their own and their coupling terms,
// with and without an internal resonance between them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

using Values = std::map<std::string, double>;

/// Two modes, and the one case of their free motion.
struct TwoModes {
  std::string name, x, y;  // equations
  std::string relations, order;
  int expand_to;
  double w2;
};

std::string joint_model_text(const TwoModes& model) {
  return "schema = 1\nname = \"" + model.name + "\"\n" +
         "[[mode]]\ncoordinate = \"x\"\nfrequency = \"w1\"\nequation = \"" + model.x +
         "\"\n[[mode]]\ncoordinate = \"y\"\nfrequency = \"w2\"\nequation = \"" + model.y +
         "\"\n[[case]]\nname = \"free\"\nrelations = [" + model.relations + "]\norder = { " + model.order +
         " }\nexpand_to = " + std::to_string(model.expand_to) +
         "\nexcitation = false\n[nominal]\nw1 = 40\nw2 = " + std::to_string(model.w2) + "\n";
}

std::string joint_experiment_text(const fs::path& model, const Values& parameters) {
  std::string text =
      "schema = 1\nname = \"pluck\"\nmodel = \"" + model.string() + "\"\nsample_rate_hz = 200.0\n[parameters]\n";
  for (const auto& [name, value] : parameters) text += name + " = " + std::to_string(value) + "\n";
  for (const char* channel : {"x", "y"})
    text += "[[response]]\nname = \"" + std::string(channel) +
            "\"\nquantity = \"displacement\"\nunit = \"m\"\nnoise_sd = 1e-5\n";
  for (const char* start : {"[0.04, 0.02]", "[0.03, 0.03]"})
    text += "[[free_decay]]\ninitial_displacement = " + std::string(start) + "\nduration_s = 18.0\n";
  return text;
}

class SlowJointDecay : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  void run(const std::string& arguments) const {
    const testing_support::Outcome outcome = testing_support::run_with_shared_cache(folder_, arguments);
    EXPECT_EQ(outcome.status, 0) << arguments << ": " << outcome.errors;
  }

  // Every parameter is identified, within four standard deviations, which are at most `share` of it.
  void expect_recovered(const std::string& model, const Values& truth, double share) const {
    std::ofstream(folder_ / "model.toml") << model;
    std::ofstream(folder_ / "experiment.toml") << joint_experiment_text(folder_ / "model.toml", truth);
    run("simulate experiment.toml -o campaign");
    run("identify campaign --model model.toml -o out");
    std::ifstream stream(folder_ / "out" / "estimate.json");
    const nlohmann::json document = nlohmann::json::parse(stream);
    std::size_t found = 0;
    for (const auto& item : document.at("estimates")) {
      const auto name = item.at("name").get<std::string>();
      ASSERT_TRUE(item.at("identifiable").get<bool>()) << name;
      const double value = item.at("value").get<double>(), sd = item.at("sd").get<double>();
      EXPECT_NEAR(value, truth.at(name), 4 * sd) << name;
      EXPECT_LT(sd, share * std::abs(truth.at(name))) << name;
      ++found;
    }
    EXPECT_EQ(found, truth.size());
  }

  fs::path folder_ = testing_support::process_folder() / "joint";
};

TEST_F(SlowJointDecay, CouplingByACommonCubicPotential) {
  expect_recovered(
      joint_model_text({"springs", "D2(x) + w1^2*x = -2*m1*D(x) - n1*D(x)^3 - k1*x^3 - k12*x*y^2",
                        "D2(y) + w2^2*y = -2*m2*D(y) - k2*y^3 - k12*x^2*y", "",
                        "m1 = 1, m2 = 1, n1 = 1, k1 = 1, k2 = 1, k12 = 1", 1, 97}),
      {{"w1", 40}, {"w2", 97}, {"m1", 0.25}, {"m2", 0.35}, {"n1", 0.1}, {"k1", 6e3}, {"k2", 3e4}, {"k12", 1.5e4}},
      0.05);
}

// Energy goes to and fro between the modes: what one loses by damping is told from what it hands over.
TEST_F(SlowJointDecay, OneToTwoInternalResonance) {
  expect_recovered(joint_model_text({"one_to_two", "D2(x) + w1^2*x = -2*m1*D(x) - 2*a*x*y - k1*x^3",
                                     "D2(y) + w2^2*y = -2*m2*D(y) - a*x^2", "\"w2 = 2*w1 + eps*sigma1\"",
                                     "m1 = 1, m2 = 1, a = 1, k1 = 2", 2, 81}),
                   {{"w1", 40}, {"w2", 81}, {"m1", 0.15}, {"m2", 0.25}, {"a", 600}, {"k1", 8e3}}, 0.05);
}

}  // namespace
}  // namespace secular
