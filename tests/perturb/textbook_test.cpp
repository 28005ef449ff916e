// Published expansions, reproduced as exact symbolic equalities.
#include <gtest/gtest.h>

#include "perturb/certificate.hpp"
#include "perturb/derivation.hpp"
#include "textbook_models.hpp"

namespace secular {
namespace {

using GiNaC::ex;
using GiNaC::I;
using GiNaC::numeric;

struct Derived {
  explicit Derived(const std::string& text)
      : model(read_model_text(text, "textbook")), derivation(derive(model, model.cases[0])) {}
  ex symbol(const std::string& name) const { return model.symbols.at(name); }
  /// Coefficient of A^a conj(A)^b |A|^m F^f in dA/dt of the first mode.
  ex modulation(int a, int b, int m = 0, int f = 0) const {
    const Field field = derivation.modulation(0);
    ex sum = 0;
    for (const auto& [key, coefficient] : field.terms()) {
      const FieldLayout& layout = derivation.layout;
      const int forcing = layout.excitations ? key[layout.forcing(0)] : 0;
      if (key[layout.amplitude(0)] == a && key[layout.conjugate(0)] == b && key[layout.modulus(0)] == m &&
          forcing == f)
        sum += coefficient;
    }
    return sum;
  }
  Model model;
  Derivation derivation;
};

void expect_equal(const ex& left, const ex& right) {
  EXPECT_TRUE((left - right).normal().is_zero()) << left << "\n" << right;
}

TEST(Textbook, DuffingFrequencyToSecondOrder) {
  // omega = w + 3 g X^2/(8 w) - 21 g^2 X^4/(256 w^3) in peak amplitude X of the fundamental... with A = X1/2 the
  // whole fundamental: the second-order coefficient is -15/16 g^2/w^3 * A^3 conj(A)^2 (Nayfeh and Mook, gauge of
  // this project).
  const Derived d(textbook::one_mode("D2(x) + w^2*x = -g*x^3", "order = { g = 1 }\nexcitation = false"));
  const ex w = d.symbol("w"), g = d.symbol("g");
  expect_equal(d.modulation(2, 1), I * 3 * g / (2 * w));
  expect_equal(d.modulation(3, 2), -I * numeric(15, 16) * g * g / GiNaC::pow(w, 3));
}

TEST(Textbook, DuffingFrequencyInPeakAmplitude) {
  // The printed -21/256 is for the peak displacement X = a (1 + g a^2/(32 w^2)), a = 2|A|: eliminate a.
  const Derived d(textbook::one_mode("D2(x) + w^2*x = -g*x^3", "order = { g = 1 }\nexcitation = false"));
  const ex w = d.symbol("w"), g = d.symbol("g");
  const GiNaC::symbol peak("X");
  const ex first = d.modulation(2, 1) / I / 4, second = d.modulation(3, 2) / I / 16;  // of a^2 and a^4
  // Third harmonic of half-amplitude g A^3/(8 w^2): cosine amplitude g a^3/(32 w^2), so a = X - g X^3/(32 w^2) +
  // ...
  const ex third = d.derivation.response[0][1].terms().rbegin()->second;
  expect_equal(third, g / (8 * w * w));
  const ex in_peak = second - 2 * first * third / 4;
  expect_equal(first, 3 * g / (8 * w));
  expect_equal(in_peak, -numeric(21, 256) * g * g / GiNaC::pow(w, 3));
}

TEST(Textbook, QuadraticAndCubicStiffnessBackbone) {
  // omega = w + (9 a3 w^2 - 10 a2^2)/(24 w^3) a^2 (Nayfeh and Mook, Eq. (2.3.35)).
  const Derived d(
      textbook::one_mode("D2(x) + w^2*x = -a2*x^2 - a3*x^3", "order = { a2 = 1, a3 = 2 }\nexcitation = false"));
  const ex w = d.symbol("w"), a2 = d.symbol("a2"), a3 = d.symbol("a3");
  expect_equal(d.modulation(2, 1) / I / 4, (9 * a3 * w * w - 10 * a2 * a2) / (24 * GiNaC::pow(w, 3)));
}

TEST(Textbook, VanDerPolFrequencyAndLimitCycle) {
  // x'' + x = eps (1 - x^2) x': limit cycle a = 2, omega = 1 - eps^2/16.
  const Derived d(textbook::one_mode("D2(x) + w^2*x = e*(1 - x^2)*D(x)", "order = { e = 1 }\nexcitation = false"));
  const ex e = d.symbol("e");
  ex rate = 0;
  const Field field = d.derivation.modulation(0);
  for (const auto& [key, coefficient] : field.terms()) rate += coefficient;  // A = conj(A) = 1, that is a = 2
  expect_equal(rate.subs(d.symbol("w") == 1), -I * e * e / 16);
}

TEST(Textbook, InertiaNonlinearityBackbone) {
  // x'' + w^2 x + g x^3 + k (x^2 x'' + x x'^2) = 0: omega = w + a^2 (3 g/(8 w) - k w/4).
  const Derived d(textbook::one_mode("D2(x) + w^2*x = -g*x^3 - k*(x^2*D2(x) + x*D(x)^2)",
                                     "order = { g = 1, k = 1 }\nexpand_to = 1\nexcitation = false"));
  const ex w = d.symbol("w"), g = d.symbol("g"), k = d.symbol("k");
  expect_equal(d.modulation(2, 1) / I / 4, 3 * g / (8 * w) - k * w / 4);
}

TEST(Textbook, DragAndDryFriction) {
  // a' = -mu1 a - 4 w mu2 a^2/(3 pi) - 2 fc/(pi w) (Nayfeh and Mook, section 3.3).
  const Derived d(textbook::one_mode("D2(x) + w^2*x = -2*mu1*D(x) - mu2*abs(D(x))*D(x) - fc*sgn(D(x))",
                                     "order = { mu1 = 1, mu2 = 1, fc = 1 }\nexpand_to = 1\nexcitation = false"));
  const ex w = d.symbol("w");
  expect_equal(d.modulation(1, 0), -d.symbol("mu1"));
  // da/dt = 2 Re(dA/dt) with A = a/2: c A|A| gives c a^2/2, c A/|A| gives 2 c.
  expect_equal(d.modulation(1, 0, 1) / 2, -4 * w * d.symbol("mu2") / (3 * GiNaC::Pi));
  expect_equal(2 * d.modulation(1, 0, -1), -2 * d.symbol("fc") / (GiNaC::Pi * w));
}

TEST(Textbook, MathieuPrincipalParametricThreshold) {
  // x'' + w^2 x = -2 m x' + p F x cos(Omega t), Omega = 2 w + eps s: dA/dt = -m A - i p F conj(A) exp(i s t)/(4 w).
  const Derived d(
      textbook::one_mode("D2(x) + w^2*x = -2*m*D(x) + p*x*F*cos(Omega*t)",
                         "order = { m = 1, p = 1 }\nexpand_to = 1\nrelations = [\"Omega = 2*w + eps*s\"]"));
  expect_equal(d.modulation(0, 1, 0, 1), -I * d.symbol("p") / (4 * d.symbol("w")));
}

TEST(Textbook, HardForcingShiftsTheFrequency) {
  // x'' + w^2 x + g x^3 = F cos(w t/3), F at order 0: v0 holds 2 Lambda cos with Lambda = F/(2 (w^2 - w^2/9)), and
  // the frequency shifts by 3 g Lambda^2/w = 243 F^2 g/(256 w^5).
  const Derived d(
      textbook::one_mode("D2(x) + w^2*x = -g*x^3 + h*F*cos(Omega*t)",
                         "order = { g = 1, h = 0 }\nexpand_to = 1\nrelations = [\"3*Omega = w + eps*s\"]"));
  const ex w = d.symbol("w"), g = d.symbol("g"), h = d.symbol("h");
  expect_equal(d.modulation(1, 0, 0, 2), I * 243 * g * h * h / (256 * GiNaC::pow(w, 5)));
}

TEST(Textbook, TwoToOneInternalResonanceWithSlowRatesOfEveryMode) {
  // x'' + w^2 x + eps g x y = 0, y'' + 4 w^2 y + eps g x^2 = 0. With frequencies w and u = 2 w exactly.
  const Model model = read_model_text(R"(schema = 1
name = "two"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -g*x*y"
[[mode]]
coordinate = "y"
frequency = "u"
equation = "D2(y) + u^2*y = -g*x^2"
[[case]]
name = "internal"
relations = ["u = 2*w"]
order = { g = 1 }
excitation = false
)",
                                      "two");
  const Derivation d = derive(model, model.cases[0]);
  const ex w = model.symbols.at("w"), u = model.symbols.at("u"), g = model.symbols.at("g");
  const FieldLayout& layout = d.layout;
  const auto coefficient = [&](std::size_t mode, std::size_t order, int a0, int c0, int a1, int c1) {
    ex sum = 0;
    for (const auto& [key, value] : d.slow_derivative[mode][order].terms())
      if (key[layout.amplitude(0)] == a0 && key[layout.conjugate(0)] == c0 && key[layout.amplitude(1)] == a1 &&
          key[layout.conjugate(1)] == c1)
        sum += value;
    return ex(sum.subs(u == 2 * w));
  };
  const ex w3 = GiNaC::pow(w, 3);
  expect_equal(coefficient(0, 1, 0, 1, 1, 0), I * g / (2 * w));
  expect_equal(coefficient(1, 1, 2, 0, 0, 0), I * g / (4 * w));
  expect_equal(coefficient(0, 2, 1, 0, 1, 1), 3 * I * g * g / (16 * w3));
  expect_equal(coefficient(0, 2, 2, 1, 0, 0), -5 * I * g * g / (16 * w3));
  for (const auto& [key, value] : d.slow_derivative[1][2].terms()) expect_equal(value.subs(u == 2 * w), 0);
  EXPECT_TRUE(certify(d).holds);
}

TEST(Textbook, GyroscopicCouplingAtFirstOrder) {
  // x'' + w1^2 x = g y', y'' + w2^2 y = -g x': (w1^2 - l^2)(w2^2 - l^2) = g^2 l^2, so
  // l1 = w1 + g^2 w1/(2 (w1^2 - w2^2)) + O(g^4), and l2 with the modes exchanged.
  const Model model = read_model_text(R"model(schema = 1
name = "rotor"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = "D2(x) + w1^2*x = g*D(y)"
[[mode]]
coordinate = "y"
frequency = "w2"
equation = "D2(y) + w2^2*y = -g*D(x)"
[[case]]
name = "free"
order = { g = 1 }
expand_to = 3
)model",
                                      "rotor");
  const Derivation d = derive(model, model.cases[0]);
  const ex w1 = model.symbols.at("w1"), w2 = model.symbols.at("w2"), g = model.symbols.at("g");
  const auto shift = [&](std::size_t mode) {
    ex sum = 0;
    const Field field = d.modulation(mode);
    for (const auto& [key, value] : field.terms()) sum += value;
    return sum / I;
  };
  expect_equal(shift(0), g * g * w1 / (2 * (w1 * w1 - w2 * w2)));
  expect_equal(shift(1), g * g * w2 / (2 * (w2 * w2 - w1 * w1)));
  EXPECT_TRUE(certify(d).holds);
}

