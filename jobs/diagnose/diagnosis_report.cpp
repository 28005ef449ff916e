#include "jobs/diagnose/diagnosis_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "jobs/shared/disturbance_output.hpp"
#include "jobs/shared/record_figure.hpp"
#include "numerics/hertz.hpp"
#include "report/cell_map.hpp"
#include "report/html_report.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using report::Column;
using report::Figure;
using report::HtmlReport;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;
using report::Table;
using report::Tone;

/// Of the ranking.
constexpr std::size_t most_causes = 10;

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string joined(const std::vector<std::string>& names, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? last : ", ") + spaced(names[i]);
  return text;
}

// "cubic inertia or cubic stiffness, with quadratic stiffness": what acts, with what would do in the place of each.
std::string effects_with_neighbours(const Diagnosis& d) {
  if (d.together.size() < 2) return joined(d.set, " or ");
  std::vector<std::string> second = {d.together[1]};
  second.insert(second.end(), d.second_or.begin(), d.second_or.end());
  return joined(d.set, " or ") + ", with " + joined(second, " or ");
}

std::string verdict_text(const Diagnosis& d) {
  if (d.verdict == "no_gap") return "no gap";
  if (d.verdict == "cause") return d.together.size() > 1 ? joined(d.together, " and ") : spaced(d.cause);
  if (d.verdict == "set") return "one of " + std::to_string(d.set.size());
  if (d.verdict == "approximate") return "acts like " + effects_with_neighbours(d);
  return "unknown";
}

// Of a single cause: what other data would not tell from it.
std::string look_alikes(const Diagnosis& d) {
  const std::vector<std::string> alike = effect_catalogue().look_alikes(d.cause);
  if (d.together.size() > 1 || alike.empty()) return "";
  return " (Other campaigns may not tell it from " + joined(alike, " or ") + ".)";
}

std::string numbers_in_use(const Diagnosis& d) {
  return d.gap.judged == Judged::fitted  ? "its own parameters fitted"
         : d.gap.judged == Judged::given ? "the given numbers"
                                         : "numbers that the given error bars allow";
}

// Of effects that are less probable than the named ones: what closes as much of the gap by itself.
std::string closes_as_much(const Diagnosis& d) {
  std::vector<std::string> names;
  for (const CauseReport& cause : d.causes) {
    const auto is_in = [&](const std::vector<std::string>& named) {
      return std::find(named.begin(), named.end(), cause.effect) != named.end();
    };
    if (cause.closed && *cause.closed >= d.gap.closed_low && cause.effect != d.cause && !is_in(d.together) &&
        !is_in(d.second_or) && !is_in(names))
      names.push_back(cause.effect);
  }
  return names.empty() ? "" : ", though " + joined(names, " or ") + " alone would close as much of the gap";
}

std::string sentence(const Diagnosis& d) {
  if (d.verdict == "no_gap")
    return "What was measured is what the model does, with " + numbers_in_use(d) +
           ", within the repeatability of the measurement.";
  if (d.verdict == "cause")
    return "The gap is explained by " + joined(d.together.size() > 1 ? d.together : std::vector{d.cause}, " and ") +
           (d.second_or.empty()
                ? ""
                : " (instead of the second, " + joined(d.second_or, " or ") + " would do as well)") +
           "; no other effect of the catalogue is as probable" + closes_as_much(d) + "." + look_alikes(d);
  if (d.verdict == "set")
    return "The gap is explained by one of " + joined(d.set, " or ") +
           ". This campaign cannot say which: they change what was measured in the same way.";
  if (d.verdict == "approximate")
    return "The structure acts like " + effects_with_neighbours(d) + ": that closes " +
           report::format_percent(d.gap.closed) + " [" + report::format_percent(d.gap.closed_low) + ", " +
           report::format_percent(d.gap.closed_high) + "] of the gap on conditions that were held out. The " +
           report::format_percent(*d.gap.left_share) +
           " that is left has structure: something else acts as well, or the law is a neighbouring one.";
  if (d.gap.noise_misjudged) return "There is no verdict: " + misjudged_noise_sentence();
  if (d.unsteady.detected && d.causes.empty())
    return "The mean motion of every dwell is what the model does, but within dwells it varies by " +
           report::format_number(d.unsteady.ratio, 2) +
           " times what noise explains, though the excitation is steady: something acts that no channel records.";
  if (d.open_law)
    return "There is a gap, and no effect of the catalogue explains it: it " + open_law_sentence(*d.open_law) +
           ", which does so better than any effect of the catalogue or two of them.";
  return "There is a gap, and no effect of the catalogue explains it" +
         (d.set.empty() ? std::string() : " (nearest: " + joined(d.set, " or ") + ")") + ": " + d.unknown_because +
         (d.unsteady.detected
              ? "; it varies by " + report::format_number(d.unsteady.ratio, 2) + " times what noise explains."
              : ".");
}

