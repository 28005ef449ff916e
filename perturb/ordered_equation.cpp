#include "perturb/ordered_equation.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>

#include "input/input_error.hpp"
#include "perturb/coefficient_text.hpp"
#include "perturb/function_expansion.hpp"

namespace secular {
namespace {

std::string factor_text(const Factor& factor, const Model& model) {
  const auto derived = [&](const std::string& inner) {
    if (factor.derivative == 0) return inner;
    return std::string(factor.derivative == 1 ? "D(" : "D2(") + inner + ")";
  };
  const auto index = static_cast<std::size_t>(factor.index);
  switch (factor.kind) {
    case Factor::Kind::coordinate:
      return derived(model.modes[index].coordinate);
    case Factor::Kind::excitation:
      return derived(model.excitations[index].amplitude + "*cos(" + model.excitations[index].frequency + "*t)");
    case Factor::Kind::clock_cos:
    case Factor::Kind::clock_sin:
      return (factor.kind == Factor::Kind::clock_cos ? "cos(" : "sin(") +
             (factor.multiple == 1 ? "" : std::to_string(factor.multiple) + "*") +
             model.excitations[index].frequency + "*t)";
    case Factor::Kind::absolute:
    case Factor::Kind::sign:
      return (factor.kind == Factor::Kind::absolute ? "abs(" : "sgn(") +
             (factor.compound() ? argument_text(factor.argument) : derived(model.modes[index].coordinate)) + ")";
    case Factor::Kind::smooth:
      return factor.function.text();
  }
  return {};
}

// About rest coefficients are fractions, which cancel over one denominator.
GiNaC::ex collected(const GiNaC::ex& sum, const Model& model) {
  GiNaC::ex expanded = sum.expand();
  return model.rest && expanded.normal().is_zero() ? GiNaC::ex(0) : expanded;
}

bool excited(const FactorProduct& product) {
  return std::any_of(product.begin(), product.end(), [](const auto& entry) {
    const Factor::Kind kind = entry.first.kind;
    return kind == Factor::Kind::excitation || kind == Factor::Kind::clock_cos || kind == Factor::Kind::clock_sin;
  });
}

// Power of eps of one monomial of a coefficient. `unknown` receives a symbol without an order.
class CoefficientOrder {
 public:
  CoefficientOrder(const Model& model, const ResonanceCase& resonance) : model_(model), resonance_(resonance) {
    for (std::size_t i = 0; i < model.frequency_count(); ++i) free_.insert(model.frequency_name(i));
  }

  int of(const GiNaC::ex& monomial, const std::string& where) const {
    int order = 0;
    if (GiNaC::is_a<GiNaC::mul>(monomial)) {
      for (std::size_t i = 0; i < monomial.nops(); ++i) order += of_factor(monomial.op(i), where);
    } else {
      order = of_factor(monomial, where);
    }
    return order;
  }

 private:
  int of_factor(const GiNaC::ex& factor, const std::string& where) const {
    if (GiNaC::is_a<GiNaC::symbol>(factor)) return of_symbol(GiNaC::ex_to<GiNaC::symbol>(factor), where);
    if (GiNaC::is_a<GiNaC::power>(factor) && GiNaC::is_a<GiNaC::symbol>(factor.op(0)) &&
        GiNaC::is_a<GiNaC::numeric>(factor.op(1)))
      return of_symbol(GiNaC::ex_to<GiNaC::symbol>(factor.op(0)), where) *
             GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int();
    for (GiNaC::const_preorder_iterator it = factor.preorder_begin(); it != factor.preorder_end(); ++it)
      if (GiNaC::is_a<GiNaC::symbol>(*it) && of_symbol(GiNaC::ex_to<GiNaC::symbol>(*it), where) != 0)
        throw InputError(model_.file, "case " + resonance_.name,
                         "symbol '" + GiNaC::ex_to<GiNaC::symbol>(*it).get_name() +
                             "' stands in a sum in a denominator (term " + where + ") and carries a power of eps",
                         "give it order 0 or expand the coefficient");
    return 0;
  }

