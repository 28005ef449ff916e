// Functions of coordinates in equations of motion: their series, the derivations that come of them, and what is
// refused.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "input/input_error.hpp"
#include "perturb/certificate.hpp"
#include "perturb/derivation.hpp"
#include "perturb/function_expansion.hpp"
#include "perturb/ordered_equation.hpp"
#include "textbook_models.hpp"

namespace secular {
namespace {

Model model_of(const std::string& equation, const std::string& resonance) {
  return read_model_text(textbook::one_mode(equation, resonance), "model.toml");
}

std::string free_to(int order, const std::string& orders = {}) {
  return "excitation = false\nordering = \"degree\"\nexpand_to = " + std::to_string(order) +
         (orders.empty() ? "" : "\norder = { " + orders + " }");
}

// At numbers of its own for each symbol: symbols of two models differ.
GiNaC::ex at_numbers(const GiNaC::ex& e, const Model& model) {
  GiNaC::exmap numbers;
  for (const std::string& name : model.symbols.names()) {
    int number = 7;
    for (const char c : name) number = number * 31 % 1009 + c;
    numbers[model.symbols.at(name)] = name == "one" ? GiNaC::numeric(1) : GiNaC::numeric(number, 13);
  }
  return e.subs(numbers);
}

void expect_equal(const FieldSeries& a, const Model& of_a, const FieldSeries& b, const Model& of_b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t n = 0; n < a.size(); ++n) {
    ASSERT_EQ(a[n].terms().size(), b[n].terms().size()) << n;
    for (const auto& [key, value] : a[n].terms()) {
      const auto other = b[n].terms().find(key);
      ASSERT_NE(other, b[n].terms().end()) << n;
      EXPECT_TRUE((at_numbers(value, of_a) - at_numbers(other->second, of_b)).is_zero()) << n << " " << value;
    }
  }
}

void expect_same_derivation(const Model& a, const Model& b) {
  const Derivation first = derive(a, a.cases[0]), second = derive(b, b.cases[0]);
  expect_equal(first.response[0], a, second.response[0], b);
  expect_equal(first.slow_derivative[0], a, second.slow_derivative[0], b);
  EXPECT_TRUE(certify(first).holds);
}

// i times it is the factor of A^(n+1) conj(A)^n in dA/dt, over w.
GiNaC::ex turning(const Derivation& d, int n) {
  FieldKey key(d.layout.size(), 0);
  key[d.layout.amplitude(0)] = n + 1;
  key[d.layout.conjugate(0)] = n;
  const Field rate = d.modulation(0);
  const auto found = rate.terms().find(key);
  return found == rate.terms().end() ? GiNaC::ex(0)
                                     : (found->second / (GiNaC::I * d.model->symbols.at("w"))).normal();
}

// Frequency over w of the oscillation whose largest displacement is q: A = a/2 with q = a + third and fifth
// harmonic.
double frequency_at_peak(const Derivation& d, double q) {
  const double f1 = GiNaC::ex_to<GiNaC::numeric>(turning(d, 1)).to_double() / 4,
               f2 = GiNaC::ex_to<GiNaC::numeric>(turning(d, 2)).to_double() / 16;
  const auto peak = [&](double a) {
    double sum = a;
    for (std::size_t n = 1; n < d.response[0].size(); ++n)
      for (const auto& [key, value] : d.response[0][n].terms())
        sum += GiNaC::ex_to<GiNaC::numeric>(value.evalf()).to_double() *
               std::pow(a / 2, key[d.layout.amplitude(0)] + key[d.layout.conjugate(0)]);
    return sum;
  };
  double a = q;
  for (int i = 0; i < 60; ++i) a -= peak(a) - q;
  return 1 + f1 * a * a + f2 * a * a * a * a;
}

TEST(SmoothFunctions, SeriesAreThoseOfGinac) {
  const GiNaC::symbol z("z");
  const auto expect = [&](SmoothKind kind, std::pair<long, long> exponent, const GiNaC::ex& rest,
                          const GiNaC::ex& function) {
    const GiNaC::exvector c = taylor_coefficients(kind, exponent, rest, 9);
    const GiNaC::ex series = GiNaC::series_to_poly(function.series(z == 0, 10));
    for (int n = 0; n <= 9; ++n)
      EXPECT_TRUE((c.at(static_cast<std::size_t>(n)) - series.coeff(z, n)).normal().is_zero())
          << function << " at power " << n;
  };
  expect(SmoothKind::sine, {1, 1}, 0, sin(z));
  expect(SmoothKind::cosine, {1, 1}, 0, cos(z));
  expect(SmoothKind::tangent, {1, 1}, 0, tan(z));
  expect(SmoothKind::exponential, {1, 1}, 0, exp(z));
  expect(SmoothKind::hyperbolic_sine, {1, 1}, 0, sinh(z));
  expect(SmoothKind::hyperbolic_cosine, {1, 1}, 0, cosh(z));
  expect(SmoothKind::hyperbolic_tangent, {1, 1}, 0, tanh(z));
  expect(SmoothKind::logarithm, {1, 1}, 1, log(1 + z));
  expect(SmoothKind::arc_tangent, {1, 1}, 0, atan(z));
  expect(SmoothKind::power, {1, 2}, 1, sqrt(1 + z));
  expect(SmoothKind::power, {-7, 3}, 1, pow(1 + z, GiNaC::numeric(-7, 3)));
  expect(SmoothKind::power, {-3, 1}, 5, pow(5 + z, -3));
}

TEST(SmoothFunctions, DeriveWhatTheirPolynomialsDo) {
  expect_same_derivation(model_of("D2(x) + w^2*sin(x) = 0", free_to(2)),
                         model_of("D2(x) + w^2*(x - x^3/6) = 0", free_to(2)));
  expect_same_derivation(model_of("D2(x) + w^2*sin(x) = 0", free_to(4)),
                         model_of("D2(x) + w^2*(x - x^3/6 + x^5/120) = 0", free_to(4)));
  expect_same_derivation(model_of("D2(x) + w^2*x/(1 + b*x^2) = -2*mu*D(x)", free_to(4, "mu = 2")),
                         model_of("D2(x) + w^2*(x - b*x^3 + b^2*x^5) = -2*mu*D(x)", free_to(4, "mu = 2")));
  expect_same_derivation(model_of("D2(x) + w^2*x = -c*tanh(D(x)/s)", free_to(4, "c = 2")),
                         model_of("D2(x) + w^2*x = -c*(D(x)/s - D(x)^3/(3*s^3))", free_to(4, "c = 2")));
  expect_same_derivation(model_of("D2(x) + w^2*(exp(x) - 1) = 0", free_to(3)),
                         model_of("D2(x) + w^2*(x + x^2/2 + x^3/6 + x^4/24) = 0", free_to(3)));
  expect_same_derivation(
      model_of("D2(x) + D2(sin(x) - x) + w^2*log(1 + x)*sqrt(1 + x) = -c*x*atan(x + D(x))", free_to(3, "c = 1")),
      model_of("D2(x) + D2(-x^3/6) + w^2*(x - x^2/2 + x^3/3 - x^4/4 + x^2/2 - x^3/4 + x^4/6 - x^3/8 + "
               "x^4/16 + x^4/16) = -c*x*(x + D(x))",
               free_to(3, "c = 1")));
}

// In a case that ends before the denominator's own power of x counts.
TEST(SmoothFunctions, WhatIsBeyondACaseIsStillNoConstant) {
  for (const int order : {1, 2})
    expect_same_derivation(model_of("D2(x) + w^2*x = -g*x^2/(a - x^3)", free_to(order)),
                           model_of("D2(x) + w^2*x = -g*x^2/a", free_to(order)));
}

TEST(SmoothFunctions, AnOrderTableOrdersTheirSeriesByDegree) {
  // `one` is 1 and brings the power of eps that the degree of a function's term does.
  const std::string shared = "relations = [\"Omega = w + eps^2*s\"]\nexpand_to = 3\n";
  expect_same_derivation(model_of("D2(x) + w^2*sin(x) = -2*mu*D(x) - a*x^3 - g*sin(x) + e*F*cos(Omega*t)*cos(x)",
                                  shared + "order = { mu = 2, e = 2, a = 2, g = 1 }"),
                         model_of("D2(x) + w^2*x = one^2*w^2*x^3/6 - 2*mu*D(x) - a*x^3 - g*x + one^2*g*x^3/6 + "
                                  "e*F*cos(Omega*t)*(1 - one*x^2/2)",
                                  shared + "order = { mu = 2, e = 2, a = 2, g = 1, one = 1 }"));
}

TEST(SmoothFunctions, EnergiesMayHoldThem) {
  const Model lagrange = read_model_text(
      "schema = 1\nname = \"m\"\n[lagrangian]\nkinetic = \"cos(x)^2*D(x)^2/2\"\npotential = \"w^2*(1 - cos(x)) + "
      "c*x^3*tan(x)\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\n[[case]]\nname = \"c\"\n" +
          free_to(4) + "\n",
      "m");
  expect_same_derivation(lagrange,
                         model_of("cos(x)^2*D2(x) - cos(x)*sin(x)*D(x)^2 + w^2*sin(x) + c*(3*x^2*tan(x) + "
                                  "x^3*(1 + tan(x)^2)) = 0",
                                  free_to(4)));
}

TEST(SmoothFunctions, ThePendulumHasTheFrequencyOfTheTextbooks) {
  // 1 - q^2/16 + q^4/3072: the fundamental a of x(t) has q = a - a^3/192, so that in a it is 1 - a^2/16 + a^4/1024.
  const Model model = model_of("D2(x) + w^2*sin(x) = 0", free_to(4));
  const Derivation d = derive(model, model.cases[0]);
  EXPECT_EQ(turning(d, 1), GiNaC::numeric(-1, 4));
  EXPECT_EQ(turning(d, 2), GiNaC::numeric(1, 64));
}

// Period of D2(x) + f(x) = 0 from potential V, by Gauss's transform of its quadrature: x = q sin(u).
double frequency_by_quadrature(const std::function<double(double)>& potential, double q) {
  constexpr int points = 60;  // it converges faster than any power
  double period = 0;
  for (int i = 0; i < points; ++i) {
    const double u = (i + 0.5) * std::numbers::pi / 2 / points;
    period += q * std::cos(u) / std::sqrt(2 * (potential(q) - potential(q * std::sin(u))));
  }
  return 2 * std::numbers::pi / (4 * period * std::numbers::pi / 2 / points);
}

TEST(SmoothFunctions, ErrorsFallByThePowerThatIsLeftOut) {
  const struct {
    const char* equation;
    double (*potential)(double);
  } laws[] = {{"D2(x) + w^2*sin(x) = 0", [](double x) { return 1 - std::cos(x); }},
              {"D2(x) + w^2*x/(1 + x^2) = 0", [](double x) { return std::log1p(x * x) / 2; }},
              {"D2(x) + w^2*tanh(x) = 0", [](double x) { return std::log(std::cosh(x)); }},
              {"D2(x) + w^2*x*sqrt(1 + x^2) = 0", [](double x) { return (std::pow(1 + x * x, 1.5) - 1) / 3; }}};
  for (const auto& law : laws)
    for (const int order : {2, 4}) {
      const Model model = model_of(law.equation, free_to(order));
      const Derivation d = derive(model, model.cases[0]);
      const auto error = [&](double q) {
        return std::abs(frequency_at_peak(d, q) - frequency_by_quadrature(law.potential, q));
      };
      const double slope = std::log2(error(0.24) / error(0.12));
      EXPECT_NEAR(slope, order + 2, 0.1) << law.equation << " to eps^" << order;
    }
}

TEST(SmoothFunctions, WhatHasNoSeriesIsRefusedAtItsPlace) {
  const auto complaint = [](const std::string& term) -> std::string {
    try {
      const Model model = model_of("D2(x) + w^2*x = -g*" + term, "order = { g = 1, a = 0 }\nexcitation = false");
      derive(model, model.cases[0]);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  };
  for (const auto& [term, part] : std::initializer_list<std::pair<const char*, const char*>>{
           {"sqrt(x) + a", "line 6, column 20: sqrt is not smooth at the rest position x = 0"},
           {"(x^2)^(1/2) + a", "a power that is no integer is not smooth at the rest position"},
           {"log(x) + a", "column 20: log is not smooth at the rest position"},
           {"a/x", "a denominator is 0 at the rest position x = 0"},
           {"a*x^(-2)", "a negative power is 0 at the rest position"},
           {"sqrt(1 + a*abs(x))", "abs, sgn, max or min in sqrt"},
           {"a*max(0, sin(x))", "nonsmooth function of something else"},
           {"sqrt(a^2 + x^2)", "a*sqrt(1 + (x/a)^2) for sqrt(a^2 + x^2)"},
           {"log(2 + a*x)", "the argument of log is not 1"},
           {"exp(a + x)", "the argument of exp is not 0"},
           {"x*cos(a)", "cos of a constant"},
           {"a*tanh(D2(x))", "an acceleration in tanh"},
           {"a*sin(x - F*cos(Omega*t))", "an excitation in sin"},
           {"a*sin(x + Omega*t)", "sin of the coordinate 'x' and of time"},
           {"(1 + x)^a", "exp(n*log(1 + x)) is the n-th power"},
           {"a*(1 + x)^0.33333333", "a denominator up to 1000"},
           {"(sin(x) - x)*a", "acts nowhere"},
           {"x^2/(1 + a*x^6)", "coefficient 'a' acts nowhere"}})
    EXPECT_NE(complaint(term).find(part), std::string::npos) << term << ": " << complaint(term);
}

TEST(SmoothFunctions, TheLinearPartIsThatOfTheOscillator) {
  const auto complaint = [](const std::string& equation) -> std::string {
    try {
      const Model model = model_of(equation, free_to(2));
      derive(model, model.cases[0]);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  };
  EXPECT_NE(complaint("D2(x) + w^2*x + g*sin(x) = 0").find("is (g + w^2)*x, not w^2*x"), std::string::npos);
  EXPECT_NE(complaint("D2(x) + k*tanh(x) = 0").find("is k*x, not w^2*x"), std::string::npos);
  EXPECT_NE(complaint("D2(x) + w^2*exp(x) = 0").find("moves the rest position away from x = 0"), std::string::npos);
  EXPECT_EQ(complaint("D2(x) + w^2*x + g*(sin(x) - x) = 0"), "no complaint");
  EXPECT_EQ(complaint("D2(x) + k*x + (w^2 - k)*sin(x) = 0"), "no complaint");
}

TEST(SmoothFunctions, ACertificateSeesAWrongSeries) {
  // The pendulum's equation beside the derivation of another law.
  const Model other = model_of("D2(x) + w^2*(x - x^3/5) = 0", free_to(2)),
              pendulum = model_of("D2(x) + w^2*sin(x) = 0", free_to(2));
  Derivation d = derive(other, other.cases[0]);
  GiNaC::exmap names{{other.symbols.at("w"), pendulum.symbols.at("w")}};
  for (auto* list : {&d.response, &d.slow_derivative})
    for (Field& field : (*list)[0]) field = field.with_symbols(names);
  d.model = &pendulum;
  d.resonance = &pendulum.cases[0];
  const Certificate certificate = certify(d);
  EXPECT_FALSE(certificate.holds);
  EXPECT_FALSE(certificate.remainders.empty());
}

TEST(SmoothFunctions, ExpansionsOutOfProportionEndAtOnce) {
  std::string deep = "x";
  for (int i = 0; i < 60; ++i) deep = "sin(" + deep + ")";
  const Model nested = model_of("D2(x) + w^2*" + deep + " = 0", free_to(4));
  EXPECT_TRUE(certify(derive(nested, nested.cases[0])).holds);
  for (int i = 0; i < 200; ++i) deep = "tanh(" + deep + ")";
  EXPECT_THROW(model_of("D2(x) + w^2*" + deep + " = 0", free_to(4)), InputError);
  std::string modes, sum;
  for (int k = 0; k < 30; ++k) sum += (k ? " + q" : "q") + std::to_string(k);
  for (int k = 0; k < 30; ++k)
    modes += "[[mode]]\ncoordinate = \"q" + std::to_string(k) + "\"\nfrequency = \"w" + std::to_string(k) +
             "\"\nequation = \"D2(q" + std::to_string(k) + ") + w" + std::to_string(k) + "^2*q" +
             std::to_string(k) + " = -g*(exp(" + sum + ") - 1)\"\n";
  const Model many =
      read_model_text("schema = 1\nname = \"m\"\n" + modes + "[[case]]\nname = \"c\"\n" + free_to(6, "g = 1"), "m");
  EXPECT_THROW(ordered_equations(many, many.cases[0]), InputError);
}

}  // namespace
}  // namespace secular
