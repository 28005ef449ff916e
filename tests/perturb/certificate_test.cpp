#include "perturb/certificate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

std::filesystem::path shipped(const std::string& name) {
  return testing_support::source_folder() / "models" / (name + ".toml");
}

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(testing_support::source_folder() / "models"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class ShippedModel : public testing::TestWithParam<std::string> {};

TEST_P(ShippedModel, EveryCaseIsCertifiedUnderBothOmegaPolicies) {
  const Model model = read_model(shipped(GetParam()));
  for (const ResonanceCase& resonance : model.cases)
    for (const OmegaPolicy policy : {OmegaPolicy::nominal, OmegaPolicy::kept}) {
      const Certificate certificate = certify(derive(model, resonance, policy));
      EXPECT_TRUE(certificate.holds) << resonance.name;
      EXPECT_GT(certificate.coefficients_checked, 10U);
      EXPECT_LT(certificate.nonsmooth_error, 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedModel, testing::ValuesIn(shipped_names()),
                         [](const auto& name) { return name.param; });

// Powers of exp(i Omega t) beyond those of small integers.
TEST(Certificate, HoldsForHighMultiplesOfAFrequency) {
  const auto text = [](int multiple, const char* term) {
    return fmt::format(
        "schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"v\"\nfrequency = \"w\"\nequation = \"D2(v) + w^2*v = "
        "-2*mu*D(v) - a*v^3 + f*F*cos(Omega*t) + g*{1}({0}*Omega*t)\"\n[[case]]\nname = \"c\"\nrelations = "
        "[\"{0}*Omega = 2*w + eps^2*sigma\"]\norder = {{ mu = 2, a = 2, f = 2, g = 2 }}\nexpand_to = 2\n",
        multiple, term);
  };
  for (const int multiple : {65, 129, 257, 999})
    for (const char* const term : {"v*cos", "v*sin"}) {
      const Model model = read_model_text(text(multiple, term), "model.toml");
      const Certificate certificate = certify(derive(model, model.find_case("c")));
      EXPECT_TRUE(certificate.holds) << multiple << term;
      EXPECT_GT(certificate.coefficients_checked, 10U);
    }
  for (const std::string& beyond : {text(1001, "v*cos"), text(1 << 30, "v*cos")})
    EXPECT_THROW(read_model_text(beyond, "model.toml"), InputError);
}

// The certificate must refuse an expansion with any single coefficient changed.
TEST(Certificate, NoticesEveryChangedCoefficient) {
  const Model model = read_model(shipped("two_mass_mode1"));
  const Derivation right = derive(model, model.find_case("principal_parametric"));
  const auto changed = [&](FieldSeries& series, std::size_t order, const FieldKey& key) {
    series[order].add(key, series[order].terms().at(key));  // doubles it
  };
  int refused = 0, tried = 0;
  for (std::size_t n = 1; n < right.response[0].size(); ++n)
    for (const auto& [key, ignored] : right.response[0][n].terms()) {
      Derivation wrong = right;
      changed(wrong.response[0], n, key);
      ++tried;
      refused += !certify(wrong).holds;
    }
  for (const auto& [key, ignored] : right.slow_derivative[0][2].terms()) {
    Derivation wrong = right;
    changed(wrong.slow_derivative[0], 2, key);
    ++tried;
    refused += !certify(wrong).holds;
  }
  EXPECT_GT(tried, 20);
  EXPECT_EQ(refused, tried);
}

}  // namespace
}  // namespace secular
