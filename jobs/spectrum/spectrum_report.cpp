#include "jobs/spectrum/spectrum_report.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "jobs/shared/json_numbers.hpp"
#include "numerics/hertz.hpp"
#include "report/html_report.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Json = nlohmann::ordered_json;
using report::Axis;
using report::Column;
using report::Figure;
using report::NamedFigure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;
using report::Table;
using report::Tone;

const char* family_name(PoleFamily family) {
  switch (family) {
    case PoleFamily::circular:
      return "circular";
    case PoleFamily::hyperbolic:
      return "hyperbolic";
    case PoleFamily::nyquist_hyperbolic:
      return "Nyquist-hyperbolic";
    case PoleFamily::product:
      return "product";
    default:
      return "constant";
  }
}

// At most about 4000 points: of every stretch the smallest and the largest, so that no peak is lost.
Series extremes_of_stretches(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const std::string& name,
                             SeriesRole role) {
  Series series;
  series.name = name;
  series.role = role;
  const Index stride = std::max<Index>(1, x.size() / 2000);
  for (Index i = 0; i < x.size(); i += stride) {
    const Index count = std::min(stride, x.size() - i);
    Index low = 0, high = 0;
    y.segment(i, count).minCoeff(&low);
    y.segment(i, count).maxCoeff(&high);
    for (const Index k : {std::min(low, high), std::max(low, high)}) {
      if (!series.x.empty() && low == high && k == std::max(low, high) && series.x.back() == x(i + k)) continue;
      series.x.push_back(x(i + k));
      series.y.push_back(y(i + k));
    }
  }
  return series;
}

Figure history_figure(const RecordSpectrum& record) {
  Figure figure;
  figure.title = "Time history";
  figure.x = {"Time", "s", false, {}};
  // Forty periods of the strongest tone, or a thousand samples, are still seen as curves.
  double strongest = 0, periods_hz = 0;
  for (const std::vector<MethodStatistics>& methods : record.survey.tables)
    for (const MethodStatistics& method : methods)
      for (const TermStatistics& term : method.terms)
        if (term.family == PoleFamily::circular && term.amplitude > strongest) {
          strongest = term.amplitude;
          periods_hz = term.frequency_hz;
        }
  const double curves = periods_hz > 0 ? std::max(1000.0, 40 * record.sample_rate_hz / periods_hz) : 1e4;
  const Index shown = std::min<Index>(
      {record.channels.rows(), record.survey.layout.length, static_cast<Index>(std::min(curves, 1e9)) + 1});
  const Eigen::VectorXd time =
      record.start_s +
      Eigen::VectorXd::LinSpaced(shown, 0, static_cast<double>(shown - 1)).array() / record.sample_rate_hz;
  if (record.excitation.size() >= shown)
    figure.panels.push_back(
        {"",
         {record.excitation_name, record.excitation_unit, false, {}},
         {extremes_of_stretches(time, record.excitation.head(shown), "", SeriesRole::reference)}});
  for (Index c = 0; c < std::min<Index>(3, record.channels.cols()); ++c)
    figure.panels.push_back(
        {"",
         {record.names[static_cast<std::size_t>(c)], record.units[static_cast<std::size_t>(c)], false, {}},
         {extremes_of_stretches(time, record.channels.col(c).head(shown), "", SeriesRole::data)}});
  if (!record.tones_count()) return figure;
  const Eigen::VectorXd model = record.survey.decomposition.reconstruct(shown).col(0);
  Series left = extremes_of_stretches(time, record.channels.col(0).head(shown) - model, "", SeriesRole::reference);
  figure.panels.push_back(
      {"", {record.names.front() + " minus its decomposition", record.units.front(), false, {}}, {left}});
  return figure;
}

Series ranked(const Eigen::VectorXd& values, const std::string& name, SeriesRole role) {
  Series series;
  series.name = name;
  series.role = role;
  series.style = SeriesStyle::line_and_points;
  for (Index i = 0; i < values.size(); ++i) {
    series.x.push_back(static_cast<double>(i + 1));
    series.y.push_back(values(i) / values(0));
  }
  return series;
}