  int of_symbol(const GiNaC::symbol& symbol, const std::string& where) const {
    const std::string name = symbol.get_name();
    if (free_.count(name)) return 0;
    const auto entry = resonance_.order.find(name);
    if (entry != resonance_.order.end()) return entry->second;
    if (resonance_.degree_ordering) return 0;
    throw InputError(model_.file, resonance_.place(),
                     "coefficient symbol '" + name + "' (term " + where + ") has no order",
                     "add " + name + " = 1 (or another power of eps) to this case's order table");
  }

  const Model& model_;
  const ResonanceCase& resonance_;
  std::set<std::string> free_;
};

}  // namespace

std::string argument_text(const std::map<std::string, Factor::Weight>& argument) {
  std::string text;
  for (const auto& [name, weight] : argument) {
    const auto [numerator, denominator] = weight;
    text += numerator < 0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    const std::string size =
        std::to_string(std::abs(numerator)) + (denominator == 1 ? "" : "/" + std::to_string(denominator));
    text += size == "1" ? name : (name == "1" ? size : size + "*" + name);
  }
  return text;
}

std::string to_string(const FactorProduct& product, const Model& model) {
  std::string text;
  for (const auto& [factor, power] : product) {
    const std::string one = factor_text(factor, model);
    const bool compound = factor.kind == Factor::Kind::excitation && factor.derivative == 0;
    text += (text.empty() ? "" : "*") +
            (power == 1 ? one : (compound ? "(" + one + ")" : one) + "^" + std::to_string(power));
  }
  return text.empty() ? "constant" : text;
}

namespace {

// By symbol with an entry in the case's order table, by every coefficient symbol where terms are ordered by degree:
// the lowest order of the terms that it is part of.
class LowestOrders {
 public:
  LowestOrders(const Model& model, const ResonanceCase& resonance) : model_(model), resonance_(resonance) {
    for (std::size_t i = 0; i < model.frequency_count(); ++i) frequencies_.insert(model.frequency_name(i));
  }

  void add(const GiNaC::ex& coefficient, int order, const std::string& term) {
    for (GiNaC::const_preorder_iterator it = coefficient.preorder_begin(); it != coefficient.preorder_end(); ++it) {
      if (!GiNaC::is_a<GiNaC::symbol>(*it)) continue;
      const std::string name = GiNaC::ex_to<GiNaC::symbol>(*it).get_name();
      if (!has_order(name) || resonance_.may_act_nowhere.count(name) == 1) continue;
      const auto [entry, first] = lowest_.try_emplace(name, order, term);
      if (!first && order < entry->second.first) entry->second = {order, term};
    }
  }

  // A symbol of a term that is expanded: it acts where one of the terms that come of it does.
  void expect(const GiNaC::ex& of, const std::string& term) {
    for (GiNaC::const_preorder_iterator it = of.preorder_begin(); it != of.preorder_end(); ++it)
      if (GiNaC::is_a<GiNaC::symbol>(*it)) expected_.try_emplace(GiNaC::ex_to<GiNaC::symbol>(*it).get_name(), term);
  }
  void expect(const TermSum& sum, const std::string& term) {
    for (const auto& [product, coefficient] : sum.terms()) {
      expect(coefficient, term);
      for (const auto& [factor, power] : product)
        if (factor.kind == Factor::Kind::smooth) expect(factor.function.argument(), term);
    }
  }

  // A coefficient whose terms are all beyond the expansion acts nowhere: the derivation would be that of another
  // model, and its certificate would hold.
  void require_within_expansion() const {
    for (const auto& [name, lowest] : lowest_) {
      const auto& [order, term] = lowest;
      if (order <= resonance_.expand_to) continue;
      throw InputError(model_.file, "line " + std::to_string(resonance_.line) + ", case " + resonance_.name,
                       "coefficient '" + name + "' acts nowhere: its lowest term, " + term + ", is of order eps^" +
                           std::to_string(order) + ", and the case expands to eps^" +
                           std::to_string(resonance_.expand_to),
                       (resonance_.order.count(name) == 1 ? "lower the order of " + name + ", " : std::string()) +
                           "set expand_to = " + std::to_string(order) + ", or take the term out of the equation");
    }
    for (const auto& [name, term] : expected_)
      if (has_order(name) && resonance_.may_act_nowhere.count(name) == 0 && lowest_.count(name) == 0)
        throw InputError(model_.file, resonance_.place(),
                         "coefficient '" + name + "' acts nowhere: the series of " + term + " up to eps^" +
                             std::to_string(resonance_.expand_to) + " does not hold it",
                         "raise expand_to, or take the coefficient out of the equation");
  }

