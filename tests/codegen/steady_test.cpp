// Jacobian, zero solution, thresholds, force response and saddle-nodes: against the equations they come from.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "codegen/canonical/amplitude_relation.hpp"
#include "codegen/canonical/cartesian_form.hpp"
#include "codegen/canonical/modulation_jacobian.hpp"
#include "codegen/canonical/polar_form.hpp"
#include "codegen/canonical/zero_solution.hpp"
#include "codegen/document/plain_text.hpp"
#include "codegen/document/print_html.hpp"
#include "codegen/document/print_json.hpp"
#include "codegen/document/print_latex.hpp"
#include "codegen/document/print_text.hpp"
#include "codegen/document/steady_statements.hpp"
#include "codegen/document/typeset_variables.hpp"
#include "codegen/expression/cpp_expression.hpp"
#include "formula_values.hpp"
#include "motion/response/spectrum.hpp"
#include "perturb/model.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

const CanonicalModel& shipped_model(const std::string& name, const std::string& only_case = {}) {
  static std::map<std::string, CanonicalModel> models;
  const std::string key = name + " " + only_case;
  if (!models.count(key))
    models[key] =
        canonical_model(read_model(testing_support::source_folder() / "models" / (name + ".toml")), only_case);
  return models.at(key);
}

/// mathieu_duffing's principal resonance to the first order, where the textbook formulas are exact.
const CanonicalModel& first_order_mathieu() {
  static const CanonicalModel model = canonical_model(read_model_text(R"toml(schema = 1
name = "mathieu"
[[mode]]
coordinate = "x"
frequency = "omega0"
equation = "D2(x) + omega0^2*x = -2*mu*D(x) - a3*x^3 - h*x*F*cos(Omega*t)"
[[case]]
name = "principal"
relations = ["Omega = 2*omega0 + eps*sigma"]
order = { mu = 1, a3 = 1, h = 1 }
expand_to = 1
)toml",
                                                                      "mathieu"));
  return model;
}

const CanonicalCase& case_of(const CanonicalModel& model, const std::string& name) {
  return *std::find_if(model.cases.begin(), model.cases.end(),
                       [&](const CanonicalCase& c) { return c.name == name; });
}

const typeset::Statement* find(const std::vector<typeset::StatementSection>& sections, const std::string& key) {
  for (const typeset::StatementSection& section : sections)
    for (const typeset::Statement& statement : section.statements)
      if (statement.key == key) return &statement;
  return nullptr;
}

/// Coefficients and symbols for exact algebra.
class Algebra {
 public:
  explicit Algebra(const SymbolOrder& order) : order_(order) {}
  RationalFunction number(long value) const {
    const std::vector<int> none(order_.size(), 0);
    return {{{std::to_string(value), none}}, {{"1", none}}};
  }
  RationalFunction operator[](const std::string& name) const {
    RationalFunction value = number(1);
    value.numerator[0]
        .exponents[static_cast<std::size_t>(std::find(order_.begin(), order_.end(), name) - order_.begin())] = 1;
    return value;
  }
  static RationalFunction inverse(const RationalFunction& value) { return {value.denominator, value.numerator}; }
  RationalFunction combination(const std::vector<CanonicalRatio>& multiples, const CanonicalModel& model) const {
    RationalFunction total{{}, number(1).denominator};
    for (std::size_t i = 0; i < multiples.size(); ++i)
      total =
          sum(total, scaled((*this)[model.frequency_name(i)], multiples[i].numerator, multiples[i].denominator));
    return total;
  }

 private:
  SymbolOrder order_;
};

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
  return sum(a, b);
}
RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  return product(a, b);
}
RationalFunction square(const RationalFunction& a) {
  return product(a, a);
}
/// The one coefficient of a sum of one term.
RationalFunction only_coefficient(const VariableSum& sum) {
  EXPECT_EQ(sum.terms().size(), 1u);
  return sum.terms().begin()->second.at(0);
}

