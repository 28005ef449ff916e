// Equations of motion: coefficients, mass matrix, accelerations, their derivatives by state and parameters.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "codegen/canonical/lump_gradient.hpp"
#include "codegen/canonical/motion_derivative.hpp"
#include "codegen/canonical/motion_parts.hpp"
#include "codegen/cpp/emitter.hpp"
#include "codegen/document/print_text.hpp"

namespace secular {
namespace {

using MotionTerms = std::vector<std::vector<CanonicalMotionTerm>>;  // [mode]

std::string repeated(const std::string& base, int power) {
  std::string text;
  for (int i = 0; i < power; ++i) text += (i ? " * " : "") + base;
  return text;
}

std::string ratio_code(int numerator, int denominator) {
  return denominator == 1 ? fmt::format("{}.0", numerator) : fmt::format("{}.0 / {}.0", numerator, denominator);
}

// "displacement[0] - parameters[3]" for v - gap.
std::string argument_code(const CanonicalModel& model, const CanonicalFactor& f) {
  if (f.argument.empty()) return fmt::format("{}[{}]", f.derivative == 0 ? "displacement" : "velocity", f.index);
  std::string sum;
  for (const auto& [name, ratio] : f.argument) {
    std::string value;
    for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
      if (name == model.coordinates[k]) value = fmt::format("displacement[{}]", k);
      if (name == "D(" + model.coordinates[k] + ")") value = fmt::format("velocity[{}]", k);
    }
    for (std::size_t p = 0; p < model.parameters.size() && value.empty(); ++p)
      if (name == model.parameters[p]) value = fmt::format("parameters[{}]", p);
    if (value.empty()) value = "1.0";
    if (std::abs(ratio.numerator) != 1 || ratio.denominator != 1)
      value = ratio_code(std::abs(ratio.numerator), ratio.denominator) + " * " + value;
    sum += (ratio.numerator < 0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ")) + value;
  }
  return "(" + sum + ")";
}

// Coefficients of the model's own equations of motion that are long sums: each has a number, and its value is
// computed by the generated function `coefficients`.
std::vector<RationalFunction> long_coefficients(const CanonicalModel& model) {
  constexpr std::size_t longest_in_place = 2;
  std::vector<RationalFunction> list;
  const std::vector<MotionPart> parts = motion_parts(model);
  for (const auto& terms : parts.front().motion)
    for (const CanonicalMotionTerm& term : terms)
      if (term.coefficient.numerator.size() > longest_in_place &&
          std::find(list.begin(), list.end(), term.coefficient) == list.end())
        list.push_back(term.coefficient);
  return list;
}

// Code of terms of the equations of motion. Values of smooth functions have names of their own, each once.
class TermWriter {
 public:
  /// `prefix` of names of functions' values.
  explicit TermWriter(const CanonicalModel& model, std::string prefix = "function_")
      : model_(model),
        prefix_(std::move(prefix)),
        long_(long_coefficients(model)),
        writer_(model.order, "Scalar") {}

  /// coefficient * factors, without the acceleration. `multiplied`: the caller multiplies it by more.
  std::string term(const CanonicalMotionTerm& term, bool multiplied = false) {
    std::string product = term.coefficient.is_one() ? "" : coefficient(term.coefficient);
    if (product == "-1.0" && !term.factors.empty()) product = "-";
    if (reads_as_sum(term.coefficient) && !number_of(term.coefficient) && (multiplied || !term.factors.empty()))
      product = "(" + product + ")";
    for (const CanonicalFactor& factor : term.factors)
      product += (product.empty() || product == "-" ? "" : " * ") + this->factor(factor);
    return product.empty() ? "1.0" : product;
  }
  /// Number of a coefficient that has one.
  std::optional<std::size_t> number_of(const RationalFunction& coefficient) const {
    const auto place = std::find(long_.begin(), long_.end(), coefficient);
    return place == long_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(place - long_.begin()));
  }
  std::size_t numbered() const { return long_.size(); }
  bool uses_numbered() const { return uses_numbered_; }
  std::vector<std::string> used_symbols() const { return writer_.used_symbols(); }
  /// Declarations of all that terms so far need.
  std::vector<std::string> definitions() const {
    std::vector<std::string> all = writer_.definitions();
    all.insert(all.end(), functions_.begin(), functions_.end());
    return all;
  }

