#include "perturb/rest_position.hpp"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "input/input_error.hpp"
#include "perturb/coefficient_text.hpp"
#include "perturb/moved_formulas.hpp"
#include "perturb/smooth_reading.hpp"
#include "perturb/term_sum.hpp"

namespace secular {
namespace {

const Factor position_of(std::size_t mode) {
  return {Factor::Kind::coordinate, static_cast<int>(mode), 0, 1};
}

// Whether a force is left at rest; one without bounds is, too.
bool is_pushed(const TermSum& equation) {
  try {
    return !value_at_rest(equation).normal().is_zero();
  } catch (const std::exception&) {  // GiNaC's division by zero
    return true;
  }
}

// Which coefficients may follow from the rest position, and which of them are taken first.
class Followers {
 public:
  Followers(const Model& stated, const std::vector<TermSum>& equations) : stated_(stated) {
    for (std::size_t k = 0; k < equations.size(); ++k)
      for (const auto& [product, coefficient] : equations[k].terms())
        for (const std::string& name : stated.parameters)
          if (coefficient.has(stated.symbols.at(name))) raise(name, rank(product));
    for (const TermSum& equation : equations)
      for (const auto& [product, ignored] : equation.terms())
        for (const auto& [factor, power] : product) {
          for (const auto& [name, weight] : factor.argument) raise(name, never);
          if (factor.kind == Factor::Kind::smooth) exclude_arguments(factor.function.argument());
        }
  }

  // The one that the equation e = 0, which is a polynomial, gives.
  std::optional<std::string> of(const GiNaC::ex& e, const std::set<std::string>& taken) const {
    std::optional<std::string> best;
    for (const std::string& name : stated_.parameters) {
      const auto entry = rank_.find(name);
      if (entry == rank_.end() || entry->second == never || taken.count(name) != 0) continue;
      if (e.degree(stated_.symbols.at(name)) != 1) continue;
      if (!best || entry->second < rank_.at(*best)) best = name;
    }
    return best;
  }

 private:
  static constexpr int load = 0, linear = 1, other = 2, never = 3;

  static int rank(const FactorProduct& product) {
    if (product.empty()) return load;
    for (const auto& [factor, power] : product)
      if (factor.kind != Factor::Kind::smooth &&
          (factor.kind != Factor::Kind::coordinate || factor.derivative != 0))
        return never;
    const auto& [factor, power] = *product.begin();
    return product.size() == 1 && power == 1 && factor.kind == Factor::Kind::coordinate ? linear : other;
  }
  void raise(const std::string& name, int to) {
    const auto [entry, first] = rank_.try_emplace(name, to);
    // A load alone is taken before what is stiffness, too.
    if (!first) entry->second = to == never || entry->second == never ? never : combined(entry->second, to);
  }
  static int combined(int a, int b) {
    if (a == b) return a;
    return a == linear || b == linear ? linear : other;
  }
  void exclude_arguments(const TermSum& argument) {
    for (const auto& [product, coefficient] : argument.terms()) {
      for (const std::string& name : stated_.parameters)
        if (coefficient.has(stated_.symbols.at(name))) raise(name, never);
      for (const auto& [factor, power] : product)
        if (factor.kind == Factor::Kind::smooth) exclude_arguments(factor.function.argument());
    }
  }

  const Model& stated_;
  std::map<std::string, int> rank_;
};

class AboutRest {
 public:
  AboutRest(Model stated, const std::vector<std::string>& asked)
      : stated_(std::move(stated)),
        taken_(stated_.symbols),
        rest_(asked),
        position_(std::make_shared<RestPosition>()) {}

  Model run() {
    stated_.rests_at_zero = false;
    find_moved();
    solve();
    MovedFormulas formulas(stated_, rest_, taken_);
    for (HeldCoefficient& held : position_->held) {
      held.text = rational_text(held.value);
      formulas.replace(held.name, parse_expression({held.text, stated_.file, 1}));
    }
    Model model = formulas.moved(stated_);
    position_->values = formulas.values();
    position_->symbols = rest_;
    position_->stated = values_;
    model.rests_at_zero = true;
    model.rest = position_;
    return model;
  }

 private:
  [[noreturn]] void refuse(const std::string& wrong, const std::string& right) const {
    throw InputError(stated_.file, "reference = \"rest\"", wrong, right);
  }

  std::string name_for(std::size_t mode) const {
    const std::string name = stated_.modes[mode].coordinate + "_rest";
    if (taken(name))
      refuse("the name " + name + " of the rest position of '" + stated_.modes[mode].coordinate + "' is taken",
             "rename that symbol, or name the rest position in its [[mode]], as rest = \"" + name + "_position\"");
    return name;
  }

  bool taken(const std::string& name) const {
    return stated_.symbols.contains(name) || std::any_of(stated_.modes.begin(), stated_.modes.end(),
                                                         [&](const Mode& mode) { return mode.coordinate == name; });
  }