TEST(Textbook, TwoExcitationsCombine) {
  // x'' + w^2 x = -a x^2 + e (F cos(Omega t) + F2 cos(Omega2 t)) with hard excitation and Omega2 - Omega near w:
  // the product of both forced motions drives the mode, dA/dt = i a L1 L2/w exp(i s t), L = e F/(2 (w^2 -
  // Omega^2)).
  const Model model = read_model_text(R"model(schema = 1
name = "two"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -a*x^2 + e*F*cos(Omega*t) + e*F2*cos(Omega2*t)"
[[case]]
name = "difference"
relations = ["Omega2 = Omega + w + eps*s"]
order = { a = 1, e = 0 }
expand_to = 1
)model",
                                      "two");
  for (const OmegaPolicy policy : {OmegaPolicy::nominal, OmegaPolicy::kept}) {
    const Derivation d = derive(model, model.cases[0], policy);
    EXPECT_TRUE(certify(d).holds);
    const ex w = model.symbols.at("w"), a = model.symbols.at("a"), e = model.symbols.at("e"),
             first = model.symbols.at("Omega"), second = model.symbols.at("Omega2");
    const ex half1 = e / (2 * (w * w - first * first)), half2 = e / (2 * (w * w - second * second));
    const Field field = d.modulation(0);
    ex sum = 0;
    for (const auto& [key, value] : field.terms())
      if (key[d.layout.forcing(0)] == 1 && key[d.layout.forcing(1)] == 1) sum += value;
    const GiNaC::exmap resonant = {{second, first + w}};
    expect_equal(ex(sum.subs(resonant)), ex((I * a * half1 * half2 / w).subs(resonant)));
  }
}

