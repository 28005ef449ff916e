// Where a model rests, in numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "input/input_error.hpp"
#include "perturb/formula_value.hpp"
#include "perturb/rest_position.hpp"

namespace secular {
namespace {

constexpr int most_newton_steps = 50, most_downhill_steps = 200;
// Newton's method has converged where a step is below rounding of the position.
constexpr double newton_rounding = 1e-13;
// The load grows in steps between these shares of it.
constexpr double first_load_step = 0.05, least_load_step = 1e-7;
// A position is refined where load steps end; that of a step may be this far from the tangent's, over the step.
constexpr double largest_deviation = 0.5;

using Numbers = std::map<std::string, double>;

// NaN at a pole and outside the domain of a function.
double number_at(const GiNaC::ex& e, const GiNaC::exmap& symbols) {
  try {
    const GiNaC::ex number = e.subs(symbols).evalf();
    if (GiNaC::is_a<GiNaC::numeric>(number) && GiNaC::ex_to<GiNaC::numeric>(number).is_real())
      return GiNaC::ex_to<GiNaC::numeric>(number).to_double();
  } catch (const std::exception&) {  // a pole
  }
  return std::numeric_limits<double>::quiet_NaN();
}

GiNaC::ex function_of(const RestValue& value, const GiNaC::ex& g) {
  switch (value.kind) {
    case SmoothKind::sine:
      return GiNaC::sin(g);
    case SmoothKind::cosine:
      return GiNaC::cos(g);
    case SmoothKind::tangent:
      return GiNaC::tan(g);
    case SmoothKind::exponential:
      return GiNaC::exp(g);
    case SmoothKind::hyperbolic_sine:
      return GiNaC::sinh(g);
    case SmoothKind::hyperbolic_cosine:
      return GiNaC::cosh(g);
    case SmoothKind::hyperbolic_tangent:
      return GiNaC::tanh(g);
    case SmoothKind::logarithm:
      return GiNaC::log(g);
    case SmoothKind::arc_tangent:
      return GiNaC::atan(g);
    case SmoothKind::power:
      break;
  }
  return GiNaC::pow(g, GiNaC::numeric(value.exponent.first, value.exponent.second));
}

// The symbols of values, with the functions that they stand for.
GiNaC::exmap functions_at_rest(const RestPosition& rest) {
  GiNaC::exmap functions;
  for (const RestValue& value : rest.values) {
    const GiNaC::ex argument = formula_value(
        value.argument, {}, [&](const Expression& symbol) -> GiNaC::ex { return rest.stated.at(symbol.text); });
    functions[rest.stated.at(value.name)] = function_of(value, argument.subs(functions));
  }
  return functions;
}

// The forces at rest at given coefficients, as functions of the position.
class StaticForces {
 public:
  StaticForces(const RestPosition& rest, const Numbers& values) {
    GiNaC::exmap known;
    for (const std::string& name : rest.stated.names())
      if (std::find(rest.symbols.begin(), rest.symbols.end(), name) == rest.symbols.end())
        if (const auto entry = values.find(name); entry != values.end())
          known[rest.stated.at(name)] = GiNaC::numeric(entry->second);
    const GiNaC::exmap functions = functions_at_rest(rest);
    for (std::size_t k = 0; k < rest.symbols.size(); ++k)
      if (!rest.symbols[k].empty()) {
        modes_.push_back(k);
        unknowns_.push_back(rest.stated.at(rest.symbols[k]));
        forces_.push_back(rest.force[k].subs(functions).subs(known));
      }
    for (const GiNaC::ex& force : forces_)
      for (const GiNaC::ex& x : unknowns_) slopes_.push_back(force.diff(GiNaC::ex_to<GiNaC::symbol>(x)));
    for (std::size_t k = 0; k < rest.symbols.size(); ++k)
      squares_.push_back((rest.stiffness[k] / rest.inertia[k]).subs(functions).subs(known));
    for (const GiNaC::ex& inertia : rest.inertia) inertia_.push_back(inertia.subs(functions).subs(known));
  }

  std::size_t size() const { return modes_.size(); }
  std::size_t mode(std::size_t i) const { return modes_[i]; }

  std::vector<double> at(const std::vector<double>& x) const { return values(forces_, x); }
  // Squares of natural frequencies, by mode.
  std::vector<double> squares(const std::vector<double>& x) const { return values(squares_, x); }
  std::vector<double> inertia(const std::vector<double>& x) const { return values(inertia_, x); }

