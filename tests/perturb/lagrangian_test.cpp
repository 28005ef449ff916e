#include <gtest/gtest.h>

#include <filesystem>

#include "input/input_error.hpp"
#include "perturb/certificate.hpp"
#include "perturb/derivation.hpp"
#include "perturb/term_sum.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

std::filesystem::path shipped_model(const std::string& name) {
  return testing_support::source_folder() / "models" / (name + ".toml");
}

GiNaC::ex term_coefficient(const Derivation& d, std::size_t mode,
                           const std::vector<std::pair<std::size_t, int>>& powers) {
  const Field modulation = d.modulation(mode);
  for (const auto& [key, value] : modulation.terms()) {
    FieldKey wanted(d.layout.size(), 0);
    for (const auto& [place, power] : powers) wanted[place] = power;
    bool same = true;
    for (std::size_t i = d.layout.amplitude(0); i < key.size(); ++i) same = same && key[i] == wanted[i];
    if (same) return value;
  }
  return 0;
}

// The equations of a Lagrangian are those written out by hand.
TEST(Lagrangian, GivesTheEquationsOfMotion) {
  const Model derived = read_model_text(
      "schema = 1\nname = \"m\"\n[lagrangian]\n"
      "kinetic = \"D(x)^2/2 + D(y)^2/2 + d*x^2*D(x)^2/2 + c*y*D(x)*D(y)\"\n"
      "potential = \"w1^2*x^2/2 + w2^2*y^2/2 + a*x^2*y + b*x^4/4 - p*x*y*F*cos(Omega*t)\"\n"
      "[[mode]]\ncoordinate = \"x\"\nfrequency = \"w1\"\nforce = \"-2*mu*D(x)\"\n"
      "[[mode]]\ncoordinate = \"y\"\nfrequency = \"w2\"\n"
      "[[case]]\nname = \"c\"\nordering = \"degree\"\norder = { mu = 2, p = 1 }\n",
      "m");
  const Model written = read_model_text(
      "schema = 1\nname = \"m\"\n"
      "[[mode]]\ncoordinate = \"x\"\nfrequency = \"w1\"\nequation = \"D2(x) + w1^2*x + d*(x^2*D2(x) + x*D(x)^2) + "
      "c*(D(y)^2 "
      "+ y*D2(y)) + 2*a*x*y + b*x^3 = -2*mu*D(x) + p*y*F*cos(Omega*t)\"\n"
      "[[mode]]\ncoordinate = \"y\"\nfrequency = \"w2\"\nequation = \"D2(y) + w2^2*y + c*y*D2(x) + a*x^2 = "
      "p*x*F*cos(Omega*t)\"\n"
      "[[case]]\nname = \"c\"\nordering = \"degree\"\norder = { mu = 2, p = 1 }\n",
      "m");
  const std::vector<TermSum> a = equations_of_motion(derived), b = equations_of_motion(written);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].terms().size(), b[k].terms().size());
    for (const auto& [product, value] : a[k].terms()) {
      // Symbols of the two models differ: compare through text-independent numbers.
      const auto number = [](const Model& m, const GiNaC::ex& e) {
        GiNaC::exmap values;
        int next = 3;
        for (const char* name : {"w1", "w2", "a", "b", "c", "d", "mu", "p"}) values[m.symbols.at(name)] = next += 4;
        return e.subs(values);
      };
      ASSERT_TRUE(b[k].terms().count(product));
      EXPECT_TRUE((number(derived, value) - number(written, b[k].terms().at(product))).is_zero());
    }
  }
}

TEST(Lagrangian, IsCertifiedFromTheEnergiesThemselves) {
  const Model model = read_model(shipped_model("two_mass_frame"));
  for (const ResonanceCase& resonance : model.cases) {
    const Derivation d = derive(model, resonance);
    EXPECT_TRUE(certify(d).holds) << resonance.name;
  }
  // A changed coefficient is found.
  Derivation wrong = derive(model, model.find_case("free"));
  const FieldKey key = wrong.slow_derivative[0][2].terms().begin()->first;
  wrong.slow_derivative[0][2].add(key, wrong.slow_derivative[0][2].terms().at(key));
  EXPECT_FALSE(certify(wrong).holds);
}

// The frame by hand. Vertical base motion F cos(Omega t) gives v1 the parametric term eta2 v1 F cos(Omega t) with
// eta2 = 6/5 ((m1+m2) p11^2/h1 + m2 (p21-p11)^2/h2), so that dA/dt holds -i eta2/(4 omega1) F conj(A).
TEST(TwoMassFrame, ParametricCoefficient) {
  const Model m = read_model(shipped_model("two_mass_frame"));
  const Derivation d = derive(m, m.find_case("principal_parametric_1"));
  const auto s = [&](const char* name) { return m.symbols.at(name); };
  const GiNaC::ex eta2 = GiNaC::ex(6) / 5 * s("lift") *
                         ((s("m1") + s("m2")) * GiNaC::pow(s("p11"), 2) / s("h1") +
                          s("m2") * GiNaC::pow(s("p21") - s("p11"), 2) / s("h2"));
  const GiNaC::ex found = term_coefficient(d, 0, {{d.layout.conjugate(0), 1}, {d.layout.forcing(0), 1}});
  EXPECT_TRUE((found + GiNaC::I * eta2 / (4 * s("omega1"))).normal().is_zero());
}

// Backbone of mode 1: potential c4 v1^4 is alpha31 = 4 c4, kinetic d4 v1^2 v1'^2 is delta31 = 2 d4, and the
// frequency moves by (3 alpha31 - 2 omega1^2 delta31)/(2 omega1) |A|^2.
TEST(TwoMassFrame, Backbone) {
  const Model m = read_model(shipped_model("two_mass_frame"));
  const Derivation d = derive(m, m.find_case("free"));
  const auto s = [&](const char* name) { return m.symbols.at(name); };
  const GiNaC::ex low = s("p11"), drift = s("p21") - s("p11");
  const GiNaC::ex c4 = GiNaC::ex(9) / 35 * s("k1") * GiNaC::pow(low, 4) / GiNaC::pow(s("h1"), 2) +
                       GiNaC::ex(9) / 35 * s("k2") * GiNaC::pow(drift, 4) / GiNaC::pow(s("h2"), 2) -
                       GiNaC::ex(9) / 35 * s("g") *
                           ((s("m1") + s("m2")) * GiNaC::pow(low, 4) / GiNaC::pow(s("h1"), 3) +
                            s("m2") * GiNaC::pow(drift, 4) / GiNaC::pow(s("h2"), 3));
  const GiNaC::ex sink1 = GiNaC::ex(6) / 5 * GiNaC::pow(low, 2) / s("h1");
  const GiNaC::ex sink2 = sink1 + GiNaC::ex(6) / 5 * GiNaC::pow(drift, 2) / s("h2");
  const GiNaC::ex d4 = (s("m1") * GiNaC::pow(sink1, 2) + s("m2") * GiNaC::pow(sink2, 2)) / 2;
  const GiNaC::ex expected = GiNaC::I * (12 * c4 - 4 * GiNaC::pow(s("omega1"), 2) * d4) / (2 * s("omega1"));
  const GiNaC::ex found = term_coefficient(d, 0, {{d.layout.amplitude(0), 2}, {d.layout.conjugate(0), 1}});
  EXPECT_TRUE((found - expected).normal().is_zero());
}

}  // namespace
}  // namespace secular
