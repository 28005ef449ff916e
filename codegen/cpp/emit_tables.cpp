// The tables of estimator/model/compiled_model.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "codegen/cpp/emitter.hpp"
#include "codegen/cpp/model_lumps.hpp"

namespace secular {
namespace {

class TableCode {
 public:
  explicit TableCode(Emitter& emitter) : model_(emitter.model), code_(emitter.code), lumps_(emitter.model) {}

  void tables() {
    const auto as_text = [](const std::string& s) { return quoted(s); };
    array("std::string_view coordinates", texts(model_.coordinates, as_text));
    if (!model_.excitations.empty()) {
      array("std::string_view excitations", texts(model_.excitations, as_text));
      array("std::string_view excitation_frequencies", texts(model_.excitation_frequencies, as_text));
    }
    dimensions();
    code_.line("constexpr CompiledSymbol symbols[] = {");
    for (std::size_t p = 0; p < model_.parameters.size(); ++p)
      code_.line(fmt::format("{{{}, {}}},", quoted(model_.parameters[p]), named(model_.parameter_dimensions[p])));
    code_.line("};");
    array("double nominal", texts(model_.nominal, [](const std::optional<double>& value) {
            return value && std::isfinite(*value) ? fmt::format("{}", *value)
                                                  : "std::numeric_limits<double>::quiet_NaN()";
          }));
    code_.line();
    lump_table();
    for (std::size_t i = 0; i < model_.cases.size(); ++i) case_tables(i);
    if (model_.cases.empty()) return;
    code_.line("constexpr CompiledCase cases[] = {");
    for (std::size_t i = 0; i < model_.cases.size(); ++i) {
      const CanonicalCase& c = model_.cases[i];
      code_.list("compiled_case(",
                 {quoted(c.name), c.excited ? "true" : "false",
                  c.relations.empty() ? "{}" : fmt::format("case_{}_relations", i),
                  c.lumps.empty() ? "{}" : fmt::format("case_{}_lumps", i), fmt::format("case_{}", i)},
                 "),");
    }
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
  template <class Values, class Text>
  static std::vector<std::string> texts(const Values& values, Text text) {
    std::vector<std::string> result;
    for (const auto& value : values) result.push_back(text(value));
    return result;
  }
  static std::vector<std::string> numbers(const std::vector<int>& values) {
    return texts(values, [](int n) { return std::to_string(n); });
  }
  static std::vector<std::string> ratios(const std::vector<CanonicalRatio>& values) {
    return texts(values,
                 [](const CanonicalRatio& r) { return fmt::format("{{{}, {}}}", r.numerator, r.denominator); });
  }

  // "constexpr int NAME[] = {1, 2};"
  void array(const std::string& declaration, const std::vector<std::string>& values) {
    code_.list("constexpr " + declaration + "[] = {", values, "};");
  }

  // Those that differ, each once.
  void dimensions() {
    const auto add = [&](const CanonicalDimension& dimension) {
      if (!dimension || named(dimension) != "{}") return;
      dimensions_.push_back(*dimension);
      array("Ratio " + named(dimension), ratios(*dimension));
    };
    for (const CanonicalDimension& dimension : model_.parameter_dimensions) add(dimension);
    for (const ModelLumps::Lump& lump : lumps_.all()) add(lump.lump->dimension);
  }
  std::string named(const CanonicalDimension& dimension) const {
    const auto place =
        dimension ? std::find(dimensions_.begin(), dimensions_.end(), *dimension) : dimensions_.end();
    return place == dimensions_.end() ? "{}" : fmt::format("dimension_{}", place - dimensions_.begin());
  }

  void lump_table() {
    if (lumps_.all().empty()) return;
    code_.line("constexpr CompiledLump lump_table[] = {");
    for (const ModelLumps::Lump& lump : lumps_.all()) {
      const std::vector<std::string> definition = quoted_lines(formula_text(lump.lump->definition, model_.order));
      const std::string open = fmt::format("{{{},", quoted(lump.lump->name));
      const std::string close = fmt::format(", {}}},", named(lump.lump->dimension));
      if (definition.size() == 1) {
        code_.list(open + " ", {definition.front()}, close);
        continue;
      }
      code_.line(open);
      for (std::size_t i = 0; i < definition.size(); ++i)
        code_.line(" " + definition[i] + (i + 1 == definition.size() ? close : ""));
    }
    code_.line("};").line();
  }

  void case_tables(std::size_t i) {
    const CanonicalCase& c = model_.cases[i];
    const std::string id = fmt::format("case_{}", i), space = safe_namespace(c.name);
    code_.comment("Case " + c.name + ".", "//");
    std::vector<int> relations, columns, phases;
    for (const CanonicalRelation& relation : c.relations)
      relations.insert(relations.end(), relation.multiples.begin(), relation.multiples.end());
    for (const CanonicalBlock& block : c.blocks) {
      for (const CanonicalBlock::Column& column : block.columns) columns.push_back(static_cast<int>(column.lump));
      if (!block.modulation) phases.insert(phases.end(), block.phase.begin(), block.phase.end());
    }
    std::vector<CanonicalRatio> observed;
    for (const auto& row : c.observed_frequency) observed.insert(observed.end(), row.begin(), row.end());
    if (!relations.empty()) array("int " + id + "_relations", numbers(relations));
    array("Ratio " + id + "_observed_frequency", ratios(observed));
    array("bool " + id + "_mode_at_rest",
          texts(c.mode_at_rest, [](bool b) { return std::string(b ? "true" : "false"); }));
    if (!c.lumps.empty()) {
      array("int " + id + "_lump_numbers", numbers(lumps_.of_case(i)));
      code_.line(fmt::format("constexpr auto {0}_lumps = chosen_lumps(lump_table, {0}_lump_numbers);", id));
    }
    if (!c.blocks.empty()) {
      code_.line(fmt::format("constexpr BlockTable {}_block_table[] = {{", id));
      for (const CanonicalBlock& block : c.blocks)
        code_.line(fmt::format("{{BlockKind::{}, {}, {}, {}, {}}},", block.modulation ? "modulation" : "harmonic",
                               quoted(block.name), block.mode, block.order, block.columns.size()));
      code_.line("};");
      array("int " + id + "_block_lumps", numbers(columns));
      if (!phases.empty()) array("int " + id + "_phases", numbers(phases));
      code_.list(fmt::format("constexpr auto {}_blocks = regressor_blocks(", id),
                 {id + "_block_table", space + "::blocks", id + "_block_lumps",
                  phases.empty() ? "nullptr" : id + "_phases",
                  std::to_string(model_.natural_frequencies.size() + model_.excitation_frequencies.size())},
                 ");");
    }
    code_.list(fmt::format("constexpr GeneratedCase {} = {{", id),
               {c.lumps.empty() ? "nullptr" : "&lump_functions", c.lumps.empty() ? "{}" : id + "_lump_numbers",
                c.blocks.empty() ? "nullptr" : space + "::blocks", c.blocks.empty() ? "{}" : id + "_blocks",
                id + "_observed_frequency", id + "_mode_at_rest"},
               "};");
    code_.line();
  }

  const CanonicalModel& model_;
  CodeText& code_;
  ModelLumps lumps_;
  std::vector<std::vector<CanonicalRatio>> dimensions_;
};

}  // namespace

void emit_tables(Emitter& emitter) {
  TableCode(emitter).tables();
}

void emit_model_table(Emitter& emitter) {
  TableCode(emitter).model_table();
}

}  // namespace secular