  // Solves (slopes(x) + shift * inertia(x)) * step = right; nothing where that is singular. `sign`: of the
  // determinant.
  std::optional<std::vector<double>> solved(const std::vector<double>& x, std::vector<double> right, int& sign,
                                            double shift = 0) const {
    std::vector<double> a = values(slopes_, x);
    const std::size_t n = size();
    if (shift > 0) {
      const std::vector<double> masses = inertia(x);
      for (std::size_t k = 0; k < n; ++k) a[k * n + k] += shift * masses[modes_[k]];
    }
    sign = 1;
    for (std::size_t c = 0; c < n; ++c) {
      std::size_t pivot = c;
      for (std::size_t r = c + 1; r < n; ++r)
        if (std::abs(a[r * n + c]) > std::abs(a[pivot * n + c])) pivot = r;
      if (!(std::abs(a[pivot * n + c]) > 0) || !std::isfinite(a[pivot * n + c])) return std::nullopt;
      if (pivot != c) {
        for (std::size_t j = 0; j < n; ++j) std::swap(a[c * n + j], a[pivot * n + j]);
        std::swap(right[c], right[pivot]);
        sign = -sign;
      }
      if (a[c * n + c] < 0) sign = -sign;
      for (std::size_t r = 0; r < n; ++r) {
        if (r == c) continue;
        const double factor = a[r * n + c] / a[c * n + c];
        for (std::size_t j = c; j < n; ++j) a[r * n + j] -= factor * a[c * n + j];
        right[r] -= factor * right[c];
      }
    }
    for (std::size_t c = 0; c < n; ++c) right[c] /= a[c * n + c];
    return right;
  }

 private:
  std::vector<double> values(const GiNaC::exvector& of, const std::vector<double>& x) const {
    GiNaC::exmap at;
    for (std::size_t i = 0; i < x.size(); ++i) at[unknowns_[i]] = GiNaC::numeric(x[i]);
    std::vector<double> result;
    for (const GiNaC::ex& e : of) result.push_back(number_at(e, at));
    return result;
  }

  std::vector<std::size_t> modes_;
  GiNaC::exvector unknowns_, forces_, slopes_, squares_, inertia_;
};

double largest(const std::vector<double>& x) {
  double size = 0;
  for (const double value : x) size = std::max(size, std::isfinite(value) ? std::abs(value) : INFINITY);
  return size;
}

// F(x) = offset by Newton's method; nothing where it does not converge.
std::optional<std::vector<double>> newton(const StaticForces& forces, std::vector<double> x,
                                          const std::vector<double>& offset) {
  int sign = 0;
  for (int i = 0; i < most_newton_steps; ++i) {
    std::vector<double> residual = forces.at(x);
    for (std::size_t k = 0; k < residual.size(); ++k) residual[k] = offset[k] - residual[k];
    if (!std::isfinite(largest(residual))) return std::nullopt;
    const auto step = forces.solved(x, residual, sign);
    if (!step) return std::nullopt;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += (*step)[k];
    if (largest(*step) <= newton_rounding * largest(x)) return x;
  }
  return std::nullopt;
}

std::string position_text(const RestPosition& rest, const StaticForces& forces, const std::vector<double>& x) {
  std::string text;
  for (std::size_t i = 0; i < x.size(); ++i)
    text += fmt::format("{}{} = {:.6g}", i ? ", " : "", rest.symbols[forces.mode(i)], x[i]);
  return text;
}

// F(x) = (1 - share) F(start): how far the load that would hold `start` can be taken away.
struct Continuation {
  std::vector<double> x;
  double share = 0;
};

// From `start`, while the determinant of the slopes keeps its sign: up to a fold at most. Nothing where there are
// no forces or no stiffness at the start.
std::optional<Continuation> continued(const StaticForces& forces, std::vector<double> start) {
  Continuation c{std::move(start), 0};
  const std::vector<double> held = forces.at(c.x);
  int sign = 0, now = 0;
  if (!std::isfinite(largest(held)) || !forces.solved(c.x, held, sign)) return std::nullopt;
  for (double step = first_load_step; c.share < 1 && step >= least_load_step;) {
    const double next = std::min(1.0, c.share + step);
    std::vector<double> right(held.size()), offset(held.size());
    for (std::size_t k = 0; k < right.size(); ++k) {
      right[k] = -(next - c.share) * held[k];
      offset[k] = (1 - next) * held[k];
    }
    const auto tangent = forces.solved(c.x, right, now);
    std::optional<std::vector<double>> found;
    if (tangent && now == sign) {
      std::vector<double> ahead = c.x;
      for (std::size_t k = 0; k < ahead.size(); ++k) ahead[k] += (*tangent)[k];
      found = newton(forces, ahead, offset);
      if (found) {
        double off = 0;
        for (std::size_t k = 0; k < ahead.size(); ++k) off = std::max(off, std::abs((*found)[k] - ahead[k]));
        int after = 0;
        if (off > largest_deviation * largest(*tangent) || !forces.solved(*found, right, after) || after != sign)
          found.reset();
      }
    }
    if (found) {
      c = {std::move(*found), next};
      step *= 2;
    } else {
      step /= 2;
    }
  }
  return c;
}

std::string near_which(const RestPosition& rest, const StaticForces& forces) {
  return "say near which position it rests: give " + rest.symbols[forces.mode(0)] + " a number, too";
}

// From zero while the load grows from nothing.
std::vector<double> loaded_position(const RestPosition& rest, const StaticForces& forces,
                                    const std::string& where) {
  const std::vector<double> zero(forces.size(), 0.0);
  const std::optional<Continuation> found = continued(forces, zero);
  if (!found)
    throw InputError(where, "",
                     std::isfinite(largest(forces.at(zero)))
                         ? "the model has no stiffness at zero, where it rests without its load"
                         : "the model's forces have no value where coordinates are zero",
                     near_which(rest, forces));
  if (found->share < 1)
    throw InputError(
        where, "",
        fmt::format("no rest position is reached from zero: the load is held up to {:.4g} of it, at {}",
                    found->share, position_text(rest, forces, found->x)),
        "lower the load, or " + near_which(rest, forces));
  return found->x;
}

// What stiffness divided by inertia says of small motions about x.
bool is_stable(const StaticForces& forces, const std::vector<double>& x) {
  const std::vector<double> squares = forces.squares(x), inertia = forces.inertia(x);
  int sign = 0;
  if (!forces.solved(x, x, sign)) return false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(squares[forces.mode(i)] > 0)) return false;
    if (inertia[forces.mode(i)] < 0) sign = -sign;
  }
  return sign > 0;
}

