// Models about their rest position: where that is, what is derived there, and what is refused.
#include "perturb/rest_position.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <string>
#include <utility>

#include "input/input_error.hpp"
#include "perturb/certificate.hpp"
#include "perturb/derivation.hpp"

namespace secular {
namespace {

// One mode; `rest` stands at the head, `below` behind the equation.
std::string resting(const std::string& equation, const std::string& nominal, int order = 2,
                    const std::string& rest = "reference = \"rest\"", const std::string& below = {}) {
  return "schema = 1\nname = \"m\"\n" + rest + "\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = \"" +
         equation + "\"\n" + below +
         "\n[[case]]\nname = \"c\"\nexcitation = false\nexpand_to = " + std::to_string(order) + "\n[nominal]\n" +
         nominal;
}

Model resting_model(const std::string& equation, const std::string& nominal, int order = 2) {
  return read_model_text(resting(equation, nominal, order), "m.toml");
}

double number_of_term(const GiNaC::ex& e, const Model& model) {
  std::map<std::string, double> values = model.nominal;
  add_values_at_rest(model, values);
  GiNaC::exmap numbers;
  for (const auto& [name, value] : values)
    if (model.symbols.contains(name)) numbers[model.symbols.at(name)] = GiNaC::numeric(value);
  return GiNaC::ex_to<GiNaC::numeric>(e.subs(numbers).evalf()).to_double();
}

// Frequency of the oscillation whose largest displacement from rest is q.
double frequency_at_largest(const Derivation& d, double q) {
  const auto power = [&](const FieldKey& key) { return key[d.layout.amplitude(0)] + key[d.layout.conjugate(0)]; };
  std::map<int, double> displacement, rate;
  for (const Field& field : d.response[0])
    for (const auto& [key, value] : field.terms()) displacement[power(key)] += number_of_term(value, *d.model);
  const Field modulation = d.modulation(0);
  for (const auto& [key, value] : modulation.terms())
    rate[power(key) - 1] += number_of_term(value / GiNaC::I, *d.model);
  const auto at = [](const std::map<int, double>& series, double half) {
    double sum = 0;
    for (const auto& [n, value] : series) sum += value * std::pow(half, n);
    return sum;
  };
  double half = q / 2;
  for (int i = 0; i < 200; ++i) half -= (at(displacement, half) - q) / 2;
  return d.model->nominal.at("w") + at(rate, half);
}

// Of D2(x) + V'(x) = 0 between x and the other end of its motion, by Gauss's transform of the period's quadrature.
double frequency_of_potential(const std::function<double(double)>& potential, double rest, double q) {
  double high = rest + q, inner = rest, outer = rest - 2 * q;
  for (int i = 0; i < 200; ++i) {
    const double middle = (inner + outer) / 2;
    (potential(middle) < potential(high) ? inner : outer) = middle;
  }
  constexpr int points = 80;  // it converges faster than any power
  const double centre = (high + inner) / 2, half = (high - inner) / 2;
  double period = 0;
  for (int i = 0; i < points; ++i) {
    const double u = std::numbers::pi * ((i + 0.5) / points - 0.5);
    period += half * std::cos(u) / std::sqrt(2 * (potential(high) - potential(centre + half * std::sin(u))));
  }
  return 2 * std::numbers::pi / (2 * period * std::numbers::pi / points);
}

TEST(RestPosition, ThePendulumUnderTorqueHasItsClosedForm) {
  const Model model = resting_model("D2(x) + k*sin(x) = torque", "k = 9.81\ntorque = 5");
  const double rest = std::asin(5 / 9.81);
  EXPECT_NEAR(model.nominal.at("x_rest"), rest, 1e-14);
  EXPECT_NEAR(model.nominal.at("w"), std::sqrt(9.81 * std::cos(rest)), 1e-13);
  EXPECT_EQ(model.nominal.count("torque"), 0U);
  // D2(u) + w^2*(sin(u) + tan(x_rest)*(cos(u) - 1)) = 0 turns by -w*(1/4 + 5/12*tan(x_rest)^2)*|A|^2.
  const Derivation d = derive(model, model.cases[0]);
  EXPECT_TRUE(certify(d).holds);
  FieldKey key(d.layout.size(), 0);
  key[d.layout.amplitude(0)] = 2;
  key[d.layout.conjugate(0)] = 1;
  const Field rate = d.modulation(0);
  const double w = model.nominal.at("w"), tangent = std::tan(rest);
  EXPECT_NEAR(number_of_term(rate.terms().at(key) / GiNaC::I, model), -w * (0.25 + 5.0 / 12 * tangent * tangent),
              1e-12);
}

TEST(RestPosition, ErrorsFallByThePowerThatIsLeftOut) {
  const struct {
    const char *equation, *nominal;
    double (*potential)(double);
  } laws[] = {
      {"D2(x) + k*x + a3*x^3 = g", "k = 1\na3 = 2\ng = 0.5",
       [](double x) { return x * x / 2 + x * x * x * x / 2 - x / 2; }},
      {"D2(x) + k*x - c*x^2 + a3*x^3 = 0.98", "k = 4\nc = 1\na3 = 0.5",
       [](double x) { return 2 * x * x - x * x * x / 3 + x * x * x * x / 8 - 0.98 * x; }},
      {"D2(x) + k*sin(x) = g", "k = 2\ng = 1", [](double x) { return -2 * std::cos(x) - x; }},
      {"D2(x) + k*x - b/(1 - x)^2 = g", "k = 3\nb = 0.2\ng = 0.1",
       [](double x) { return 1.5 * x * x - 0.2 / (1 - x) - 0.1 * x; }},
      {"D2(x) + k*x + h*(exp(x/d) - 1) - sqrt(2 + x) = g", "k = 1\nh = 0.5\nd = 2\ng = 0",
       [](double x) { return x * x / 2 + std::exp(x / 2) - x / 2 - 2.0 / 3 * std::pow(2 + x, 1.5); }},
      {"D2(x) + k*tanh(x) + log(1 + x) = g", "k = 2\ng = 1",
       [](double x) { return 2 * std::log(std::cosh(x)) + (1 + x) * std::log1p(x) - 2 * x; }},
      // A mass that depends on the position divides its equation; at small x0 the potential is that of time scaled.
      {"2*D2(x) + 2*k*x + 2*a3*x^3 = g", "k = 1\na3 = 2\ng = 1",
       [](double x) { return x * x / 2 + x * x * x * x / 2 - x / 2; }}};
  for (const auto& law : laws)
    for (const int order : {2, 4}) {
      const Model model = resting_model(law.equation, law.nominal, order);
      const Derivation d = derive(model, model.cases[0]);
      EXPECT_TRUE(certify(d).holds) << law.equation;
      const double rest = model.nominal.at("x_rest");
      const auto error = [&](double q) {
        return std::abs(frequency_at_largest(d, q) - frequency_of_potential(law.potential, rest, q));
      };
      double q = 0.02;  // from where errors are above rounding, and powers beyond still small
      while (error(q) < 1e-9 * model.nominal.at("w")) q *= 1.25;
      const double slope = std::log2(error(2 * q) / error(q));
      EXPECT_GT(slope, order + 1.6) << law.equation << " to eps^" << order;
      EXPECT_LT(slope, order + 2.4) << law.equation << " to eps^" << order;
    }
}

TEST(RestPosition, ACoordinateThatNothingMovesStaysAtZero) {
  const Model cable = read_model_text(
      "schema = 1\nname = \"cable\"\nreference = \"rest\"\n"
      "[[mode]]\ncoordinate = \"y\"\nfrequency = \"w1\"\nequation = \"D2(y) + k1*y + c*y*(y^2 + z^2) = g\"\n"
      "[[mode]]\ncoordinate = \"z\"\nfrequency = \"w2\"\nequation = \"D2(z) + k2*z + c*z*(y^2 + z^2) = 0\"\n"
      "[[case]]\nname = \"two_to_one\"\nrelations = [\"w1 = 2*w2 + eps*sigma\"]\nexcitation = false\nexpand_to = "
      "2\n"
      "[nominal]\nk1 = 100\nk2 = 30\nc = 20\ng = 80\n",
      "cable.toml");
  ASSERT_EQ(cable.rest->symbols, (std::vector<std::string>{"y_rest", ""}));
  EXPECT_TRUE(certify(derive(cable, cable.cases[0])).holds);
  const double y = cable.nominal.at("y_rest");
  EXPECT_NEAR(100 * y + 20 * y * y * y, 80, 1e-11);
  EXPECT_NEAR(cable.nominal.at("w1"), std::sqrt(100 + 60 * y * y), 1e-12);
  EXPECT_NEAR(cable.nominal.at("w2"), std::sqrt(30 + 20 * y * y), 1e-12);
}

TEST(RestPosition, AnEnergyRestsWhereItsEquationDoes) {
  const std::string head = "schema = 1\nname = \"m\"\nreference = \"rest\"\n",
                    tail = "[[case]]\nname = \"c\"\nexcitation = false\n[nominal]\nk = 2\ng = 1\nm = 0.3\n";
  const Model energy = read_model_text(head +
                                           "[lagrangian]\nkinetic = \"D(x)^2*(1 + m*x)/2\"\npotential = "
                                           "\"-k*cos(x) - g*x\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = "
                                           "\"w\"\n" +
                                           tail,
                                       "m"),
              written = read_model_text(head +
                                            "[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = "
                                            "\"(1 + m*x)*D2(x) + m*D(x)^2/2 + k*sin(x) = g\"\n" +
                                            tail,
                                        "m");
  const double rest = std::asin(0.5);
  for (const Model* model : {&energy, &written}) {
    EXPECT_NEAR(model->nominal.at("x_rest"), rest, 1e-14);
    EXPECT_NEAR(model->nominal.at("w"), std::sqrt(2 * std::cos(rest) / (1 + 0.3 * rest)), 1e-14);
  }
  const Derivation a = derive(energy, energy.cases[0]), b = derive(written, written.cases[0]);
  EXPECT_TRUE(certify(a).holds && certify(b).holds);
  EXPECT_NEAR(frequency_at_largest(a, 0.1), frequency_at_largest(b, 0.1), 1e-14);
}

TEST(RestPosition, LoadsComeBackFromWhereTheyHold) {
  for (const char* equation : {"D2(x) + k*x + a3*x^3 = g", "D2(x) + k*sin(x) + a3*x^3 = g*cos(x)"}) {
    const Model model = resting_model(equation, "k = 1.5\na3 = 2\ng = 0.5");
    std::map<std::string, double> back;
    for (const FollowingCoefficient& c : following_coefficients(model, model.nominal)) {
      back[c.name] = c.value;
      for (const auto& [name, slope] : c.slopes) {  // by differences
        std::map<std::string, double> moved = model.nominal;
        const double step = 1e-5;
        double sides[2] = {};
        for (const int side : {0, 1}) {
          moved[name] = model.nominal.at(name) + (side ? step : -step);
          for (const FollowingCoefficient& other : following_coefficients(model, moved))
            if (other.name == c.name) sides[side] = other.value;
        }
        EXPECT_NEAR(slope, (sides[1] - sides[0]) / (2 * step), 1e-7 * (1 + std::abs(slope)))
            << c.name << " by " << name;
      }
    }
    EXPECT_EQ(back.size(), 2U);
    for (const auto& [name, value] : back) EXPECT_NEAR(value, name == "k" ? 1.5 : name == "g" ? 0.5 : 2, 1e-12);
  }
}

TEST(RestPosition, OfSeveralItIsTheOneAskedFor) {
  // -x + x^3 = g rests at three positions; none of the stable ones is reached from zero.
  const auto rest_of = [](const std::string& start) {
    const Model model =
        read_model_text(resting("D2(x) - k*x + a3*x^3 = g", "k = 1\na3 = 1\ng = 0.1\n" + start), "m");
    return model.nominal.at("x_rest");
  };
  EXPECT_NEAR(rest_of("x_rest = 1"), 1.04668, 1e-5);
  EXPECT_NEAR(rest_of("x_rest = -1"), -0.94565, 1e-5);
  const Model buckled = read_model_text(
      resting("D2(x) - k*x + a3*x^3 = 0", "k = 1\na3 = 4\nx0 = 0.6", 2, "reference = \"rest\"", "rest = \"x0\""),
      "m");
  EXPECT_NEAR(buckled.nominal.at("x0"), 0.5, 1e-14);
  EXPECT_NEAR(buckled.nominal.at("w"), std::numbers::sqrt2, 1e-14);
}

// -x + x^3 = g is stable outside 1/sqrt(3) and has its fold at |g| = 2/(3*sqrt(3)), 0.3849.
TEST(RestPosition, ANumberLeadsToNoOtherWell) {
  for (const double g : {-0.5, -0.39, -0.38, 0.2, 0.39})
    for (const double start : {-3.0, -0.6, 0.5, 0.6, 1.5}) {
      std::map<std::string, double> values = {{"k", 1}, {"a3", 1}, {"g", g}, {"x_rest", start}};
      const bool is_there = std::abs(start) > 1 / std::numbers::sqrt3 && (start * g > 0 || std::abs(g) < 0.3849);
      const Model model = resting_model("D2(x) - k*x + a3*x^3 = g", "");
      try {
        const std::string said = take_rest_position(model, values, "values");
        EXPECT_TRUE(is_there) << g << " " << start;
        const double x = values.at("x_rest");
        EXPECT_NEAR(x * x * x - x, g, 1e-13);
        EXPECT_GT(x * start, 0);
        EXPECT_NE(said.find("rests at x_rest = "), std::string::npos) << said;
      } catch (const InputError& error) {
        EXPECT_FALSE(is_there) << error.what();
        EXPECT_NE(std::string(error.what()).find("no rest position is found near"), std::string::npos);
        if (std::abs(g) > 0.3849) {
          EXPECT_NE(error.wrong().find(g > 0 ? "it rests at x_rest = 1.1" : "it rests at x_rest = -1.1"),
                    std::string::npos)
              << error.what();
        }
      }
    }
}

TEST(RestPosition, WhatIsWrongIsSaidWithNumbers) {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      const Model model = read_model_text(text, "m.toml");
      derive(model, model.cases[0]);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  };
  const std::string soft = "D2(x) + k*x - a3*x^3 = g";
  for (const auto& [text, part] : std::initializer_list<std::pair<std::string, const char*>>{
           {resting("D2(x) + w^2*x = g", "", 2, "", "[[case]]\nname = \"d\"\norder = { g = 0 }"),
            "write reference = \"rest\" at the head of the model file"},
           {resting("D2(x) + k*x = 0", ""), "no constant force moves a coordinate away from zero"},
           {resting("D2(x) + w^2*x + a3*x^3 = g", ""), "frequency w of 'x' stands in its equation"},
           {resting("D2(x) + k*x + x_rest*x^3 = g", ""), "the name x_rest of the rest position of 'x' is taken"},
           {resting(soft, "k = 1\na3 = 1\ng = 0.5"), "the load is held up to 0.7698 of it, at x_rest = 0.577"},
           {resting(soft, "k = 1\na3 = 1\ng = 0.1\nx_rest = 0.9"),
            "near x_rest = 0.9: the model is not stable there; it rests at x_rest = 0.101"},
           {resting("D2(x) - k*x + a3*x^3 = g", "k = 1\na3 = 1\ng = 0.1"), "is not stable"},
           {resting("D2(x) + k*log(1 + x) = g", "k = 1\ng = 1\nx_rest = -3"),
            "no rest position is found near x_rest = -3"},
           {resting("D2(x) + k*x - b/x^2 = g", "k = 1\nb = 1\ng = 1"),
            "forces have no value where coordinates are zero"},
           {resting("D2(x) + k*x + a3*x^3 = g", "k = 1\ng = 1"), "gives g, k without a3"},
           {resting("D2(x) + k*x + a3*x^3 = g", "k = 1"), "gives k without g, a3"},
           {resting("D2(x) + k*x + a3*x^3 = g", "k = 1\ng = 1\na3 = 1\nw = 2"), "w follows from them"},
           {resting("D2(x) + k*x + c*abs(x) = g", ""), "abs of a coordinate that does not rest at zero"},
           {resting("D2(x) + k*atan(x) = g", ""), "atan of a coordinate that does not rest at zero"},
           {resting("D2(x) + 4*x + x^3 = 2", ""), "has no coefficient that gives the load"},
           {resting("D2(x) + k*x = g", "", 2, "reference = \"best\""), "'rest' was expected"},
           {resting("D2(x) + k*x + w^2*x = 0", "", 2, "", "rest = \"x0\""),
            "write reference = \"rest\" at the head"}})
    EXPECT_NE(complaint(text).find(part), std::string::npos) << text << "\n" << complaint(text);
}

}  // namespace
}  // namespace secular