// Rows of the equations of motion against amplitude, before and after.
Figure residual_figure(const Diagnosis& d, const std::string& mode, const std::string& unit) {
  Figure figure;
  figure.title = "Discrepancy of the equation of motion of " + mode;
  figure.x = {"Peak amplitude of " + mode, unit, false, {}};
  for (const EffectComponent component : {EffectComponent::conservative, EffectComponent::dissipative}) {
    Series before, after;
    before.name = "model as it is";
    before.role = SeriesRole::data;
    after.name = "best explanation added";
    after.role = SeriesRole::held_out;
    before.style = after.style = SeriesStyle::points;
    double lowest = std::numeric_limits<double>::infinity(), highest = 0;
    for (std::size_t r = 0; r < d.labels.size(); ++r) {
      const RowLabel& label = d.labels[r];
      if (!label.balance || label.place != mode || label.component != component) continue;
      const auto i = static_cast<Eigen::Index>(r);
      before.x.push_back(2 * label.amplitude);
      after.x.push_back(2 * label.amplitude);
      lowest = std::min(lowest, 2 * label.amplitude);
      highest = std::max(highest, 2 * label.amplitude);
      before.y.push_back(d.rows_before(i));
      after.y.push_back(d.rows_after(i));
    }
    if (before.x.empty()) continue;
    const bool stiff = component == EffectComponent::conservative;
    const Series noise{"95 % of noise alone",
                       SeriesStyle::band,
                       SeriesRole::reference,
                       {lowest, highest},
                       {0, 0},
                       {1.96, 1.96},
                       {}};
    std::vector<Series> series = {noise, before};
    if (d.gap.detected) series.push_back(after);
    figure.panels.push_back({stiff ? "in phase: stiffness and inertia" : "in quadrature: damping",
                             {"Discrepancy", "sd", false, {}},
                             series,
                             true});
  }
  return figure;
}

Figure figure_of_records(const Diagnosis& d) {
  return record_figure(d.labels, d.rows_before, d.gap.detected ? &d.rows_after : nullptr);
}

std::vector<std::string> balanced_modes(const Diagnosis& d) {
  std::vector<std::string> modes;
  for (const RowLabel& label : d.labels)
    if (label.balance && std::find(modes.begin(), modes.end(), label.place) == modes.end())
      modes.push_back(label.place);
  return modes;
}

// Root mean squares of the rows with the model as it is: by what they are of, and by the amplitude there.
std::optional<report::CellMap> gap_map(const Diagnosis& d, const std::string& unit) {
  constexpr std::size_t parts = 6;
  double largest = 0;
  for (const RowLabel& label : d.labels)
    if (label.balance) largest = std::max(largest, 2 * label.amplitude);
  if (!(largest > 0)) return std::nullopt;
  report::CellMap map;
  map.title = "Where the gap is";
  map.values_are = "Root mean square of what the model leaves, in standard deviations; one is noise alone";
  map.columns_are =
      "Peak amplitude up to" + (unit.empty() ? std::string() : " (" + report::pretty_unit(unit) + ")");
  for (std::size_t c = 1; c <= parts; ++c)
    map.columns.push_back(report::format_number(largest * static_cast<double>(c) / parts, 2));
  std::vector<std::vector<std::pair<double, double>>> sums;  // of squares, and how many
  for (std::size_t r = 0; r < d.labels.size(); ++r) {
    const RowLabel& label = d.labels[r];
    if (!label.balance) continue;
    const std::string name = label.place + ", " + spaced(to_string(label.component)) + ", " + label.harmonic;
    const auto known = std::find(map.rows.begin(), map.rows.end(), name);
    const auto row = static_cast<std::size_t>(known - map.rows.begin());
    if (known == map.rows.end()) {
      map.rows.push_back(name);
      sums.emplace_back(parts);
    }
    const auto part = static_cast<std::size_t>(2 * label.amplitude / largest * parts);
    auto& [square, count] = sums[row][std::min(part, parts - 1)];
    square += std::pow(d.rows_before(static_cast<Eigen::Index>(r)), 2);
    ++count;
  }
  for (const auto& row : sums) {
    map.values.emplace_back();
    for (const auto& [square, count] : row) map.values.back().push_back(std::sqrt(square / count));
  }
  return map;
}

