// Lumps: functions of the parameters, and their derivatives.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "codegen/cpp/emitter.hpp"
#include "codegen/cpp/lump_gradient_lines.hpp"
#include "codegen/cpp/model_lumps.hpp"
#include "codegen/cpp/rest_value_lines.hpp"

namespace secular {
namespace {

constexpr std::size_t longest_line = 112;  // of a function in one

void symbols(Emitter& emitter, const CppWriter& writer) {
  const CanonicalModel& model = emitter.model;
  const std::vector<std::string> used = with_arguments(model, writer.used_symbols());
  std::vector<std::string> names, values;
  for (std::size_t p = 0; p < model.parameters.size(); ++p) {
    if (std::find(used.begin(), used.end(), model.parameters[p]) == used.end()) continue;
    names.push_back(safe_identifier(model.parameters[p]));
    values.push_back(fmt::format("{}(parameters[{}])", names.back(), p));
  }
  if (!names.empty()) emitter.code.list("const double ", names, ";");
  for (const std::string& name : used)
    if (name == "pi") emitter.code.line("static constexpr double pi = std::numbers::pi;");
  for (const std::string& value : rest_value_lines(model, used, "double")) emitter.code.line(value);
  for (const std::string& definition : writer.definitions()) emitter.code.line(definition);
  emitter.code.line();
  emitter.code.list(fmt::format("explicit Lumps({}const double* parameters){}",
                                values.empty() ? "[[maybe_unused]] " : "", values.empty() ? "" : " : "),
                    values, " {}");
  emitter.code.line();
}

// All lumps of a model as code. Values and derivatives share symbols, powers and inverses.
struct LumpCode {
  ModelLumps lumps;
  CppWriter writer;
  std::vector<std::string> values;
  std::vector<std::vector<std::string>> gradients;

  explicit LumpCode(const CanonicalModel& model) : lumps(model), writer(model.order, "double") {
    for (const ModelLumps::Lump& lump : lumps.all()) {
      values.push_back(writer.expression(lump.lump->definition));
      gradients.push_back(lump_gradient_lines(model, lump.lump->definition, writer));
    }
  }

  // "&Lumps::lump_mu"
  std::vector<std::string> addresses(const std::string& of) const {
    std::vector<std::string> result;
    for (const ModelLumps::Lump& lump : lumps.all()) result.push_back("&" + of + "::" + lump.function);
    return result;
  }
};

}  // namespace

void emit_lumps(Emitter& emitter) {
  CodeText& code = emitter.code;
  const LumpCode all(emitter.model);
  if (all.values.empty()) return;
  code.comment(
      "Lumps: the parameter combinations that multiply data. Symbols, their powers and the inverses of sums that "
      "divide (small divisors) first, each once.");
  code.line("struct Lumps {");
  symbols(emitter, all.writer);
  for (std::size_t l = 0; l < all.values.size(); ++l) {
    const CanonicalLump& lump = *all.lumps.all()[l].lump;
    const std::string& function = all.lumps.all()[l].function;
    const std::string body = fmt::format("double {}() const {{ return {}; }}", function, all.values[l]);
    if (body.size() <= longest_line) {
      code.line(body);
      continue;
    }
    code.comment(fmt::format("{} = {}", lump.name, formula_text(lump.definition, emitter.model.order)));
    code.line(fmt::format("double {}() const {{", function));
    code.line(fmt::format("return {};", all.values[l]));
    code.line("}");
  }
  code.line();
  code.comment("By their numbers in the tables.");
  code.list("static constexpr double (Lumps::*list[])() const = {", all.addresses("Lumps"), "};");
  code.line("};").line();
}

void emit_lump_gradients(Emitter& emitter) {
  CodeText& code = emitter.code;
  const LumpCode all(emitter.model);
  if (all.values.empty()) return;
  code.comment(
      "gradient[p] = derivative of a lump by parameters[p], entries that are not zero. Of lumps with small "
      "divisors: f_n are the fractions whose sum the lump is, q_d those of divisor d times its power and inverse, "
      "c_n what "
      "multiplies a product of coefficients.");
  code.line("struct LumpGradients : Lumps {");
  code.line("using Lumps::Lumps;").line();
  for (std::size_t l = 0; l < all.values.size(); ++l) {
    const std::string open =
        fmt::format("void {}([[maybe_unused]] double* gradient) const {{", all.lumps.all()[l].function);
    if (all.gradients[l].size() == 1) {
      const std::string statement = all.gradients[l][0].substr(0, all.gradients[l][0].find(";  // ") + 1);
      if (open.size() + statement.size() + 3 <= longest_line) {
        code.line(open + " " + statement + " }");
        continue;
      }
    }
    code.line(open);
    for (const std::string& line : all.gradients[l]) code.line(line);
    code.line("}");
  }
  code.line();
  code.line("using Gradient = void (LumpGradients::*)(double*) const;");
  code.list("static constexpr Gradient gradients[] = {", all.addresses("LumpGradients"), "};");
  code.line("};").line();
}

}  // namespace secular