 private:
  bool has_order(const std::string& name) const {
    return resonance_.order.count(name) == 1 || (resonance_.degree_ordering && frequencies_.count(name) == 0);
  }

  const Model& model_;
  const ResonanceCase& resonance_;
  std::set<std::string> frequencies_;
  std::map<std::string, std::pair<int, std::string>> lowest_;
  std::map<std::string, std::string> expected_;
};

// The terms of one equation by their powers of eps.
class TermsByOrder {
 public:
  TermsByOrder(const Model& model, const ResonanceCase& resonance, LowestOrders& lowest)
      : model_(model), resonance_(resonance), lowest_(lowest), coefficient_order_(model, resonance) {}

  // Returns the lowest power of eps that a monomial of the coefficient brings.
  int add(const FactorProduct& product, const GiNaC::ex& coefficient, bool by_degree) {
    const std::string where = to_string(product, model_);
    const int base = by_degree ? std::max(0, degree_in_coordinates(product) - 1) : 0;
    const GiNaC::ex expanded = coefficient.expand();
    const bool is_sum = GiNaC::is_a<GiNaC::add>(expanded);
    int least = resonance_.expand_to + 1;
    for (std::size_t i = 0; i < (is_sum ? expanded.nops() : 1); ++i) {
      const GiNaC::ex monomial = is_sum ? expanded.op(i) : expanded;
      const int order = base + coefficient_order_.of(monomial, where);
      if (order < 0)
        throw InputError(model_.file, resonance_.place(),
                         "term " + where + " would be of order eps^" + std::to_string(order),
                         "raise the order of its coefficient symbols");
      by_order_[product][order] += monomial;
      least = std::min(least, order);
    }
    return least;
  }

  // A term with smooth functions: the series of each as far as it counts.
  void add_expanded(const FactorProduct& product, const GiNaC::ex& coefficient) {
    const std::string where = to_string(product, model_);
    TermSum term;
    term.add(product, coefficient);
    lowest_.expect(term, where);
    int outer = 0, counts = -1;  // degree beside the functions; highest one of a term that counts
    TermSum series;
    try {
      for (int degree = resonance_.expand_to + 1; series.empty() && degree <= resonance_.expand_to + beyond;
           ++degree)
        series = FunctionExpansions(degree).of(product, coefficient);
    } catch (const ExpansionTooLong& error) {
      throw InputError(model_.file, resonance_.place(), "term " + where + " " + error.what(),
                       "lower expand_to, or write the function of fewer terms");
    }
    for (const auto& [expanded, part] : series.terms())
      if (add(expanded, part, true) <= resonance_.expand_to)
        counts = std::max(counts, degree_in_coordinates(expanded));
    for (const auto& [factor, power] : product)
      if (factor.kind == Factor::Kind::coordinate) outer += power;
    for (const auto& [factor, power] : product)
      if (factor.kind == Factor::Kind::smooth) note(factor.function, counts - outer);
  }

  // What has not cancelled counts for where coefficients act.
  void tell_lowest_orders() {
    for (const auto& [product, orders] : by_order_)
      for (const auto& [order, coefficient] : orders) {
        const GiNaC::ex sum = collected(coefficient, model_);
        if (!sum.is_zero()) lowest_.add(sum, order, to_string(product, model_));
      }
  }

  std::map<FactorProduct, std::map<int, GiNaC::ex>>& by_order() { return by_order_; }
  const std::vector<ExpandedFunction>& expanded() const { return expanded_; }

 private:
  static constexpr int beyond =
      8;  // how much later a series may begin for its coefficients to be named in a message

  void note(const SmoothFunction& function, int degree) {
    const auto known = std::find_if(expanded_.begin(), expanded_.end(),
                                    [&](const ExpandedFunction& e) { return e.function == function; });
    if (known == expanded_.end())
      expanded_.push_back({function, std::max(0, degree)});
    else
      known->degree = std::max(known->degree, degree);
  }