void where_section(HtmlReport& page, const DiagnosisRun& run) {
  const Diagnosis& d = run.diagnosis;
  page.section("Where");
  page.paragraph(
      "The residual of a mode's equation of motion on its resonant line, divided by the amplitude, has a meaning: "
      "in "
      "phase with the motion it is a force of stiffness or inertia, in quadrature one of damping. Everything is in "
      "standard deviations of the measurement's own repeatability, of the model with " +
      numbers_in_use(d) + ".");
  if (!d.where.empty()) {
    Table table;
    table.columns = {{"Mode or channel", Column::Kind::text, ""},
                     {"Component", Column::Kind::text, ""},
                     {"Line", Column::Kind::text, ""},
                     {"Region", Column::Kind::text, ""},
                     {"Share", Column::Kind::number, ""}};
    for (const GapShare& share : d.where)
      table.rows.push_back({share.mode, spaced(to_string(share.component)), share.harmonic, share.region,
                            report::format_percent(share.share)});
    table.caption = "Shares of the gap";
    page.table(table);
  }
  if (const std::optional<report::CellMap> map = gap_map(d, run.coordinate_unit))
    page.drawing(report::cell_map(*map), map->title,
                 "Each row is one line of an equation of motion: its part in phase (stiffness and inertia) or in "
                 "quadrature (damping); columns are six parts of the amplitudes. The stronger the colour, the "
                 "farther model and measurement are apart. The card's gap is over all rows, on conditions that "
                 "were held out; a number here is over the rows of its cell alone.");
  for (const std::string& mode : balanced_modes(d)) {
    const Figure figure = residual_figure(d, mode, run.coordinate_unit);
    if (!figure.panels.empty())
      page.figure(figure,
                  "Each point is one condition (a dwell, or a stretch of a decay), in units of its own standard "
                  "deviation: noise alone leaves 95 % of them in the band.");
  }
  const bool several = std::any_of(d.labels.begin(), d.labels.end(), [&](const RowLabel& label) {
    return label.fold >= 0 && label.record != d.labels.front().record;
  });
  if (several)
    page.figure(figure_of_records(d),
                "All rows of a record together: balances of the resonant lines and lines of every "
                "channel. One is what repeatability leaves.");
}

void add_ranking(HtmlReport& page, const Diagnosis& d) {
  report::ShareBars bars;
  bars.title = "Candidates by rank";
  bars.names = {"probability"};
  if (std::any_of(d.causes.begin(), d.causes.end(),
                  [](const CauseReport& cause) { return cause.closed.has_value(); }))
    bars.names.emplace_back("of the gap closed by it alone");
  for (const CauseReport& cause : d.causes) {
    if (bars.rows.size() == most_causes) break;
    bars.rows.push_back(spaced(cause.effect) + (cause.subject.empty() ? "" : ", " + cause.subject));
    bars.values.push_back({cause.probability});
    if (bars.names.size() > 1) bars.values.back().push_back(cause.closed.value_or(std::nan("")));
  }
  page.drawing(
      report::share_bars(bars), bars.title,
      "Probability that an effect is part of what acts, over all explanations that hold it: several can be "
      "near 100 % together." +
          std::string(bars.names.size() > 1 ? " A bar of what it closes is there for the first few alone, on "
                                              "conditions that the fit had not seen."
                                            : ""));
}

