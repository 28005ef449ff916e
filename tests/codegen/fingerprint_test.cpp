// A model file may bear a shipped model's name and differ in anything: its code is the shipped one only where all
// that code is made from is the same.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "codegen/canonical/canonical_model.hpp"
#include "generated/registry.hpp"
#include "perturb/model.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

std::string shipped_text(const std::string& name) {
  std::ifstream file(testing_support::source_folder() / "models" / (name + ".toml"));
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string fingerprint_of(const std::string& text) {
  return canonical_model(read_model_text(text, "model.toml"), {}, CanonicalContent::code).fingerprint;
}

std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::out_of_range(from);
  return text.replace(at, from.size(), to);
}

constexpr const char* duffing = R"toml(schema = 1
name = "two_springs"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -2*m*D(x) - g*x^3 - h*y*x + k*F*cos(Omega*t)"
[[mode]]
coordinate = "y"
frequency = "q"
equation = "D2(y) + q^2*y = -2*n*D(y) - h*x^2"
[[case]]
name = "primary"
relations = ["Omega = w + eps^2*sigma"]
order = { m = 2, n = 2, g = 2, h = 1, k = 2 }
expand_to = 2
modes_at_rest = []
[nominal]
w = 10.0
q = 37.0
)toml";

TEST(Fingerprint, OfTheShippedFileIsThatOfTheCompiledModel) {
  for (const char* name : {"two_mass_mode1", "duffing", "pendulum"})
    EXPECT_EQ(fingerprint_of(shipped_text(name)), generated::find_compiled_model(name)->fingerprint) << name;
}

TEST(Fingerprint, ChangesWithEverythingThatCodeIsMadeFrom) {
  const std::string text = duffing, own = fingerprint_of(text);
  EXPECT_EQ(fingerprint_of(text + "# a comment\n"), own);
  for (const auto& [from, to] :
       {std::pair{"w = 10.0", "w = 11.0"}, std::pair{"q = 37.0\n", ""},
        std::pair{"modes_at_rest = []", "modes_at_rest = [\"y\"]"},
        std::pair{"[\"Omega = w + eps^2*sigma\"]", "[\"Omega = w + eps*sigma\"]"}, std::pair{"g*x^3", "2*g*x^3"},
        std::pair{"coordinate = \"y\"\n", "coordinate = \"y\"  \n"}}) {
    const bool same = std::string(from).starts_with("coordinate");
    EXPECT_EQ(fingerprint_of(edited(text, from, to)) == own, same) << from << " -> " << to;
  }
  const std::string free = edited(edited(text, "relations = [\"Omega = w + eps^2*sigma\"]\n", ""),
                                  "modes_at_rest = []", "excitation = false");
  EXPECT_NE(fingerprint_of(free), fingerprint_of(edited(free, "excitation = false", "excitation = true")));
  EXPECT_NE(fingerprint_of(edited(text, "expand_to = 2", "expand_to = 3")), own);
}

}  // namespace
}  // namespace secular