  // A coordinate moves if a force is left on it where those that move are at rest.
  void find_moved() {
    for (std::size_t k = 0; k < rest_.size(); ++k)
      if (!rest_[k].empty()) declare(k);
    for (bool more = true; more;) {
      more = false;
      MovedFormulas formulas(stated_, rest_, taken_);
      Model moved = formulas.moved(stated_);
      for (const RestValue& value : formulas.values()) moved.symbols.add_real(value.name);
      equations_ = equations_of_motion(moved);
      values_ = moved.symbols;
      for (std::size_t k = 0; k < rest_.size(); ++k) {
        if (!rest_[k].empty() || !is_pushed(equations_[k])) continue;
        rest_[k] = name_for(k);
        declare(k);
        more = true;
      }
    }
    if (std::all_of(rest_.begin(), rest_.end(), [](const std::string& name) { return name.empty(); }))
      refuse(
          "no constant force moves a coordinate away from zero",
          "leave reference out, or name the rest position of a coordinate that rests elsewhere in its [[mode]], as "
          "rest = \"" +
              stated_.modes.front().coordinate + "_rest\"");
  }

  void declare(std::size_t mode) {
    if (taken(rest_[mode]))
      refuse(
          "the name " + rest_[mode] + " of the rest position of '" + stated_.modes[mode].coordinate + "' is taken",
          "choose a name that is no symbol of the equations");
    stated_.symbols.add_real(rest_[mode]);
  }

  void solve() {
    RestPosition& p = *position_;
    const std::vector<TermSum> raw = equations_of_motion(stated_);
    const Followers followers(stated_, raw);
    p.frequency.assign(rest_.size(), "");
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      Factor acceleration = position_of(k);
      acceleration.derivative = 2;
      p.force.push_back(value_at_rest(equations_[k]));
      p.stiffness.push_back(value_at_rest(equations_[k].partial(position_of(k))));
      p.inertia.push_back(value_at_rest(equations_[k].partial(acceleration)));
      if (p.inertia[k].normal().is_zero())
        refuse("equation of '" + stated_.modes[k].coordinate + "' has no inertia at rest",
               "it holds D2(" + stated_.modes[k].coordinate + ")");
    }
    for (std::size_t k = 0; k < rest_.size(); ++k)
      if (!rest_[k].empty()) follow(p.force[k], k, "the load that holds it there", followers);
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      const Mode& mode = stated_.modes[k];
      const GiNaC::ex w = stated_.symbols.at(mode.frequency);
      const GiNaC::ex excess = p.stiffness[k] - GiNaC::pow(w, 2) * p.inertia[k];
      if (excess.normal().is_zero()) continue;
      for (const GiNaC::ex* part : {&p.force[k], &p.stiffness[k]})
        if (part->has(w))
          refuse("frequency " + mode.frequency + " of '" + mode.coordinate +
                     "' stands in its equation, and the rest position changes the stiffness",
                 mode.frequency +
                     " is the natural frequency of small oscillations about rest: give the stiffness as "
                     "stated a symbol of its own, as k*" +
                     mode.coordinate);
      p.frequency[k] = mode.frequency;
      follow(excess, k, "the stiffness that oscillates at " + mode.frequency, followers);
    }
  }

  // One more coefficient from e = 0.
  void follow(const GiNaC::ex& e, std::size_t k, const std::string& what, const Followers& followers) {
    RestPosition& p = *position_;
    const GiNaC::ex polynomial = with_held(e).numer().expand();
    if (polynomial.is_zero()) return;
    std::set<std::string> known;
    for (const HeldCoefficient& held : p.held) known.insert(held.name);
    const std::optional<std::string> name = followers.of(polynomial, known);
    if (!name)
      refuse("equation of '" + stated_.modes[k].coordinate + "' has no coefficient that gives " + what,
             "give the constant force and the stiffness symbols of their own, which stand in no damping, no "
             "excitation "
             "and inside no function");
    const GiNaC::ex& symbol = stated_.symbols.at(*name);
    const GiNaC::ex value = (-polynomial.coeff(symbol, 0) / polynomial.coeff(symbol, 1)).normal();
    for (HeldCoefficient& held : p.held) held.value = held.value.subs(symbol == value).normal();
    p.held.push_back({*name, value, {}});
  }

  GiNaC::ex with_held(const GiNaC::ex& e) const {
    GiNaC::exmap values;
    for (const HeldCoefficient& held : position_->held) values[stated_.symbols.at(held.name)] = held.value;
    return e.subs(values).normal();
  }

  Model stated_;
  SymbolTable taken_;   // as stated
  SymbolTable values_;  // with values of functions at rest
  std::vector<std::string> rest_;
  std::shared_ptr<RestPosition> position_;
  std::vector<TermSum> equations_;
};

}  // namespace

bool RestPosition::is_value(const std::string& name) const {
  return std::any_of(values.begin(), values.end(), [&](const RestValue& v) { return v.name == name; });
}

bool RestPosition::holds(const std::string& name) const {
  return std::any_of(held.begin(), held.end(), [&](const HeldCoefficient& h) { return h.name == name; });
}

Model about_rest(Model stated, const std::vector<std::string>& asked) {
  return AboutRest(std::move(stated), asked).run();
}

}  // namespace secular
