#include "jobs/identify/full_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "jobs/identify/estimate_tables.hpp"
#include "jobs/identify/full_equations.hpp"
#include "jobs/identify/verdict_sentence.hpp"
#include "jobs/shared/disturbance_output.hpp"
#include "jobs/shared/record_figure.hpp"
#include "jobs/shared/residual_whiteness.hpp"
#include "report/html_report.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using report::Figure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

/// Records whose motion is shown, and samples that are drawn of each.
constexpr std::size_t most_records = 4, most_drawn = 400;

std::size_t drawn_of(const ComparedRecord& record) {
  return std::min(most_drawn, record.stretches[record.loudest].measured.size());
}

Figure motion_figure(const ComparedRecord& record, const Campaign& campaign) {
  const ComparedStretch& stretch = record.stretches[record.loudest];
  Series measured{"measured", SeriesStyle::points, SeriesRole::data, {}, {}, {}, {}};
  Series computed{"full equations", SeriesStyle::line, SeriesRole::model, {}, {}, {}, {}};
  Series left{"measured minus computed", SeriesStyle::points, SeriesRole::data, {}, {}, {}, {}};
  for (std::size_t i = 0; i < drawn_of(record); ++i) {
    const double t = stretch.from_s + static_cast<double>(i) * record.sample_s;
    for (Series* series : {&measured, &computed, &left}) series->x.push_back(t);
    measured.y.push_back(stretch.measured[i]);
    computed.y.push_back(stretch.computed[i]);
    left.y.push_back(stretch.measured[i] - stretch.computed[i]);
  }
  const Channel& channel = campaign.channels[record.channel];
  Figure figure;
  figure.title = channel.name + " in " + campaign.records[record.record].file;
  figure.x = {"Time", "s", false, {}};
  figure.panels.push_back({"", {channel.name, channel.unit, false, {}}, {measured, computed}});
  figure.panels.push_back({"", {"Measured minus computed", channel.unit, false, {}}, {left}, true});
  return figure;
}

LeftInTime left_of(const ComparedRecord& record) {
  LeftInTime left{{}, record.fitted};
  for (const ComparedStretch& stretch : record.stretches) {
    left.stretches.push_back(stretch.measured);
    for (std::size_t i = 0; i < stretch.measured.size(); ++i) left.stretches.back()[i] -= stretch.computed[i];
  }
  return left;
}

void add_motion(report::HtmlReport& page, const ComparedRecord& record, const Campaign& campaign) {
  std::vector<double> measured, computed;
  for (const ComparedStretch& stretch : record.stretches) {
    measured.insert(measured.end(), stretch.measured.begin(), stretch.measured.end());
    computed.insert(computed.end(), stretch.computed.begin(), stretch.computed.end());
  }
  const double begin = record.stretches[record.loudest].from_s,
               drawn = static_cast<double>(drawn_of(record)) * record.sample_s,
               all = static_cast<double>(measured.size()) * record.sample_s;
  page.figure(
      motion_figure(record, campaign),
      fmt::format("Drawn: {} s from {} s on, where the motion is largest, and the full equations from the "
                  "state at the beginning of that segment. Fit of all {} s that were compared, in {} "
                  "stretch{}: {}.",
                  report::format_number(drawn, 3), report::format_number(begin, 3), report::format_number(all, 3),
                  record.stretches.size(), record.stretches.size() == 1 ? "" : "es",
                  report::format_percent(share_fitted(measured, computed))));
  add_whiteness(page, left_of(record), record.sample_s);
}

ComparedInTime in_time(const FullEstimate& full) {
  ComparedInTime result{full.compared.size(), 0};
  for (const ComparedRecord& record : full.compared)
    if (!whiteness_of(left_of(record)).is_white()) ++result.not_white;
  return result;
}

}  // namespace

Figure full_figure(const Identification& id) {
  const FullEstimate& full = *id.full;
  if (full.compared.empty()) return record_figure(full.labels, full.rows);
  return motion_figure(full.compared.front(), id.campaign);
}

std::string full_report(const Identification& id, const std::string& command) {
  const FullEstimate& full = *id.full;
  const std::set<std::string> frequencies = natural_frequencies(*id.model);
  report::HtmlReport page(
      "Identification of " + std::string(id.model->name),
      "Campaign " + id.campaign.name + ", by the full equations: " + records_in_words(id.campaign, full.records));
  for (const std::string& warning : id.estimate.warnings) page.warn(warning);
  if (full.has_converged && full.noise_misjudged) {
    page.verdict("The noise is misjudged: what the fit leaves says nothing of the model.", report::Tone::caution);
  } else if (full.has_converged) {
    const ComparedInTime compared = in_time(full);
    page.verdict(verdict_sentence(id.estimate, compared), verdict_tone(id.estimate, compared));
  } else {
    page.verdict("The fit did not come to an end: there are no numbers.", report::Tone::bad);
  }
  add_cards(page, id.estimate, frequencies);
  if (full.has_converged) {
    const LackOfFit& fit = id.estimate.lack_of_fit.front().equations.front();
    page.card({"Fit of all records", report::format_number(fit.misfit_ratio, 3) + " times repeatability",
               report::format_p(fit.p_value) + (full.noise_misjudged
                                                    ? ": the noise is misjudged, and nothing is said of the model"
                                                : fit.significant ? ", the model does not hold"
                                                                  : ""),
               fit.significant || full.noise_misjudged ? report::Tone::caution : report::Tone::good});
  }
  page.section("Parameters");
  page.paragraph(full.has_converged
                     ? "Parameters of the model, fitted to all records at once by its full equations of motion: "
                       "dwells by their lines, all others sample by sample from a state of each stretch's own. A "
                       "parameter that is \"not identifiable\" moves nothing that was measured, or only together "
                       "with those it is entangled with."
                     : "The fit did not come to an end: there are no numbers.");
  add_values(page, id.estimate, false, frequencies);
  add_following(page, id);
  add_pairs(page, id.estimate, frequencies);
  page.section("Measured and computed");
  for (std::size_t i = 0; i < std::min(most_records, full.compared.size()); ++i)
    add_motion(page, full.compared[i], id.campaign);
  if (full.records.size() > 1)
    page.figure(record_figure(full.labels, full.rows),
                "All rows of a record together. One is what repeatability leaves.");
  if (!id.disturbances.empty()) page.section("Disturbances");
  add_disturbances(page, id.disturbances, id.campaign);
  add_null_directions(page, id.estimate);
  page.provenance({command,
                   report::program_version,
                   {fmt::format("campaign {}, {} records, {} of the samples used", id.campaign.name,
                                id.campaign.records.size(), report::format_percent(full.data_used))}});
  return page.html();
}

}  // namespace secular