TEST(RationalFunctions, AddAndMultiplyExactly) {
  const SymbolOrder order = {"a", "b"};
  const Algebra x(order);
  const RationalFunction a = x["a"], b = x["b"], one = x.number(1);
  const auto text = [&](const RationalFunction& value) { return formula_text(value, order); };
  EXPECT_EQ(text(scaled(a, 1, 2) + scaled(b, 1, 3)), "(3*a + 2*b)/6");
  EXPECT_EQ(text(Algebra::inverse(a) + Algebra::inverse(b)), "(a + b)/(a*b)");
  EXPECT_EQ(text(Algebra::inverse(a * a) + Algebra::inverse(a)), "(a + 1)/a^2");
  const RationalFunction below = a + b;
  EXPECT_EQ(text(a * Algebra::inverse(below) + b * Algebra::inverse(scaled(below, 2, 1))), "(2*a + b)/(2*a + 2*b)");
  EXPECT_TRUE((Algebra::inverse(below) + scaled(Algebra::inverse(below), -1, 1)).is_zero());
  EXPECT_EQ(text(one * Algebra::inverse(below) * below), "(a + b)/(a + b)");  // no polynomial division
  EXPECT_EQ(text(scaled(a, 2, 3) * scaled(Algebra::inverse(a), 3, 4)), "1/2");
}

class SteadyModel : public testing::TestWithParam<std::string> {};

