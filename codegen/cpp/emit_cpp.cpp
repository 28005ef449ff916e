#include "codegen/cpp/emit_cpp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "codegen/cpp/emitter.hpp"
#include "codegen/document/print_text.hpp"

namespace secular {
namespace {

std::string relations_of(const CanonicalCase& c) {
  std::string relations;
  for (const CanonicalRelation& relation : c.relations)
    relations += (relations.empty() ? "" : "; ") + commented(relation.text);
  return !relations.empty() ? relations : c.excited ? "no resonance" : "free vibration";
}

std::string case_file(const CanonicalModel& model, const CanonicalCase& c) {
  return model.name + "." + c.name + ".hpp";
}

std::string space_of(const CanonicalModel& model) {
  return "secular::generated::" + safe_namespace(model.name);
}

void banner(Emitter& emitter, const std::string& content) {
  const CanonicalModel& model = emitter.model;
  emitter.code.comment(fmt::format("Model {}: generated code, never edited by hand.", model.name), "//");
  emitter.code.comment(fmt::format("Holds {} Made by: secular generate {}.", content, model.name), "//");
}

void model_banner(Emitter& emitter) {
  const CanonicalModel& model = emitter.model;
  banner(emitter, "equations of motion, lumps, what rows are made of.");
  if (!model.source.empty()) emitter.code.comment("Source: " + commented(model.source), "//");
  emitter.code.comment("Units: SI; frequencies in rad/s; amplitudes as in estimator/model/compiled_model.hpp.",
                       "//");
  for (const CanonicalCase& c : model.cases)
    emitter.code.comment(fmt::format("{}: {}", case_file(model, c), relations_of(c)), "//");
}

void case_banner(Emitter& emitter, const CanonicalCase& c) {
  banner(emitter, fmt::format("rows of the case {}.", c.name));
  emitter.code.comment(
      fmt::format(
          "{}, multiple scales to eps^{}. Valid near that resonance for small amplitudes; what is left out is "
          "of order eps^{}.",
          relations_of(c), c.expand_to, c.expand_to + 1),
      "//");
}

// Light headers alone, see BatchArrays.
void include(CodeText& code, std::vector<std::string> names) {
  code.line("#include <cstddef>").line("#include <numbers>").line();
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) code.line(fmt::format("#include \"estimator/model/{}.hpp\"", name));
  code.line();
}

std::vector<std::string> function_headers(const CanonicalModel& model) {
  std::vector<std::string> names = {"block_functions", "dense_solve",    "excitation_sample", "integer_power",
                                    "lane_functions",  "lump_functions", "scalar_functions"};
  if (has_smooth_functions(model)) names.push_back("smooth_functions");
  return names;
}

constexpr const char* motion_functions[] = {"mass_matrix", "accelerations", "acceleration_by_state",
                                            "acceleration_by_parameters"};
constexpr const char* motion_arguments =
    "const double*, const ExcitationSample*, const double*, const double*, double*";
constexpr const char* lane_arguments =
    "const LaneParameter*, const LaneSample*, const Lanes*, const Lanes*, Lanes*";

// Tables of a unit among several: what the others hold.
void declare_functions(Emitter& emitter) {
  CodeText& code = emitter.code;
  for (const char* const name : motion_functions) {
    code.line("template <class Scalar, class Parameter, class Sample>");
    code.line(
        fmt::format("void {}(const Parameter*, const Sample*, const Scalar*, const Scalar*, Scalar*);", name));
    code.line(fmt::format("extern template void {}<double>({});", name, motion_arguments));
  }
  code.line(fmt::format("extern template void accelerations<Lanes>({});", lane_arguments));
  code.line("extern const LumpFunctions lump_functions;");
  for (const CanonicalCase& c : emitter.model.cases)
    if (!c.blocks.empty())
      code.line(fmt::format("namespace {} {{ extern const BlockFunctions blocks[{}]; }}", safe_namespace(c.name),
                            c.blocks.size()));
  code.line();
}

void refuse_unsupported(const CanonicalModel& model) {
  refuse_unsupported_motion(model);
  for (const CanonicalCase& c : model.cases) refuse_unsupported(model, c);
}

bool has_lumps(const CanonicalModel& model) {
  return std::any_of(model.cases.begin(), model.cases.end(),
                     [](const CanonicalCase& c) { return !c.lumps.empty(); });
}

// `linkage`: of constants, "inline constexpr" in a header, "extern const" of a unit among several.
void lump_list(Emitter& emitter, const std::string& linkage) {
  if (!has_lumps(emitter.model)) return;
  emitter.code.line(
      fmt::format("{} LumpFunctions lump_functions = {{lump_values<Lumps>, lump_jacobian<LumpGradients, "
                  "{}>}};",
                  linkage, emitter.model.parameters.size()));
}

// Rows of one case in its namespace.
void emit_case(Emitter& emitter, std::size_t i, const std::string& linkage) {
  const CanonicalCase& c = emitter.model.cases[i];
  CodeText& code = emitter.code;
  code.line(fmt::format("namespace {} {{", safe_namespace(c.name))).line();
  emit_blocks(emitter, i);
  if (!c.blocks.empty()) {
    code.list(fmt::format("{} BlockFunctions blocks[{}] = {{", linkage, c.blocks.size()),
              block_function_list(emitter.model, i), "};");
    code.line();
  }
  code.line(fmt::format("}}  // namespace {}", safe_namespace(c.name)));
}

constexpr const char* in_header = "inline constexpr";
constexpr const char* in_unit = "extern const";

GeneratedFile model_header(const CanonicalModel& model) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  model_banner(emitter);
  code.line("#pragma once").line();
  include(code, function_headers(model));
  code.line(fmt::format("namespace {} {{", space_of(model))).line();
  emit_motion(emitter);
  emit_lumps(emitter);
  emit_row_signals(emitter);
  code.line(fmt::format("}}  // namespace {}", space_of(model)));
  return {model.name + ".hpp", without_namespace_indentation(code.text())};
}

