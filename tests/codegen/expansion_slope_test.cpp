// Expansions against the periodic solutions of the full equations, integrated: the error of the amplitude falls
// with eps as the order of the expansion promises.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/interpreted_model.hpp"
#include "motion/simulate/motion.hpp"
#include "perturb/model.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A number times a power of eps.
struct ScaledNumber {
  double value = 0;
  int power = 0;
};

struct SlopeCase {
  std::string name;
  std::string equations;  // [[mode]] and [[case]] tables
  std::map<std::string, ScaledNumber> numbers;
  ScaledNumber detuning;               // of the observed frequency of the first mode, from `from`
  double from = 1;                     // the observed frequency without detuning
  int line = 1;                        // which multiple of the period's frequency it is
  std::vector<int> excitations = {1};  // and which ones the excitations' frequencies are
  double slope = 1;                    // that is promised
  std::vector<double> eps = {0.2, 0.1, 0.05};
};

class SlopedExpansion {
 public:
  SlopedExpansion(const SlopeCase& c, double eps)
      : case_(c),
        model_(interpreted_model(
            canonical_model(read_model_text("schema = 1\nname = \"m\"\n" + c.equations, "slope.toml")))),
        base_((c.from + sized(c.detuning, eps)) / c.line) {
    for (const CompiledSymbol& symbol : model_->symbols)
      parameters_.push_back(sized(c.numbers.at(std::string(symbol.name)), eps));
    for (const int multiple : c.excitations) frequencies_.push_back(multiple * base_);
  }

  // Amplitudes at which the modulation equations stand still, by Newton from rest.
  VectorXd fixed_point() const {
    VectorXd z = VectorXd::Zero(unknowns());
    for (int iteration = 0; iteration < 60; ++iteration) {
      const VectorXd rate = modulation(z);
      MatrixXd slope(unknowns(), unknowns());
      for (Index c = 0; c < unknowns(); ++c)
        slope.col(c) = (modulation(z + 1e-7 * VectorXd::Unit(unknowns(), c)) - rate) / 1e-7;
      z -= slope.fullPivLu().solve(rate);
    }
    return z;
  }

