// Derivatives of the lumps by the parameters.
#include "codegen/cpp/lump_gradient_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "codegen/canonical/lump_gradient.hpp"
#include "codegen/cpp/emitter.hpp"

namespace secular {
namespace {

class GradientLines {
 public:
  explicit GradientLines(const CanonicalModel& model) : model_(model) {}

  std::vector<std::string> of(const RationalFunction& definition, CppWriter& writer) const {
    std::vector<std::string> lines;
    const bool divided = !definition.is_zero() && !definition.numerator.back().divisors.empty();
    std::vector<bool> frequency(model_.order.size(), true);
    if (divided) {
      frequency = frequencies(definition);
      by_frequencies(definition, frequency, writer, lines);
      by_coefficients(definition, frequency, writer, lines);
    }
    for (const LumpGradient::Entry& entry : lump_gradient(model_, definition).entries)
      if (!divided || (entry.symbol >= model_.natural_frequencies.size() && frequency[entry.symbol]))
        lines.push_back(fmt::format("gradient[{}] = {};  // by {}", entry.parameter, writer.expression(entry.rate),
                                    model_.parameters[entry.parameter]));
    for (std::string& line : lines) line = with_remark_if_it_fits(line);
    return without_unused(lines);
  }

 private:
  static std::string with_remark_if_it_fits(const std::string& line) {
    constexpr std::size_t room = 112;
    const std::size_t remark = line.find(";  // ");
    return line.size() <= room || remark == std::string::npos ? line : line.substr(0, remark + 1);
  }

  // A fraction with neither frequency nor divisor is of no derivative by frequencies.
  static std::vector<std::string> without_unused(const std::vector<std::string>& lines) {
    std::vector<std::string> used;
    for (const std::string& line : lines) {
      const bool fraction = line.starts_with("const double f_");
      const std::string name = fraction ? line.substr(13, line.find(" =") - 13) : "";
      const auto names_it = [&](const std::string& other) {
        for (std::size_t at = other.find(name); at != std::string::npos; at = other.find(name, at + 1)) {
          const char next = at + name.size() < other.size() ? other[at + name.size()] : ' ';
          if (next < '0' || next > '9') return true;
        }
        return false;
      };
      const auto mentions = std::count_if(lines.begin(), lines.end(), names_it);
      if (!fraction || mentions > 1) used.push_back(line);
    }
    return used;
  }

  static std::string bracketed(const std::string& sum) {
    return sum.find(" + ") == std::string::npos && sum.find(" - ") == std::string::npos ? sum : "(" + sum + ")";
  }

  // Of several terms where a value at rest depends on the parameter, too.
  static std::string factor_code(const RationalFunction& rate, CppWriter& writer) {
    const std::string text = writer.expression(rate);
    return reads_as_sum(rate) ? "(" + text + ")" : text;
  }

  RationalFunction in_lowest_terms(const RationalFunction& value) const {
    return product(value, monomial(unit(0, 0), unit(0, 0)));
  }

  RationalFunction monomial(const std::vector<int>& above, const std::vector<int>& below) const {
    return {{{"1", above}}, {{"1", below}}};
  }

  // Of a lump with divisors: symbols that natural frequencies are or that divisors hold.
  std::vector<bool> frequencies(const RationalFunction& definition) const {
    std::vector<bool> result(model_.order.size(), false);
    std::fill_n(result.begin(), model_.natural_frequencies.size(), true);
    for (const PolynomialTerm& term : definition.numerator)
      for (const DivisorPower& divisor : term.divisors)
        for (const PolynomialTerm& one : *divisor.sum)
          for (std::size_t s = 0; s < result.size(); ++s) result[s] = result[s] || one.exponents[s] != 0;
    return result;
  }

  // By a coefficient: from the lump as sum of c_g * (coefficients).
  void by_coefficients(const RationalFunction& definition, const std::vector<bool>& frequency, CppWriter& writer,
                       std::vector<std::string>& lines) const {
    std::vector<bool> coefficient = frequency;
    coefficient.flip();
    const std::vector<PolynomialGroup> groups = grouped(definition.numerator, coefficient, false);
    const PolynomialTerm& below = definition.denominator.front();
    PolynomialTerm below_factor = below;
    std::vector<int> below_common = below.exponents;
    for (std::size_t s = 0; s < frequency.size(); ++s)
      (frequency[s] ? below_common : below_factor.exponents)[s] = 0;
    std::vector<std::string> sums(model_.parameters.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const RationalFunction common = monomial(groups[g].common, below_common);
      const LumpGradient gradient = lump_gradient(model_, common);
      if (gradient.entries.empty()) continue;
      lines.push_back(fmt::format("const double c_{} = {};  // multiplies {}", g,
                                  writer.expression(in_lowest_terms({groups[g].rest, {below_factor}})),
                                  formula_text(common, model_.order)));
      for (const LumpGradient::Entry& entry : gradient.entries)
        add_to_sum(sums[entry.parameter],
                   (entry.rate.is_one() ? "" : factor_code(entry.rate, writer) + " * ") + fmt::format("c_{}", g));
    }
    for (std::size_t p = 0; p < sums.size(); ++p)
      if (!sums[p].empty())
        lines.push_back(fmt::format("gradient[{}] = {};  // by {}", p, sums[p], model_.parameters[p]));
  }

