#include "jobs/identify/full_report.hpp"

#include <fmt/format.h>

#include <algorithm>

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

/// Records whose motion is shown.
constexpr std::size_t most_stretches = 4;

Figure stretch_figure(const ComparedStretch& stretch, const Campaign& campaign) {
  Series measured{"measured", SeriesStyle::points, SeriesRole::data, {}, {}, {}, {}};
  Series computed{"full equations", SeriesStyle::line, SeriesRole::model, {}, {}, {}, {}};
  Series left{"measured minus computed", SeriesStyle::points, SeriesRole::data, {}, {}, {}, {}};
  for (std::size_t i = 0; i < stretch.measured.size(); ++i) {
    const double t = stretch.from_s + static_cast<double>(i) * stretch.sample_s;
    for (Series* series : {&measured, &computed, &left}) series->x.push_back(t);
    measured.y.push_back(stretch.measured[i]);
    computed.y.push_back(stretch.computed[i]);
    left.y.push_back(stretch.measured[i] - stretch.computed[i]);
  }
  const Channel& channel = campaign.channels[stretch.channel];
  Figure figure;
  figure.title = channel.name + " in " + campaign.records[stretch.record].file;
  figure.x = {"Time", "s", false, {}};
  figure.panels.push_back({"", {channel.name, channel.unit, false, {}}, {measured, computed}});
  figure.panels.push_back({"", {"Measured minus computed", channel.unit, false, {}}, {left}, true});
  return figure;
}

void add_stretch(report::HtmlReport& page, const ComparedStretch& stretch, const Campaign& campaign) {
  page.figure(
      stretch_figure(stretch, campaign),
      fmt::format("The stretch of the record in which the motion is largest, and the full equations from the "
                  "state at its beginning. Fit: {}.",
                  report::format_percent(share_fitted(stretch.measured, stretch.computed))));
  std::vector<double> left = stretch.measured;
  for (std::size_t i = 0; i < left.size(); ++i) left[i] -= stretch.computed[i];
  add_whiteness(page, left, stretch.sample_s);
}

}  // namespace

Figure full_figure(const Identification& id) {
  const FullEstimate& full = *id.full;
  if (full.stretches.empty()) return record_figure(full.labels, full.rows);
  return stretch_figure(full.stretches.front(), id.campaign);
}

std::string full_report(const Identification& id, const std::string& command) {
  const FullEstimate& full = *id.full;
  report::HtmlReport page(
      "Identification of " + std::string(id.model->name),
      "Campaign " + id.campaign.name + ", by the full equations: " + records_in_words(id.campaign, full.records));
  for (const std::string& warning : id.estimate.warnings) page.warn(warning);
  if (full.has_converged && full.noise_misjudged)
    page.verdict("The noise is misjudged: what the fit leaves says nothing of the model.", report::Tone::caution);
  else if (full.has_converged)
    page.verdict(verdict_sentence(id.estimate), verdict_tone(id.estimate));
  else
    page.verdict("The fit did not come to an end: there are no numbers.", report::Tone::bad);
  add_cards(page, id.estimate, natural_frequencies(*id.model));
  if (full.has_converged) {
    const LackOfFit& fit = id.estimate.lack_of_fit.front().equations.front();
    page.card({"Fit of all records", report::format_number(fit.misfit_ratio, 3) + " times repeatability",
               fmt::format("p {}{}", fit.p_value < 1e-15 ? "< 1e-15" : fmt::format("= {:.2g}", fit.p_value),
                           full.noise_misjudged ? ": the noise is misjudged, and nothing is said of the model"
                           : fit.significant    ? ", the model does not hold"
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
  add_values(page, id.estimate, false, natural_frequencies(*id.model));
  add_following(page, id);
  add_pairs(page, id.estimate, natural_frequencies(*id.model));
  page.section("Measured and computed");
  for (std::size_t i = 0; i < std::min(most_stretches, full.stretches.size()); ++i)
    add_stretch(page, full.stretches[i], id.campaign);
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