  const Model& model_;
  const ResonanceCase& resonance_;
  LowestOrders& lowest_;
  CoefficientOrder coefficient_order_;
  std::map<FactorProduct, std::map<int, GiNaC::ex>> by_order_;
  std::vector<ExpandedFunction> expanded_;
};

bool has_function(const FactorProduct& product) {
  return std::any_of(product.begin(), product.end(),
                     [](const auto& entry) { return entry.first.kind == Factor::Kind::smooth; });
}

// "(k + omega0^2)*x" for the linear part of an equation of order 0.
std::string linear_part(const GiNaC::ex& coefficient, const std::string& coordinate) {
  const GiNaC::ex sum = coefficient.expand();
  if (sum.is_zero()) return "0";
  const std::optional<std::vector<std::string>> terms = sum_terms(sum);
  if (!terms) return "something else";
  const std::string text = joined_terms(*terms);
  return (terms->size() > 1 ? "(" + text + ")*" : text + "*") + coordinate;
}

[[noreturn]] void refuse_leading_term(const Model& model, const ResonanceCase& resonance, std::size_t k,
                                      const FactorProduct& product, const GiNaC::ex& excess) {
  const std::string& x = model.modes[k].coordinate;
  const std::string oscillator = "D2(" + x + ") + " + model.modes[k].frequency + "^2*" + x;
  const Factor position{Factor::Kind::coordinate, static_cast<int>(k), 0, 1};
  if (product == FactorProduct{{position, 1}})
    throw InputError(model.file, resonance.place(),
                     "equation of '" + x + "': its linear part at order eps^0 is " +
                         linear_part(excess + GiNaC::pow(model.frequency(k), 2), x) + ", not " +
                         model.modes[k].frequency + "^2*" + x,
                     "write the equation so that functions and terms of order 0 leave " + oscillator +
                         " alone, as c*(sin(" + x + ") - " + x + "), or give a coefficient a positive order");
  if (product.empty())
    throw InputError(
        model.file, resonance.place(),
        "equation of '" + x + "': a constant force of order eps^0 moves the rest position away from " + x + " = 0",
        "write reference = \"rest\" at the head of the model file (above the first [[...]]): the rest position is "
        "found and " +
            x + " counts from there; or give the constant a positive order");
  throw InputError(model.file, resonance.place(),
                   "equation of '" + x + "': term " + to_string(product, model) +
                       " at order eps^0 is not part of the linear oscillator " + oscillator,
                   "give its coefficient a positive order, or correct the equation's linear part");
}

}  // namespace

std::vector<OrderedEquation> ordered_equations(const Model& model, const ResonanceCase& resonance) {
  LowestOrders lowest(model, resonance);
  const std::vector<TermSum> equations = equations_of_motion(model);
  std::vector<OrderedEquation> ordered(equations.size());
  for (std::size_t k = 0; k < equations.size(); ++k) {
    TermsByOrder terms(model, resonance, lowest);
    for (const auto& [product, coefficient] : equations[k].terms()) {
      if (!resonance.excited && excited(product)) continue;
      if (has_function(product))
        terms.add_expanded(product, coefficient);
      else
        terms.add(product, coefficient, resonance.degree_ordering);
    }
    terms.tell_lowest_orders();
    ordered[k].expanded = terms.expanded();
    auto& by_order = terms.by_order();
    const Factor position{Factor::Kind::coordinate, static_cast<int>(k), 0, 1};
    const Factor acceleration{Factor::Kind::coordinate, static_cast<int>(k), 2, 1};
    by_order[{{position, 1}}][0] -= GiNaC::pow(model.frequency(k), 2);
    by_order[{{acceleration, 1}}][0] -= 1;
    for (const auto& [product, orders] : by_order)
      for (const auto& [order, sum] : orders) {
        const GiNaC::ex coefficient = collected(sum, model);
        if (coefficient.is_zero()) continue;
        const bool hard_forcing =
            excited(product) && std::all_of(product.begin(), product.end(), [](const auto& entry) {
              return entry.first.kind != Factor::Kind::coordinate && !entry.first.nonsmooth();
            });
        if (order == 0 && !hard_forcing) refuse_leading_term(model, resonance, k, product, coefficient);
        if (order > resonance.expand_to) continue;
        ordered[k].right_hand_side.push_back({product, order, (-coefficient).expand()});
      }
  }
  lowest.require_within_expansion();
  return ordered;
}

}  // namespace secular