Figure temporal_figure(const RecordSpectrum& record) {
  Figure figure;
  figure.title = "Singular values of delay coordinates";
  figure.x = {"Number", "", false, std::pair(0.0, static_cast<double>(record.survey.temporal.size()) + 1)};
  figure.panels.push_back({"",
                           {"Singular value over the largest", "", true, {}},
                           {ranked(record.survey.temporal, "", SeriesRole::data)}});
  return figure;
}

Figure order_figure(const RecordSpectrum& record) {
  Figure figure;
  figure.title = "Singular values of the covariance";
  figure.x = {"Number", "", false, std::pair(0.0, static_cast<double>(record.survey.biased.size()) + 1)};
  Series unbiased = ranked(record.survey.unbiased, "unbiased: without zero lag", SeriesRole::model);
  unbiased.style = SeriesStyle::line;
  figure.panels.push_back(
      {"",
       {"Singular value over the largest", "", true, {}},
       {ranked(record.survey.biased, "biased: noise adds its variance", SeriesRole::data), unbiased}});
  return figure;
}

Figure spatial_figure(const RecordSpectrum& record) {
  Figure figure;
  figure.title = "Spatial singular values";
  figure.x = {"Number", "", false, std::pair(0.0, static_cast<double>(record.survey.spatial.size()) + 1)};
  figure.panels.push_back({"",
                           {"Singular value over the largest", "", true, {}},
                           {ranked(record.survey.spatial, "", SeriesRole::data)}});
  return figure;
}

// From 200 dB below the highest ordinate upwards: below that there is rounding.
Axis level_axis(const std::string& label, const std::string& unit, const Eigen::MatrixXd& amplitude) {
  const double top = amplitude.maxCoeff();
  if (!(top > 0)) return {label, unit, true, {}};  // of a constant nothing is left beside its mean
  const double bottom = std::max(1e-10 * top, 0.5 * amplitude.bottomRows(amplitude.rows() - 1).minCoeff());
  return {label, unit, true, std::pair(bottom, 2 * top)};
}

// Decades where nine tenths of the power lie below a twentieth of the highest frequency.
Axis frequency_axis(const AmplitudeSpectrum& spectrum, double sample_rate_hz) {
  const double highest = 0.5 * sample_rate_hz;
  double low = 0, all = 0;
  for (Index k = 1; k < spectrum.frequency_hz.size(); ++k) {
    const double power = spectrum.amplitude.row(k).squaredNorm();
    all += power;
    if (spectrum.frequency_hz(k) < highest / 20) low += power;
  }
  if (spectrum.frequency_hz.size() < 3 || !(low > 0.9 * all))
    return {"Frequency", "Hz", false, std::pair(0.0, highest)};
  return {"Frequency", "Hz", true, std::pair(spectrum.frequency_hz(1), highest)};
}

Figure spectrum_figure(const RecordSpectrum& record) {
  Figure figure;
  figure.title = "Amplitude spectra";
  figure.x = frequency_axis(record.spectrum, record.sample_rate_hz);
  if (record.excitation.size() > 0)
    figure.panels.push_back(
        {"",
         level_axis(record.excitation_name, record.excitation_unit, record.excitation_spectrum.amplitude),
         {extremes_of_stretches(record.excitation_spectrum.frequency_hz,
                                record.excitation_spectrum.amplitude.col(0), "", SeriesRole::reference)}});
  const Eigen::VectorXd mean =
      record.spectrum.amplitude.rowwise().norm() / std::sqrt(static_cast<double>(record.spectrum.amplitude.cols()));
  Series tones;
  tones.name = "terms of the decomposition";
  tones.style = SeriesStyle::points;
  tones.role = SeriesRole::model;
  const Decomposition& d = record.survey.decomposition;
  for (std::size_t i = 0; i < d.poles.size() && record.tones_count(); ++i) {
    if (d.poles[i].family != PoleFamily::circular) continue;
    double square = 0;
    for (Index c = 0; c < d.amplitudes.cols(); ++c)
      square += d.amplitudes.block(d.first_function(i), c, 2, 1).squaredNorm();
    tones.x.push_back(d.poles[i].frequency * to_hz);
    tones.y.push_back(std::sqrt(square / static_cast<double>(d.amplitudes.cols())));
  }
  const std::string label = record.names.size() == 1 ? record.names.front() : "Mean of the channels";
  figure.panels.push_back(
      {"",
       level_axis(label, record.units.front(), mean),
       {extremes_of_stretches(record.spectrum.frequency_hz, mean, "discrete Fourier transform", SeriesRole::data),
        tones}});
  return figure;
}

