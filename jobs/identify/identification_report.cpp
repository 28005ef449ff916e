#include "jobs/identify/identification_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "jobs/identify/case_view.hpp"
#include "jobs/identify/decay_figures.hpp"
#include "jobs/identify/dwell_figures.hpp"
#include "jobs/identify/estimate_tables.hpp"
#include "jobs/identify/full_report.hpp"
#include "jobs/identify/scatter_output.hpp"
#include "jobs/identify/verdict_sentence.hpp"
#include "jobs/shared/disturbance_output.hpp"
#include "jobs/shared/residual_whiteness.hpp"
#include "report/html_report.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using report::Axis;
using report::Column;
using report::Figure;
using report::Panel;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;
using report::Table;
using report::Tone;

std::string cases_text(const Identification& id) {
  std::string text;
  for (const ObservationSet& set : id.measured)
    text += (text.empty() ? "" : ", ") + std::string(set.resonance->name);
  return (id.measured.size() > 1 ? "cases " : "case ") + text;
}

std::size_t observations_of(const Identification& id) {
  std::size_t count = 0;
  for (const ObservationSet& set : id.measured) count += set.observations.size();
  return count;
}

void add_damping(report::HtmlReport& page, const Estimate& estimate) {
  page.section("Damping laws");
  page.paragraph(
      "Every selection of damping terms, judged by how well it predicts the equations of conditions that were left "
      "out, "
      "one after the other. The score is the mean square over what noise explains; differences to the chosen law "
      "are "
      "taken condition by condition, p is that of a signed-rank test over the conditions. Chosen is the law with "
      "the "
      "fewest terms among those that predict no worse than the best.");
  for (const DampingComparison& comparison : estimate.damping) {
    Table table;
    table.columns = {{"Terms of " + comparison.mode, Column::Kind::text, ""},
                     {"Held-out score", Column::Kind::number, ""},
                     {"Worse than the chosen by", Column::Kind::number, ""},
                     {"Standard deviation", Column::Kind::number, ""},
                     {"p", Column::Kind::number, ""},
                     {"", Column::Kind::text, ""}};
    for (std::size_t l = 0; l < comparison.laws.size(); ++l) {
      const DampingLaw& law = comparison.laws[l];
      const bool chosen = l == comparison.chosen;
      table.rows.push_back({fmt::format("{}", fmt::join(law.terms, " + ")), report::format_number(law.score, 4),
                            report::format_number(law.worse_by, 3), report::format_number(law.sd, 2),
                            chosen ? "" : report::format_number(law.p_value, 2),
                            chosen ? "chosen" : (law.excluded ? "excluded" : "predicts no worse")});
    }
    page.table(table);
    page.paragraph(comparison.decided
                       ? "Decided: every law that lacks a term of the chosen one is excluded."
                       : "Not decided: a law without all terms of the chosen one predicts no worse.");
  }
}

void add_lack_of_fit(report::HtmlReport& page, const Estimate& estimate) {
  if (estimate.lack_of_fit.empty()) return;
  Table table;
  table.columns = {{"Equation", Column::Kind::text, ""},
                   {"Case", Column::Kind::text, ""},
                   {"Misfit over repeats", Column::Kind::number, ""},
                   {"Repeats over noise", Column::Kind::number, ""},
                   {"Degrees of freedom", Column::Kind::text, ""},
                   {"p", Column::Kind::number, ""}};
  for (const CaseLackOfFit& tests : estimate.lack_of_fit)
    for (const LackOfFit& test : tests.equations) {
      table.rows.push_back({test.name, tests.resonance, report::format_number(test.misfit_ratio, 3),
                            report::format_number(test.scatter_ratio, 3),
                            std::isfinite(test.denominator_df)
                                ? fmt::format("{:.1f}, {:.0f}", test.numerator_df, test.denominator_df)
                                : fmt::format("{:.1f}", test.numerator_df),
                            report::format_number(test.p_value, 2)});
      table.row_tones.push_back(test.significant ? Tone::caution : Tone::neutral);
    }
  page.table(table);
  page.paragraph(
      "Does each equation hold at every condition as well as repeats of one condition agree? A ratio of one is "
      "perfect. Where it is significant (marked), the model lacks something, its parameters have absorbed part of "
      "it, and error bars are widened by what as large a part again would do along them; where that dominates, a "
      "value is called doubtful.");
}

