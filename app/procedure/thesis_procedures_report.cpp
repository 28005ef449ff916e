#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/procedure/thesis_procedures.hpp"
#include "jobs/shared/json_numbers.hpp"
#include "numerics/confidence.hpp"
#include "report/html_report.hpp"
#include "report/number_format.hpp"

namespace secular::app {
namespace {

using Json = nlohmann::ordered_json;
using report::Column;
using report::Table;
using report::Tone;

Json anova_json(const std::string& name, const AnovaTable& table) {
  Json rows = Json::array();
  for (const AnovaRow& row : table.rows)
    rows.push_back({{"term", row.name},
                    {"degrees_of_freedom", row.degrees_of_freedom},
                    {"sum_of_squares", row.sum_of_squares},
                    {"f", optional_json(row.f)},
                    {"p", optional_json(row.p)},
                    {"f_by_condition", optional_json(row.clustered_f)},
                    {"p_by_condition", optional_json(row.clustered_p)}});
  return {{"equation", name},
          {"rows", rows},
          {"residual", table.residual},
          {"residual_degrees_of_freedom", table.residual_degrees_of_freedom},
          {"total", table.total},
          {"total_degrees_of_freedom", table.total_degrees_of_freedom},
          {"conditions", table.clusters},
          {"r_squared", table.r_squared}};
}

std::string cell(const std::optional<double>& value, int digits = 4) {
  return value ? report::format_number(*value, digits) : "";
}

// By how many standard deviations the best value is off.
std::optional<double> sd_off(const ProcedureRow& row) {
  const std::optional<double> sd = row.best_sd();
  if (!row.truth || !sd || !(*sd > 0)) return {};
  return (row.best() - *row.truth) / *sd;
}

Json bias_json(const ProcedureRow& row) {
  if (!row.bias) return nullptr;
  const Interval interval = confidence_interval(row.best(), row.bias->sd(), row.bias->degrees_of_freedom);
  return {{"value", row.bias->value},
          {"sd_by_noise", row.bias->noise_sd},
          {"sd_by_open_parameters", row.bias->open_sd},
          {"value_without_bias", row.best()},
          {"sd", row.bias->sd()},
          {"ci95", {interval.low, interval.high}}};
}

// Columns that hold something.
Table values_table(const ProcedureSection& section) {
  using Cell = std::function<std::string(const ProcedureRow&)>;
  const std::vector<std::pair<Column, Cell>> columns = {
      {{"Quantity", Column::Kind::text, ""}, [](const ProcedureRow& row) { return row.name; }},
      {{"Recovered", Column::Kind::number, ""},
       [](const ProcedureRow& row) {
         return row.sd ? report::format_uncertain(row.recovered, *row.sd) : report::format_number(row.recovered, 5);
       }},
      {{"Its bias", Column::Kind::number, ""},
       [](const ProcedureRow& row) {
         return row.bias ? report::format_uncertain(row.bias->value, row.bias->sd()) : "";
       }},
      {{"Without bias", Column::Kind::number, ""},
       [](const ProcedureRow& row) {
         return row.bias ? report::format_uncertain(row.best(), row.bias->sd()) : "";
       }},
      {{"True", Column::Kind::number, ""}, [](const ProcedureRow& row) { return cell(row.truth); }},
      {{"Off by", Column::Kind::number, "sd"},
       [](const ProcedureRow& row) {
         const std::optional<double> off = sd_off(row);
         return off ? report::format_fixed(*off, 1) : "";
       }},
      {{"As printed", Column::Kind::number, ""}, [](const ProcedureRow& row) { return cell(row.as_printed); }},
      {{"Scatter", Column::Kind::number, ""}, [](const ProcedureRow& row) { return cell(row.scatter, 2); }},
      {{"Source's table", Column::Kind::number, ""},
       [](const ProcedureRow& row) {
         if (!row.source) return std::string();
         return cell(row.source) + (row.source_sd ? " \u00b1 " + cell(row.source_sd, 3) : "") + " (" + row.table +
                ")";
       }},
      {{"Unit", Column::Kind::text, ""}, [](const ProcedureRow& row) { return report::pretty_unit(row.unit); }}};
  Table table;
  table.rows.resize(section.rows.size());
  for (const auto& [column, text] : columns) {
    std::vector<std::string> cells;
    for (const ProcedureRow& row : section.rows) cells.push_back(text(row));
    if (std::all_of(cells.begin(), cells.end(), [](const std::string& c) { return c.empty(); })) continue;
    table.columns.push_back(column);
    for (std::size_t r = 0; r < cells.size(); ++r) table.rows[r].push_back(cells[r]);
  }
  for (const ProcedureRow& row : section.rows) {
    const std::optional<double> off = sd_off(row);
    table.row_tones.push_back(off && std::abs(*off) > 3 ? Tone::caution : Tone::neutral);
  }
  return table;
}

Table anova_table(const std::string& name, const AnovaTable& anova) {
  Table table;
  table.caption = fmt::format(
      "{}: residual {} on {} degrees of freedom, total {} on {}, R\u00b2 = {:.4f}, {} conditions", name,
      report::format_number(anova.residual, 4), anova.residual_degrees_of_freedom,
      report::format_number(anova.total, 4), anova.total_degrees_of_freedom, anova.r_squared, anova.clusters);
  table.columns = {{"Term", Column::Kind::text, ""},
                   {"DOF", Column::Kind::number, ""},
                   {"SS", Column::Kind::number, ""},
                   {"F", Column::Kind::number, ""},
                   {"p", Column::Kind::number, ""},
                   {"F by condition", Column::Kind::number, ""},
                   {"p by condition", Column::Kind::number, ""}};
  for (const AnovaRow& row : anova.rows) {
    table.rows.push_back({row.name, std::to_string(row.degrees_of_freedom),
                          report::format_number(row.sum_of_squares, 4), report::format_number(row.f, 4),
                          report::format_number(row.p, 2), report::format_number(row.clustered_f, 4),
                          report::format_number(row.clustered_p, 2)});
    table.row_tones.push_back(row.clustered_p < 0.05 ? Tone::neutral : Tone::caution);
  }
  return table;
}

}  // namespace

std::string procedures_json(const ProcedureRun& run) {
  Json document;
  document["schema"] = 1;
  document["campaign"] = run.campaign.name;
  document["model"] = run.model->name;
  document["case"] = run.resonance->name;
  document["ensembles"] = run.measured.observations.size();
  document["methods"] = Json::array();
  for (const ProcedureSection& section : run.sections) {
    Json values = Json::array(), tables = Json::array();
    for (const ProcedureRow& row : section.rows)
      values.push_back({{"name", row.name},
                        {"unit", row.unit},
                        {"equation", row.equation},
                        {"value", row.recovered},
                        {"sd", optional_json(row.sd)},
                        {"scatter", optional_json(row.scatter)},
                        {"bias", bias_json(row)},
                        {"true", optional_json(row.truth)},
                        {"as_printed", optional_json(row.as_printed)},
                        {"source", optional_json(row.source)},
                        {"source_sd", optional_json(row.source_sd)},
                        {"table", row.table}});
    for (const auto& [name, table] : section.anova) tables.push_back(anova_json(name, table));
    document["methods"].push_back({{"method", section.method},
                                   {"title", section.title},
                                   {"text", section.text},
                                   {"values", values},
                                   {"analysis_of_variance", tables}});
  }
  document["warnings"] = run.warnings;
  return document.dump(2) + "\n";
}

std::string procedures_report(const ProcedureRun& run, const std::string& command) {
  report::HtmlReport page("The source's procedures on " + run.campaign.name,
                          fmt::format("Model {}, case {}", run.model->name, run.resonance->name));
  for (const std::string& warning : run.warnings) page.warn(warning);
  std::size_t inside = 0, judged = 0;
  for (const ProcedureSection& section : run.sections)
    for (const ProcedureRow& row : section.rows)
      if (const std::optional<double> off = sd_off(row)) {
        ++judged;
        if (std::abs(*off) < 2) ++inside;
      }
  if (judged > 0)
    page.card({"Truth within two standard deviations", fmt::format("{} of {}", inside, judged), "",
               inside + judged / 5 >= judged ? Tone::good : Tone::caution});
  page.card({"Ensembles", std::to_string(run.measured.observations.size()), "", Tone::neutral});
  page.paragraph(
      "Recovered: misprints and wrong signs of the source put right. As printed: what the printed equation makes "
      "of "
      "the same data. Its bias: what the method does on motions of the full equations with the parameters that "
      "`secular identify` finds, where the truth is known; its error bar holds the measured noise and what the "
      "campaign leaves open of the parameters. True: what the campaign was simulated with, where that is given. "
      "The source's tables are of "
      "the laboratory's structure: they stand beside for their size and their standard deviations.");
  for (const ProcedureSection& section : run.sections) {
    page.section(section.title);
    page.paragraph(section.text);
    if (!section.rows.empty()) page.table(values_table(section));
    for (const auto& [name, table] : section.anova) page.table(anova_table(name, table));
    for (const auto& [figure, caption] : section.figures) page.figure(figure, caption);
  }
  page.provenance({command,
                   report::program_version,
                   {fmt::format("campaign {}, {} records, {} ensembles used", run.campaign.name,
                                run.campaign.records.size(), run.measured.observations.size())}});
  return page.html();
}

}  // namespace secular::app
