// Equations of motion: mass matrix, accelerations, their derivatives by state and parameters.
#include <fmt/format.h>

#include <cmath>
#include <map>

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
  return denominator == 1 ? fmt::format("Scalar({}.0)", numerator)
                          : fmt::format("Scalar({}.0) / Scalar({}.0)", numerator, denominator);
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
    if (value.empty()) value = "Scalar(1.0)";
    if (std::abs(ratio.numerator) != 1 || ratio.denominator != 1)
      value = ratio_code(std::abs(ratio.numerator), ratio.denominator) + " * " + value;
    sum += (ratio.numerator < 0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ")) + value;
  }
  return "(" + sum + ")";
}

// Code of terms of the equations of motion. Values of smooth functions have names of their own, each once.
class TermWriter {
 public:
  /// `prefix` of names of functions' values.
  explicit TermWriter(const CanonicalModel& model, std::string prefix = "function_")
      : model_(model), prefix_(std::move(prefix)), writer_(model.order, "Scalar") {}

  /// coefficient * factors, without the acceleration. `multiplied`: the caller multiplies it by more.
  std::string term(const CanonicalMotionTerm& term, bool multiplied = false) {
    std::string product = term.coefficient.is_one() ? "" : writer_.expression(term.coefficient);
    if (reads_as_sum(term.coefficient) && (multiplied || !term.factors.empty())) product = "(" + product + ")";
    for (const CanonicalFactor& factor : term.factors)
      product += (product.empty() ? "" : " * ") + this->factor(factor);
    return product.empty() ? "Scalar(1.0)" : product;
  }
  std::vector<std::string> used_symbols() const { return writer_.used_symbols(); }
  /// Declarations of all that terms so far need.
  std::vector<std::string> definitions() const {
    std::vector<std::string> all = writer_.definitions();
    all.insert(all.end(), functions_.begin(), functions_.end());
    return all;
  }