 private:
  std::string coefficient(const RationalFunction& value) {
    const std::optional<std::size_t> number = number_of(value);
    if (!number) return writer_.expression(value);
    uses_numbered_ = true;
    return fmt::format("coefficient[{}]", *number);
  }

  std::string factor(const CanonicalFactor& f) {
    using Kind = CanonicalFactor::Kind;
    switch (f.kind) {
      case Kind::displacement:
        return repeated(fmt::format("displacement[{}]", f.index), f.power);
      case Kind::velocity:
        return repeated(fmt::format("velocity[{}]", f.index), f.power);
      case Kind::excitation: {
        static const char* const member[] = {"value", "first_derivative", "second_derivative"};
        return repeated(fmt::format("excitation[{}].{}", f.index, member[f.derivative]), f.power);
      }
      case Kind::absolute:
        return repeated(fmt::format("absolute({})", argument_code(model_, f)), f.power);
      case Kind::sign:
        return repeated(fmt::format("sign_of({})", argument_code(model_, f)), f.power);
      case Kind::smooth:
        return repeated(function(f), f.power);
      case Kind::acceleration:
      case Kind::clock_cos:
      case Kind::clock_sin:
        break;
    }
    return {};
  }

  // The name of a function's value.
  std::string function(const CanonicalFactor& f) {
    std::string argument;
    for (const CanonicalMotionTerm& inner : f.inner) add_to_sum(argument, term(inner));
    if (f.function == SmoothKind::power)
      argument += f.exponent.denominator == 1
                      ? fmt::format(", {}.0", f.exponent.numerator)
                      : fmt::format(", {}.0 / {}.0", f.exponent.numerator, f.exponent.denominator);
    const std::string call =
        fmt::format("{}_of({})", f.function == SmoothKind::power ? "power" : name_of(f.function), argument);
    const auto [named, added] = names_.try_emplace(call, fmt::format("{}{}", prefix_, names_.size()));
    if (added) functions_.push_back(fmt::format("const Scalar {} = {};", named->second, call));
    return named->second;
  }