std::string gradient_file(const CanonicalModel& model) {
  return model.name + ".lump-gradients.hpp";  // no case is named so
}

GeneratedFile gradient_header(const CanonicalModel& model) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  banner(emitter, "derivatives of the lumps by the parameters.");
  code.line("#pragma once").line();
  code.line(fmt::format("#include \"{}.hpp\"", model.name)).line();
  code.line(fmt::format("namespace {} {{", space_of(model))).line();
  emit_lump_gradients(emitter);
  lump_list(emitter, in_header);
  code.line().line(fmt::format("}}  // namespace {}", space_of(model)));
  return {gradient_file(model), without_namespace_indentation(code.text())};
}

GeneratedFile case_header(const CanonicalModel& model, std::size_t i) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  case_banner(emitter, model.cases[i]);
  code.line("#pragma once").line();
  std::set<std::size_t> others;
  for (std::size_t b = 0; b < model.cases[i].blocks.size(); ++b) others.insert(block_place(model, i, b).resonance);
  others.erase(i);
  for (const std::size_t other : others)
    code.line(fmt::format("#include \"{}\"", case_file(model, model.cases[other])));
  code.line(fmt::format("#include \"{}.hpp\"", model.name)).line();
  code.line(fmt::format("namespace {} {{", space_of(model))).line();
  emit_case(emitter, i, in_header);
  code.line(fmt::format("}}  // namespace {}", space_of(model)));
  return {case_file(model, model.cases[i]), without_namespace_indentation(code.text())};
}

GeneratedFile table(const CanonicalModel& model, bool in_units) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  banner(emitter, "tables.");
  if (!in_units) {
    for (const CanonicalCase& c : model.cases) code.line(fmt::format("#include \"{}\"", case_file(model, c)));
    if (has_lumps(model)) code.line(fmt::format("#include \"{}\"", gradient_file(model)));
    code.line(fmt::format("#include \"{}.hpp\"", model.name)).line();
  }
  code.line("#include <limits>").line().line("#include \"estimator/model/generated_table.hpp\"").line();
  code.line(fmt::format("namespace {} {{", space_of(model))).line();
  if (in_units) declare_functions(emitter);
  code.line("namespace {").line();
  emit_tables(emitter);
  code.line("}  // namespace").line();
  emit_model_table(emitter);
  code.line(fmt::format("}}  // namespace {}", space_of(model)));
  return {model.name + ".cpp", without_namespace_indentation(code.text())};
}

GeneratedFile functions_unit(const CanonicalModel& model) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  banner(emitter, "equations of motion and rows.");
  include(code, function_headers(model));
  code.line(fmt::format("namespace {} {{", space_of(model))).line();
  emit_motion(emitter);
  for (const char* const name : motion_functions)
    code.line(fmt::format("template void {}<double>({});", name, motion_arguments));
  code.line(fmt::format("template void accelerations<Lanes>({});", lane_arguments)).line();
  emit_row_signals(emitter);
  for (std::size_t i = 0; i < model.cases.size(); ++i) emit_case(emitter, i, in_unit);
  code.line(fmt::format("}}  // namespace {}", space_of(model)));
  return {model.name + "_functions.cpp", without_namespace_indentation(code.text())};
}

GeneratedFile lumps_unit(const CanonicalModel& model) {
  Emitter emitter(model);
  CodeText& code = emitter.code;
  banner(emitter, "lumps.");
  std::vector<std::string> headers = {"lump_functions"};
  if (!model.rest_values.empty()) headers.push_back("smooth_functions");
  include(code, headers);
  code.line(fmt::format("namespace {} {{", space_of(model))).line();
  emit_lumps(emitter);
  emit_lump_gradients(emitter);
  lump_list(emitter, in_unit);
  code.line(fmt::format("}}  // namespace {}", space_of(model)));
  return {model.name + "_lumps.cpp", without_namespace_indentation(code.text())};
}

}  // namespace

std::vector<GeneratedFile> emit_cpp(const CanonicalModel& model) {
  refuse_unsupported(model);
  std::vector<GeneratedFile> files{model_header(model)};
  if (has_lumps(model)) files.push_back(gradient_header(model));
  for (std::size_t i = 0; i < model.cases.size(); ++i) files.push_back(case_header(model, i));
  files.push_back(table(model, false));
  return files;
}

std::vector<GeneratedUnit> emit_cpp_units(const CanonicalModel& model) {
  refuse_unsupported(model);
  std::vector<GeneratedUnit> units{{functions_unit(model), true}};
  if (has_lumps(model)) units.push_back({lumps_unit(model), false});
  units.push_back({table(model, true), true});
  return units;
}

}  // namespace secular
