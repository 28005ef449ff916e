#include "perturb/automatic_order.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "input/input_error.hpp"
#include "perturb/function_expansion.hpp"
#include "perturb/ordered_equation.hpp"
#include "perturb/resonance.hpp"
#include "perturb/rest_position.hpp"
#include "perturb/term_sum.hpp"

namespace secular {
namespace {

bool is_excited(const FactorProduct& product) {
  return std::any_of(product.begin(), product.end(), [](const auto& entry) {
    const Factor::Kind kind = entry.first.kind;
    return kind == Factor::Kind::excitation || kind == Factor::Kind::clock_cos || kind == Factor::Kind::clock_sin;
  });
}

bool holds(const FactorProduct& product, bool (*wanted)(const Factor&)) {
  return std::any_of(product.begin(), product.end(), [&](const auto& entry) { return wanted(entry.first); });
}
bool is_smooth(const Factor& factor) {
  return factor.kind == Factor::Kind::smooth;
}
bool is_nonsmooth(const Factor& factor) {
  return factor.nonsmooth();
}
// x*D(x), sinh(D(x)).
bool has_velocity(const FactorProduct& product) {
  return std::any_of(product.begin(), product.end(), [](const auto& entry) {
    const Factor& factor = entry.first;
    if (factor.kind == Factor::Kind::coordinate) return factor.derivative == 1;
    if (!is_smooth(factor)) return false;
    const auto& argument = factor.function.argument().terms();
    return std::any_of(argument.begin(), argument.end(), [](const auto& term) { return has_velocity(term.first); });
  });
}

std::vector<GiNaC::ex> monomials(const GiNaC::ex& coefficient) {
  const GiNaC::ex sum = coefficient.expand();
  if (!GiNaC::is_a<GiNaC::add>(sum)) return {sum};
  return {sum.begin(), sum.end()};
}

void add_symbols(const GiNaC::ex& e, std::set<std::string>& names) {
  for (GiNaC::const_preorder_iterator it = e.preorder_begin(); it != e.preorder_end(); ++it)
    if (GiNaC::is_a<GiNaC::symbol>(*it)) names.insert(GiNaC::ex_to<GiNaC::symbol>(*it).get_name());
}

// Inside a function or a sum in a denominator powers of eps cannot be told.
void add_enclosed(const GiNaC::ex& monomial, std::set<std::string>& names) {
  const auto one = [&](const GiNaC::ex& factor) {
    const bool plain = GiNaC::is_a<GiNaC::symbol>(factor) ||
                       (GiNaC::is_a<GiNaC::power>(factor) && GiNaC::is_a<GiNaC::symbol>(factor.op(0)));
    if (!plain) add_symbols(factor, names);
  };
  if (!GiNaC::is_a<GiNaC::mul>(monomial)) return one(monomial);
  for (const GiNaC::ex& factor : monomial) one(factor);
}
void add_enclosed(const TermSum& argument, std::set<std::string>& names) {
  for (const auto& [product, coefficient] : argument.terms()) {
    add_symbols(coefficient, names);
    for (const auto& [factor, power] : product)
      if (is_smooth(factor)) add_enclosed(factor.function.argument(), names);
  }
}

// Without smooth functions, which are expanded as far as the case is.
std::vector<TermSum> expanded(const std::vector<TermSum>& equations, const ResonanceCase& resonance) {
  std::vector<TermSum> series;
  for (const TermSum& equation : equations) {
    TermSum& sum = series.emplace_back();
    FunctionExpansions expansions(resonance.expand_to + 1);
    for (const auto& [product, coefficient] : equation.terms()) {
      if (!resonance.excited && is_excited(product)) continue;
      try {
        if (holds(product, is_smooth))
          sum += expansions.of(product, coefficient);
        else
          sum.add(product, coefficient);
      } catch (const ExpansionTooLong&) {  // the expansion says it
      }
    }
  }
  return series;
}

class OrderChoice {
 public:
  OrderChoice(const Model& model, ResonanceCase& resonance)
      : model_(model),
        resonance_(resonance),
        lattice_(model, resonance),
        equations_(equations_of_motion(model)),
        series_(expanded(equations_, resonance)),
        balance_(balancing_order()) {}