void add_tests(report::HtmlReport& page, const Estimate& estimate) {
  Table table;
  table.columns = {
      {"Lump", Column::Kind::text, ""}, {"Case", Column::Kind::text, ""},
      {"F", Column::Kind::number, ""},  {"Degrees of freedom", Column::Kind::text, ""},
      {"p", Column::Kind::number, ""},  {"p, all tests of the case allowed for", Column::Kind::number, ""}};
  for (const EstimatedValue& v : estimate.lumps)
    if (v.partial_f)
      table.rows.push_back({v.name, v.resonance, report::format_number(v.partial_f->f, 4),
                            fmt::format("1, {:.0f}", v.partial_f->degrees_of_freedom),
                            report::format_number(v.partial_f->p_value, 3),
                            report::format_number(v.partial_f->p_value_holm, 3)});
  if (table.rows.empty()) return;
  page.section("Analysis of variance, added last");
  page.paragraph(
      "Partial F of each lump added after all others. The denominator's degrees of freedom count conditions, not "
      "ensembles: ensembles of one condition share what the model gets wrong there. The last column is Holm's, for "
      "all "
      "tests of the case together.");
  page.table(table);
}

void add_conditions(report::HtmlReport& page, const Identification& id) {
  if (id.estimate.conditions.empty()) return;
  page.section("Conditions");
  Figure figure;
  figure.title = "Residual of every condition";
  figure.x = {"Peak amplitude of the first oscillating mode", id.coordinate_unit, false, {}};
  Panel panel;
  panel.y = {"Residual over noise", "", false, {}};
  Table table;
  table.columns = {{"Record", Column::Kind::text, ""},
                   {"Case", Column::Kind::text, ""},
                   {"Ensembles", Column::Kind::number, ""},
                   {"Leverage", Column::Kind::number, ""},
                   {"Influence (Cook)", Column::Kind::number, ""},
                   {"Residual over noise", Column::Kind::number, ""}};
  for (std::size_t c = 0; c < id.measured.size(); ++c) {
    Series points;
    points.name = std::string(id.measured[c].resonance->name);
    points.style = SeriesStyle::points;
    points.role = SeriesRole::data;
    points.group = static_cast<int>(c);
    const CaseView view = view_of(id, c);
    for (const ConditionQuality& q : id.estimate.conditions) {
      if (q.resonance != points.name) continue;
      points.x.push_back(q.amplitude[first_mode(view)]);
      points.y.push_back(q.residual);
      table.rows.push_back({id.campaign.records[q.record].file, q.resonance, std::to_string(q.ensembles),
                            report::format_number(q.leverage, 3), report::format_number(q.influence, 3),
                            report::format_number(q.residual, 3)});
      table.row_tones.push_back(q.influence > 1 ? Tone::caution : Tone::neutral);
    }
    if (!points.x.empty()) panel.series.push_back(std::move(points));
  }
  figure.panels.push_back(std::move(panel));
  page.figure(figure,
              "Root mean square of the whitened equation residuals by condition. A trend with amplitude says "
              "that the model lacks something.");
  page.table(table);
  page.paragraph(
      "Leverage adds up to the number of unknowns. Influence above one (marked) means that the estimates "
      "move by more than their joint error bar when that condition is left out.");
}

void add_outliers(report::HtmlReport& page, const Identification& id) {
  if (id.estimate.outliers.empty()) return;
  page.paragraph("Ensembles that stand out from the others of their condition:");
  Table table;
  table.columns = {{"Record", Column::Kind::text, ""},
                   {"Case", Column::Kind::text, ""},
                   {"Ensemble at", Column::Kind::number, "s"},
                   {"Distance over usual", Column::Kind::number, ""},
                   {"Weight", Column::Kind::number, ""}};
  for (const OutlyingEnsemble& o : id.estimate.outliers)
    table.rows.push_back({id.campaign.records[o.record].file, o.resonance, fmt::format("{:.1f}", o.centre_s),
                          report::format_number(o.distance, 3), report::format_number(o.weight, 2)});
  page.table(table);
}

void add_nearly_alike(report::HtmlReport& page, const Estimate& estimate) {
  std::string text;
  for (const EstimatedValue& v : estimate.lumps) {
    if (v.nearly_entangled_with.empty()) continue;
    text += label_of(v, estimate) + ":";
    for (const std::string& other : v.nearly_entangled_with) text += " " + other;
    text += "\n";
  }
  if (!text.empty())
    page.details("Lumps that act nearly alike on these conditions", [&] { page.preformatted(text); });
}

LeftInTime left_of(const HeldOutPrediction& decay) {
  std::vector<double> left = decay.measured;
  for (std::size_t i = 0; i < left.size(); ++i) left[i] -= decay.predicted[i];
  return {{left}, 0};
}

