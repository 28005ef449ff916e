// The tables of estimator/model/compiled_model.hpp.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "codegen/cpp/emitter.hpp"

namespace secular {
namespace {

class TableCode {
 public:
  explicit TableCode(Emitter& emitter) : model_(emitter.model), code_(emitter.code) {}

  void tables() {
    const auto as_text = [](const std::string& s) { return quoted(s); };
    code_.line(
        fmt::format("constexpr std::string_view coordinates[] = {{{}}};", listed(model_.coordinates, as_text)));
    if (!model_.excitations.empty()) {
      code_.line(
          fmt::format("constexpr std::string_view excitations[] = {{{}}};", listed(model_.excitations, as_text)));
      code_.line(fmt::format("constexpr std::string_view excitation_frequencies[] = {{{}}};",
                             listed(model_.excitation_frequencies, as_text)));
    }
    std::vector<std::string> symbol_rows;
    for (std::size_t p = 0; p < model_.parameters.size(); ++p)
      symbol_rows.push_back(
          fmt::format("{{{}, {}}},", quoted(model_.parameters[p]),
                      dimension_table(fmt::format("dimension_{}", p), model_.parameter_dimensions[p])));
    code_.line("constexpr CompiledSymbol symbols[] = {");
    for (const std::string& row : symbol_rows) code_.line(row);
    code_.line("};");
    code_.line(fmt::format("constexpr double nominal[] = {{{}}};",
                           listed(model_.nominal, [](const std::optional<double>& value) {
                             return value && std::isfinite(*value) ? fmt::format("{}", *value)
                                                                   : "std::numeric_limits<double>::quiet_NaN()";
                           })));
    code_.line();
    for (std::size_t i = 0; i < model_.cases.size(); ++i) case_tables(model_.cases[i], fmt::format("case_{}", i));
    if (model_.cases.empty()) return;
    code_.line("constexpr CompiledCase cases[] = {");
    for (std::size_t i = 0; i < model_.cases.size(); ++i) case_row(model_.cases[i], fmt::format("case_{}", i));
    code_.line("};").line();
  }

  void model_table() {
    code_.line("extern const CompiledModel model;");
    code_.line("const CompiledModel model = {");
    code_.line(fmt::format(".name = {},", quoted(model_.name)));
    code_.line(fmt::format(".source = {},", quoted(model_.source)));
    code_.line(fmt::format(".fingerprint = {},", quoted(model_.fingerprint)));
    code_.line(".coordinates = coordinates,");
    const bool excited = !model_.excitations.empty();
    code_.line(excited ? ".excitations = excitations," : ".excitations = {},");
    code_.line(excited ? ".excitation_frequencies = excitation_frequencies," : ".excitation_frequencies = {},");
    code_.line(".symbols = symbols,").line(".nominal = nominal,");
    code_.line(model_.cases.empty() ? ".cases = {}," : ".cases = cases,");
    code_.line(".mass_matrix = mass_matrix<double>,").line(".acceleration = accelerations<double>,");
    code_.line(".acceleration_of_lanes = accelerations<Lanes>,");
    for (const char* function : {"acceleration_by_state", "acceleration_by_parameters"})
      code_.line(fmt::format(".{0} = {0}<double>,", function));
    code_.line("};").line();
  }

 private:
  std::string ratios(const std::vector<CanonicalRatio>& values) const {
    std::string text;
    for (const CanonicalRatio& r : values)
      text += (text.empty() ? "" : ", ") + fmt::format("{{{}, {}}}", r.numerator, r.denominator);
    return text;
  }

  std::string dimension_table(const std::string& name, const CanonicalDimension& dimension) {
    if (!dimension) return "{}";
    code_.line(fmt::format("constexpr Ratio {}[] = {{{}}};", name, ratios(*dimension)));
    return name;
  }

  template <class Values, class Text>
  static std::string listed(const Values& values, Text text) {
    std::string result;
    for (const auto& value : values) result += (result.empty() ? "" : ", ") + text(value);
    return result;
  }