// The stable rest position that the model slides to from x, by implicit steps of M x' = -F(x) that grow where it is
// stable.
std::optional<std::vector<double>> downhill(const StaticForces& forces, std::vector<double> x) {
  double shift = 0;
  for (int i = 0, sign = 0; i < most_downhill_steps; ++i) {
    const bool stable = is_stable(forces, x);
    shift = stable ? shift / 4 : 2 * largest(forces.squares(x));
    std::vector<double> right = forces.at(x);
    for (double& force : right) force = -force;
    if (!std::isfinite(largest(right)) || !std::isfinite(shift)) return std::nullopt;
    const auto step = forces.solved(x, right, sign, shift);
    if (!step) return std::nullopt;
    if (stable && largest(*step) <= 1e-9 * largest(x)) return x;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += (*step)[k];
  }
  return std::nullopt;
}

// docs/inference.md (R5).
std::vector<double> given_position(const RestPosition& rest, const StaticForces& forces, const Numbers& values,
                                   const std::string& where) {
  std::vector<double> start;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const auto entry = values.find(rest.symbols[forces.mode(i)]);
    start.push_back(entry == values.end() ? 0.0 : entry->second);
  }
  std::string wrong = "no rest position is found near " + position_text(rest, forces, start);
  if (std::isfinite(largest(forces.at(start)))) {
    const bool stable = is_stable(forces, start);
    const std::optional<Continuation> found = stable ? continued(forces, start) : std::nullopt;
    if (found && found->share == 1) return found->x;
    wrong += found ? fmt::format(": on the way to one the model stops to be stable, at {}",
                                 position_text(rest, forces, found->x))
                   : ": the model is not stable there";
  }
  const auto other = downhill(forces, start);
  const std::string known = other ? position_text(rest, forces, *other) : std::string();
  throw InputError(where, "", wrong + (known.empty() ? "" : "; it rests at " + known),
                   known.empty() ? "give a number where the model is stable, or correct the others"
                                 : "give that, if it is the one, or correct the numbers");
}

GiNaC::exmap known_numbers(const RestPosition& rest, const Numbers& values) {
  GiNaC::exmap known;
  for (const std::string& name : rest.stated.names())
    if (const auto entry = values.find(name); entry != values.end())
      known[rest.stated.at(name)] = GiNaC::numeric(entry->second);
  return known;
}

}  // namespace

