#include "thesis/verify/convergence_proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <set>

#include "perturb/prime_field.hpp"
#include "thesis/verify/evaluation.hpp"

namespace secular::verify {
namespace {

using GiNaC::ex;
using Complex = std::complex<double>;

Complex number(const ex& e, const FormulaSource& text) {
  const ex value = e.evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(value))
    fail_at(text, {text.first_line, 1}, "holds something that has no value in a measured motion",
            "leave the proof out with --without-proofs");
  const auto& n = GiNaC::ex_to<GiNaC::numeric>(value);
  return {n.real().to_double(), n.imag().to_double()};
}
// Harmonics of an expression in the waves: exponents to coefficient.
std::map<std::vector<int>, ex> harmonics(const ex& expression, const PrintedFormula& formula, std::size_t modes) {
  const ex expanded = expression.expand();
  std::map<std::vector<int>, ex> result;
  const bool is_sum = GiNaC::is_a<GiNaC::add>(expanded);
  for (std::size_t i = 0; i < (is_sum ? expanded.nops() : 1); ++i) {
    ex term = is_sum ? expanded.op(i) : expanded;
    std::vector<int> exponents;
    for (std::size_t k = 0; k < modes; ++k) {
      const int power = term.degree(formula.wave(k));
      exponents.push_back(power);
      term = term * GiNaC::pow(formula.wave(k), -power);
    }
    result[exponents] += term;
  }
  return result;
}

double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double mean_x = 0, mean_y = 0, above = 0, below = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / static_cast<double>(x.size());
    mean_y += std::log(y[i]) / static_cast<double>(x.size());
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    above += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
    below += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
  }
  return above / below;
}

}  // namespace

bool can_be_measured(const PrintedStatement& statement) {
  static const std::set<std::string> kinds = {"forcing", "response",      "modulation", "definition",
                                              "polar",   "real_response", "line"};
  return kinds.count(statement.kind) != 0;
}

std::string ConvergenceProof::text() const {
  return fmt::format(
      "error against the full equations at eps = {:g} to {:g}: printed {:.1e} to {:.1e} (slope {:.2f}), "
      "corrected {:.1e} to {:.1e} (slope {:.2f})",
      eps.front(), eps.back(), printed_error.front(), printed_error.back(), printed_slope, corrected_error.front(),
      corrected_error.back(), corrected_slope);
}

namespace {

/// `error(text, measurement)`: what a form of the statement leaves at a measurement.
template <class Error>
ConvergenceProof decided(Laboratory& laboratory, const PrintedStatement& statement,
                         const std::set<std::string>& without, const Error& error) {
  // Both errors are powers of eps in the limit alone: where what follows hides the leading term, eps is smaller.
  ConvergenceProof proof;
  for (const double largest : {0.02, 0.005, 0.00125}) {
    proof = ConvergenceProof();
    for (const double eps : {largest, largest / 2, largest / 4}) {
      const Measurement& measurement = laboratory.measure(eps, without);
      proof.eps.push_back(eps);
      proof.printed_error.push_back(error(statement.printed, measurement));
      proof.corrected_error.push_back(error(*statement.corrected, measurement));
    }
    proof.printed_slope = slope(proof.eps, proof.printed_error);
    proof.corrected_slope = slope(proof.eps, proof.corrected_error);
    proof.decides_for_correction = proof.corrected_slope > proof.printed_slope + 0.5 &&
                                   proof.corrected_error.back() < 0.5 * proof.printed_error.back();
    if (proof.decides_for_correction) break;
  }
  return proof;
}

ConvergenceProof proof_of(Laboratory& laboratory, const PrintedStatement& statement,
                          const PrintedStatement* inside) {
  const PrintedFormula& formula = laboratory.formula();
  const Model& model = *laboratory.derivation().model;
  const std::size_t modes = model.modes.size();
  const auto k = static_cast<std::size_t>(statement.mode);
  std::vector<int> own(modes, 0);
  own[k] = 1;
  // Harmonics in which the two forms differ: the others are the same error in both.
  std::set<std::vector<int>> contested;
  if (statement.kind == "forcing" || statement.kind == "response" || statement.kind == "real_response")
    for (const auto& [n, difference] :
         harmonics(formula.read(statement.printed) - formula.read(*statement.corrected), formula, modes))
      if (!value_at_random_point(formula.at_resonance(difference)).is_zero()) contested.insert(n);

  // What must vanish at the measured values.
  const auto error = [&](const FormulaSource& text, const Measurement& m) {
    const auto at = [&](const ex& e) { return number(e.subs(m.values, GiNaC::subs_options::no_pattern), text); };
    if (statement.kind == "modulation") return std::abs(at(formula.difference(text)));
    if (statement.kind == "polar") {
      const ex equals = statement.equals ? formula.read(*statement.equals) : ex(0);
      return std::abs(at(formula.difference(text) - equals));
    }
    if (statement.kind == "definition") {
      PrintedFormula with = formula;
      with.set_definition(statement.name,
                          formula.read(text) / (statement.scale ? formula.read(*statement.scale) : ex(1)));
      return std::abs(at(with.difference(inside->corrected ? *inside->corrected : inside->printed)));
    }
    if (statement.kind == "line") {
      PrintedFormula with = formula;
      with.set_lines([&](std::size_t mode, const std::vector<int>& n) -> ex {
        const auto measured = m.mode[mode].harmonic.find(n);
        if (measured == m.mode[mode].harmonic.end())
          fail_at(text, {text.first_line, 1}, "has a line that is not measured in the integrated motion",
                  "leave the proof out with --without-proofs");
        return 2 * (measured->second.real() + GiNaC::I * measured->second.imag());
      });
      return std::abs(at(with.difference(text)));
    }
    double largest = 0;
    for (const auto& [n, coefficient] : harmonics(formula.read(text), formula, modes)) {
      if (!contested.count(n)) continue;
      const auto measured = m.mode[k].harmonic.find(n);
      if (measured == m.mode[k].harmonic.end())
        fail_at(text, {text.first_line, 1}, "has a harmonic that is not measured in the integrated motion",
                "leave the proof out with --without-proofs");
      Complex claimed = at(coefficient), seen = measured->second;
      if (statement.kind == "forcing") {
        if (n == own) {
          seen = 0;  // solvability
        } else {
          ex frequency = 0;
          for (std::size_t j = 0; j < modes; ++j) frequency += n[j] * model.frequency(j);
          claimed /= at(GiNaC::pow(model.frequency(k), 2) - GiNaC::pow(frequency, 2));
        }
      }
      largest = std::max(largest, std::abs(claimed - seen));
    }
    return largest;
  };
  std::set<std::string> without(statement.without.begin(), statement.without.end());
  if (statement.kind == "definition") without.clear();                     // its equation has them
  if (modes == 1 && model.symbols.contains("mu2")) without.insert("mu2");  // the fit takes smooth harmonics
  return decided(laboratory, statement, without, error);
}

}  // namespace

ConvergenceProof prove(Laboratory& laboratory, const PrintedStatement& statement, const PrintedStatement* inside) {
  return evaluated(statement.printed, [&] { return proof_of(laboratory, statement, inside); });
}

}  // namespace secular::verify