  void case_tables(const CanonicalCase& c, const std::string& id) {
    const auto number = [](int n) { return std::to_string(n); };
    std::vector<int> relations;
    for (const CanonicalRelation& relation : c.relations)
      relations.insert(relations.end(), relation.multiples.begin(), relation.multiples.end());
    if (!relations.empty())
      code_.line(fmt::format("constexpr int {}_relations[] = {{{}}};", id, listed(relations, number)));
    std::vector<CanonicalRatio> observed;
    for (const auto& row : c.observed_frequency) observed.insert(observed.end(), row.begin(), row.end());
    code_.line(fmt::format("constexpr Ratio {}_observed_frequency[] = {{{}}};", id, ratios(observed)));
    code_.line(fmt::format("constexpr bool {}_mode_at_rest[] = {{{}}};", id,
                           listed(c.mode_at_rest, [](bool b) { return std::string(b ? "true" : "false"); })));
    std::vector<std::string> lump_rows;
    for (std::size_t l = 0; l < c.lumps.size(); ++l)
      lump_rows.push_back(fmt::format("{{{}, {}, {}}},", quoted(c.lumps[l].name),
                                      quoted(formula_text(c.lumps[l].definition, model_.order)),
                                      dimension_table(fmt::format("{}_lump_{}", id, l), c.lumps[l].dimension)));
    if (!lump_rows.empty()) {
      code_.line(fmt::format("constexpr CompiledLump {}_lumps[] = {{", id));
      for (const std::string& row : lump_rows) code_.line(row);
      code_.line("};");
    }
    for (std::size_t b = 0; b < c.blocks.size(); ++b) {
      code_.line(fmt::format("constexpr int {}_block_{}_lumps[] = {{{}}};", id, b,
                             listed(c.blocks[b].columns, [](const CanonicalBlock::Column& column) {
                               return std::to_string(column.lump);
                             })));
      if (!c.blocks[b].modulation)
        code_.line(
            fmt::format("constexpr int {}_block_{}_phase[] = {{{}}};", id, b, listed(c.blocks[b].phase, number)));
    }
    if (c.blocks.empty()) return void(code_.line());
    code_.line(fmt::format("constexpr RegressorBlock {}_blocks[] = {{", id));
    for (std::size_t b = 0; b < c.blocks.size(); ++b) {
      const BlockPlace place = block_place(model_, c, b);
      code_.line(fmt::format(
          "{{BlockKind::{0}, {1}, {2}, {3}, {4}, {5}_block_{6}_lumps, column_function<{7}::columns_{9}, {8}>, "
          "column_slope_function<{7}::column_slopes_{9}, {8}>}},",
          c.blocks[b].modulation ? "modulation" : "harmonic", quoted(c.blocks[b].name), c.blocks[b].mode,
          c.blocks[b].order, c.blocks[b].modulation ? "{}" : fmt::format("{}_block_{}_phase", id, b), id, b,
          place.space,
          fmt::format("{}, {}, {}", model_.coordinates.size(), model_.excitations.size(),
                      c.blocks[b].columns.size()),
          place.block));
    }
    code_.line("};").line();
  }

  void case_row(const CanonicalCase& c, const std::string& id) {
    code_.line("{");
    code_.line(fmt::format(".name = {},", quoted(c.name)));
    code_.line(fmt::format(".excited = {},", c.excited));
    code_.line(c.relations.empty() ? ".relations = {}," : fmt::format(".relations = {}_relations,", id));
    code_.line(fmt::format(".observed_frequency = {}_observed_frequency,", id));
    code_.line(fmt::format(".mode_at_rest = {}_mode_at_rest,", id));
    code_.line(c.lumps.empty() ? ".lumps = {}," : fmt::format(".lumps = {}_lumps,", id));
    code_.line(c.blocks.empty() ? ".blocks = {}," : fmt::format(".blocks = {}_blocks,", id));
    const std::string space = safe_namespace(c.name);
    for (const char* function : {"evaluate_lumps", "evaluate_lumps_jacobian"})
      code_.line(fmt::format(".{0} = {1}::{0}<double>,", function, space));
    code_.line(fmt::format(".modulation = modulation_function<{}::modulation<double>>,", space));
    code_.line(fmt::format(".modulation_jacobian = jacobian_function<{}::modulation_jacobian<double>>,", space));
    code_.line("},");
  }

  const CanonicalModel& model_;
  CodeText& code_;
};

}  // namespace

void emit_tables(Emitter& emitter) {
  TableCode(emitter).tables();
}

void emit_model_table(Emitter& emitter) {
  TableCode(emitter).model_table();
}

}  // namespace secular
