#include "codegen/document/print_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "codegen/document/plain_text.hpp"
#include "codegen/document/print_text.hpp"
#include "codegen/document/rest_lines.hpp"
#include "codegen/document/steady_statements.hpp"
#include "codegen/expression/cpp_expression.hpp"

namespace secular {
namespace {

using Json = nlohmann::ordered_json;

Json terms_json(const CanonicalModel& model, const CanonicalCase& c, const std::vector<CanonicalTerm>& terms,
                bool harmonics) {
  Json list = Json::array();
  for (const CanonicalTerm& term : terms) {
    Json entry;
    entry["order"] = term.order;
    if (harmonics) entry["phase"] = phase_text(model, term.powers.phase);
    entry["powers"] = powers_text(model, term.powers);
    if (!harmonics) {
      Json slow = Json::object();
      for (std::size_t r = 0; r < c.relations.size(); ++r)
        if (term.powers.slow_phase[r] != 0 && !c.relations[r].detuning.empty())
          slow[c.relations[r].detuning] = term.powers.slow_phase[r];
      entry["slow_phase"] = std::move(slow);
    }
    entry["real"] = formula_text(term.real, model.order);
    entry["imaginary"] = formula_text(term.imaginary, model.order);
    list.push_back(std::move(entry));
  }
  return list;
}

Json section_json(const typeset::StatementSection& section) {
  Json list = Json::array();
  for (const typeset::Statement& statement : section.statements) {
    Json equations = Json::array();
    for (const typeset::Equation& equation : statement.equations)
      equations.push_back(
          {{"left", typeset::plain_text(equation.left)}, {"right", typeset::plain_text(equation.right)}});
    list.push_back({{"name", statement.key},
                    {"meaning", typeset::plain_text(statement.says)},
                    {"equations", std::move(equations)}});
  }
  return list;
}

}  // namespace

std::string derivation_json(const CanonicalModel& model) {
  Json result;
  result["model"] = model.name;
  result["source"] = model.source;
  for (std::size_t k = 0; k < model.coordinates.size(); ++k)
    result["equations_of_motion"][model.coordinates[k]] = motion_text(model, k);
  for (const std::string& line : rest_lines(model)) result["rest"].push_back(line);
  result["cases"] = Json::array();
  for (const CanonicalCase& c : model.cases) {
    Json entry;
    entry["case"] = c.name;
    entry["expand_to"] = c.expand_to;
    for (const auto& [name, order] : c.chosen_orders) entry["order"][name] = order;
    entry["relations"] = Json::array();
    for (const CanonicalRelation& relation : c.relations) entry["relations"].push_back(relation.text);
    for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
      entry["modulation"][model.coordinates[k]] = terms_json(model, c, c.slow_derivative[k], false);
      entry["harmonics"][model.coordinates[k]] = terms_json(model, c, c.harmonics[k], true);
    }
    for (const CanonicalSeries& series : c.series)
      entry["functions"].push_back({{"function", factors_text(model, {series.function})},
                                    {"degree", series.degree},
                                    {"series", sum_text(model, series.terms)}});
    for (const CanonicalQuadrature& quadrature : c.quadratures)
      entry["quadratures"].push_back({{"mode", model.coordinates[quadrature.mode]},
                                      {"order", quadrature.order},
                                      {"mean_of", factors_text(model, quadrature.factors)},
                                      {"real", formula_text(quadrature.real, model.order)},
                                      {"imaginary", formula_text(quadrature.imaginary, model.order)}});
    if (!c.observed_frequency.empty())
      for (const typeset::StatementSection& section : typeset::steady_sections(model, c))
        entry[section.key] = section_json(section);
    entry["lumps"] = Json::array();
    for (const CanonicalLump& lump : c.lumps)
      entry["lumps"].push_back({{"name", lump.name}, {"definition", formula_text(lump.definition, model.order)}});
    entry["blocks"] = Json::array();
    for (const CanonicalBlock& block : c.blocks)
      entry["blocks"].push_back({{"name", block.name}, {"equation", equation_text(model, c, block)}});
    entry["certificate"] = {{"holds", c.certificate.holds},
                            {"order", c.certificate.order},
                            {"coefficients_checked", c.certificate.coefficients_checked},
                            {"remainders", c.certificate.remainders}};
    entry["warnings"] = c.warnings;
    result["cases"].push_back(std::move(entry));
  }
  return result.dump(2) + "\n";
}

}  // namespace secular
