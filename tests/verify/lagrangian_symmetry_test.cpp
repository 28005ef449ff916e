#include "thesis/verify/lagrangian_symmetry.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/places.hpp"

namespace secular::verify {
namespace {

const std::vector<std::string> dissipation_and_excitation = {"mu11", "mu12",  "mu13",  "mu21",  "mu22",
                                                             "mu23", "eta11", "eta12", "eta21", "eta22"};

std::string two_mass_text() {
  std::ifstream file(testing_support::source_folder() / "models" / "two_mass.toml");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(LagrangianSymmetry, HoldsForTheTwoModeEquations) {
  EXPECT_TRUE(broken_lagrangian_symmetries(read_model_text(two_mass_text(), "two_mass"), dissipation_and_excitation)
                  .empty());
}

// Any one coupling term changed breaks a condition.
TEST(LagrangianSymmetry, BreaksWithOneChangedTerm) {
  for (const auto& [from, to] : {std::pair<std::string, std::string>("2*alpha22*v1*v2", "3*alpha22*v1*v2"),
                                 {"- delta23*D(v2)^2", "+ delta23*D(v2)^2"},
                                 {"3*alpha32*v1^2*v2", "2*alpha32*v1^2*v2"},
                                 {"2*delta33*D(v1)*v2*D(v2)", "delta33*D(v1)*v2*D(v2)"},
                                 {"delta35*v1*D(v2)^2", "2*delta35*v1*D(v2)^2"}}) {
    std::string text = two_mass_text();
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    EXPECT_FALSE(broken_lagrangian_symmetries(read_model_text(text, "changed"), dissipation_and_excitation).empty())
        << from;
  }
}

TEST(LagrangianSymmetry, DampingBreaksIt) {
  EXPECT_FALSE(broken_lagrangian_symmetries(read_model_text(two_mass_text(), "two_mass"), {}).empty());
}

}  // namespace
}  // namespace secular::verify