Figure modal_figure(const RecordSpectrum& record) {
  Figure figure;
  figure.title = "Spectra of the modal coordinates";
  figure.x = {"Frequency", "Hz", false, std::pair(0.0, 0.5 * record.sample_rate_hz)};
  const Eigen::MatrixXd& all = record.modal.amplitude;
  for (std::size_t m = 0; m < record.modes.size(); ++m)
    figure.panels.push_back(
        {"",
         level_axis(record.modes[m], "", all),
         {extremes_of_stretches(record.modal.frequency_hz, all.col(static_cast<Index>(m)), "", SeriesRole::data)}});
  return figure;
}

Figure relation_figure(const RecordSpectrum& record, std::size_t channel) {
  const LinearRelation& relation = record.relations[channel];
  Figure figure;
  figure.title = fmt::format("Correlation of delayed {} and {}", record.excitation_name, record.names[channel]);
  figure.x = {"Delay", "s", false, {}};
  const auto line = [&](const Eigen::VectorXd& values, const std::string& name, SeriesRole role) {
    Series series;
    series.name = name;
    series.role = role;
    series.style = SeriesStyle::line_and_points;
    for (Index k = 0; k < values.size(); ++k) {
      series.x.push_back(static_cast<double>(k) / record.sample_rate_hz);
      series.y.push_back(values(k));
    }
    return series;
  };
  figure.panels.push_back(
      {"",
       {"Correlation", "", false, std::pair(-1.1, 1.1)},
       {line(relation.excitation, record.excitation_name + " with itself", SeriesRole::reference),
        line(relation.response, record.names[channel] + " with itself", SeriesRole::data),
        line(relation.cross, record.names[channel] + " with " + record.excitation_name, SeriesRole::model)}});
  return figure;
}

// What delays, and any filter, make of the excitation.
std::string relation_sentence(const RecordSpectrum& record, std::size_t channel) {
  const LinearRelation& relation = record.relations[channel];
  std::string text =
      fmt::format("{}: {} delays of {} explain {} of its variance by a linear relation", record.names[channel],
                  relation.delays, record.excitation_name, report::format_percent(relation.explained, 1));
  if (!relation.coherent) return text + ".";
  const double seconds = static_cast<double>(relation.coherent->window) / record.sample_rate_hz;
  text += fmt::format("; a linear filter of any form explains at least {} (coherence in windows of {} s)",
                      report::format_percent(relation.coherent->share, 1), report::format_number(seconds, 3));
  if (std::max(relation.coherent->share, relation.explained) < 0.1)
    text +=
        ": ARMA and frequency responses say little here. Its motion is at other frequencies than the excitation, "
        "or noise hides it";
  return text + ".";
}

std::vector<NamedFigure> record_figures(const RecordSpectrum& record) {
  std::vector<NamedFigure> figures = {
      {"history", history_figure(record),
       record.tones_count() ? "The beginning of what was analysed, and what the decomposition leaves of it."
                            : "The beginning of what was analysed."},
      {"spectrum", spectrum_figure(record),
       "Hann window; a tone in the middle of a bin shows its peak amplitude, one between bins up to 1.4 dB less. "
       "Markers: the decomposition of the first ensemble."}};
  if (!record.modes.empty())
    figures.push_back({"modes", modal_figure(record),
                       "The channels through the modal filter (pseudo-inverse of the mode shapes)."});
  return figures;
}

