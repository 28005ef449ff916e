#include "perturb/automatic_order.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <set>

#include "input/input_error.hpp"
#include "perturb/function_expansion.hpp"
#include "perturb/ordered_equation.hpp"
#include "perturb/resonance.hpp"
#include "perturb/term_sum.hpp"

namespace secular {
namespace {

/// Order at which the first nonlinear terms come into the modulation.
int balancing_order(const Model& model, const ResonanceCase& resonance) {
  const bool is_quadratic =
      std::any_of(resonance.relations.begin(), resonance.relations.end(), [&](const ResonanceRelation& relation) {
        const auto modes = static_cast<std::ptrdiff_t>(model.modes.size());
        const auto begin = relation.multiples.begin();
        const bool is_internal =
            std::all_of(begin + modes, relation.multiples.end(), [](int multiple) { return multiple == 0; });
        return is_internal && std::accumulate(begin, begin + modes, 0,
                                              [](int sum, int multiple) { return sum + std::abs(multiple); }) == 3;
      });
  return std::min(is_quadratic ? 1 : 2, resonance.expand_to);
}

class OrderChoice {
 public:
  OrderChoice(const Model& model, ResonanceCase& resonance)
      : model_(model),
        resonance_(resonance),
        lattice_(model, resonance),
        balance_(balancing_order(model, resonance)) {}

  void run() {
    const std::vector<TermSum> equations = equations_of_motion(model_);
    for (const bool bears : {false, true})
      for (std::size_t k = 0; k < equations.size(); ++k)
        for (const auto& [product, coefficient] : equations[k].terms()) {
          if (!resonance_.excited && is_excited(product)) continue;
          const int own = wanted(product, k);
          const GiNaC::ex sum = coefficient.expand();
          const bool is_sum = GiNaC::is_a<GiNaC::add>(sum);
          for (std::size_t i = 0; i < (is_sum ? sum.nops() : 1); ++i) {
            const std::vector<std::string> names = coefficients(is_sum ? sum.op(i) : sum);
            if (bears && own > 0) bear(names, own, product);
            if (!bears && own == 0 && !is_excited(product)) fixed_.insert(names.begin(), names.end());
          }
        }
  }

 private:
  static bool is_excited(const FactorProduct& product) {
    return std::any_of(product.begin(), product.end(), [](const auto& entry) {
      const Factor::Kind kind = entry.first.kind;
      return kind == Factor::Kind::excitation || kind == Factor::Kind::clock_cos || kind == Factor::Kind::clock_sin;
    });
  }

  // Beyond the degree's order.
  int wanted(const FactorProduct& product, std::size_t equation) const {
    const int degree = degree_in_coordinates(product);
    bool is_nonsmooth = false;
    for (const auto& [factor, power] : product) {
      if (factor.kind == Factor::Kind::smooth) return 0;
      is_nonsmooth = is_nonsmooth || factor.nonsmooth();
    }
    if (is_nonsmooth) return std::max(0, resonance_.expand_to - std::max(0, degree - 1));
    if (is_excited(product)) return is_resonant(product, equation) ? balance_ : std::min(degree, 1);
    if (degree != 1) return 0;
    const Factor& only = product.begin()->first;
    if (only.derivative == 2) return 0;
    const bool is_own = static_cast<std::size_t>(only.index) == equation;
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
      if (const auto known = resonance_.order.find(name); known != resonance_.order.end() && known->second >= order)
        return;
    const auto free =
        std::find_if(names.begin(), names.end(), [&](const std::string& name) { return !fixed_.contains(name); });
    if (free == names.end())
      throw InputError(model_.file, resonance_.place(),
                       "order = \"auto\" finds none for the term " + to_string(product, model_) + ": all of its " +
                           "coefficients stand in terms of order eps^0, too",
                       "write a table, as order = { " + names.front() + " = " + std::to_string(order) + " }");
    resonance_.order[*free] = order;
  }

  const Model& model_;
  ResonanceCase& resonance_;
  ResonanceLattice lattice_;
  int balance_;
  std::set<std::string> fixed_;  // at order 0: of the oscillator and its law; a force may have any order
};

}  // namespace

void choose_orders(const Model& model, ResonanceCase& resonance) {
  resonance.degree_ordering = true;
  OrderChoice(model, resonance).run();
}

}  // namespace secular
