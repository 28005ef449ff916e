#include "jobs/identify/identification_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <utility>

#include "jobs/identify/estimate_tables.hpp"
#include "jobs/identify/full_report.hpp"
#include "jobs/identify/scatter_output.hpp"
#include "jobs/shared/disturbance_output.hpp"
#include "measure/observe/mode_frequencies.hpp"
#include "numerics/hertz.hpp"
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

// Ensembles of one condition: mean and scatter of the peak amplitude of the first active mode.
struct Condition {
  std::string group;
  double frequency_hz = 0, amplitude = 0, amplitude_sd = 0, forcing = 0;
  double model_amplitude = 0, phase_difference = 0;  // against the replayed motion; 0 where there is none
};

// One case of an identification, for its figures.
struct CaseView {
  const CompiledModel* model;
  const CompiledCase* resonance;
  const Campaign& campaign;
  const ObservationSet &measured, &replayed;
  const std::string& coordinate_unit;
  ModeFrequencies modes;
};

CaseView view_of(const Identification& id, std::size_t c) {
  return {id.model.get(),
          id.measured[c].resonance,
          id.campaign,
          id.measured[c],
          id.replayed[c],
          id.coordinate_unit,
          mode_frequencies(*id.model, *id.measured[c].resonance)};
}

std::size_t first_mode(const CaseView& id) {
  for (std::size_t k = 0; k < id.model->modes(); ++k)
    if (id.modes.oscillates[k]) return k;
  return 0;
}

// Modes of a decay that ring in some of its windows.
std::vector<std::size_t> modes_seen(const CaseView& id) {
  std::vector<std::size_t> seen;
  for (std::size_t k = 0; k < id.model->modes(); ++k)
    if (id.modes.oscillates[k] && std::any_of(id.measured.observations.begin(), id.measured.observations.end(),
                                              [&](const Observation& o) { return o.growth_sd[k] >= 0; }))
      seen.push_back(k);
  return seen;
}

// Phase of the response against the excitation, and the turn after which it repeats. Locked modes: the response's
// phase minus its share of the excitation's (half in a 2:1 lock, ambiguous by half a turn of the excitation). Two
// modes with a free frequency: gamma = arg(F conj(A1) conj(A2)).
struct RelativePhase {
  double phase = 0, turn = 0;
};
RelativePhase relative_phase(const CaseView& id, const Observation& o) {
  const std::size_t mode = first_mode(id);
  if (!id.modes.free.empty()) {
    std::complex<double> product = o.forcing[0];
    for (std::size_t k = 0; k < id.model->modes(); ++k)
      if (id.modes.oscillates[k]) product *= std::conj(o.amplitude[k]);
    return {std::arg(product), two_pi};
  }
  const double ratio = o.rate[mode].imag() / o.excitation_frequency[0];
  return {std::arg(o.amplitude[mode]) - ratio * std::arg(o.forcing[0]), two_pi * ratio};
}

std::vector<Condition> conditions_of(const CaseView& id) {
  const std::size_t mode = first_mode(id);
  std::map<std::size_t, std::vector<std::size_t>> members;
  const auto& seen = id.measured.observations;
  for (std::size_t i = 0; i < seen.size(); ++i) members[seen[i].record].push_back(i);
  const bool replayed = id.replayed.observations.size() == seen.size();
  std::vector<Condition> conditions;
  for (const auto& [record, ensembles] : members) {
    Condition c;
    c.group = id.campaign.records[record].group;
    const auto n = static_cast<double>(ensembles.size());
    double square = 0;
    for (const std::size_t i : ensembles) {
      const Observation& o = seen[i];
      c.frequency_hz += o.excitation_frequency[0] * to_hz / n;
      c.forcing += std::abs(o.forcing[0]) / n;
      const double peak = 2 * std::abs(o.amplitude[mode]);
      c.amplitude += peak / n;
      square += peak * peak / n;
      if (!replayed) continue;
      const Observation& m = id.replayed.observations[i];
      c.model_amplitude += 2 * std::abs(m.amplitude[mode]) / n;
      const RelativePhase seen_phase = relative_phase(id, o), model_phase = relative_phase(id, m);
      c.phase_difference +=
          std::remainder(seen_phase.phase - model_phase.phase, seen_phase.turn) * 180 / std::numbers::pi / n;
    }
    c.amplitude_sd = std::sqrt(std::max(0.0, square - c.amplitude * c.amplitude));
    conditions.push_back(c);
  }
  return conditions;
}