void add_values_at_rest(const Model& model, std::map<std::string, double>& values) {
  if (!model.rest) return;
  const GiNaC::exmap known = known_numbers(*model.rest, values);
  for (const auto& [symbol, function] : functions_at_rest(*model.rest))
    if (const double value = number_at(function, known); std::isfinite(value))
      values[GiNaC::ex_to<GiNaC::symbol>(symbol).get_name()] = value;
}

std::vector<FollowingCoefficient> following_coefficients(const Model& model, const Numbers& values) {
  std::vector<FollowingCoefficient> result;
  if (!model.rest) return result;
  const RestPosition& rest = *model.rest;
  const GiNaC::exmap known = known_numbers(rest, values), functions = functions_at_rest(rest);
  for (const HeldCoefficient& held : rest.held) {
    const GiNaC::ex whole = held.value.subs(functions);
    const double value = number_at(whole, known);
    if (!std::isfinite(value)) continue;
    FollowingCoefficient& added = result.emplace_back(FollowingCoefficient{held.name, value, {}});
    for (const auto& [symbol, ignored] : known)
      if (const double slope = number_at(whole.diff(GiNaC::ex_to<GiNaC::symbol>(symbol)), known); slope != 0)
        added.slopes[GiNaC::ex_to<GiNaC::symbol>(symbol).get_name()] = slope;
  }
  return result;
}

std::string take_rest_position(const Model& model, std::map<std::string, double>& values,
                               const std::string& where) {
  if (!model.rest) return {};
  const RestPosition& rest = *model.rest;
  std::string given, open, follow;
  const auto list = [](std::string& names, const std::string& name) {
    names += (names.empty() ? "" : ", ") + name;
  };
  for (const HeldCoefficient& held : rest.held) list(values.count(held.name) ? given : open, held.name);
  if (given.empty()) return {};
  for (const std::string& name : rest.frequency)
    if (!name.empty()) {
      list(follow, name);
      if (values.count(name))
        throw InputError(where, "", name + " and " + given + " are given: " + name + " follows from them",
                         "give one or the other");
    }
  Numbers all = model.nominal;
  for (const auto& [name, value] : values) all[name] = value;
  std::set<std::string> needed;
  for (const auto* expressions : {&rest.force, &rest.stiffness, &rest.inertia})
    for (const GiNaC::ex& e : *expressions)
      for (GiNaC::const_preorder_iterator it = e.preorder_begin(); it != e.preorder_end(); ++it)
        if (GiNaC::is_a<GiNaC::symbol>(*it)) needed.insert(GiNaC::ex_to<GiNaC::symbol>(*it).get_name());
  for (const std::string& name : needed)
    if (!all.count(name) && !rest.holds(name) && !rest.is_value(name) &&
        std::find(rest.symbols.begin(), rest.symbols.end(), name) == rest.symbols.end())
      list(open, name);
  if (!open.empty())
    throw InputError(where, "",
                     "gives " + given + " without " + open + ": the rest position depends on all of them",
                     "give them all");
  const StaticForces forces(rest, all);
  const bool start = std::any_of(rest.symbols.begin(), rest.symbols.end(),
                                 [&](const std::string& name) { return !name.empty() && values.count(name) != 0; });
  const std::vector<double> x =
      start ? given_position(rest, forces, values, where) : loaded_position(rest, forces, where);
  const std::vector<double> squares = forces.squares(x);
  for (std::size_t k = 0; k < squares.size(); ++k)
    if (!(squares[k] > 0))
      throw InputError(where, "",
                       fmt::format("the rest position {} is not stable: the square of {} is {:.6g} there",
                                   position_text(rest, forces, x), model.frequency_name(k), squares[k]),
                       "correct the numbers, or " + near_which(rest, forces));
  for (std::size_t i = 0; i < x.size(); ++i) values[rest.symbols[forces.mode(i)]] = x[i];
  std::string found = "rests at " + position_text(rest, forces, x);
  for (std::size_t k = 0; k < squares.size(); ++k) {
    if (rest.frequency[k].empty()) continue;
    values[rest.frequency[k]] = std::sqrt(squares[k]);
    found += fmt::format(", {} = {:.6g} rad/s", rest.frequency[k], std::sqrt(squares[k]));
  }
  for (const HeldCoefficient& held : rest.held) values.erase(held.name);
  return where + ": the model " + found;
}

}  // namespace secular