  // By a natural frequency w: from the lump as sum of the fractions f_g, each a number of coefficients times powers
  // of frequencies and divisors D, sum (power of w in f_g) f_g/w - sum dD/dw * q, q = sum (power of D) f_g/D.
  void by_frequencies(const RationalFunction& definition, const std::vector<bool>& frequency, CppWriter& writer,
                      std::vector<std::string>& lines) const {
    const std::vector<PolynomialGroup> groups = grouped(definition.numerator, frequency, true);
    const PolynomialTerm& below = definition.denominator.front();
    const std::size_t modes = model_.natural_frequencies.size();
    std::vector<std::string> by_power(modes);
    std::vector<std::string> by_divisor;
    std::vector<std::shared_ptr<const std::vector<PolynomialTerm>>> divisors;
    const auto weighted = [](std::string& sum, int weight, std::size_t g) {
      const std::string size = std::abs(weight) == 1 ? "" : fmt::format("{}.0 * ", std::abs(weight));
      add_to_sum(sum, fmt::format("{}{}f_{}", weight < 0 ? "-" : "", size, g));
    };
    for (std::size_t g = 0; g < groups.size(); ++g) {
      RationalFunction value{groups[g].rest, {below}};
      for (PolynomialTerm& term : value.numerator) {
        for (std::size_t s = 0; s < frequency.size(); ++s) term.exponents[s] += groups[g].common[s];
        term.divisors = groups[g].divisors;
      }
      lines.push_back(fmt::format("const double f_{} = {};", g, writer.expression(in_lowest_terms(value))));
      for (std::size_t k = 0; k < modes; ++k)
        if (const int power = groups[g].common[k] - below.exponents[k]; power != 0) weighted(by_power[k], power, g);
      for (const auto& [sum, power] : groups[g].divisors) {
        const std::size_t number = writer.number_of(sum);
        if (by_divisor.size() <= number) {
          by_divisor.resize(number + 1);
          divisors.resize(number + 1);
        }
        divisors[number] = sum;
        weighted(by_divisor[number], power, g);
      }
    }
    for (std::size_t d = 0; d < by_divisor.size(); ++d)
      if (!by_divisor[d].empty())
        lines.push_back(fmt::format("const double q_{0} = {1} * per_{0};", d, bracketed(by_divisor[d])));
    for (std::size_t k = 0; k < modes; ++k) {
      std::string value;
      if (!by_power[k].empty()) {
        const std::string name = writer.expression(monomial(unit(k), unit(0, 0)));
        value = fmt::format("{} / {}", bracketed(by_power[k]), name);
      }
      for (std::size_t d = 0; d < divisors.size(); ++d)
        if (divisors[d]) subtract_rate(value, {*divisors[d], {{"1", unit(0, 0)}}}, k, d, writer);
      if (!value.empty())
        lines.push_back(fmt::format("gradient[{}] = {};  // by {}", k, value, model_.parameters[k]));
    }
  }

  // - dD/dw * q
  void subtract_rate(std::string& value, const RationalFunction& divisor, std::size_t symbol, std::size_t d,
                     CppWriter& writer) const {
    RationalFunction rate = derivative(divisor, symbol);
    if (rate.is_zero()) return;
    for (PolynomialTerm& term : rate.numerator)
      term.coefficient = term.coefficient.front() == '-' ? term.coefficient.substr(1) : "-" + term.coefficient;
    const std::string text = writer.expression(rate);
    const bool one = rate.is_constant() && (text == "1.0" || text == "-1.0");
    add_to_sum(value, one ? fmt::format("{}q_{}", text.front() == '-' ? "-" : "", d)
                          : fmt::format("{} * q_{}", reads_as_sum(rate) ? "(" + text + ")" : text, d));
  }

  // Powers: one of a symbol, or none.
  std::vector<int> unit(std::size_t symbol, int power = 1) const {
    std::vector<int> powers(model_.order.size(), 0);
    powers[symbol] = power;
    return powers;
  }

  const CanonicalModel& model_;
};

}  // namespace

std::vector<std::string> lump_gradient_lines(const CanonicalModel& model, const RationalFunction& definition,
                                             CppWriter& writer) {
  return GradientLines(model).of(definition, writer);
}

}  // namespace secular