  const CanonicalModel& model_;
  std::string prefix_;
  std::vector<RationalFunction> long_;
  bool uses_numbered_ = false;
  CppWriter writer_;
  std::map<std::string, std::string> names_;  // by what they are the value of
  std::vector<std::string> functions_;
};

// The same model with numbered coefficients written as such.
CanonicalModel with_named_coefficients(const CanonicalModel& model) {
  CanonicalModel named = model;
  const std::vector<RationalFunction> list = long_coefficients(model);
  const std::size_t before = model.order.size();
  for (std::size_t n = 0; n < list.size(); ++n) named.order.push_back(fmt::format("coefficient[{}]", n));
  for (auto& terms : named.motion)
    for (CanonicalMotionTerm& term : terms)
      if (const auto place = std::find(list.begin(), list.end(), term.coefficient); place != list.end()) {
        std::vector<int> one(named.order.size(), 0), none = one;
        one[before + static_cast<std::size_t>(place - list.begin())] = 1;
        term.coefficient = {{{"1", one}}, {{"1", none}}};
      }
  return named;
}

// Their derivatives by the parameters.
void coefficient_slopes(Emitter& emitter, const std::vector<RationalFunction>& list) {
  const CanonicalModel& model = emitter.model;
  CppWriter writer(model.order, "Scalar");
  std::vector<std::string> lines;
  for (std::size_t n = 0; n < list.size(); ++n)
    for (const LumpGradient::Entry& entry : lump_gradient(model, list[n]).entries)
      lines.push_back(fmt::format("add({}, {}, {});  // by {}", entry.parameter, n, writer.expression(entry.rate),
                                  model.parameters[entry.parameter]));
  const std::size_t parameters = model.parameters.size(), coefficients = list.size();
  emitter.code.comment(fmt::format(
      "slope[i * {} + p] += sum of by[i * {} + c] * d coefficient[c] / d parameters[p], of every equation i.",
      parameters, coefficients));
  emitter.code.line("template <class Scalar, class Parameter>");
  emitter.code.line("void add_coefficient_slopes(const Parameter* parameters, const Scalar* by, Scalar* slope) {");
  emitter.unpack(writer.used_symbols());
  emitter.definitions(writer.definitions());
  emitter.code.line(
      "const auto add = [by, slope](std::size_t parameter, std::size_t coefficient, const Scalar& rate) {");
  emitter.code.line(fmt::format(
      "for (std::size_t i = 0; i < {}; ++i) slope[i * {} + parameter] += by[i * {} + coefficient] * rate;",
      model.coordinates.size(), parameters, coefficients));
  emitter.code.line("};");
  for (const std::string& line : lines) emitter.code.line(line);
  emitter.code.line("}").line();
}

// The coefficients that have numbers, as one function of the parameters.
void coefficients(Emitter& emitter) {
  const CanonicalModel& model = emitter.model;
  const std::vector<RationalFunction> list = long_coefficients(model);
  if (list.empty()) return;
  CppWriter writer(model.order, "Scalar");
  std::vector<std::string> values;
  for (const RationalFunction& coefficient : list) values.push_back(writer.expression(coefficient));
  emitter.code.comment(
      "Coefficients of the equations of motion below that are sums of many products of parameters.");
  emitter.code.line("template <class Scalar, class Parameter>");
  emitter.code.line("void coefficients(const Parameter* parameters, Scalar* coefficient) {");
  emitter.unpack(writer.used_symbols());
  emitter.definitions(writer.definitions());
  for (std::size_t n = 0; n < values.size(); ++n)
    emitter.code.line(fmt::format("coefficient[{}] = {};", n, values[n]));
  emitter.code.line("}").line();
  coefficient_slopes(emitter, list);
}

void declare(Emitter& emitter, const std::string& name, const std::string& result) {
  CodeText& code = emitter.code;
  code.line("template <class Scalar, class Parameter, class Sample>");
  code.line(fmt::format("void {}([[maybe_unused]] const Parameter* parameters,", name));
  code.line("    [[maybe_unused]] const Sample* excitation,");
  code.line("    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,");
  code.line(fmt::format("    Scalar* {}) {{", result));
}

// Local variables that terms need.
void prepare(Emitter& emitter, const TermWriter& writer) {
  emitter.unpack(writer.used_symbols());
  if (writer.uses_numbered()) {
    emitter.code.line(fmt::format("Scalar coefficient[{}];", writer.numbered()));
    emitter.code.line("coefficients(parameters, coefficient);");
  }
  emitter.definitions(writer.definitions());
}

// Entries [equation][mode] as code, empty where nothing multiplies the acceleration.
std::vector<std::string> mass_entries(const CanonicalModel& model, const MotionTerms& motion, TermWriter& writer) {
  const std::size_t modes = model.coordinates.size();
  std::vector<std::string> mass(modes * modes);
  for (std::size_t k = 0; k < modes; ++k)
    for (const CanonicalMotionTerm& term : motion[k])
      if (term.acceleration_of) add_to_sum(mass[k * modes + *term.acceleration_of], writer.term(term));
  return mass;
}

void mass_matrix(Emitter& emitter) {
  const CanonicalModel& model = emitter.model;
  TermWriter writer(model);
  const std::vector<std::string> mass = mass_entries(model, model.motion, writer);
  emitter.code.comment(
      fmt::format("Mass matrix M of the equations of motion M*acceleration + force = 0 below, state-dependent: "
                  "mass[k * {} + j] multiplies the acceleration of mode j in equation k.",
                  model.coordinates.size()));
  declare(emitter, "mass_matrix", "mass");
  prepare(emitter, writer);
  for (std::size_t i = 0; i < mass.size(); ++i)
    emitter.code.line(fmt::format("mass[{}] = {};", i, mass[i].empty() ? "0.0" : mass[i]));
  emitter.code.line("}").line();
}

// What a mass matrix is, by its entries.
struct MassShape {
  bool diagonal = true, unity = true;  // unity: ones on the diagonal
  explicit MassShape(const std::vector<std::string>& mass, std::size_t modes) {
    for (std::size_t i = 0; i < mass.size(); ++i) {
      const bool on_diagonal = i % (modes + 1) == 0;
      diagonal = diagonal && on_diagonal != mass[i].empty();
      unity = unity && (!on_diagonal || mass[i] == "1.0");
    }
  }
};

std::string acts(std::size_t strength) {
  return fmt::format("is_nonzero(parameters[{}])", strength);
}

// Condition under which the mass matrix is not unity because of an added effect; none: it is not without any.
std::string inertia_acts(const CanonicalModel& model) {
  const std::vector<MotionPart> parts = motion_parts(model);
  TermWriter writer(model);
  const MassShape own(mass_entries(model, parts.front().motion, writer), model.coordinates.size());
  std::string condition;
  for (std::size_t p = 1; own.diagonal && own.unity && p < parts.size(); ++p)
    if (parts[p].has_inertia()) condition += (condition.empty() ? "" : " || ") + acts(*parts[p].strength);
  return condition;
}

// Equations that no other acceleration enters are divided.
void divide(Emitter& emitter, const std::vector<std::string>& mass, const std::string& right_sides,
            std::size_t columns) {
  const std::size_t modes = emitter.model.coordinates.size();
  for (std::size_t k = 0; k < modes; ++k) {
    if (mass[k * (modes + 1)] == "1.0") continue;
    const auto divide = [&](const std::string& i) {
      return fmt::format("{0}[{1}] = {0}[{1}] / mass[{2}];", right_sides, i, k * (modes + 1));
    };
    if (columns == 1)
      emitter.code.line(divide(std::to_string(k)));
    else
      emitter.code.line(
          fmt::format("for (std::size_t i = {}; i < {}; ++i) {}", k * columns, (k + 1) * columns, divide("i")));
  }
}

// right_sides = M^-1 right_sides
void solve(Emitter& emitter, const std::string& right_sides, std::size_t columns, bool coefficients_at_hand) {
  const CanonicalModel& model = emitter.model;
  const std::size_t modes = model.coordinates.size();
  TermWriter writer(model);
  const std::vector<std::string> mass = mass_entries(model, model.motion, writer);
  const MassShape shape(mass, modes);
  if (shape.diagonal && shape.unity) return;
  const std::string condition = inertia_acts(model);
  if (!condition.empty()) emitter.code.line("if (" + condition + ") {");
  emitter.code.line(fmt::format("Scalar mass[{}];", modes * modes));
  // Entries of numbered coefficients alone, which are at hand, are written here.
  if (coefficients_at_hand && writer.uses_numbered() && writer.used_symbols().empty() &&
      writer.definitions().empty() && condition.empty())
    for (std::size_t i = 0; i < mass.size(); ++i)
      emitter.code.line(fmt::format("mass[{}] = {};", i, mass[i].empty() ? "0.0" : mass[i]));
  else
    emitter.code.line("mass_matrix(parameters, excitation, displacement, velocity, mass);");
  if (shape.diagonal)
    divide(emitter, mass, right_sides, columns);
  else
    emitter.code.line(fmt::format("solve_in_place(mass, {}, {}, {});", modes, right_sides, columns));
  if (!condition.empty()) emitter.code.line("}");
}

// Of one part of the equations of motion, as code by mode: what stands beside the accelerations.
struct Forces {
  TermWriter writer;
  std::vector<std::string> of_mode;