std::vector<NamedFigure> order_figures(const RecordSpectrum& record) {
  std::vector<NamedFigure> figures = {
      {"delays", temporal_figure(record),
       fmt::format("Principal components of {} delays: a sum of n tones or decaying oscillations needs 2n.",
                   record.survey.temporal.size() / static_cast<Index>(record.names.size()))},
      {"covariance", order_figure(record), "Where the two part, noise begins."}};
  if (record.names.size() > 1)
    figures.push_back({"channels", spatial_figure(record),
                       "Principal components of the channels: one for each independent motion."});
  return figures;
}

std::vector<NamedFigure> relation_figures(const RecordSpectrum& record) {
  std::vector<NamedFigure> figures;
  for (std::size_t c = 0; c < std::min<std::size_t>(3, record.relations.size()); ++c)
    figures.push_back({"relation_" + record.names[c], relation_figure(record, c),
                       "Where the response is uncorrelated with every delay of the excitation, no linear relation "
                       "of these delays finds the resonance, although each is well correlated with itself."});
  return figures;
}

// The response itself where there is no force.
std::vector<double> over_force(const SteadyLevel& level) {
  std::vector<double> over = level.response;
  for (std::size_t i = 0; i < level.force.size(); ++i) over[i] /= level.force[i];
  return over;
}

void add_tables(report::HtmlReport& page, const RecordSpectrum& record, std::size_t channel) {
  const std::string& unit = record.units[channel];
  Table table;
  table.caption = fmt::format(
      "{}: {} of {} s{}", record.names[channel],
      record.survey.layout.count == 1 ? "one ensemble"
                                      : fmt::format("mean over {} ensembles", record.survey.layout.count),
      report::format_number(static_cast<double>(record.survey.layout.length) / record.sample_rate_hz),
      record.survey.layout.count == 1
          ? "; in parentheses the standard deviation that maximum likelihood gives itself"
          : ", scatter of one in parentheses");
  const bool rates = record.has_rates();
  table.columns = {{"Method", Column::Kind::text, ""},
                   {"Term", Column::Kind::text, ""},
                   {"Frequency or rate/2π", Column::Kind::number, "Hz"},
                   {"Amplitude", Column::Kind::number, unit},
                   {"Rate", Column::Kind::number, "1/s"},
                   {"Ensembles", Column::Kind::number, ""},
                   {"γ²", Column::Kind::number, ""},
                   {"S/N", Column::Kind::number, "dB"}};
  if (!rates) table.columns.erase(table.columns.begin() + 4);
  Table first;
  first.caption = record.names[channel] + ": first ensemble, t = 0 at its first sample";
  first.columns = {{"Method", Column::Kind::text, ""},
                   {"Term", Column::Kind::text, ""},
                   {"Frequency or rate/2π", Column::Kind::number, "Hz"},
                   {"p (cos) or a (cosh)", Column::Kind::number, unit},
                   {"q (sin) or b (sinh)", Column::Kind::number, unit}};
  for (const MethodStatistics& method : record.survey.tables[channel]) {
    if (!record.are_tones(channel, method)) {
      table.rows.push_back({method.name, no_tones_text(method)});
      table.rows.back().resize(table.columns.size());
      continue;
    }
    for (std::size_t i = 0; i < method.terms.size(); ++i) {
      const TermStatistics& term = method.terms[i];
      const std::string name = i == 0 ? method.name : "";
      const auto uncertain = [](double value, double sd) {
        return std::isfinite(sd) ? report::format_uncertain(value, sd) : report::format_number(value, 7);
      };
      table.rows.push_back({name, family_name(term.family), uncertain(term.frequency_hz, term.frequency_sd),
                            uncertain(term.amplitude, term.amplitude_sd), std::to_string(term.ensembles),
                            i == 0 ? report::format_fixed(method.correlation, 6) : "",
                            i == 0 ? report::format_fixed(method.signal_to_noise_db, 1) : ""});
      if (rates)
        table.rows.back().insert(table.rows.back().begin() + 4, term.family == PoleFamily::circular
                                                                    ? std::string()
                                                                    : report::format_number(term.rate, 5));
      first.rows.push_back({name, family_name(term.family), report::format_number(term.frequency_hz, 7),
                            report::format_number(term.p, 6), report::format_number(term.q, 6)});
    }
  }
  for (std::size_t i = 0; i < record.survey.peaks[channel].size(); ++i) {
    const SpectrumPeak& peak = record.survey.peaks[channel][i];
    first.rows.push_back({i == 0 ? "DFT peak" : "", "circular", report::format_number(peak.frequency * to_hz, 7),
                          report::format_number(peak.p, 6), report::format_number(peak.q, 6)});
  }
  if (table.rows.empty()) return;
  page.table(table);
  page.details("First ensemble, beside the peaks of its discrete Fourier transform", [&] { page.table(first); });
}

}  // namespace