void which_section(HtmlReport& page, const Diagnosis& d) {
  if (d.causes.empty()) return;
  page.section("Which");
  add_ranking(page, d);
  Table table;
  table.columns = {{"Effect", Column::Kind::text, ""},        {"Of", Column::Kind::text, ""},
                   {"Probability", Column::Kind::number, ""}, {"Coefficient", Column::Kind::text, ""},
                   {"Value", Column::Kind::number, ""},       {"Unit", Column::Kind::text, ""},
                   {"Closes alone", Column::Kind::number, ""}};
  std::size_t shown = 0;
  for (const CauseReport& cause : d.causes) {
    if (++shown > most_causes) break;
    const bool in_set = std::find(d.set.begin(), d.set.end(), cause.effect) != d.set.end() ||
                        std::find(d.together.begin(), d.together.end(), cause.effect) != d.together.end();
    table.rows.push_back(
        {spaced(cause.effect), cause.subject, report::format_percent(cause.probability), cause.coefficient_name,
         cause.coefficient_name.empty() ? "" : report::format_uncertain(cause.coefficient, cause.sd),
         report::pretty_unit(cause.unit), cause.closed ? report::format_percent(*cause.closed) : ""});
    table.row_tones.push_back(in_set ? Tone::good : Tone::neutral);
  }
  table.caption = "Every effect was tried with all of the model's own parameters fitted beside it.";
  page.table(table);
  if (!d.parameters_moved.empty()) {
    Table moved;
    moved.columns = {{"Parameter", Column::Kind::text, ""},
                     {"Given", Column::Kind::number, ""},
                     {"Fitted", Column::Kind::number, ""}};
    for (const ParameterMove& m : d.parameters_moved)
      moved.rows.push_back({m.name, report::format_number(m.from, 5), report::format_uncertain(m.to, m.sd)});
    moved.caption = "Parameters that a fit moves by more than three standard deviations";
    page.table(moved);
  }
}

void closing_section(HtmlReport& page, const Diagnosis& d) {
  if (!d.gap.detected) return;
  page.section("How far it closes");
  Table table;
  table.columns = {{"", Column::Kind::text, ""},
                   {"Before", Column::Kind::number, ""},
                   {"After", Column::Kind::number, ""},
                   {"Floor", Column::Kind::number, ""},
                   {"Closed", Column::Kind::number, ""}};
  table.rows.push_back({d.verdict == "unknown" ? "best explanation" : "named explanation",
                        report::format_number(d.gap.before, 3), report::format_number(d.gap.after, 3),
                        report::format_number(d.gap.floor, 3), report::format_percent(d.gap.closed)});
  if (!d.gap.wrong_cause.empty())
    table.rows.push_back({"best other cause: " + spaced(d.gap.wrong_cause), report::format_number(d.gap.before, 3),
                          "", report::format_number(d.gap.floor, 3),
                          report::format_percent(d.gap.wrong_cause_closed)});
  if (d.gap.placebo_closed)
    table.rows.push_back({"placebo regressor", report::format_number(d.gap.before, 3), "",
                          report::format_number(d.gap.floor, 3), report::format_percent(*d.gap.placebo_closed)});
  table.caption = d.gap.metric;
  page.table(table);
  page.paragraph(
      "Closed is (before - after)/(before - floor). Every number is of conditions that the fit which "
      "predicted them had not seen; 95 % interval of the closed share over conditions: " +
      report::format_percent(d.gap.closed_low) + " to " + report::format_percent(d.gap.closed_high) +
      ". Predictions are those of the full equations of motion; no expansion enters.");
}

void simulated_rows(Table& table, const std::string& what, const std::vector<SimulatedError>& errors) {
  for (const SimulatedError& e : errors)
    table.rows.push_back({what, e.channel, report::format_number(e.signal, 4), report::format_number(e.before, 4),
                          report::format_number(e.after, 4)});
  for (const SimulatedError& e : errors)
    if (e.before_fitted && e.after_fitted)
      table.rows.push_back({what + ", with the numbers that fit them best", e.channel,
                            report::format_number(e.signal, 4), report::format_number(*e.before_fitted, 4),
                            report::format_number(*e.after_fitted, 4)});
}

// The same question once more, asked of the equations of motion alone.
void simulated_section(HtmlReport& page, const Diagnosis& d) {
  if (!d.simulated || (d.simulated->dwells.empty() && d.simulated->segments.empty())) return;
  Table table;
  table.columns = {{"Records", Column::Kind::text, ""},
                   {"Channel", Column::Kind::text, ""},
                   {"Measured", Column::Kind::number, ""},
                   {"Difference before", Column::Kind::number, ""},
                   {"Difference after", Column::Kind::number, ""}};
  simulated_rows(table, "dwells", d.simulated->dwells);
  simulated_rows(table, "decays, sweeps, broadband: segments", d.simulated->segments);
  simulated_rows(table, "window to check on: records in one piece", d.simulated->apart);
  table.caption =
      "Root mean squares in the channel's unit: the full equations of motion solved by themselves, with the "
      "measured "
      "excitation, against what was measured" +
      (d.simulated->lost > 0 ? "; " + std::to_string(d.simulated->lost) +
                                   " dwells without a steady motion near the measured one are left out"
                             : std::string());
  page.table(table);
}