  // The first mode's line at its observed frequency in the periodic solution, by shooting from rest.
  Complex line_of_motion() const {
    VectorXd state = VectorXd::Zero(unknowns());
    for (int iteration = 0; iteration < 40; ++iteration) {
      const VectorXd gap = after(state, nullptr) - state;
      MatrixXd slope(unknowns(), unknowns());
      for (Index c = 0; c < unknowns(); ++c)
        slope.col(c) = (after(state + 1e-6 * VectorXd::Unit(unknowns(), c), nullptr) - state - gap) / 1e-6 -
                       VectorXd::Unit(unknowns(), c);
      const VectorXd step = slope.fullPivLu().solve(gap);
      state -= step;
      if (step.norm() < 1e-11) break;
    }
    std::vector<double> samples;
    after(state, &samples);
    Complex line = 0;
    const auto n = static_cast<double>(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
      line += samples[i] * std::polar(1.0, -2 * std::numbers::pi * case_.line * static_cast<double>(i) / n) / n;
    return line;
  }

 private:
  static double sized(const ScaledNumber& number, double eps) { return number.value * std::pow(eps, number.power); }
  Index unknowns() const { return 2 * static_cast<Index>(model_->modes()); }

  VectorXd modulation(const VectorXd& z) const {
    std::vector<Complex> amplitude, rate(model_->modes());
    for (std::size_t k = 0; k < model_->modes(); ++k)
      amplitude.emplace_back(z(2 * static_cast<Index>(k)), z(2 * static_cast<Index>(k) + 1));
    const std::vector<Complex> forcing(frequencies_.size(), 1.0);
    model_->cases[0].modulation(parameters_.data(), frequencies_.data(), amplitude.data(), forcing.data(),
                                rate.data());
    VectorXd result(unknowns());
    for (std::size_t k = 0; k < model_->modes(); ++k)
      result.segment(2 * static_cast<Index>(k), 2) << rate[k].real(), rate[k].imag();
    return result;
  }

  VectorXd after(const VectorXd& start, std::vector<double>* samples) const {
    constexpr int count = 256;
    MotionState moving;
    for (std::size_t k = 0; k < model_->modes(); ++k) {
      moving.displacement.push_back(start(2 * static_cast<Index>(k)));
      moving.velocity.push_back(start(2 * static_cast<Index>(k) + 1));
    }
    const ExcitationSignal signal = [&](double t, ExcitationSample* s) {
      for (std::size_t j = 0; j < frequencies_.size(); ++j) {
        const double w = frequencies_[j];
        s[j] = {std::cos(w * t), -w * std::sin(w * t), -w * w * std::cos(w * t)};
      }
    };
    MotionSettings settings;
    settings.relative_tolerance = settings.absolute_tolerance = 1e-12;
    VectorXd end(unknowns());
    int i = 0;
    integrate_motion({*model_, parameters_.data(), signal}, {0, 0, 2 * std::numbers::pi / base_ / count, count + 1},
                     settings, moving, [&](const MotionSample& s) {
                       if (samples && i < count) samples->push_back(s.displacement[0]);
                       ++i;
                       for (std::size_t k = 0; k < model_->modes(); ++k)
                         end.segment(2 * static_cast<Index>(k), 2) << s.displacement[k], s.velocity[k];
                     });
    return end;
  }

  const SlopeCase& case_;
  std::shared_ptr<const CompiledModel> model_;
  double base_;
  std::vector<double> parameters_, frequencies_;
};

std::string one_mode(const std::string& law, const std::string& resonance) {
  return "[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = \"D2(x) + 2*mu*D(x) + " + law +
         "\"\n[[case]]\nname = \"c\"\n" + resonance;
}

std::string six_modes() {
  std::string text, sum = "x1", order = "mu = 2, kc = 2, e = 2";
  for (int k = 2; k <= 6; ++k) {
    sum += " + p" + std::to_string(k) + "*x" + std::to_string(k);
    order += ", p" + std::to_string(k) + " = 0";
  }
  for (int k = 1; k <= 6; ++k) {
    const std::string n = std::to_string(k), p = k == 1 ? "" : "p" + n + "*";
    text += "[[mode]]\ncoordinate = \"x" + n + "\"\nfrequency = \"w" + n + "\"\nequation = \"D2(x" + n + ") + w" +
            n + "^2*x" + n + " + 2*mu*D(x" + n + ") + " + p + "kc*(" + sum +
            ")^3 = " + (k == 1 ? "e*F*cos(Omega*t)" : "0") + "\"\n";
  }
  return text +
         "[[case]]\nname = \"c\"\nrelations = [\"Omega = w1 + eps^2*s\"]\nexpand_to = 2\nmodes_at_rest = "
         "[\"x2\", \"x3\", \"x4\", \"x5\", \"x6\"]\norder = { " +
         order + " }\n";
}

const char* const rotor = R"toml([[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x + 2*mu*D(x) + b*x^3 = g*D(y) + e*F*cos(Omega*t)"
[[mode]]
coordinate = "y"
frequency = "u"
equation = "D2(y) + u^2*y + 2*mu*D(y) = -g*D(x)"
[[case]]
name = "c"
relations = ["Omega = w + eps^2*s"]
expand_to = 2
order = { mu = 2, g = 1, b = 2, e = 2 }
modes_at_rest = ["y"]
)toml";