TEST_P(SteadyModel, JacobianEqualsCentralDifferences) {
  const CanonicalModel& model = shipped_model(GetParam());
  for (const CanonicalCase& c : model.cases) {
    if (c.observed_frequency.empty()) continue;
    const ModulationJacobian jacobian = modulation_jacobian(model, c);
    const std::size_t size = 2 * model.coordinates.size();
    ASSERT_EQ(jacobian.entry.size(), size);
    for (unsigned seed = 1; seed <= 2; ++seed) {
      const Values values = random_values(model, c, 0, seed);
      for (std::size_t j = 0; j < size; ++j) {
        const std::string name = (j % 2 == 0 ? "x_" : "y_") + model.coordinates[j / 2];
        const auto moved = [&](double step) {
          Values result = values;
          result.set(name, values[name] + step);
          return result;
        };
        const double step = 1e-5;
        const Values up = moved(step), down = moved(-step);
        for (std::size_t i = 0; i < size; ++i) {
          const auto [x_rate, y_rate] = typeset::cartesian_modulation(model, c, i / 2);
          const typeset::Expression& right = i % 2 == 0 ? x_rate.right : y_rate.right;
          const double difference = (up.of(right) - down.of(right)).real() / (2 * step);
          const double entry = values.of(typeset::cartesian_expression(model, c, jacobian.entry[i][j])).real();
          EXPECT_NEAR(entry, difference, 1e-6 * (1 + std::abs(difference))) << c.name << " " << i << " " << j;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, SteadyModel,
                         testing::Values("duffing", "mathieu_duffing", "parametric_pair", "pendulum",
                                         "two_mass_mode1", "van_der_pol", "internal_resonance"),
                         [](const auto& instance) { return instance.param; });

TEST(Jacobian, IsRegularAtZeroWithoutModuli) {
  const CanonicalModel& smooth = shipped_model("duffing");
  EXPECT_TRUE(modulation_jacobian(smooth, case_of(smooth, "primary")).regular_at_zero);
  const CanonicalModel& model = shipped_model("two_mass_mode1");
  EXPECT_FALSE(modulation_jacobian(model, case_of(model, "free")).regular_at_zero);
  EXPECT_NE(derivation_text(model).find("Not regular at zero"), std::string::npos);
}

/// Largest real part of the Jacobian's eigenvalues at (almost) zero amplitude.
double growth(const CanonicalModel& model, const CanonicalCase& c, const ModulationJacobian& jacobian,
              Values values) {
  for (const std::string& v : model.coordinates) {
    values.set("x_" + v, 1e-9);
    values.set("y_" + v, 1e-9);
  }
  const auto size = static_cast<Eigen::Index>(jacobian.entry.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      matrix(i, j) = values
                         .of(typeset::cartesian_expression(
                             model, c, jacobian.entry[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]))
                         .real();
  return spectrum_of(matrix).eigenvalues(0).real();
}

/// Excitation minus its threshold, both as the printed equation has them: positive where zero is said unstable.
double beyond_threshold(const std::vector<typeset::StatementSection>& sections, Values values) {
  const typeset::Statement& threshold = *find(sections, "threshold");
  if (const typeset::Statement* pair = find(sections, "characteristic_equation"); pair != nullptr) {
    for (std::size_t i = 1; i < pair->equations.size(); ++i)
      values.set(pair->equations[i].left, values.of(pair->equations[i].right));
    values.set(threshold.equations[1].left, values.of(threshold.equations[1].right));
    return (values.of(threshold.equations[0].left) - values.of(threshold.equations[0].right)).real();
  }
  return (values.of(threshold.equations[0].right) - values.of(threshold.equations[0].left)).real();
}

void set_near_resonance(Values& values, const CanonicalModel& model, const CanonicalCase& c, double distance) {
  const std::vector<int>& multiples = c.relations.at(0).multiples;
  double natural = 0;
  for (std::size_t k = 0; k < model.natural_frequencies.size(); ++k)
    natural += multiples[k] * values[model.natural_frequencies[k]].real();
  values.set("Omega", -natural / multiples[model.natural_frequencies.size()] + distance);
}

struct ThresholdCase {
  const char *model, *resonance, *reversed;  ///< a parameter whose sign is changed, so that there is a threshold
};

void PrintTo(const ThresholdCase& threshold, std::ostream* stream) {
  *stream << threshold.model << " " << threshold.resonance;
}

class Threshold : public testing::TestWithParam<ThresholdCase> {};

TEST_P(Threshold, SeparatesDecayFromGrowth) {
  const CanonicalModel& model = GetParam().model == std::string("first_order_mathieu")
                                    ? first_order_mathieu()
                                    : shipped_model(GetParam().model);
  const CanonicalCase& c = case_of(model, GetParam().resonance);
  const ModulationJacobian jacobian = modulation_jacobian(model, c);
  const std::vector<typeset::StatementSection> sections = typeset::steady_sections(model, c);
  ASSERT_NE(find(sections, "threshold"), nullptr);
  std::size_t stable = 0, unstable = 0, crossings = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Values values = random_values(model, c, 0, seed);
    for (const char* damping : {"mu", "mu1", "mu2"})
      if (std::find(model.parameters.begin(), model.parameters.end(), damping) != model.parameters.end())
        values.set(damping, 0.1 * values[damping]);
    for (const CanonicalRelation& relation : c.relations)
      values.set(relation.detuning, 0.1 * values[relation.detuning]);
    if (*GetParam().reversed != '\0') values.set(GetParam().reversed, -values[GetParam().reversed]);
    set_near_resonance(values, model, c, 0.15 * (static_cast<double>(seed) - 4));
    const auto with_forcing = [&](double forcing) {
      Values result = values;
      result.set("F", forcing);
      return result;
    };
    std::optional<double> before;
    for (double forcing = 0.02; forcing < 6; forcing *= 1.4) {
      const Values at = with_forcing(forcing);
      const double rate = growth(model, c, jacobian, at), margin = beyond_threshold(sections, at);
      if (std::abs(rate) < 1e-6) continue;  // too close to tell
      EXPECT_EQ(rate > 0, margin > 0) << "seed " << seed << ", F = " << forcing << ": " << rate << " " << margin;
      (rate > 0 ? unstable : stable) += 1;
      if (before && growth(model, c, jacobian, with_forcing(*before)) < 0 && rate > 0) {
        double low = *before, high = forcing;
        for (int i = 0; i < 60; ++i) {
          const double middle = (low + high) / 2;
          (growth(model, c, jacobian, with_forcing(middle)) < 0 ? low : high) = middle;
        }
        EXPECT_NEAR(beyond_threshold(sections, with_forcing(low)), 0, 1e-6);
        ++crossings;
      }
      before = forcing;
    }
  }
  EXPECT_GT(stable, 5u);
  EXPECT_GT(unstable, 5u);
  EXPECT_GT(crossings, 2u);
}

INSTANTIATE_TEST_SUITE_P(Cases, Threshold,
                         testing::Values(ThresholdCase{"first_order_mathieu", "principal", ""},
                                         ThresholdCase{"mathieu_duffing", "principal", ""},
                                         ThresholdCase{"mathieu_duffing", "fundamental", ""},
                                         ThresholdCase{"two_mass_mode1", "principal_parametric", ""},
                                         ThresholdCase{"parametric_pair", "additive", ""},
                                         ThresholdCase{"parametric_pair", "additive_second_order", ""},
                                         ThresholdCase{"parametric_pair", "difference", "q"}),
                         [](const auto& instance) {
                           return std::string(instance.param.model) + "_" + instance.param.resonance;
                         });

// p q F^2 = 4 omega1 omega2 c1 c2 (1 + 4 sigma^2/(c1 + c2)^2), c_k = 2 mu_k, sigma = Omega - omega1 - omega2.
TEST(TextbookThreshold, OfTheAdditiveResonanceIsTheTextbooks) {
  const CanonicalModel& model = shipped_model("parametric_pair");
  const ZeroSolution zero = zero_solution(model, case_of(model, "additive"));
  ASSERT_EQ(zero.groups.size(), 1u);
  ASSERT_EQ(zero.groups[0].kind, ZeroSolution::Group::Kind::additive);
  const ZeroSolution::Pair pair = zero.pair(zero.groups[0]);
  EXPECT_TRUE(pair.exchange.imaginary.is_zero());
  EXPECT_TRUE(pair.detuning.is_zero());
  const Algebra symbol(model.order);
  const RationalFunction c1 = only_coefficient(pair.first_decay), c2 = only_coefficient(pair.second_decay),
                         derived = c1 * c2 *
                                   (symbol.number(1) + square(symbol.combination(pair.turning, model)) *
                                                           Algebra::inverse(square(c1 + c2)));
  const RationalFunction exchange = only_coefficient(pair.exchange.real);  // of F^2
  EXPECT_EQ(pair.exchange.real.terms().begin()->first, std::vector<int>{2});
  // p q = exchange * scale, so that the threshold is p q F^2 = derived * scale.
  const RationalFunction scale = symbol["p"] * symbol["q"] * Algebra::inverse(exchange);
  const RationalFunction C1 = scaled(symbol["mu1"], 2, 1), C2 = scaled(symbol["mu2"], 2, 1),
                         sigma = symbol["Omega"] + scaled(symbol["omega1"] + symbol["omega2"], -1, 1);
  const RationalFunction textbook =
      scaled(symbol["omega1"] * symbol["omega2"] * C1 * C2 *
                 (symbol.number(1) + scaled(square(sigma) * Algebra::inverse(square(C1 + C2)), 4, 1)),
             4, 1);
  EXPECT_TRUE((derived * scale + scaled(textbook, -1, 1)).is_zero());
}

TEST(TextbookThreshold, OfTheDifferenceResonanceNeedsOppositeCouplings) {
  const CanonicalModel& model = shipped_model("parametric_pair");
  const ZeroSolution zero = zero_solution(model, case_of(model, "difference"));
  ASSERT_EQ(zero.groups.size(), 1u);
  ASSERT_EQ(zero.groups[0].kind, ZeroSolution::Group::Kind::difference);
  const ZeroSolution::Pair pair = zero.pair(zero.groups[0]);
  EXPECT_EQ(formula_text(only_coefficient(pair.exchange.real), model.order), "-p*q/(16*omega1*omega2)");
}

// (h F)^2 = (4 omega0 mu)^2 + (2 omega0 sigma)^2 with sigma = Omega - 2 omega0.
TEST(TextbookThreshold, OfTheMathieuEquationIsTheTextbooks) {
  const CanonicalModel& model = first_order_mathieu();
  const ZeroSolution zero = zero_solution(model, model.cases.at(0));
  ASSERT_EQ(zero.groups.at(0).kind, ZeroSolution::Group::Kind::parametric);
  const ComplexSum &p = zero.direct[0][0], &q = zero.conjugate[0][0];
  EXPECT_TRUE(p.imaginary.is_zero());
  EXPECT_TRUE(q.real.is_zero());
  const Algebra symbol(model.order);
  const RationalFunction left =
      square(only_coefficient(p.real)) + square(symbol.combination(zero.offset[0], model));
  const RationalFunction scale = square(symbol["h"] * Algebra::inverse(only_coefficient(q.imaginary)));
  const RationalFunction sigma = symbol["Omega"] + scaled(symbol["omega0"], -2, 1),
                         textbook = square(scaled(symbol["omega0"] * symbol["mu"], 4, 1)) +
                                    square(scaled(symbol["omega0"] * sigma, 2, 1));
  EXPECT_TRUE((left * scale + scaled(textbook, -1, 1)).is_zero());
  const std::vector<typeset::StatementSection> sections = typeset::steady_sections(model, model.cases.at(0));
  const typeset::Statement& critical = *find(sections, "critical_excitation");
  Values values = random_values(model, model.cases.at(0), 0);
  values.set("F", std::sqrt(values.of(critical.equations[0].right)));
  const double hF = (values["h"] * values["F"]).real(), w = values["omega0"].real(),
               detuning = values["Omega"].real() - 2 * w;
  EXPECT_NEAR(hF * hF, std::pow(4 * w * values["mu"].real(), 2) + std::pow(2 * w * detuning, 2), 1e-12);
}

TEST(ZeroSolution, IsFoundOnlyWhereItIs) {
  const CanonicalModel& duffing = shipped_model("duffing");
  EXPECT_EQ(zero_solution(duffing, case_of(duffing, "primary")).kind, ZeroSolution::Kind::none);
  EXPECT_EQ(zero_solution(duffing, case_of(duffing, "subharmonic_3")).kind, ZeroSolution::Kind::linear);
  const CanonicalModel& pendulum = shipped_model("pendulum");  // dry friction
  EXPECT_EQ(zero_solution(pendulum, pendulum.cases.at(0)).kind, ZeroSolution::Kind::not_differentiable);
  const CanonicalModel& oscillator = shipped_model("van_der_pol");
  const ZeroSolution zero = zero_solution(oscillator, oscillator.cases.at(0));
  ASSERT_EQ(zero.kind, ZeroSolution::Kind::linear);
  EXPECT_EQ(zero.groups.at(0).kind, ZeroSolution::Group::Kind::single);
  EXPECT_EQ(formula_text(only_coefficient(zero.direct[0][0].real), oscillator.order), "mu/2");
}

double frame_turning(const CanonicalModel& model, const CanonicalCase& c, const Values& values) {
  return values.of(typeset::frequency_combination(model, frame_offset(c, 0))).real();
}

/// Sets beta, F and Omega so that the oscillation is steady; false if no excitation was found.
bool make_steady(const CanonicalModel& model, const CanonicalCase& c, Values& values) {
  const auto polar = typeset::polar_modulation(model, c, 0);
  const std::string beta = "beta_" + model.coordinates[0];
  const auto amplitude_rate = [&](double angle) {
    values.set(beta, angle);
    return values.of(polar.first.right).real();
  };
  for (const double forcing : {0.5, 2.0, 8.0, 30.0, 100.0, 1000.0}) {
    values.set("F", forcing);
    for (double angle = 0; angle < 6; angle += 0.05) {
      if (amplitude_rate(angle) * amplitude_rate(angle + 0.05) >= 0) continue;
      double low = angle, high = angle + 0.05;
      for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (amplitude_rate(low) * amplitude_rate(middle) <= 0 ? high : low) = middle;
      }
      values.set(beta, low);
      const double turning = (values.of(polar.second.right) / values["a_" + model.coordinates[0]]).real();
      values.set("Omega", 0.0);
      const double at_zero = frame_turning(model, c, values);
      values.set("Omega", 1.0);
      values.set("Omega", (turning - at_zero) / (frame_turning(model, c, values) - at_zero));
      return true;
    }
  }
  return false;
}

void expect_equal(Complex left, Complex right, const std::string& where) {
  EXPECT_LT(std::abs(left - right), 1e-9 * (1e-3 + std::abs(left) + std::abs(right)))
      << where << ": " << left << " " << right;
}

class SteadyStates : public testing::TestWithParam<std::string> {};

TEST_P(SteadyStates, SatisfyWhatIsPrinted) {
  const CanonicalModel& model = shipped_model(GetParam());
  std::size_t checked = 0;
  for (const CanonicalCase& c : model.cases) {
    if (c.observed_frequency.empty()) continue;
    const AmplitudeRelation relation = amplitude_relation(model, c);
    if (relation.kind == AmplitudeRelation::Kind::none) continue;
    const std::vector<typeset::StatementSection> sections = typeset::steady_sections(model, c);
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const std::string where = c.name + ", seed " + std::to_string(seed);
      Values values = random_values(model, c, 0, seed);
      ASSERT_TRUE(make_steady(model, c, values)) << where;
      const typeset::Statement& response = *find(sections, "frequency_response");
      for (std::size_t i = 1; i < response.equations.size(); ++i)
        values.set(response.equations[i].left, values.of(response.equations[i].right));
      const Complex left = values.of(response.equations[0].left), right = values.of(response.equations[0].right);
      expect_equal(left, right, where + ", frequency response");
      const Complex a = values["a_" + model.coordinates[0]];
      const auto polynomial = [&](const Values& at) {
        return at.of(typeset::amplitude_expression(model, c, relation.relation)).real();
      };
      EXPECT_NEAR(polynomial(values) * std::pow(a.real(), relation.divided), 0, 1e-8 * (1 + std::abs(left)))
          << where;
      const double step = 1e-5;
      Values up = values, down = values;
      up.set("a_" + model.coordinates[0], a + step);
      down.set("a_" + model.coordinates[0], a - step);
      const double difference = (polynomial(up) - polynomial(down)) / (2 * step);
      EXPECT_NEAR(values.of(typeset::amplitude_expression(model, c, relation.fold)).real(), difference,
                  1e-5 * (1 + std::abs(left) + std::abs(difference)))
          << where;
      if (const typeset::Statement* force = find(sections, "force_response"); force != nullptr)
        expect_equal(values.of(force->equations[0].left), values.of(force->equations[0].right), where + ", force");
      if (const typeset::Statement* detuning = find(sections, "detuning"); detuning != nullptr) {
        values.set(detuning->equations[2].left, values.of(detuning->equations[2].right));
        const Complex frame = values.of(detuning->equations[0].left);
        const double distance = std::min(std::abs(values.of(detuning->equations[0].right) - frame),
                                         std::abs(values.of(detuning->equations[1].right) - frame));
        EXPECT_LT(distance, 1e-6 * (1 + std::abs(frame))) << where << ", detuning";
      }
      ++checked;
    }
  }
  EXPECT_GT(checked, 2u);
}

INSTANTIATE_TEST_SUITE_P(Models, SteadyStates, testing::Values("duffing", "mathieu_duffing", "two_mass_mode1"),
                         [](const auto& instance) { return instance.param; });

struct FoldCase {
  const char *name, *model, *resonance, *varied;
  double low, high;  ///< of the varied quantity, with one fold between
  std::map<std::string, double> values;
};

void PrintTo(const FoldCase& fold, std::ostream* stream) {
  *stream << fold.name;
}

class SaddleNode : public testing::TestWithParam<FoldCase> {};

// Where the number of amplitudes that satisfy the frequency response changes, by counting them.
TEST_P(SaddleNode, IsWhereTheNumberOfSteadyStatesChanges) {
  const FoldCase& fold = GetParam();
  const CanonicalModel& model =
      std::string(fold.model) == "first_order_mathieu" ? first_order_mathieu() : shipped_model(fold.model);
  const CanonicalCase& c = case_of(model, fold.resonance);
  Values values = random_values(model, c, 0);
  for (const auto& [name, value] : fold.values) values.set(name, value);
  const std::vector<typeset::StatementSection> sections = typeset::steady_sections(model, c);
  const std::vector<typeset::Equation>& parts = find(sections, "frequency_response")->equations;
  const typeset::Equation& response = parts.at(0);
  const std::vector<typeset::Equation>& printed = find(sections, "saddle_node")->equations;
  ASSERT_EQ(printed.size(), 2u);
  const std::string amplitude = "a_" + model.coordinates[0];
  const auto residual = [&](double a) {
    values.set(amplitude, a);
    for (std::size_t i = 1; i < parts.size(); ++i) values.set(parts[i].left, values.of(parts[i].right));
    return (values.of(response.left) - values.of(response.right)).real();
  };
  const auto roots = [&](double varied) {
    values.set(fold.varied, varied);
    std::vector<double> list;
    double before = residual(0.001);
    for (int i = 2; i <= 4000; ++i) {
      const double a = 0.001 * i, here = residual(a);
      if ((before < 0) != (here < 0)) list.push_back(a - 0.0005);
      before = here;
    }
    return list;
  };
  double low = fold.low, high = fold.high;
  const std::size_t few = roots(low).size(), many = roots(high).size();
  ASSERT_EQ(std::max(few, many), std::min(few, many) + 2);
  for (int i = 0; i < 24; ++i) {
    const double middle = (low + high) / 2;
    (roots(middle).size() == few ? low : high) = middle;
  }
  std::vector<double> list = roots(few > many ? low : high);  // the side with more of them
  double a = 0, closest = 1e9;
  for (std::size_t i = 0; i + 1 < list.size(); ++i)
    if (list[i + 1] - list[i] < closest) {
      closest = list[i + 1] - list[i];
      a = (list[i] + list[i + 1]) / 2;
    }
  // Newton's method on the two printed equations from there ends close by.
  double varied = low;
  const auto value = [&](std::size_t equation, double at, double parameter) {
    values.set(amplitude, at);
    values.set(fold.varied, parameter);
    return values.of(printed[equation].right).real();
  };
  for (int i = 0; i < 30; ++i) {
    const double step = 1e-6;
    Eigen::Matrix2d matrix;
    Eigen::Vector2d right;
    for (std::size_t e = 0; e < 2; ++e) {
      const auto row = static_cast<Eigen::Index>(e);
      right(row) = value(e, a, varied);
      matrix(row, 0) = (value(e, a + step, varied) - value(e, a - step, varied)) / (2 * step);
      matrix(row, 1) = (value(e, a, varied + step) - value(e, a, varied - step)) / (2 * step);
    }
    const Eigen::Vector2d move = matrix.partialPivLu().solve(right);
    a -= move(0);
    varied -= move(1);
  }
  EXPECT_NEAR(value(0, a, varied), 0, 1e-12);
  EXPECT_NEAR(value(1, a, varied), 0, 1e-10);
  EXPECT_NEAR(varied, low, 3e-4 * std::abs(low));
  EXPECT_LT(closest, 0.05);
}

const std::map<std::string, double> bent = {{"omega0", 1}, {"mu", 0.05}, {"a2", 0.1}, {"a3", 1},
                                            {"e", 1},      {"h", 1},     {"F", 0.2},  {"Omega", 2.4}};
const std::map<std::string, double> two_masses = {
    {"omega0", 1},    {"mu1", 0.02},    {"mu2", 0.01}, {"mu3", 0.01}, {"alpha2", 0.1}, {"alpha3", 1},
    {"delta2", 0.05}, {"delta3", 0.02}, {"eta1", 0.1}, {"eta2", 1},   {"F", 0.2},      {"Omega", 2.2}};
const std::map<std::string, double> second_order = {{"omega0", 1}, {"mu", 0.02},   {"a3", 0.3},
                                                    {"h", 1},      {"sigma", 0.1}, {"Omega", 2.1}};

INSTANTIATE_TEST_SUITE_P(
    Cases, SaddleNode,
    testing::Values(FoldCase{"duffing_up", "duffing", "primary", "Omega", 1.0, 1.6, bent},
                    FoldCase{"duffing_down", "duffing", "primary", "Omega", 1.6, 3.5, bent},
                    FoldCase{"mathieu", "first_order_mathieu", "principal", "F", 0.1, 0.5, bent},
                    FoldCase{"two_mass", "two_mass_mode1", "principal_parametric", "F", 0.02, 0.3, two_masses},
                    FoldCase{"mathieu_second_order", "mathieu_duffing", "principal", "F", 0.04, 0.15,
                             second_order}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(TextbookSaddleNode, OfTheMathieuEquationIsWhereTheExcitationBalancesDamping) {
  const CanonicalModel& model = first_order_mathieu();
  const AmplitudeRelation relation = amplitude_relation(model, model.cases.at(0));
  Values values = random_values(model, model.cases.at(0), 0);
  // The relation's double root in a^2: a^2 = 8 omega0 d/(3 a3), h F = 4 omega0 mu.
  const double w = values["omega0"].real(), d = 0.2;
  values.set("Omega", 2 * (w + d));
  values.set("F", 4.0 * w * values["mu"] / values["h"]);
  values.set("a_x", std::sqrt(8 * w * d / (3 * values["a3"].real())));
  for (const VariableSum* one : {&relation.relation, &relation.fold})
    EXPECT_NEAR(values.of(typeset::amplitude_expression(model, model.cases[0], *one)).real(), 0, 1e-12);
}

const char* const awkward_names = R"toml(schema = 1
name = "awkward"
[[mode]]
coordinate = "v"
frequency = "w"
equation = "D2(v) + w^2*v = -2*omega_obs*D(v) - R*v^3 + S*F*cos(Omega*t)"
[[case]]
name = "free"
relations = []
order = { omega_obs = 1, R = 1, S = 1 }
expand_to = 1
excitation = false
[[case]]
name = "primary"
relations = ["Omega = w + eps*sigma"]
order = { omega_obs = 1, R = 1, S = 1 }
expand_to = 1
)toml";

TEST(SteadyNames, AreNoneOfTheModel) {
  const CanonicalModel model = canonical_model(read_model_text(awkward_names, "awkward"));
  const std::string text = derivation_text(model);
  EXPECT_NE(text.find("a_v*(omega_obs_ - w) = 3*R/(8*w)*a_v^3"), std::string::npos);
  EXPECT_NE(text.find("+ sqrt(R_)"), std::string::npos);
  EXPECT_EQ(text.find("(w - w)"), std::string::npos);
}

std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

TEST(SteadyOutputs, SayTheSame) {
  for (const char* name : {"duffing", "mathieu_duffing", "parametric_pair"}) {
    const CanonicalModel& model = shipped_model(name);
    const std::string text = derivation_text(model), latex = derivation_latex(model), html = derivation_html(model);
    const nlohmann::json json = nlohmann::json::parse(derivation_json(model));
    std::size_t equations = 0;
    for (const nlohmann::json& one : json.at("cases"))
      for (const char* section : {"jacobian", "zero_solution", "steady_states"})
        for (const nlohmann::json& statement : one.at(section))
          for (const nlohmann::json& equation : statement.at("equations")) {
            EXPECT_NE(text.find(equation.at("left").get<std::string>() + " = " +
                                equation.at("right").get<std::string>() + "\n"),
                      std::string::npos);
            ++equations;
          }
    EXPECT_GT(equations, 20u);
    for (const char* heading : {"Jacobian of the Cartesian form", "Zero solution", "Steady states"}) {
      EXPECT_EQ(times_in(text, std::string("\n") + heading + "\n"), model.cases.size());
      EXPECT_EQ(times_in(latex, std::string("{") + heading + "}"), model.cases.size());
      EXPECT_EQ(times_in(html, std::string(">") + heading + "<"), model.cases.size());
    }
  }
}

TEST(SteadyOutputs, HoldTheTermsLeftToQuadrature) {
  const CanonicalModel model = canonical_model(read_model_text(R"toml(schema = 1
name = "rubbing"
[[mode]]
coordinate = "v"
frequency = "omega1"
equation = "D2(v) + omega1^2*v = -2*mu*D(v) - c*abs(D(v) - D(u)/2)*(D(v) - D(u)/2)"
[[mode]]
coordinate = "u"
frequency = "omega2"
equation = "D2(u) + omega2^2*u = -2*mu*D(u)"
[[case]]
name = "free"
relations = []
order = { mu = 1, c = 1 }
expand_to = 1
)toml",
                                                               "rubbing"));
  ASSERT_FALSE(model.cases.at(0).quadratures.empty());
  const std::string text = derivation_text(model), latex = derivation_latex(model), html = derivation_html(model);
  EXPECT_EQ(times_in(text, "mean["), model.cases[0].quadratures.size());
  EXPECT_EQ(times_in(latex, "\\langle "), model.cases[0].quadratures.size());
  EXPECT_EQ(times_in(html, "\u27E8"), model.cases[0].quadratures.size());
  EXPECT_NE(latex.find("\\lvert \\dot{u} - 2 \\dot{v}\\rvert"), std::string::npos);
  EXPECT_NE(text.find("Without the terms that are left to quadrature."), std::string::npos);
  EXPECT_EQ(zero_solution(model, model.cases[0]).kind, ZeroSolution::Kind::undecided);
}

}  // namespace
}  // namespace secular