TEST(Textbook, AdditiveCombinationThreshold) {
  // x'' + c1 x' + w1^2 x = p y F cos(Omega t), y'' + c2 y' + w2^2 y = q x F cos(Omega t), Omega = w1 + w2 + sigma:
  // the trivial solution loses stability where p q F^2 = 4 w1 w2 c1 c2 (1 + 4 sigma^2/(c1 + c2)^2).
  const Model model = read_model_text(R"model(schema = 1
name = "pair"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = "D2(x) + w1^2*x = -c1*D(x) + p*y*F*cos(Omega*t)"
[[mode]]
coordinate = "y"
frequency = "w2"
equation = "D2(y) + w2^2*y = -c2*D(y) + q*x*F*cos(Omega*t)"
[[case]]
name = "additive"
relations = ["Omega = w1 + w2 + eps*sigma"]
order = { c1 = 1, c2 = 1, p = 1, q = 1 }
expand_to = 1
)model",
                                      "pair");
  const Derivation d = derive(model, model.cases[0]);
  const auto symbol = [&](const char* name) { return model.symbols.at(name); };
  const auto coefficient = [&](std::size_t mode, std::size_t place) {
    const Field field = d.modulation(mode);
    ex sum = 0;
    for (const auto& [key, value] : field.terms())
      if (key[place] == 1) sum += value;
    return sum;
  };
  // A1 = B1 exp(i nu t), conj(A2) = conj(B2) exp(i (nu - sigma) t): on the threshold nu is real.
  const ex d1 = coefficient(0, d.layout.amplitude(0)), d2 = coefficient(1, d.layout.amplitude(1));
  const ex q1 = coefficient(0, d.layout.conjugate(1)), q2 = coefficient(1, d.layout.conjugate(0)) * -1;
  expect_equal(d1, -symbol("c1") / 2);
  expect_equal(d2, -symbol("c2") / 2);
  // (i nu + c1/2)(i (nu - sigma) + c2/2) = q1 conj(q2) F^2: imaginary part gives nu = sigma c1/(c1 + c2).
  const ex c1 = symbol("c1"), c2 = symbol("c2"), sigma = symbol("sigma");
  const ex nu = sigma * c1 / (c1 + c2);
  const ex left = (I * nu + c1 / 2) * (I * (nu - sigma) + c2 / 2);
  const ex product = q1 * q2;  // conj(q2) of the second equation: q is imaginary
  const ex force = left.expand() / product;
  expect_equal(force * symbol("p") * symbol("q"),
               4 * symbol("w1") * symbol("w2") * c1 * c2 * (1 + 4 * sigma * sigma / GiNaC::pow(c1 + c2, 2)));
}

}  // namespace
}  // namespace secular