Figure dwell_response(const CaseView& id) {
  const std::vector<Condition> conditions = conditions_of(id);
  const bool replayed = id.replayed.observations.size() == id.measured.observations.size();
  Figure figure;
  figure.title = "Steady response: measured and computed";
  figure.x = {"Excitation frequency", "Hz", false, {}};
  Panel panel;
  panel.y = {
      fmt::format("Peak amplitude of {}", id.model->coordinates[first_mode(id)]), id.coordinate_unit, false, {}};
  std::vector<std::string> groups;
  for (const Condition& c : conditions)
    if (std::find(groups.begin(), groups.end(), c.group) == groups.end()) groups.push_back(c.group);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Series data, model;
    data.name = groups[g].empty() ? "measured" : groups[g];
    data.style = SeriesStyle::error_bars;
    data.role = SeriesRole::data;
    data.group = static_cast<int>(g);
    model.name = g == 0 ? "full equations, estimated parameters" : "";
    model.style = SeriesStyle::line;
    model.role = SeriesRole::model;
    model.group = static_cast<int>(g);
    std::vector<const Condition*> sorted;
    for (const Condition& c : conditions)
      if (c.group == groups[g]) sorted.push_back(&c);
    std::sort(sorted.begin(), sorted.end(), [](auto* a, auto* b) { return a->frequency_hz < b->frequency_hz; });
    for (const Condition* c : sorted) {
      data.x.push_back(c->frequency_hz);
      data.y.push_back(c->amplitude);
      data.y_error.push_back(2 * c->amplitude_sd);
      model.x.push_back(c->frequency_hz);
      model.y.push_back(c->model_amplitude);
    }
    panel.series.push_back(std::move(data));
    if (replayed) panel.series.push_back(std::move(model));
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure dwell_differences(const CaseView& id) {
  Figure figure;
  figure.title = "Measured minus computed";
  figure.x = {"Peak amplitude", id.coordinate_unit, false, {}};
  Series amplitude, phase;
  amplitude.style = phase.style = SeriesStyle::points;
  amplitude.role = phase.role = SeriesRole::data;
  for (const Condition& c : conditions_of(id)) {
    amplitude.x.push_back(c.amplitude);
    amplitude.y.push_back(100 * (c.amplitude / c.model_amplitude - 1));
    phase.x.push_back(c.amplitude);
    phase.y.push_back(c.phase_difference);
  }
  figure.panels.push_back({"", {"Amplitude difference", "%", false, {}}, {amplitude}});
  figure.panels.push_back({"", {"Phase difference", "degrees", false, {}}, {phase}});
  return figure;
}

Figure decay_response(const CaseView& id, std::size_t own) {
  Figure figure;
  figure.title =
      fmt::format("Free decay of {}: frequency and damping against amplitude", id.model->coordinates[own]);
  figure.x = {fmt::format("Peak amplitude of {}", id.model->coordinates[own]), id.coordinate_unit, false, {}};
  Series frequency, damping, model_frequency, model_damping;
  frequency.name = damping.name = "measured, windows";
  frequency.style = damping.style = SeriesStyle::error_bars;
  frequency.role = damping.role = SeriesRole::data;
  model_frequency.name = model_damping.name = "full equations, estimated parameters";
  for (const Observation& o : id.measured.observations) {
    if (o.growth_sd[own] < 0) continue;
    const double peak = 2 * std::abs(o.amplitude[own]);
    frequency.x.push_back(peak);
    frequency.y.push_back(o.rate[own].imag() * to_hz);
    frequency.y_error.push_back(2 * o.frequency_sd[own] * to_hz);
    damping.x.push_back(peak);
    damping.y.push_back(-o.rate[own].real());
    damping.y_error.push_back(2 * o.growth_sd[own]);
  }
  std::vector<const Observation*> computed;
  for (const Observation& o : id.replayed.observations)
    if (o.growth_sd[own] >= 0) computed.push_back(&o);
  std::sort(computed.begin(), computed.end(), [own](const Observation* a, const Observation* b) {
    return std::abs(a->amplitude[own]) < std::abs(b->amplitude[own]);
  });
  for (const Observation* o : computed) {
    const double peak = 2 * std::abs(o->amplitude[own]);
    model_frequency.x.push_back(peak);
    model_frequency.y.push_back(o->rate[own].imag() * to_hz);
    model_damping.x.push_back(peak);
    model_damping.y.push_back(-o->rate[own].real());
  }
  figure.panels.push_back({"", {"Frequency", "Hz", false, {}}, {frequency, model_frequency}});
  figure.panels.push_back({"", {"Decay rate", "1/s", false, {}}, {damping, model_damping}});
  return figure;
}

Figure held_out_figure(const CaseView& id, const HeldOutPrediction& prediction) {
  Figure figure;
  figure.title = "Held out: the rest of the decay, predicted";
  figure.x = {"Time in the record", "s", false, {}};
  Series measured, predicted, difference;
  measured.name = "measured, not used";
  measured.role = SeriesRole::held_out;
  predicted.name = "predicted by the full equations";
  predicted.role = SeriesRole::model;
  difference.role = SeriesRole::data;
  measured.x = predicted.x = difference.x = prediction.time;
  measured.y = prediction.measured;
  predicted.y = prediction.predicted;
  for (std::size_t i = 0; i < prediction.time.size(); ++i)
    difference.y.push_back(prediction.measured[i] - prediction.predicted[i]);
  const std::string name(id.model->coordinates[first_mode(id)]);
  figure.panels.push_back({"", {name, id.coordinate_unit, false, {}}, {measured, predicted}});
  figure.panels.push_back({"", {"Measured minus predicted", id.coordinate_unit, false, {}}, {difference}});
  return figure;
}

Figure decay_residuals(const CaseView& id, std::size_t own) {
  Figure figure;
  figure.title = fmt::format("Measured minus computed, {}", id.model->coordinates[own]);
  figure.x = {"Time in the record", "s", false, {}};
  Series frequency, damping;
  frequency.style = damping.style = SeriesStyle::error_bars;
  frequency.role = damping.role = SeriesRole::data;
  for (std::size_t i = 0; i < id.replayed.observations.size(); ++i) {
    const Observation &seen = id.measured.observations[i], &computed = id.replayed.observations[i];
    if (seen.growth_sd[own] < 0) continue;
    const std::complex<double> difference = seen.rate[own] - computed.rate[own];
    frequency.x.push_back(seen.centre_s);
    frequency.y.push_back(difference.imag() * to_hz);
    frequency.y_error.push_back(2 * seen.frequency_sd[own] * to_hz);
    damping.x.push_back(seen.centre_s);
    damping.y.push_back(difference.real());
    damping.y_error.push_back(2 * seen.growth_sd[own]);
  }
  figure.panels.push_back({"", {"Frequency difference", "Hz", false, {}}, {frequency}});
  figure.panels.push_back({"", {"Growth difference", "1/s", false, {}}, {damping}});
  return figure;
}

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

void add_response(report::HtmlReport& page, const Identification& id, const CaseView& view) {
  page.section(id.measured.size() > 1 ? "Response, case " + std::string(view.resonance->name) : "Response");
  if (view.resonance->excited) {
    page.figure(dwell_response(view),
                "Peak amplitude of the modal displacement (mean over the ensembles of a dwell, bars: two standard "
                "deviations) and what the full equations of motion do with the estimated parameters.");
    if (view.replayed.observations.size() == view.measured.observations.size())
      page.figure(dwell_differences(view),
                  "What is left: amplitude and phase of every dwell against the full equations.");
  } else {
    for (const std::size_t mode : modes_seen(view)) {
      page.figure(
          decay_response(view, mode),
          "Every window of the decay (bars: two standard deviations) and the same windows on the full equations "
          "with the estimated parameters.");
      if (id.held_out.empty() && view.replayed.observations.size() == view.measured.observations.size())
        page.figure(decay_residuals(view, mode), "What is left of frequency and growth rate in every window.");
    }
    for (const HeldOutPrediction& p : id.held_out)
      page.figure(held_out_figure(view, p),
                  "The part of the record after the fitted window, integrated from the state at the window's end.");
  }
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
  if (id.full) return full_figure(id);
  std::size_t shown = 0;
  while (shown + 1 < id.measured.size() && id.measured[shown].observations.empty()) ++shown;
  const CaseView view = view_of(id, shown);
  if (view.resonance->excited) return dwell_response(view);
  const std::vector<std::size_t> seen = modes_seen(view);
  return decay_response(view, seen.empty() ? first_mode(view) : seen.front());
}

std::string identification_report(const Identification& id, const std::string& command) {
  if (id.full) return full_report(id, command);
  report::HtmlReport page("Identification of " + std::string(id.model->name),
                          "Campaign " + id.campaign.name + ", " + cases_text(id));
  for (const std::string& warning : id.estimate.warnings) page.warn(warning);
  add_cards(page, id.estimate);
  const bool angle = id.coordinate_unit == "rad";
  for (const HeldOutPrediction& p : id.held_out)
    page.card({"Held out, predicted within",
               angle ? report::format_number(p.rms * 180 / std::numbers::pi, 3) + " degrees RMS"
                     : report::format_number(p.rms, 3) + " " + report::pretty_unit(id.coordinate_unit) + " RMS",
               fmt::format("{:.1f} s to {:.1f} s, not used in the fit", p.from_s, p.to_s), Tone::good});

  page.section("Parameters");
  page.paragraph(
      "Physical parameters of the model as far as these data determine them. A parameter in the second column's "
      "words "
      "\"not identifiable\" cannot be told apart from those it is entangled with: no number is given for it. "
      "Standard "
      "deviations have two parts: by noise, from the scatter between test conditions, and what is left open, the "
      "bias "
      "that the expansion's truncation may have where entangled parameters act beyond it (another measurement of "
      "the "
      "same kind would not change that part).");
  add_values(page, id.estimate, false);
  for (const std::string& line : scatter_lines(id.estimate)) page.paragraph(line + ".");
  for (std::size_t c = 0; c < id.measured.size(); ++c) {
    const CaseView view = view_of(id, c);
    if (!view.measured.observations.empty()) add_response(page, id, view);
  }
  if (!id.disturbances.empty() || !id.lateness.empty()) page.section("Disturbances");
  add_disturbances(page, id.disturbances, id.campaign);
  for (const CaseLateness& lateness : id.lateness)
    if (lateness.finding == PhaseFinding::late) add_lateness(page, lateness);
  add_null_directions(page, id.estimate);
  if (!id.estimate.damping.empty()) add_damping(page, id.estimate);
  page.section("Lumps");
  page.paragraph("The parameter combinations that the regression sees near this resonance.");
  add_values(page, id.estimate, true);
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