  void run() {
    fix();
    for (std::size_t k = 0; k < series_.size(); ++k)
      for (const auto& [product, coefficient] : series_[k].terms())
        if (const int own = wanted(product, k); own > 0)
          for (const GiNaC::ex& monomial : monomials(coefficient)) bear(coefficients(monomial), own, product);
    if (!without_.empty()) refuse();
  }

 private:
  // The order at which the first nonlinear terms change frequency or damping with amplitude, see choose_orders().
  int balancing_order() const {
    int first = resonance_.expand_to;
    bool nonlinear = false;
    for (std::size_t k = 0; k < series_.size(); ++k)
      for (const auto& [product, coefficient] : series_[k].terms()) {
        const int degree = degree_in_coordinates(product);
        if (is_excited(product)) continue;
        nonlinear = nonlinear || degree > 1 || holds(product, is_nonsmooth);
        if (degree < 2 || holds(product, is_nonsmooth)) continue;
        const bool at_once = degree % 2 == 1 || is_resonant(product, k);
        first = std::min(first, at_once ? degree - 1 : 2 * (degree - 1));
      }
    return nonlinear ? first : std::min(2, resonance_.expand_to);
  }

  // What has to be at order 0: the oscillator and its law. A force may have any order; damping by functions or,
  // about rest, that depends on the position, is ordered by degree in any table, and its first term damps.
  void fix() {
    if (model_.rest) {
      fixed_.insert(model_.rest->symbols.begin(), model_.rest->symbols.end());
      for (const RestValue& value : model_.rest->values) fixed_.insert(value.name);
    }
    for (std::size_t k = 0; k < equations_.size(); ++k)
      for (const auto& [product, coefficient] : equations_[k].terms()) {
        for (const auto& [factor, power] : product)
          if (is_smooth(factor)) add_enclosed(factor.function.argument(), fixed_);
        const bool is_law = !is_excited(product) &&
                            !(has_velocity(product) && (model_.rest || holds(product, is_smooth))) &&
                            (holds(product, is_smooth) || wanted(product, k) == 0);
        if (is_law) add_symbols(coefficient, fixed_);
        for (const GiNaC::ex& monomial : monomials(coefficient)) add_enclosed(monomial, fixed_);
        if (model_.rest && has_velocity(product) && !is_excited(product))
          for (const std::string& name : coefficients(coefficient))
            damping_degree_[name] = std::max(damping_degree_[name], degree_in_coordinates(product));
      }
  }

  // Beyond the degree's order; of a product without smooth functions.
  int wanted(const FactorProduct& product, std::size_t equation) const {
    const int degree = degree_in_coordinates(product);
    if (holds(product, is_nonsmooth)) return std::max(0, resonance_.expand_to - std::max(0, degree - 1));
    if (is_excited(product)) return is_resonant(product, equation) ? balance_ : std::min(degree, 1);
    if (degree != 1) return 0;
    const Factor& only = product.begin()->first;
    if (only.derivative == 2) return 0;
    const bool is_own = static_cast<std::size_t>(only.index) == equation;
    if (model_.rest && is_own && only.derivative == 0) return 0;  // it is that of the natural frequency
    return is_own || is_resonant(product, equation) ? balance_ : std::min(1, resonance_.expand_to);
  }

  // Whether a product of the modes' and the excitations' own motions holds the equation's natural frequency.
  bool is_resonant(const FactorProduct& product, std::size_t equation) const {
    std::set<Phase> phases = {Phase(model_.frequency_count(), 0)};
    for (const auto& [factor, power] : product) {
      const bool is_coordinate = factor.kind == Factor::Kind::coordinate;
      const std::size_t place = static_cast<std::size_t>(factor.index) + (is_coordinate ? 0 : model_.modes.size());
      const int multiple = is_coordinate || factor.kind == Factor::Kind::excitation ? 1 : factor.multiple;
      for (int i = 0; i < power; ++i) {
        std::set<Phase> next;
        for (const Phase& phase : phases)
          for (const int sense : {-multiple, multiple}) {
            Phase moved = phase;
            moved[place] += sense;
            next.insert(std::move(moved));
          }
        phases = std::move(next);
      }
    }
    return std::any_of(phases.begin(), phases.end(), [&](Phase phase) {
      phase[equation] -= 1;
      return std::all_of(phase.begin(), phase.end(), [](int m) { return m == 0; }) || is_slow(phase);
    });
  }