void next_section(HtmlReport& page, const DiagnosisRun& run) {
  const NextExperiment& next = run.diagnosis.next_experiment;
  if (!run.diagnosis.gap.detected) return;
  page.section("Next experiment");
  if (!next.proposed) page.paragraph("None is proposed: " + next.reason + ".");
  if (!next.test) return;
  const ProposedTest& test = *next.test;
  const RecordEntry& like = run.campaign.records[test.like];
  std::string rivals;
  for (const std::string& effect : next.separates) rivals += (rivals.empty() ? "" : ", ") + spaced(effect);
  Table table;
  table.columns = {{"", Column::Kind::text, ""}, {"", Column::Kind::text, ""}};
  const std::string minutes = report::format_number(test.minutes, 2) + " minutes",
                    level = report::format_number(test.level, 2) + " times that of " + like.file;
  if (is_steady(like.kind))
    table.rows = {{"Dwell", test.resonance},
                  {"Frequency", report::format_number(test.frequency * to_hz, 5) + " Hz"},
                  {"Peak of " + test.channel, report::format_number(test.excitation, 4) + ", " + level},
                  {"Length", report::format_number(test.length, 2) + " times as many ensembles as that record, " +
                                 minutes + " once it has settled"}};
  else
    table.rows = {{"Record", spaced(to_string(like.kind))},
                  {"Level", level},
                  {"How many", report::format_number(test.length, 2) + " as long as that record, " + minutes}};
  table.rows.insert(
      table.rows.end(),
      {{"Tells apart", rivals},
       {"Expected separation", report::format_number(test.separation, 2) + " sd of the closest two"},
       {"Look at", test.watch},
       {"Expected probability of the right one",
        report::format_percent(test.probability) + " after it, " + report::format_percent(test.before) + " now, " +
            report::format_percent(test.typical) + " after one taken at random"},
       {"Chance that it leaves one", report::format_percent(test.chance)}});
  table.caption = "Best of " + std::to_string(test.compared) + " tests around those that were measured";
  page.table(table);
}

}  // namespace

report::Figure gap_figure(const DiagnosisRun& run) {
  const Diagnosis& d = run.diagnosis;
  const std::vector<std::string> modes = balanced_modes(d);
  return modes.empty() ? figure_of_records(d) : residual_figure(d, modes.front(), run.coordinate_unit);
}

std::string open_law_sentence(const OpenLaw& law) {
  return "acts like " + fmt::format(fmt::runtime(law.in_words), fmt::arg("mode", law.mode),
                                    fmt::arg("exponent", report::format_uncertain(law.exponent, law.sd)));
}

std::string misjudged_noise_sentence() {
  return "what the model leaves scatters far less than the repeatability that it is measured in, so that a gap as "
         "large as the noise would not be seen. Ensembles that differ by more than noise (a drift, a beat) make "
         "repeatability look worse than it is.";
}

std::string diagnosis_report(const DiagnosisRun& run, const std::string& command) {
  const Diagnosis& d = run.diagnosis;
  HtmlReport page("Diagnosis of " + run.campaign.name,
                  "model " + std::string(run.model->name) + ", " + std::to_string(d.conditions) + " conditions");
  const Tone tone = d.verdict == "no_gap" ? Tone::good : d.verdict == "unknown" ? Tone::bad : Tone::caution;
  page.verdict(sentence(d), tone);
  page.card({"Verdict", verdict_text(d), "", tone});
  page.card({"Gap", report::format_number(d.gap.before, 3) + " × repeatability", report::format_p(d.gap.p_value),
             d.gap.detected ? Tone::caution : Tone::good});
  if (d.gap.detected)
    page.card({"Closed", report::format_percent(d.gap.closed),
               "95 % interval " + report::format_percent(d.gap.closed_low) + " to " +
                   report::format_percent(d.gap.closed_high),
               d.gap.closed > 0.9 ? Tone::good : Tone::caution});
  for (const std::string& warning : d.warnings) page.warn(warning);
  where_section(page, run);
  which_section(page, d);
  closing_section(page, d);
  simulated_section(page, d);
  next_section(page, run);
  if (!run.disturbances.empty()) page.section("Disturbances");
  add_disturbances(page, run.disturbances, run.campaign);
  page.provenance({command,
                   report::program_version,
                   {"campaign: " + run.campaign.folder.string() + ", " +
                    std::to_string(run.campaign.records.size()) + " records"}});
  return page.html();
}

}  // namespace secular