std::string no_tones_text(const MethodStatistics& method) {
  if (method.terms.empty()) return "no finite decomposition of this order";
  return fmt::format("explains {}: its terms are no tones of this record",
                     report::format_percent(std::max(0.0, method.correlation), 2));
}

void conclude(RecordSpectrum& record) {
  const SpectralSurvey& survey = record.survey;
  const auto say = [&](std::string text) { record.conclusions.push_back(std::move(text)); };
  if (survey.step.clear)
    say(fmt::format("{} function{} of time dominate{}: singular value {} is {} times the next. {}",
                    survey.step.functions, survey.step.functions == 1 ? "" : "s",
                    survey.step.functions == 1 ? "s" : "", survey.step.functions,
                    report::format_number(survey.step.ratio, 2),
                    survey.step.functions % 2 == 0
                        ? fmt::format("A linear system of that order could have made most of the signal: {} tone{} "
                                      "or decaying oscillation{}.",
                                      survey.step.functions / 2, survey.step.functions == 2 ? "" : "s",
                                      survey.step.functions == 2 ? "" : "s")
                        : "An odd number is half a pair: a constant, or a slowly growing function."));
  else
    say(
        fmt::format("No clear number of functions of time: the singular values fall without a step (the largest is "
                    "a factor of {} behind number {}). A linear system that rings freely, or that few tones drive, "
                    "would show one.",
                    report::format_number(survey.step.ratio, 2), survey.step.functions));
  const std::vector<Pole>& poles = survey.decomposition.poles;
  const bool decays =
      std::any_of(poles.begin(), poles.end(), [](const Pole& pole) { return pole.family == PoleFamily::product; });
  if (record.tones_count())
    say(fmt::format("{}{} steady tone{} stand{} above white noise by a test{}{}.",
                    survey.tones_limited ? "At least " : "", survey.tones, survey.tones == 1 ? "" : "s",
                    survey.tones == 1 ? "s" : "", decays ? " (a decay counts for several)" : "",
                    survey.step.clear && !decays && 2 * survey.tones > survey.step.functions
                        ? ", the weak ones among them"
                        : ""));
  else if (survey.tones == 0)
    say("No steady tone stands above white noise by a test.");
  else
    say(fmt::format(
        "Steady tones are not counted: {} of them explain {} of {}, and what they leave is no white noise. "
        "This is no sum of few steady tones.",
        survey.order,
        record.tables_empty() ? "nothing"
                              : report::format_percent(std::max(0.0, survey.tables.front().back().correlation), 2),
        record.names.front()));
  if (record.names.size() > 1)
    say(fmt::format(
        "{} function{} of space{}.", survey.spatial_count.functions, survey.spatial_count.functions == 1 ? "" : "s",
        survey.spatial_count.limited ? ", as many as these channels can show: more may take part" : ""));
  if (record.tones_count()) {
    const std::vector<TermStatistics>& terms = survey.tables.front().back().terms;
    double largest = 0, others = 0;
    for (const TermStatistics& term : terms) {
      largest = std::max(largest, term.amplitude);
      others += term.amplitude * term.amplitude;
    }
    if (terms.size() > 1 && largest > 0 && !decays)
      say(fmt::format("{}: the tones beside the largest have {} of its amplitude (root of the sum of squares).",
                      record.names.front(),
                      report::format_percent(std::sqrt(std::max(0.0, others - largest * largest)) / largest, 2)));
  }
  // A closed form whose frequencies are a little off loses the phase over a long record.
  std::string poor;
  if (!record.tables_empty() && survey.tables.front().back().correlation > 0.9)
    for (const MethodStatistics& method : survey.tables.front())
      if (!method.terms.empty() && method.correlation < 0.9)
        poor += (poor.empty() ? "" : ", ") +
                fmt::format("{} ({})", method.name, report::format_fixed(method.correlation, 2));
  if (!poor.empty())
    say(fmt::format(
        "{}: closed forms that do not follow the record (gamma^2): {}. Their errors of frequency add up "
        "over {} s; shorter ensembles (--ensemble) or a higher --order help.",
        record.names.front(), poor,
        report::format_number(static_cast<double>(survey.layout.length) / record.sample_rate_hz, 4)));
  if (survey.settling)
    say(survey.settling->settled ? "Settled: no tone drifts over the record beyond its error and the tolerance."
                                 : "Not settled: " + survey.settling->reason + ".");
  for (std::size_t c = 0; c < record.relations.size(); ++c) say(relation_sentence(record, c));
}

