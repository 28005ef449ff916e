#include "codegen/canonical/dimensions.hpp"

#include <algorithm>

namespace secular {
namespace {

using GiNaC::numeric;

// Exponents of the symbols in one monomial. Nothing for a monomial that holds sums.
std::optional<std::map<std::string, int>> monomial_powers(const GiNaC::ex& monomial) {
  std::map<std::string, int> powers;
  const auto add = [&](const GiNaC::ex& factor) {
    const bool power = GiNaC::is_a<GiNaC::power>(factor);
    const GiNaC::ex base = power ? factor.op(0) : factor;
    if (GiNaC::is_a<GiNaC::numeric>(base) || GiNaC::is_a<GiNaC::constant>(base)) return true;
    if (!GiNaC::is_a<GiNaC::symbol>(base) || (power && !GiNaC::is_a<GiNaC::numeric>(factor.op(1)))) return false;
    powers[GiNaC::ex_to<GiNaC::symbol>(base).get_name()] +=
        power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
    return true;
  };
  if (!GiNaC::is_a<GiNaC::mul>(monomial)) return add(monomial) ? std::optional(powers) : std::nullopt;
  for (std::size_t i = 0; i < monomial.nops(); ++i)
    if (!add(monomial.op(i))) return std::nullopt;
  return powers;
}

std::vector<GiNaC::ex> summands(const GiNaC::ex& expression) {
  const GiNaC::ex expanded = expression.expand();
  if (!GiNaC::is_a<GiNaC::add>(expanded)) return {expanded};
  std::vector<GiNaC::ex> terms;
  for (std::size_t i = 0; i < expanded.nops(); ++i) terms.push_back(expanded.op(i));
  return terms;
}

}  // namespace

std::map<std::string, Dimension> symbol_dimensions(const Model& model, const std::vector<TermSum>& equations) {
  const std::size_t modes = model.modes.size(), size = modes + model.excitations.size() + 1, second = size - 1;
  std::map<std::string, Dimension> known;
  for (std::size_t i = 0; i < model.frequency_count(); ++i) {
    Dimension rate(size, 0);
    rate[second] = -1;
    known[model.frequency_name(i)] = rate;
  }
  // Terms with one open symbol fix it; repeated until nothing changes. Products of several open symbols stay open.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k < modes; ++k)
      for (const auto& [product, coefficient] : equations[k].terms()) {
        Dimension needed(size, 0);
        needed[k] = 1;
        needed[second] = -2;
        for (const auto& [factor, power] : product) {
          // What stands beside a coordinate in abs or sgn has its unit.
          for (const auto& [name, weight] : factor.argument) {
            if (std::find(model.parameters.begin(), model.parameters.end(), name) == model.parameters.end() ||
                known.count(name))
              continue;
            Dimension beside(size, 0);
            beside[static_cast<std::size_t>(factor.index)] = 1;
            beside[second] = -factor.derivative;
            known[name] = beside;
            changed = true;
          }
          const bool unitless = factor.kind == Factor::Kind::sign || factor.kind == Factor::Kind::clock_cos ||
                                factor.kind == Factor::Kind::clock_sin;
          if (unitless) continue;
          const auto index = static_cast<std::size_t>(factor.index);
          const std::size_t base = factor.kind == Factor::Kind::excitation ? modes + index : index;
          needed[base] = needed[base] - power;
          needed[second] = needed[second] + power * factor.derivative;
        }
        for (const GiNaC::ex& monomial : summands(coefficient)) {
          const auto powers = monomial_powers(monomial);
          if (!powers) continue;
          Dimension left = needed;
          std::string open;
          int open_power = 0, open_count = 0;
          for (const auto& [name, power] : *powers) {
            const auto entry = known.find(name);
            if (entry == known.end()) {
              open = name;
              open_power = power;
              ++open_count;
              continue;
            }
            for (std::size_t i = 0; i < size; ++i) left[i] = left[i] - power * entry->second[i];
          }
          if (open_count != 1) continue;
          for (numeric& exponent : left) exponent = exponent / open_power;
          known[open] = left;
          changed = true;
        }
      }
  }
  return known;
}

std::optional<Dimension> dimension_of(const GiNaC::ex& expression, const std::map<std::string, Dimension>& symbols,
                                      const Model& model) {
  const std::size_t size = model.frequency_count() + 1;
  // Coordinates of one unit make summands that differ in form, and GiNaC's order of summands is not fixed: the
  // smallest.
  std::optional<Dimension> smallest;
  for (const GiNaC::ex& monomial : summands(expression)) {
    const auto powers = monomial_powers(monomial);
    if (!powers) continue;
    Dimension sum(size, 0);
    const bool all_known = std::all_of(powers->begin(), powers->end(), [&](const auto& entry) {
      const auto symbol = symbols.find(entry.first);
      if (symbol == symbols.end()) return false;
      for (std::size_t i = 0; i < size; ++i) sum[i] = sum[i] + entry.second * symbol->second[i];
      return true;
    });
    if (all_known &&
        (!smallest || std::lexicographical_compare(sum.begin(), sum.end(), smallest->begin(), smallest->end())))
      smallest = sum;
  }
  return smallest;
}

}  // namespace secular