  Forces(const CanonicalModel& model, const MotionTerms& motion, const std::string& prefix)
      : writer(model, prefix), of_mode(motion.size()) {
    for (std::size_t k = 0; k < motion.size(); ++k)
      for (const CanonicalMotionTerm& term : motion[k])
        if (!term.acceleration_of) add_to_sum(of_mode[k], writer.term(term));
  }
};

// Forces of an added effect, computed where it acts.
void subtract_effect(Emitter& emitter, std::size_t strength, const Forces& forces) {
  emitter.code.line("if (" + acts(strength) + ") {");
  prepare(emitter, forces.writer);
  for (std::size_t k = 0; k < forces.of_mode.size(); ++k)
    if (!forces.of_mode[k].empty())
      emitter.code.line(fmt::format("acceleration[{0}] = acceleration[{0}] - ({1});", k, forces.of_mode[k]));
  emitter.code.line("}");
}

void accelerations(Emitter& emitter) {
  const CanonicalModel& model = emitter.model;
  const std::size_t modes = model.coordinates.size();
  const std::vector<MotionPart> parts = motion_parts(model);
  std::vector<Forces> forces;
  for (const MotionPart& part : parts)
    forces.emplace_back(model, part.motion,
                        part.strength ? fmt::format("function_{}_", *part.strength) : std::string("function_"));
  emitter.code.comment(
      "Accelerations of the full equations of motion, solved from the state-dependent mass matrix.");
  if (parts.size() > 1)
    emitter.code.comment("Terms of an added effect are computed where its strength is not zero.");
  const CanonicalModel named = with_named_coefficients(model);
  for (std::size_t k = 0; k < modes; ++k) emitter.code.comment(motion_text(named, k));
  emitter.code.comment(fmt::format("parameters: {}. displacement, velocity, acceleration: {} values.",
                                   emitter.parameter_list(), modes));
  declare(emitter, "accelerations", "acceleration");
  prepare(emitter, forces.front().writer);
  for (std::size_t k = 0; k < modes; ++k) {
    const std::string& own = forces.front().of_mode[k];
    emitter.code.line(fmt::format("acceleration[{}] = -({});", k, own.empty() ? "0.0" : own));
  }
  for (std::size_t p = 1; p < parts.size(); ++p) subtract_effect(emitter, *parts[p].strength, forces[p]);
  solve(emitter, "acceleration", 1, forces.front().writer.uses_numbered());
  emitter.code.line("}").line();
}

// d(acceleration)/dx = -M^-1 (dM/dx * acceleration + d(force)/dx) for all `variables`, one a column.
class SlopeCode {
 public:
  SlopeCode(Emitter& emitter, std::vector<MotionVariable> variables, std::vector<std::string> names)
      : emitter_(emitter),
        model_(emitter.model),
        variables_(std::move(variables)),
        names_(std::move(names)),
        writer_(emitter.model) {}