 private:
  std::string factor(const CanonicalFactor& f) {
    using Kind = CanonicalFactor::Kind;
    switch (f.kind) {
      case Kind::displacement:
        return repeated(fmt::format("displacement[{}]", f.index), f.power);
      case Kind::velocity:
        return repeated(fmt::format("velocity[{}]", f.index), f.power);
      case Kind::excitation: {
        static const char* const member[] = {"value", "first_derivative", "second_derivative"};
        return repeated(fmt::format("Scalar(excitation[{}].{})", f.index, member[f.derivative]), f.power);
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
  CppWriter writer_;
  std::map<std::string, std::string> names_;  // by what they are the value of
  std::vector<std::string> functions_;
};

void declare(Emitter& emitter, const std::string& name, const std::string& result) {
  CodeText& code = emitter.code;
  code.line("template <class Scalar, class Parameter, class Sample>");
  code.line(fmt::format("void {}([[maybe_unused]] const Parameter* parameters,", name));
  code.line("    [[maybe_unused]] const Sample* excitation,");
  code.line("    [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,");
  code.line(fmt::format("    Scalar* {}) {{", result));
}

int operations(const TermWriter& writer, const std::vector<std::string>& expressions) {
  int count = 0;
  for (const std::string& definition : writer.definitions()) count += operations_in(definition);
  for (const std::string& expression : expressions) count += operations_in(expression);
  return count;
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
                  "mass[k * {} + j] multiplies the acceleration of mode j in equation k. {} operations.",
                  model.coordinates.size(), operations(writer, mass)));
  declare(emitter, "mass_matrix", "mass");
  emitter.unpack(writer.used_symbols());
  emitter.definitions(writer.definitions());
  for (std::size_t i = 0; i < mass.size(); ++i)
    emitter.code.line(fmt::format("mass[{}] = {};", i, mass[i].empty() ? "Scalar(0.0)" : mass[i]));
  emitter.code.line("}").line();
}

// What a mass matrix is, by its entries.
struct MassShape {
  bool diagonal = true, unity = true;  // unity: ones on the diagonal
  explicit MassShape(const std::vector<std::string>& mass, std::size_t modes) {
    for (std::size_t i = 0; i < mass.size(); ++i) {
      const bool on_diagonal = i % (modes + 1) == 0;
      diagonal = diagonal && on_diagonal != mass[i].empty();
      unity = unity && (!on_diagonal || mass[i] == "Scalar(1.0)");
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
    if (mass[k * (modes + 1)] == "Scalar(1.0)") continue;
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
void solve(Emitter& emitter, const std::string& right_sides, std::size_t columns) {
  const CanonicalModel& model = emitter.model;
  const std::size_t modes = model.coordinates.size();
  TermWriter writer(model);
  const std::vector<std::string> mass = mass_entries(model, model.motion, writer);
  const MassShape shape(mass, modes);
  if (shape.diagonal && shape.unity) return;
  const std::string condition = inertia_acts(model);
  if (!condition.empty()) emitter.code.line("if (" + condition + ") {");
  emitter.code.line(fmt::format("Scalar mass[{}];", modes * modes));
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
  emitter.unpack(forces.writer.used_symbols());
  emitter.definitions(forces.writer.definitions());
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
  int count = 0;
  for (const MotionPart& part : parts) {
    forces.emplace_back(model, part.motion,
                        part.strength ? fmt::format("function_{}_", *part.strength) : std::string("function_"));
    count += operations(forces.back().writer, forces.back().of_mode);
  }
  emitter.code.comment(
      "Accelerations of the full equations of motion, solved from the state-dependent mass matrix.");
  if (parts.size() > 1)
    emitter.code.comment("Terms of an added effect are computed where its strength is not zero.");
  for (std::size_t k = 0; k < modes; ++k) emitter.code.comment(motion_text(model, k));
  emitter.code.comment(
      fmt::format("parameters: {}. displacement, velocity, acceleration: {} values. {} operations.",
                  emitter.parameter_list(), modes, count));
  declare(emitter, "accelerations", "acceleration");
  emitter.unpack(forces.front().writer.used_symbols());
  emitter.definitions(forces.front().writer.definitions());
  for (std::size_t k = 0; k < modes; ++k) {
    const std::string& own = forces.front().of_mode[k];
    emitter.code.line(fmt::format("acceleration[{}] = -({});", k, own.empty() ? "Scalar(0.0)" : own));
  }
  for (std::size_t p = 1; p < parts.size(); ++p) subtract_effect(emitter, *parts[p].strength, forces[p]);
  solve(emitter, "acceleration", 1);
  emitter.code.line("}").line();
}

// d(acceleration)/dx = -M^-1 (dM/dx * acceleration + d(force)/dx) for all `variables`, one a column.
void slopes(Emitter& emitter, const std::string& name, const std::vector<MotionVariable>& variables,
            const std::vector<std::string>& variable_names) {
  const CanonicalModel& model = emitter.model;
  const std::size_t modes = model.coordinates.size();
  TermWriter writer(model);
  bool accelerates = false;
  std::vector<std::string> assignments;
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t x = 0; x < variables.size(); ++x) {
      std::string sum;
      for (const CanonicalMotionTerm& term : model.motion[k])
        for (const WeightedMotionTerm& derived : motion_derivative(model, term, variables[x])) {
          const bool weighted = derived.weight.numerator != 1 || derived.weight.denominator != 1;
          std::string product = writer.term(derived.term, weighted || derived.term.acceleration_of.has_value());
          if (weighted)
            product += " * " + (derived.weight.numerator < 0 || derived.weight.denominator != 1
                                    ? "(" + ratio_code(derived.weight.numerator, derived.weight.denominator) + ")"
                                    : ratio_code(derived.weight.numerator, 1));
          if (derived.term.acceleration_of) {
            product += fmt::format(" * acceleration[{}]", *derived.term.acceleration_of);
            accelerates = true;
          }
          add_to_sum(sum, product);
        }
      if (!sum.empty())
        assignments.push_back(fmt::format("slope[{}] = -({});  // equation {} by {}", k * variables.size() + x, sum,
                                          k + 1, variable_names[x]));
    }
  emitter.code.comment(
      fmt::format("slope[k * {0} + x] = d acceleration[k] / d x = -M^-1*(dM/dx*acceleration + d(force)/dx), x = "
                  "{1}. Of nonsmooth "
                  "terms the classical derivative: d|x| = sgn(x) dx, zero at the corner, and d sgn(x) = 0. {2} "
                  "operations before "
                  "the solution of {0} right sides.",
                  variables.size(), fmt::join(variable_names, ", "), operations(writer, assignments)));
  declare(emitter, name, "slope");
  if (accelerates) {
    emitter.code.line(fmt::format("Scalar acceleration[{}];", modes));
    emitter.code.line("accelerations(parameters, excitation, displacement, velocity, acceleration);");
  }
  emitter.unpack(writer.used_symbols());
  emitter.definitions(writer.definitions());
  emitter.code.line(
      fmt::format("for (std::size_t i = 0; i < {}; ++i) slope[i] = Scalar(0.0);", modes * variables.size()));
  for (const std::string& assignment : assignments) emitter.code.line(assignment);
  solve(emitter, "slope", variables.size());
  emitter.code.line("}").line();
}

}  // namespace

void emit_motion(Emitter& emitter) {
  const CanonicalModel& model = emitter.model;
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
  slopes(emitter, "acceleration_by_state", state, state_names);
  slopes(emitter, "acceleration_by_parameters", parameters, model.parameters);
}

}  // namespace secular