ComparedInTime in_time(const Identification& id) {
  std::set<std::size_t> records, not_white;
  for (const std::vector<HeldOutPrediction>* decays : {&id.followed, &id.held_out})
    for (const HeldOutPrediction& decay : *decays) {
      records.insert(decay.record);
      if (!whiteness_of(left_of(decay)).is_white()) not_white.insert(decay.record);
    }
  return {records.size(), not_white.size()};
}

void add_decay(report::HtmlReport& page, const CaseView& view, const HeldOutPrediction& decay, bool held_out) {
  const std::string file = view.campaign.records[decay.record].file;
  page.figure(
      decay_in_time(view, decay, held_out ? "Held out: the rest of the decay, " + file : "In time: " + file),
      fmt::format("{}, integrated in one piece from one state: an error of frequency adds up. Fit: {}.",
                  held_out ? "The part of the record after the fitted window" : "What was fitted",
                  report::format_percent(share_fitted(decay.measured, decay.predicted))));
  if (decay.time.size() < 2) return;
  add_whiteness(page, left_of(decay), decay.time[1] - decay.time[0]);
}

// The case of the first figure: the first one of which anything was observed.
std::size_t shown_case(const Identification& id) {
  std::size_t shown = 0;
  while (shown + 1 < id.measured.size() && id.measured[shown].observations.empty()) ++shown;
  return shown;
}

Figure first_figure(const CaseView& view) {
  if (view.resonance->excited) return dwell_response(view);
  const std::vector<std::size_t> seen = modes_seen(view);
  return decay_response(view, seen.empty() ? first_mode(view) : seen.front());
}

void add_response(report::HtmlReport& page, const Identification& id, const CaseView& view,
                  const Figure& response) {
  page.section(id.measured.size() > 1 ? "Response, case " + std::string(view.resonance->name) : "Response");
  if (view.resonance->excited) {
    page.figure(
        response,
        "Peak amplitude of the modal displacement: mean over the ensembles of a dwell, bars of two standard "
        "deviations of that mean (often smaller than the marker). " +
            meaning_of_lines(response) +
            (view.is_replayed()
                 ? " Hollow markers are what the full equations of motion do at each dwell's own level."
                 : "") +
            " A level has dwells within 1 % and the name of their mean.");
    if (const std::optional<Figure> by_level = dwells_by_level(view))
      page.figure(*by_level,
                  "The same dwells against the excitation's amplitude. Frequencies differ from point to "
                  "point, so nothing joins them.");
    if (view.is_replayed())
      page.figure(dwell_differences(view),
                  "What is left: amplitude and phase of every dwell against the full equations; bars are two "
                  "standard deviations of a dwell's mean. " +
                      size_of_differences(view));
    return;
  }
  const std::vector<std::size_t> modes = modes_seen(view);
  for (const std::size_t mode : modes) {
    page.figure(
        mode == modes.front() ? response : decay_response(view, mode),
        "Every window of the decay (bars: two standard deviations) and the same windows on the full equations "
        "with the estimated parameters. Band: two standard deviations by the noise of the measurement and "
        "by what it leaves open; what a lack of fit adds to the error bars of the table is not in it.");
    if (id.held_out.empty() && view.is_replayed())
      page.figure(decay_residuals(view, mode),
                  "What is left of frequency and decay rate in every window, with bars of two standard deviations. "
                  "Neighbouring windows overlap, so they scatter together.");
  }
  for (const HeldOutPrediction& decay : id.followed) add_decay(page, view, decay, false);
  for (const HeldOutPrediction& decay : id.held_out) add_decay(page, view, decay, true);
}

// Lateness of the responses by record.
void add_lateness(report::HtmlReport& page, const CaseLateness& lateness) {
  Series late{"Responses", SeriesStyle::points, SeriesRole::data, {}, {}, {}, {}};
  for (const RecordLateness& record : lateness.records) {
    late.x.push_back(static_cast<double>(record.record + 1));
    late.y.push_back(1e3 * record.late_s);
  }
  Figure figure;
  figure.title = "Responses later than their excitation";
  figure.x = {"Record", "", false, {}};
  figure.panels.push_back({"", {"Lateness", "ms", false, {}}, {late}});
  page.figure(figure, text_of(lateness) + ".");
}