bool RecordSpectrum::are_tones(std::size_t channel, const MethodStatistics& method) const {
  constexpr double least_explained = 0.9, most_power = 2;
  const double possible = survey.tones_limited ? 1 : std::min(1.0, survey.tables[channel].back().correlation);
  if (method.terms.empty() || !(method.correlation >= least_explained * possible)) return false;
  double power = 0;
  for (const TermStatistics& term : method.terms)
    if (term.family == PoleFamily::circular) power += 0.5 * term.amplitude * term.amplitude;
  const Eigen::VectorXd samples = channels.col(static_cast<Index>(channel));
  return power <= most_power * samples.squaredNorm() / static_cast<double>(samples.size());
}

bool RecordSpectrum::tones_count() const {
  return !tables_empty() && are_tones(0, survey.tables.front().back());
}

bool RecordSpectrum::has_rates() const {
  for (const std::vector<MethodStatistics>& methods : survey.tables)
    for (const MethodStatistics& method : methods)
      for (const TermStatistics& term : method.terms)
        if (term.family != PoleFamily::circular) return true;
  return false;
}

bool RecordSpectrum::tables_empty() const {
  return survey.tables.empty() || survey.tables.front().empty();
}

std::vector<NamedFigure> spectrum_figures(const RecordSpectrum& record) {
  std::vector<NamedFigure> figures = record_figures(record);
  for (auto* more : {&order_figures, &relation_figures})
    for (NamedFigure& figure : more(record)) figures.push_back(std::move(figure));
  return figures;
}

