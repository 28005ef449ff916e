#include "codegen/cpp/emit_cpp.hpp"

#include <fmt/format.h>

#include "codegen/cpp/emitter.hpp"
#include "codegen/document/print_text.hpp"

namespace secular {
namespace {

void banner(Emitter& emitter) {
  const CanonicalModel& model = emitter.model;
  emitter.code.comment(fmt::format("Model {}: generated code, never edited by hand.", model.name), "//");
  if (!model.source.empty()) emitter.code.comment("Source: " + commented(model.source), "//");
  for (std::size_t k = 0; k < model.coordinates.size(); ++k)
    emitter.code.comment("Equation of motion: " + motion_text(model, k), "//");
  for (const CanonicalCase& c : model.cases) {
    std::string relations;
    for (const CanonicalRelation& relation : c.relations)
      relations += (relations.empty() ? "" : "; ") + commented(relation.text);
    emitter.code.comment(
        fmt::format("Case {}: {}, multiple scales to eps^{}. Valid near that resonance for small amplitudes; "
                    "what is left out is of order eps^{}.",
                    c.name, relations.empty() ? (c.excited ? "no resonance" : "free vibration") : relations,
                    c.expand_to, c.expand_to + 1),
        "//");
  }
  emitter.code.comment("Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.",
                       "//");
  emitter.code.comment("Made by: secular generate " + model.name, "//");
}

// What generated functions include: light headers alone, see BatchArrays.
void include_function_headers(CodeText& code, const CanonicalModel& model) {
  code.line("#include <cstddef>").line("#include <numbers>").line();
  for (const char* const name : {"batch_arrays", "complex_number", "dense_solve", "dual_number",
                                 "excitation_sample", "integer_power", "lane_functions", "scalar_functions"})
    code.line(fmt::format("#include \"estimator/model/{}.hpp\"", name));
  if (has_smooth_functions(model)) code.line("#include \"estimator/model/smooth_functions.hpp\"");
  code.line();
}

void include_table_headers(CodeText& code) {
  code.line("#include <limits>").line().line("#include \"estimator/model/generated_table.hpp\"").line();
}

constexpr const char* lump_functions[] = {"evaluate_lumps", "evaluate_lumps_jacobian"};
constexpr const char* motion_functions[] = {"mass_matrix", "accelerations", "acceleration_by_state",
                                            "acceleration_by_parameters"};
constexpr const char* modulation_functions[] = {"modulation", "modulation_jacobian"};

// A template whose instantiation for double is in another unit.
void declare(CodeText& code, const std::string& name, const char* generic, const char* instance,
             const char* types = "class Scalar") {
  code.line(fmt::format("template <{}>", types)).line(fmt::format("void {}({});", name, generic));
  code.line(fmt::format("extern template void {}<double>({});", name, instance)).line();
}

void declare_lumps(CodeText& code) {
  for (const char* const name : lump_functions)
    declare(code, name, "const Scalar* parameters, Scalar* result", "const double*, double*");
}

constexpr const char* motion_arguments =
    "const double*, const ExcitationSample*, const double*, const double*, double*";
constexpr const char* lane_arguments =
    "const LaneParameter*, const LaneSample*, const Lanes*, const Lanes*, Lanes*";
constexpr const char* modulation_arguments = "const double*, const double*, const double*, const double*, double*";

void declare_functions(Emitter& emitter) {
  CodeText& code = emitter.code;
  for (const char* const name : motion_functions)
    declare(code, name,
            "const Parameter* parameters, const Sample* excitation, const Scalar* displacement, const Scalar* "
            "velocity, "
            "Scalar* result",
            motion_arguments, "class Scalar, class Parameter, class Sample");
  code.line(fmt::format("extern template void accelerations<Lanes>({});", lane_arguments)).line();
  for (const CanonicalCase& c : emitter.model.cases) {
    code.line(fmt::format("namespace {} {{", safe_namespace(c.name))).line();
    declare_lumps(code);
    for (std::size_t b = 0; b < c.blocks.size(); ++b) {
      if (block_place(emitter.model, c, b).space != safe_namespace(c.name)) continue;
      code.line(fmt::format("void columns_{}(const BatchArrays& data, double* const* columns);", b));
      code.line(fmt::format(
          "void column_slopes_{}(const BatchArrays& data, std::size_t mode, double* const* columns);", b));
    }
    for (const char* const name : modulation_functions)
      declare(
          code, name,
          "const Scalar* parameters, const Scalar* excitation_frequency, const Scalar* amplitude, const Scalar* "
          "forcing, Scalar* result",
          modulation_arguments);
    code.line(fmt::format("}}  // namespace {}", safe_namespace(c.name))).line();
  }
}

void refuse_unsupported(const CanonicalModel& model) {
  refuse_unsupported_motion(model);
  for (const CanonicalCase& c : model.cases) refuse_unsupported(model, c);
}

// Everything but the tables: a header, or the unit of `emitter.units`, whose lumps are in another.
void emit_functions(Emitter& emitter) {
  const CanonicalModel& model = emitter.model;
  CodeText& code = emitter.code;
  emit_motion(emitter);
  if (!emitter.units) emit_shared_lumps(emitter);
  for (const CanonicalCase& c : model.cases) {
    code.line(fmt::format("namespace {} {{", safe_namespace(c.name))).line();
    if (emitter.units)
      declare_lumps(code);
    else
      emit_lumps(emitter, c);
    for (std::size_t b = 0; b < c.blocks.size(); ++b)
      if (block_place(model, c, b).space == safe_namespace(c.name)) emit_block(emitter, c, b);
    emit_modulation(emitter, c);
    code.line(fmt::format("}}  // namespace {}", safe_namespace(c.name))).line();
  }
}

GeneratedFile header(const CanonicalModel& model) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  const std::string space = safe_namespace(model.name);
  banner(emitter);
  code.line("#pragma once").line();
  include_function_headers(code, model);
  code.line(fmt::format("namespace secular::generated::{} {{", space)).line();
  emit_functions(emitter);
  code.line(fmt::format("}}  // namespace secular::generated::{}", space));
  return {model.name + ".hpp", without_namespace_indentation(code.text())};
}

GeneratedFile table(const CanonicalModel& model, bool in_units) {
  Emitter emitter(model, in_units);
  CodeText& code = emitter.code;
  const std::string space = safe_namespace(model.name);
  banner(emitter);
  if (!in_units) code.line(fmt::format("#include \"generated/{}.hpp\"", model.name)).line();
  include_table_headers(code);
  code.line(fmt::format("namespace secular::generated::{} {{", space)).line();
  if (in_units) declare_functions(emitter);
  code.line("namespace {").line();
  emit_tables(emitter);
  code.line("}  // namespace").line();
  emit_model_table(emitter);
  code.line(fmt::format("}}  // namespace secular::generated::{}", space));
  return {model.name + ".cpp", without_namespace_indentation(code.text())};
}

GeneratedFile functions_unit(const CanonicalModel& model) {
  Emitter emitter(model, true);
  CodeText& code = emitter.code;
  const std::string space = safe_namespace(model.name);
  code.comment(fmt::format("Functions of model {}.", model.name), "//");
  include_function_headers(code, model);
  code.line(fmt::format("namespace secular::generated::{} {{", space)).line();
  emit_functions(emitter);
  const auto instantiate = [&](const std::string& name, const char* arguments) {
    code.line(fmt::format("template void {}<double>({});", name, arguments));
  };
  for (const char* const name : motion_functions) instantiate(name, motion_arguments);
  code.line(fmt::format("template void accelerations<Lanes>({});", lane_arguments));
  for (const CanonicalCase& c : model.cases)
    for (const char* const name : modulation_functions)
      instantiate(fmt::format("{}::{}", safe_namespace(c.name), name), modulation_arguments);
  code.line().line(fmt::format("}}  // namespace secular::generated::{}", space));
  return {model.name + "_functions.cpp", without_namespace_indentation(code.text())};
}

GeneratedFile lumps_unit(const CanonicalModel& model) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  code.comment(fmt::format("Lumps of model {} and their derivatives.", model.name), "//");
  for (const char* const name : {"<cstddef>", "<numbers>"}) code.line(fmt::format("#include {}", name));
  code.line().line("#include \"estimator/model/integer_power.hpp\"");
  if (!model.rest_values.empty()) code.line("#include \"estimator/model/smooth_functions.hpp\"");
  code.line();
  code.line(fmt::format("namespace secular::generated::{} {{", safe_namespace(model.name))).line();
  emit_shared_lumps(emitter);
  for (const CanonicalCase& c : model.cases) {
    code.line(fmt::format("namespace {} {{", safe_namespace(c.name))).line();
    emit_lumps(emitter, c);
    for (const char* const name : lump_functions)
      code.line(fmt::format("template void {}<double>(const double*, double*);", name));
    code.line(fmt::format("}}  // namespace {}", safe_namespace(c.name))).line();
  }
  code.line(fmt::format("}}  // namespace secular::generated::{}", safe_namespace(model.name)));
  return {model.name + "_lumps.cpp", without_namespace_indentation(code.text())};
}

}  // namespace

std::vector<GeneratedFile> emit_cpp(const CanonicalModel& model) {
  refuse_unsupported(model);
  return {header(model), table(model, false)};
}

std::vector<GeneratedUnit> emit_cpp_units(const CanonicalModel& model) {
  refuse_unsupported(model);
  std::vector<GeneratedUnit> units{{functions_unit(model), true}};
  if (!model.cases.empty()) units.push_back({lumps_unit(model), false});
  units.push_back({table(model, true), false});
  return units;
}

}  // namespace secular
