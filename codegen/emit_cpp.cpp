#include "codegen/emit_cpp.hpp"

#include <fmt/format.h>

#include <utility>

#include "codegen/emitter.hpp"
#include "codegen/print_text.hpp"

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
  emitter.code.comment("Units: SI; frequencies in rad/s; amplitudes as in estimator/compiled_model.hpp.", "//");
  emitter.code.comment("Made by: secular generate " + model.name, "//");
}

enum class Lumps { defined, declared };

constexpr const char* lump_functions[] = {"evaluate_lumps", "evaluate_lumps_jacobian"};

void declare_lumps(CodeText& code) {
  for (const char* const name : lump_functions) {
    code.line("template <class Scalar>")
        .line(fmt::format("void {}(const Scalar* parameters, Scalar* result);", name));
    code.line(fmt::format("extern template void {}<double>(const double*, double*);", name)).line();
  }
}

GeneratedFile header(const CanonicalModel& model, Lumps lumps) {
  refuse_unsupported_motion(model);
  for (const CanonicalCase& c : model.cases) refuse_unsupported(model, c);
  Emitter emitter(model);
  CodeText& code = emitter.code;
  const std::string space = safe_namespace(model.name);
  banner(emitter);
  code.line("#pragma once").line();
  for (const char* const name : {"<cmath>", "<complex>", "<cstddef>", "<numbers>"})
    code.line(fmt::format("#include {}", name));
  code.line();
  for (const char* const name :
       {"compiled_model", "complex_number", "dense_solve", "dual_number", "integer_power", "scalar_functions"})
    code.line(fmt::format("#include \"estimator/{}.hpp\"", name));
  code.line().line(fmt::format("namespace secular::generated::{} {{", space)).line();
  emit_motion(emitter);
  for (const CanonicalCase& c : model.cases) {
    code.line(fmt::format("namespace {} {{", safe_namespace(c.name))).line();
    if (lumps == Lumps::defined)
      emit_lumps(emitter, c);
    else
      declare_lumps(code);
    for (std::size_t b = 0; b < c.blocks.size(); ++b) emit_block(emitter, c, b);
    emit_modulation(emitter, c);
    code.line(fmt::format("}}  // namespace {}", safe_namespace(c.name))).line();
  }
  code.line(fmt::format("}}  // namespace secular::generated::{}", space));
  return {model.name + ".hpp", without_namespace_indentation(code.text())};
}

GeneratedFile table(const CanonicalModel& model) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  const std::string space = safe_namespace(model.name);
  banner(emitter);
  code.line(fmt::format("#include \"generated/{}.hpp\"", model.name)).line();
  code.line("#include <limits>").line();
  code.line(fmt::format("namespace secular::generated::{} {{", space)).line("namespace {").line();
  emit_tables(emitter);
  code.line("}  // namespace").line();
  emit_model_table(emitter);
  code.line(fmt::format("}}  // namespace secular::generated::{}", space));
  return {model.name + ".cpp", without_namespace_indentation(code.text())};
}

GeneratedFile lumps_unit(const CanonicalModel& model) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  code.comment(fmt::format("Lumps of model {} and their derivatives.", model.name), "//");
  for (const char* const name : {"<cmath>", "<cstddef>", "<numbers>"}) code.line(fmt::format("#include {}", name));
  code.line().line("#include \"estimator/integer_power.hpp\"").line();
  code.line(fmt::format("namespace secular::generated::{} {{", safe_namespace(model.name))).line();
  for (const CanonicalCase& c : model.cases) {
    code.line(fmt::format("namespace {} {{", safe_namespace(c.name))).line();
    emit_lumps(emitter, c);
    for (const char* const name : lump_functions)
      code.line(fmt::format("template void {}<double>(const double*, double*);", name));
    code.line(fmt::format("}}  // namespace {}", safe_namespace(c.name))).line();
  }
  code.line(fmt::format("}}  // namespace secular::generated::{}", safe_namespace(model.name)));
  return {lumps_unit_name(model.name), without_namespace_indentation(code.text())};
}

}  // namespace

std::vector<GeneratedFile> emit_cpp(const CanonicalModel& model) {
  return {header(model, Lumps::defined), table(model)};
}

std::vector<GeneratedFile> emit_cpp_units(const CanonicalModel& model) {
  std::vector<GeneratedFile> files{header(model, Lumps::declared), table(model)};
  if (!model.cases.empty()) files.push_back(lumps_unit(model));
  return files;
}

std::string lumps_unit_name(const std::string& model_name) {
  return model_name + "_lumps.cpp";
}

}  // namespace secular