std::string spectrum_report(const RecordSpectrum& record, const std::string& command) {
  report::HtmlReport page("Spectrum", record.source);
  const SpectralSurvey& survey = record.survey;
  if (!record.conclusions.empty()) page.verdict(record.conclusions.front());
  page.card({"Dominant functions of time",
             survey.step.clear ? std::to_string(survey.step.functions) : "no clear number",
             fmt::format("largest step of the singular values: {}", report::format_number(survey.step.ratio, 2)),
             survey.step.clear ? Tone::neutral : Tone::caution});
  if (record.tones_count() || survey.tones == 0)
    page.card({"Steady tones", fmt::format("{}{}", survey.tones_limited ? "at least " : "", survey.tones),
               "by a test against white noise", Tone::neutral});
  else
    page.card({"Steady tones", "not counted", "the record is no sum of few of them", Tone::caution});
  if (record.names.size() > 1)
    page.card({"Functions of space", std::to_string(survey.spatial_count.functions),
               survey.spatial_count.limited ? "as many as the channels can show" : "", Tone::neutral});
  if (survey.settling)
    page.card({"Settled", survey.settling->settled ? "yes" : "no", survey.settling->reason,
               survey.settling->settled ? Tone::good : Tone::bad});
  if (record.conclusions.size() > 1) {
    page.section("Conclusions");
    page.bullets({record.conclusions.begin() + 1, record.conclusions.end()});
  }
  page.section("Record");
  for (const NamedFigure& figure : record_figures(record)) page.figure(figure.figure, figure.caption);
  page.section("Number of functions");
  for (const NamedFigure& figure : order_figures(record)) page.figure(figure.figure, figure.caption);
  page.section("Circular-hyperbolic decomposition");
  page.paragraph(fmt::format("{} term{} ({}).", survey.order, survey.order == 1 ? "" : "s",
                             survey.order_by_test ? "as many as the test finds tones" : "as asked for"));
  for (std::size_t c = 0; c < record.names.size(); ++c) add_tables(page, record, c);
  if (!record.relations.empty()) {
    page.section("Linear relation to the excitation");
    Table table;
    table.columns = {
        {"Channel", Column::Kind::text, ""},
        {fmt::format("Explained by {} delays", record.relations.front().delays), Column::Kind::number, ""},
        {"By any linear filter", Column::Kind::number, ""},
        {"RV coefficient", Column::Kind::number, ""}};
    for (std::size_t c = 0; c < record.relations.size(); ++c)
      table.rows.push_back(
          {record.names[c], report::format_percent(record.relations[c].explained, 2),
           record.relations[c].coherent ? report::format_percent(record.relations[c].coherent->share, 2) : "n/a",
           report::format_number(record.relations[c].block_correlation, 3)});
    page.table(table);
    for (const NamedFigure& figure : relation_figures(record)) page.figure(figure.figure, figure.caption);
  }
  page.provenance({command, report::program_version, {record.source}});
  return page.html();
}