  void emit(const std::string& name) {
    const std::size_t modes = model_.coordinates.size(), count = variables_.size();
    for (std::size_t k = 0; k < modes; ++k) equation(k);
    CodeText& code = emitter_.code;
    code.comment(fmt::format(
        "slope[k * {} + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = {}. "
        "Of nonsmooth terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) "
        "= 0.",
        count, fmt::join(names_, ", ")));
    declare(emitter_, name, "slope");
    if (accelerates_) {
      code.line(fmt::format("Scalar acceleration[{}];", modes));
      code.line("accelerations(parameters, excitation, displacement, velocity, acceleration);");
    }
    prepare(emitter_, writer_);
    code.line(fmt::format("for (std::size_t i = 0; i < {}; ++i) slope[i] = 0.0;", modes * count));
    for (const std::string& assignment : assignments_) code.line(assignment);
    if (!by_coefficient_.empty()) {
      code.comment("Through the coefficients: by_coefficient[k * coefficients + c], then by the chain rule.", "//");
      code.line(fmt::format("Scalar by_coefficient[{}] = {{}};", modes * writer_.numbered()));
      for (const std::string& assignment : by_coefficient_) code.line(assignment);
      code.line("add_coefficient_slopes(parameters, by_coefficient, slope);");
    }
    solve(emitter_, "slope", count, writer_.uses_numbered());
    code.line("}").line();
  }