void add_regression_quality(report::HtmlReport& page, const Estimate& estimate) {
  page.section("Quality of the regression");
  Table table;
  table.columns = {{"Equation", Column::Kind::text, ""},          {"Rows", Column::Kind::number, ""},
                   {"Conditions", Column::Kind::number, ""},      {"Residual over noise", Column::Kind::number, ""},
                   {"Condition index", Column::Kind::number, ""}, {"Error bars", Column::Kind::text, ""}};
  for (const BlockQuality& block : estimate.blocks)
    table.rows.push_back({block.name, std::to_string(block.equations), std::to_string(block.conditions),
                          report::format_number(block.normalised_residual, 3),
                          report::format_number(block.condition_index, 3),
                          block.clustered ? "clustered by condition (jackknife)" : "from residuals"});
  page.table(table);
  page.paragraph(
      "Residual over noise is one where measurement noise explains everything. It grows where the expansion is "
      "truncated "
      "or the model lacks an effect. A condition index above about 30 warns of parameters that the data separate "
      "poorly.");
}

}  // namespace

Figure response_figure(const Identification& id) {
  return id.full ? full_figure(id) : first_figure(view_of(id, shown_case(id)));
}

std::string identification_report(const Identification& id, const Figure& response, const std::string& command) {
  if (id.full) return full_report(id, command);
  const std::set<std::string> frequencies = natural_frequencies(*id.model);
  report::HtmlReport page("Identification of " + std::string(id.model->name),
                          "Campaign " + id.campaign.name + ", " + cases_text(id));
  for (const std::string& warning : id.estimate.warnings) page.warn(warning);
  const ComparedInTime compared = in_time(id);
  page.verdict(verdict_sentence(id.estimate, compared), verdict_tone(id.estimate, compared));
  add_cards(page, id.estimate, frequencies);
  const bool angle = id.coordinate_unit == "rad";
  for (const HeldOutPrediction& p : id.held_out)
    page.card({"Held out, predicted within",
               angle ? report::format_number(p.rms * 180 / std::numbers::pi, 3) + " degrees RMS"
                     : report::format_number(p.rms, 3) + " " + report::pretty_unit(id.coordinate_unit) + " RMS",
               fmt::format("{:.1f} s to {:.1f} s, not used in the fit", p.from_s, p.to_s), Tone::neutral});

  page.section("Parameters");
  page.paragraph(
      "Physical parameters of the model as far as these data determine them. A parameter in the second column's "
      "words \"not identifiable\" cannot be told apart from those it is entangled with: no number is given for it. "
      "Standard deviations have two parts: by noise, from the scatter between test conditions, and what is left "
      "open, the bias that the expansion's truncation may have where entangled parameters act beyond it (another "
      "measurement of the same kind would not change that part).");
  if (id.refinement) {
    page.paragraph("Numbers are " + text_of(*id.refinement) + ".");
    if (id.refinement->is_taken())
      page.paragraph(
          "Their noise is that of the samples. Standard deviations hold beside it what parts of the decays differ "
          "by, "
          "and what laws too weak to be seen could move. Lumps are those of the modulation equations.");
  }
  add_values(page, id.estimate, false, frequencies);
  if (id.refinement) add_refinement(page, *id.refinement);
  add_following(page, id);
  add_pairs(page, id.estimate, frequencies);
  for (const std::string& line : scatter_lines(id.estimate)) page.paragraph(line + ".");
  for (std::size_t c = 0; c < id.measured.size(); ++c) {
    const CaseView view = view_of(id, c);
    if (!view.measured.observations.empty())
      add_response(page, id, view, c == shown_case(id) ? response : first_figure(view));
  }
  if (!id.disturbances.empty() || !id.lateness.empty()) page.section("Disturbances");
  add_disturbances(page, id.disturbances, id.campaign);
  for (const CaseLateness& lateness : id.lateness)
    if (lateness.finding == PhaseFinding::late) add_lateness(page, lateness);
  add_null_directions(page, id.estimate);
  if (!id.estimate.damping.empty()) add_damping(page, id.estimate);
  page.section("Lumps");
  page.paragraph("The parameter combinations that the regression sees near this resonance.");
  add_values(page, id.estimate, true, frequencies);
  add_regression_quality(page, id.estimate);
  add_lack_of_fit(page, id.estimate);
  add_tests(page, id.estimate);
  add_nearly_alike(page, id.estimate);
  add_conditions(page, id);
  add_outliers(page, id);
  page.details("Model and equations", [&] {
    std::string text = "Source: " + std::string(id.model->source) + "\n";
    for (const ObservationSet& set : id.measured) {
      if (id.measured.size() > 1) text += "Case " + std::string(set.resonance->name) + "\n";
      for (const CompiledLump& lump : set.resonance->lumps)
        text += std::string(lump.name) + " = " + std::string(lump.definition) + "\n";
    }
    page.preformatted(text);
  });
  page.provenance({command,
                   report::program_version,
                   {fmt::format("campaign {}, {} records, {} observations used", id.campaign.name,
                                id.campaign.records.size(), observations_of(id))}});
  return page.html();
}

}  // namespace secular
