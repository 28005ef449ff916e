#include <gtest/gtest.h>

#include "input/input_error.hpp"
#include "perturb/certificate.hpp"
#include "perturb/derivation.hpp"

namespace secular {
namespace {

Model oscillator(const std::string& right, const std::string& order, int expand_to, const std::string& more = {}) {
  return read_model_text(
      "schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"v\"\nfrequency = \"w\"\nequation = \"D2(v) + "
      "w^2*v = " +
          right + "\"\n[[case]]\nname = \"c\"\nexpand_to = " + std::to_string(expand_to) + "\norder = { " + order +
          " }\n" + more,
      "m");
}

// The coefficient of A^powers in dA/dt.
GiNaC::ex coefficient(const Derivation& d, int amplitude, int conjugate, int modulus) {
  const Field modulation = d.modulation(0);
  for (const auto& [key, value] : modulation.terms())
    if (key[d.layout.amplitude(0)] == amplitude && key[d.layout.conjugate(0)] == conjugate &&
        key[d.layout.modulus(0)] == modulus)
      return value;
  return 0;
}

bool equal(const GiNaC::ex& a, const GiNaC::ex& b) {
  return (a - b).normal().is_zero();
}

// A spring that acts on one side only has half its stiffness on average: the frequency rises by kb/(4 w).
TEST(Nonsmooth, OneSidedSpringHasHalfItsStiffness) {
  const Model m = oscillator("-kb*max(v, 0)", "kb = 1", 1);
  const Derivation d = derive(m, m.cases[0]);
  EXPECT_TRUE(equal(coefficient(d, 1, 0, 0), GiNaC::I * m.symbols.at("kb") / (4 * m.symbols.at("w"))));
  EXPECT_TRUE(certify(d).holds);
  // max(v, 0) + min(v, 0) = v
  const Model least = oscillator("-kb*(max(v, 0) + min(v, 0))", "kb = 1", 1);
  const Derivation linear = derive(least, least.cases[0]);
  EXPECT_TRUE(equal(coefficient(linear, 1, 0, 0), GiNaC::I * least.symbols.at("kb") / (2 * least.symbols.at("w"))));
}

// |v| v: first harmonic 8/(3 pi) of the squared peak amplitude a = 2|A|: frequency shift 4 c a/(3 pi w).
TEST(Nonsmooth, QuadraticSpring) {
  const Model m = oscillator("-c*abs(v)*v", "c = 1", 1);
  const Derivation d = derive(m, m.cases[0]);
  EXPECT_TRUE(
      equal(coefficient(d, 1, 0, 1), 8 * GiNaC::I * m.symbols.at("c") / (3 * GiNaC::Pi * m.symbols.at("w"))));
  EXPECT_TRUE(certify(d).holds);
}

// Dry friction takes 2 fc/(pi w) of amplitude in unit time.
TEST(Nonsmooth, DryFriction) {
  const Model m = oscillator("-fc*sgn(D(v))", "fc = 1", 1);
  const Derivation d = derive(m, m.cases[0]);
  EXPECT_TRUE(equal(coefficient(d, 1, 0, -1), -m.symbols.at("fc") / (GiNaC::Pi * m.symbols.at("w"))));
  EXPECT_TRUE(certify(d).holds);
}

// Drag at eps^2 in an expansion to eps^3 feels the quadratic spring's harmonics through sgn(v0') v1'.
TEST(Nonsmooth, DragIsCorrectedOneOrderUp) {
  const Model m = oscillator("-a2*v^2 - mu2*abs(D(v))*D(v)", "a2 = 1, mu2 = 2", 3);
  const Derivation d = derive(m, m.cases[0]);
  const Certificate certificate = certify(d);
  EXPECT_TRUE(certificate.holds);
  EXPECT_LT(certificate.nonsmooth_error, 1e-12);
  Derivation wrong = d;
  const FieldKey key = wrong.response[0][3].terms().begin()->first;
  wrong.response[0][3].add(key, wrong.response[0][3].terms().at(key));
  EXPECT_FALSE(certify(wrong).holds);
}

// A dead band and several harmonics go to a stated quadrature, with nothing of them in the closed form.
TEST(Nonsmooth, NoClosedFormGoesToQuadrature) {
  const Model gap = oscillator("-k*(max(v - gap, 0) - max(-v - gap, 0))", "k = 1, gap = 0", 1);
  const Derivation d = derive(gap, gap.cases[0]);
  ASSERT_EQ(d.quadratures.size(), 2U);
  EXPECT_EQ(d.quadratures[0].order, 1);
  EXPECT_TRUE(certify(d).holds);
  const Model hard = oscillator("-fc*sgn(D(v)) + e*F*cos(Omega*t)", "fc = 1, e = 0", 1);
  const Derivation forced = derive(hard, hard.cases[0]);
  EXPECT_EQ(forced.quadratures.size(), 1U);
  EXPECT_TRUE(forced.modulation(0).empty());
  EXPECT_TRUE(certify(forced).holds);
}

// Relative drag between a moving and a resting mode is a quadrature term too, though only one of them moves.
TEST(Nonsmooth, RelativeDragWithAModeAtRest) {
  const Model m = read_model_text(
      "schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = \"D2(x) + w^2*x = "
      "-c*abs(D(x) - D(y))*(D(x) - D(y))\"\n[[mode]]\ncoordinate = \"y\"\nfrequency = \"u\"\nequation = \"D2(y) + "
      "u^2*y = "
      "0\"\n[[case]]\nname = \"c\"\nexpand_to = 1\norder = { c = 1 }\nmodes_at_rest = [\"y\"]\n",
      "m");
  const Derivation d = derive(m, m.cases[0]);
  EXPECT_EQ(d.quadratures.size(), 2U);
  EXPECT_TRUE(certify(d).holds);
}

TEST(Nonsmooth, RefusesWhatWouldNeedInfinitelyManyHarmonics) {
  for (const auto& [right, order, expand_to] :
       {std::tuple<const char*, const char*, int>("-kb*max(v, 0)", "kb = 1", 2),
        {"-fc*sgn(D(v))", "fc = 2", 3},
        {"-c*abs(v)*abs(D(v))", "c = 1", 1},
        {"-k*max(v - gap, 0)", "k = 1, gap = 0", 2},
        {"-k*abs(v^2)", "k = 1", 1},
        {"-k*abs(gap)", "k = 1, gap = 0", 1},
        {"-k*max(v)", "k = 1", 1}}) {
    EXPECT_THROW(
        {
          const Model m = oscillator(right, order, expand_to);
          derive(m, m.cases[0]);
        },
        InputError)
        << right;
  }
}

}  // namespace
}  // namespace secular