std::vector<SlopeCase> slope_cases() {
  const std::string primary = "relations = [\"Omega = w + eps^2*s\"]\nexpand_to = 2\n",
                    by_degree = primary + "order = { mu = 2, e = 2 }\nordering = \"degree\"\n",
                    force = " = e*F*cos(Omega*t)", two = force + " + e*F2*cos(Omega2*t)";
  const ScaledNumber one{1, 0}, mu{0.3, 2}, soft{0.5, 2}, small{0.5, 3};
  std::map<std::string, ScaledNumber> six = {{"mu", mu}, {"kc", soft}, {"e", soft}};
  for (int k = 1; k <= 6; ++k) {
    six["w" + std::to_string(k)] = {k * (1 + 0.17 * k) / 1.17, 0};
    if (k > 1) six["p" + std::to_string(k)] = {1 - 0.3 * k, 0};
  }
  return {
      {"pendulum", one_mode("w^2*sin(x)" + force, by_degree), {{"w", one}, {"mu", mu}, {"e", small}}, {0.2, 2}},
      {"magnet",
       "reference = \"rest\"\n" + one_mode("k*x - b/(1 + x^2)" + force, by_degree),
       {{"w", one}, {"mu", mu}, {"e", small}, {"b", {0.3, 0}}, {"x_rest", {0.6, 0}}},
       {0.2, 2}},
      {"cable",
       one_mode("w^2*x + a*x^2 + b*x^3" + force, primary + "order = { mu = 2, a = 1, b = 2, e = 2 }\n"),
       {{"w", one}, {"mu", mu}, {"e", soft}, {"a", {0.6, 1}}, {"b", {0.7, 2}}},
       {0.2, 2}},
      {"rotor",
       rotor,
       {{"w", one}, {"u", {1.7, 0}}, {"mu", mu}, {"g", {0.5, 1}}, {"b", soft}, {"e", soft}},
       {0.2, 2}},
      {"superharmonic_by_a_fraction",
       one_mode("w^2*x + b*x^3" + force,
                "relations = [\"Omega = w/3 + eps^2*s\"]\n"
                "expand_to = 2\norder = { mu = 2, b = 2, e = 0 }\n"),
       {{"w", one}, {"mu", mu}, {"e", one}, {"b", {0.5, 2}}},
       {0.2, 2},
       1,
       3,
       {1}},
      {"free_difference",
       one_mode("w^2*x + a*x^2 + b*x^3" + two,
                "relations = [\"Omega2 - Omega = w + eps^2*s\"]\n"
                "expand_to = 2\norder = { mu = 2, a = 2, b = 2, e = 0 }\n"),
       {{"w", one}, {"mu", mu}, {"e", {0.7, 0}}, {"a", {0.5, 2}}, {"b", {0.5, 2}}},
       {0.2, 2},
       1,
       5,
       {3, 8}},
      {"local_spring_on_six_modes", six_modes(), six, {0.2, 2}, 1, 1, {1}, 1, {0.2, 0.1}},
      {"duffing_to_order_5",
       one_mode("w^2*x + b*x^3" + force,
                "relations = [\"Omega = w + eps*s\"]\nexpand_to = 5\n"
                "order = { mu = 1, b = 1, e = 1 }\n"),
       {{"w", one}, {"mu", {0.3, 1}}, {"e", {0.4, 1}}, {"b", {0.5, 1}}},
       {0.2, 1},
       1,
       1,
       {1},
       5,
       {0.4, 0.2}},
  };
}

class Slope : public testing::TestWithParam<SlopeCase> {};

TEST_P(Slope, OfTheErrorIsThatOfTheOrder) {
  const SlopeCase c = GetParam();
  std::vector<double> errors;
  for (const double eps : c.eps) {
    const SlopedExpansion expansion(c, eps);
    const VectorXd fixed = expansion.fixed_point();
    const Complex predicted(fixed(0), fixed(1)), integrated = expansion.line_of_motion();
    ASSERT_GT(std::abs(integrated), 0.01);
    errors.push_back(std::abs(predicted - integrated) / std::abs(integrated));
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_GT(std::log(errors[i - 1] / errors[i]) / std::log(c.eps[i - 1] / c.eps[i]), c.slope - 0.15);
}

INSTANTIATE_TEST_SUITE_P(Cases, Slope, testing::ValuesIn(slope_cases()),
                         [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace secular