  bool is_slow(const Phase& phase) const {
    try {
      return lattice_.slow_multipliers(phase).has_value();
    } catch (const InputError&) {  // a fraction of a relation: the expansion says it, if it comes to that
      return false;
    }
  }

  std::vector<std::string> coefficients(const GiNaC::ex& monomial) const {
    std::set<std::string> present;
    for (GiNaC::const_preorder_iterator it = monomial.preorder_begin(); it != monomial.preorder_end(); ++it)
      if (GiNaC::is_a<GiNaC::symbol>(*it)) present.insert(GiNaC::ex_to<GiNaC::symbol>(*it).get_name());
    std::vector<std::string> names;  // as the model has them: the order of GiNaC's terms changes from run to run
    std::copy_if(model_.parameters.begin(), model_.parameters.end(), std::back_inserter(names),
                 [&](const std::string& name) { return present.contains(name); });
    return names;
  }

  void bear(const std::vector<std::string>& names, int order, const FactorProduct& product) {
    if (names.empty()) return;  // of frequencies alone: the oscillator, or a message of the expansion
    for (const std::string& name : names)
      if (const auto known = resonance_.order.find(name);
          known != resonance_.order.end() && known->second >= within_expansion(name, order))
        return;
    const auto free =
        std::find_if(names.begin(), names.end(), [&](const std::string& name) { return !fixed_.contains(name); });
    if (free != names.end())
      resonance_.order[*free] = within_expansion(*free, order);
    else
      without_.push_back({names, order, to_string(product, model_)});
  }

  // Damping that depends on the position is not to be lost beyond the expansion.
  int within_expansion(const std::string& name, int order) const {
    const auto damping = damping_degree_.find(name);
    if (damping == damping_degree_.end()) return order;
    return std::min(order, std::max(1, resonance_.expand_to + 1 - damping->second));
  }

  // With all orders that were found, and for each term without one that of a coefficient of its own. In a table
  // without order by degree all others have that of their terms, too.
  std::optional<std::string> table_that_works() const {
    ResonanceCase by_hand = resonance_;
    by_hand.degree_ordering = model_.rest != nullptr;
    if (!by_hand.degree_ordering)
      for (std::size_t k = 0; k < equations_.size(); ++k)
        for (const auto& [product, coefficient] : equations_[k].terms())
          for (const std::string& name : coefficients(coefficient)) {
            const int own = std::max(0, degree_in_coordinates(product) - 1);
            const auto [entry, first] = by_hand.order.try_emplace(name, own);
            if (!first && resonance_.order.count(name) == 0) entry->second = std::min(entry->second, own);
          }
    return completed(by_hand, 0);
  }

  std::optional<std::string> completed(const ResonanceCase& table, std::size_t next) const {
    if (next == without_.size()) {
      try {
        ordered_equations(model_, table);
      } catch (const InputError&) {
        return std::nullopt;
      }
      std::string text;
      for (const auto& [name, order] : table.order)
        text += (text.empty() ? "" : ", ") + name + " = " + std::to_string(order);
      return "{ " + text + " }";
    }
    const Without& term = without_[next];
    for (const std::string& name : term.names) {
      ResonanceCase tried = table;
      int& order = tried.order[name];
      order = std::max(order, term.order);
      if (auto found = completed(tried, next + 1)) return found;
    }
    return std::nullopt;
  }

  [[noreturn]] void refuse() const {
    const std::optional<std::string> table = table_that_works();
    throw InputError(
        model_.file, resonance_.place(),
        "order = \"auto\" finds none for the term " + without_.front().term +
            ": all of its coefficients stand in terms of order eps^0, too",
        table ? "write a table, as order = " + *table : std::string("give that term a coefficient of its own"));
  }

  struct Without {
    std::vector<std::string> names;
    int order = 0;
    std::string term;
  };

  const Model& model_;
  ResonanceCase& resonance_;
  ResonanceLattice lattice_;
  std::vector<TermSum> equations_, series_;
  int balance_;
  std::set<std::string> fixed_;                // at order 0
  std::map<std::string, int> damping_degree_;  // about rest: highest of terms with a velocity
  std::vector<Without> without_;
};

}  // namespace

void choose_orders(const Model& model, ResonanceCase& resonance) {
  resonance.degree_ordering = true;
  OrderChoice(model, resonance).run();
}

}  // namespace secular
