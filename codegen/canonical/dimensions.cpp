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

// Units of symbols, found out term by term.
class UnitSearch {
 public:
  explicit UnitSearch(const Model& model)
      : model_(model),
        modes_(model.modes.size()),
        size_(modes_ + model.excitations.size() + 1),
        second_(size_ - 1) {
    for (std::size_t i = 0; i < model.frequency_count(); ++i) {
      Dimension rate(size_, 0);
      rate[second_] = -1;
      known_[model.frequency_name(i)] = rate;
    }
  }

  // Terms with one open symbol fix it; repeated until nothing changes. Products of several open symbols stay open.
  std::map<std::string, Dimension> run(const std::vector<TermSum>& equations) && {
    do {
      changed_ = false;
      for (std::size_t k = 0; k < modes_; ++k) {
        Dimension acceleration(size_, 0);
        acceleration[k] = 1;
        acceleration[second_] = -2;
        each_term_has(equations[k], acceleration);
      }
    } while (changed_);
    return std::move(known_);
  }

 private:
  void each_term_has(const TermSum& sum, const Dimension& unit) {
    for (const auto& [product, coefficient] : sum.terms()) {
      Dimension needed = unit;
      const std::optional<Dimension> factors = of_factors(product);
      if (!factors) continue;
      for (std::size_t i = 0; i < size_; ++i) needed[i] = needed[i] - (*factors)[i];
      for (const GiNaC::ex& monomial : summands(coefficient)) fix_open_symbol(monomial, needed);
    }
  }

  void fix_open_symbol(const GiNaC::ex& monomial, Dimension left) {
    const auto powers = monomial_powers(monomial);
    if (!powers) return;
    std::string open;
    int open_power = 0, open_count = 0;
    for (const auto& [name, power] : *powers) {
      const auto entry = known_.find(name);
      if (entry == known_.end()) {
        open = name;
        open_power = power;
        ++open_count;
        continue;
      }
      for (std::size_t i = 0; i < size_; ++i) left[i] = left[i] - power * entry->second[i];
    }
    if (open_count != 1) return;
    for (numeric& exponent : left) exponent = exponent / open_power;
    known_[open] = left;
    changed_ = true;
  }

  std::optional<Dimension> of_factors(const FactorProduct& product) {
    Dimension whole(size_, 0);
    for (const auto& [factor, power] : product) {
      const std::optional<Dimension> one = of_factor(factor);
      if (!one) return std::nullopt;
      for (std::size_t i = 0; i < size_; ++i) whole[i] = whole[i] + power * (*one)[i];
    }
    return whole;
  }

  std::optional<Dimension> of_factor(const Factor& factor) {
    Dimension unit(size_, 0);
    if (factor.kind == Factor::Kind::smooth) return of_function(factor.function);
    const auto index = static_cast<std::size_t>(factor.index);
    // What stands beside a coordinate in abs or sgn has its unit.
    for (const auto& [name, weight] : factor.argument) {
      if (std::find(model_.parameters.begin(), model_.parameters.end(), name) == model_.parameters.end() ||
          known_.count(name))
        continue;
      Dimension beside(size_, 0);
      beside[index] = 1;
      beside[second_] = -factor.derivative;
      known_[name] = beside;
      changed_ = true;
    }
    const bool unitless = factor.kind == Factor::Kind::sign || factor.kind == Factor::Kind::clock_cos ||
                          factor.kind == Factor::Kind::clock_sin;
    if (unitless) return unit;
    unit[factor.kind == Factor::Kind::excitation ? modes_ + index : index] = 1;
    unit[second_] = -factor.derivative;
    return unit;
  }

  // Functions but powers are of numbers and are numbers. What a power is of has one unit, that of the first of its
  // terms whose symbols are all known.
  std::optional<Dimension> of_function(const SmoothFunction& function) {
    Dimension unit(size_, 0);
    if (function.kind() == SmoothKind::power) {
      const std::optional<Dimension> inner = of_sum(function.argument());
      if (!inner) return std::nullopt;
      unit = *inner;
    }
    each_term_has(function.argument(), unit);
    const numeric exponent(function.exponent().first, function.exponent().second);
    for (numeric& power : unit) power = power * exponent;
    return unit;
  }

  std::optional<Dimension> of_sum(const TermSum& sum) {
    for (const auto& [product, coefficient] : sum.terms()) {
      const std::optional<Dimension> factors = of_factors(product);
      const std::optional<Dimension> whole =
          factors ? dimension_of(coefficient, known_, model_) : std::optional<Dimension>();
      if (!whole) continue;
      Dimension unit = *factors;
      for (std::size_t i = 0; i < size_; ++i) unit[i] = unit[i] + (*whole)[i];
      return unit;
    }
    return std::nullopt;
  }

  const Model& model_;
  std::size_t modes_, size_, second_;
  std::map<std::string, Dimension> known_;
  bool changed_ = false;
};

}  // namespace

std::map<std::string, Dimension> symbol_dimensions(const Model& model, const std::vector<TermSum>& equations) {
  return UnitSearch(model).run(equations);
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