std::string spectrum_json(const RecordSpectrum& record) {
  const SpectralSurvey& survey = record.survey;
  Json result = {{"schema", 1}, {"source", record.source}, {"sample_rate_hz", record.sample_rate_hz}};
  result["ensembles"] = {{"count", survey.layout.count},
                         {"length_s", static_cast<double>(survey.layout.length) / record.sample_rate_hz},
                         {"overlap", survey.layout.share()}};
  result["order"] = survey.order;
  result["tones"] = {{"count", record.tones_count() || survey.tones == 0 ? Json(survey.tones) : Json(nullptr)},
                     {"at_least", survey.tones_limited}};
  result["functions_of_time"] = {
      {"count", survey.step.functions}, {"clear", survey.step.clear}, {"step", finite_json(survey.step.ratio)}};
  if (record.names.size() > 1) {
    result["functions_of_space"] = {{"count", survey.spatial_count.functions},
                                    {"at_least", survey.spatial_count.limited},
                                    {"probability", survey.spatial_count.probability}};
  }
  if (survey.settling)
    result["settled"] = {{"settled", survey.settling->settled}, {"reason", survey.settling->reason}};
  result["singular_values"] = {{"temporal", list_json(survey.temporal)},
                               {"biased", list_json(survey.biased)},
                               {"unbiased", list_json(survey.unbiased)},
                               {"spatial", list_json(survey.spatial)}};
  result["channels"] = Json::array();
  for (std::size_t c = 0; c < record.names.size(); ++c) {
    Json channel = {{"name", record.names[c]}, {"unit", record.units[c]}, {"methods", Json::array()}};
    for (const MethodStatistics& method : survey.tables[c]) {
      Json entry = {{"name", method.name},
                    {"ensembles", method.ensembles},
                    {"correlation", finite_json(method.correlation)},
                    {"signal_to_noise_db", finite_json(method.signal_to_noise_db)},
                    {"tones", record.are_tones(c, method)},
                    {"terms", Json::array()}};
      for (const TermStatistics& term : method.terms)
        entry["terms"].push_back({{"family", family_name(term.family)},
                                  {"ensembles", term.ensembles},
                                  {"frequency_hz", term.frequency_hz},
                                  {"frequency_sd_hz", finite_json(term.frequency_sd)},
                                  {"amplitude", term.amplitude},
                                  {"amplitude_sd", finite_json(term.amplitude_sd)},
                                  {"first_ensemble", {{"p", term.p}, {"q", term.q}}}});
      channel["methods"].push_back(std::move(entry));
    }
    channel["transform_peaks"] = Json::array();
    for (const SpectrumPeak& peak : survey.peaks[c])
      channel["transform_peaks"].push_back(
          {{"frequency_hz", peak.frequency * to_hz}, {"p", peak.p}, {"q", peak.q}});
    if (c < record.relations.size())
      channel["linear_relation"] = {
          {"excitation", record.excitation_name},
          {"delays", record.relations[c].delays},
          {"explained", record.relations[c].explained},
          {"coherent",
           record.relations[c].coherent ? finite_json(record.relations[c].coherent->share) : Json(nullptr)},
          {"rv_coefficient", record.relations[c].block_correlation}};
    result["channels"].push_back(std::move(channel));
  }
  result["conclusions"] = record.conclusions;
  return result.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<NamedFigure> steady_figures(const SteadyTable& table) {
  std::vector<NamedFigure> figures;
  for (const auto& [name, levels] : table.series) {
    Figure figure;
    figure.title = name;
    figure.x = {"Frequency", "Hz", false, {}};
    report::Panel amplitude{"", {"Response amplitude", "", false, {}}, {}};
    report::Panel ratio{"", {"Response over force", "", false, {}}, {}};
    int group = 0;
    for (const SteadyLevel& level : levels) {
      Series response;
      response.name = level.name;
      response.style = SeriesStyle::line_and_points;
      response.role = SeriesRole::data;
      response.group = group++;
      response.x = level.frequency_hz;
      response.y = level.response;
      amplitude.series.push_back(response);
      if (level.force.empty()) continue;
      response.name.clear();
      response.y = over_force(level);
      ratio.series.push_back(response);
    }
    figure.panels.push_back(amplitude);
    if (!ratio.series.empty()) figure.panels.push_back(ratio);
    figures.push_back(
        {name, std::move(figure),
         "Amplitude against frequency at each level. Curves over force that fall from level to level mean "
         "damping that rises with amplitude; peaks that move mean stiffness that changes."});
  }
  return figures;
}

std::string steady_table_report(const SteadyTable& table, const std::string& command) {
  report::HtmlReport page("Steady responses", table.source);
  std::size_t s = 0;
  const std::vector<NamedFigure> figures = steady_figures(table);
  for (const auto& [name, levels] : table.series) {
    page.section(name);
    page.figure(figures[s].figure, figures[s].caption);
    ++s;
    Table peaks;
    peaks.caption = "Highest response over force (over nothing where there is no force) of each level";
    peaks.columns = {{"Level", Column::Kind::text, ""},
                     {"Frequency", Column::Kind::number, "Hz"},
                     {"Response", Column::Kind::number, ""},
                     {"Response over force", Column::Kind::number, ""}};
    for (const SteadyLevel& level : levels) {
      const std::vector<double> over = over_force(level);
      const auto best = static_cast<std::size_t>(std::max_element(over.begin(), over.end()) - over.begin());
      peaks.rows.push_back({level.name, report::format_number(level.frequency_hz[best], 6),
                            report::format_number(level.response[best], 4),
                            level.force.empty() ? "n/a" : report::format_number(over[best], 4)});
    }
    page.table(peaks);
  }
  page.provenance({command, report::program_version, {table.source}});
  return page.html();
}

std::string steady_table_json(const SteadyTable& table) {
  Json result = {{"schema", 1}, {"source", table.source}, {"series", Json::array()}};
  for (const auto& [name, levels] : table.series) {
    Json series = {{"name", name}, {"levels", Json::array()}};
    for (const SteadyLevel& level : levels)
      series["levels"].push_back({{"name", level.name},
                                  {"frequency_hz", level.frequency_hz},
                                  {"response", level.response},
                                  {"force", level.force}});
    result["series"].push_back(std::move(series));
  }
  return result.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace secular