 private:
  void equation(std::size_t k) {
    for (std::size_t x = 0; x < variables_.size(); ++x) {
      std::string sum;
      for (const CanonicalMotionTerm& term : model_.motion[k]) add(sum, term, variables_[x]);
      if (!sum.empty())
        assignments_.push_back(fmt::format("slope[{}] = -({});  // equation {} by {}", k * variables_.size() + x,
                                           sum, k + 1, names_[x]));
    }
    if (variables_.empty() || variables_.front().kind != MotionVariable::Kind::parameter) return;
    std::vector<std::string> sums(writer_.numbered());
    for (CanonicalMotionTerm term : model_.motion[k]) {
      const std::optional<std::size_t> number = writer_.number_of(term.coefficient);
      if (!number) continue;
      term.coefficient = one();
      add_to_sum(sums[*number], with_acceleration(term, writer_.term(term)));
    }
    for (std::size_t c = 0; c < sums.size(); ++c)
      if (!sums[c].empty())
        by_coefficient_.push_back(fmt::format("by_coefficient[{}] = -({});", k * sums.size() + c, sums[c]));
  }

  // What a numbered coefficient depends on is left to the chain rule.
  void add(std::string& sum, const CanonicalMotionTerm& term, const MotionVariable& variable) {
    const bool apart =
        variable.kind == MotionVariable::Kind::parameter && writer_.number_of(term.coefficient).has_value();
    CanonicalMotionTerm derived_from = term;
    if (apart) derived_from.coefficient = one();
    for (WeightedMotionTerm& derived : motion_derivative(model_, derived_from, variable)) {
      if (apart) derived.term.coefficient = product(derived.term.coefficient, term.coefficient);
      const bool weighted = derived.weight.numerator != 1 || derived.weight.denominator != 1;
      std::string text = writer_.term(derived.term, weighted || derived.term.acceleration_of.has_value());
      if (weighted)
        text += " * " + (derived.weight.numerator < 0 || derived.weight.denominator != 1
                             ? "(" + ratio_code(derived.weight.numerator, derived.weight.denominator) + ")"
                             : ratio_code(derived.weight.numerator, 1));
      add_to_sum(sum, with_acceleration(derived.term, text));
    }
  }

  std::string with_acceleration(const CanonicalMotionTerm& term, std::string text) {
    if (!term.acceleration_of) return text;
    accelerates_ = true;
    return text + fmt::format(" * acceleration[{}]", *term.acceleration_of);
  }

  RationalFunction one() const {
    const std::vector<int> none(model_.order.size(), 0);
    return {{{"1", none}}, {{"1", none}}};
  }

  Emitter& emitter_;
  const CanonicalModel& model_;
  std::vector<MotionVariable> variables_;
  std::vector<std::string> names_;
  TermWriter writer_;
  bool accelerates_ = false;
  std::vector<std::string> assignments_, by_coefficient_;
};

}  // namespace

void emit_motion(Emitter& emitter) {
  const CanonicalModel& model = emitter.model;
  coefficients(emitter);
  mass_matrix(emitter);
  accelerations(emitter);
  std::vector<MotionVariable> state, parameters;
  std::vector<std::string> state_names;
  for (const bool velocity : {false, true})
    for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
      state.push_back({velocity ? MotionVariable::Kind::velocity : MotionVariable::Kind::displacement, k});
      state_names.push_back(velocity ? "D(" + model.coordinates[k] + ")" : model.coordinates[k]);
    }
  for (std::size_t p = 0; p < model.parameters.size(); ++p)
    parameters.push_back({MotionVariable::Kind::parameter, p});
  SlopeCode(emitter, state, state_names).emit("acceleration_by_state");
  SlopeCode(emitter, parameters, model.parameters).emit("acceleration_by_parameters");
}

}  // namespace secular
