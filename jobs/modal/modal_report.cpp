#include "jobs/modal/modal_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/modal/modal_mass.hpp"
#include "measure/modal/pole.hpp"
#include "numerics/hertz.hpp"
#include "report/html_report.hpp"
#include "report/number_format.hpp"
#include "report/structure_drawing.hpp"

namespace secular {
namespace {

using Eigen::Index;
using report::Column;
using report::Figure;
using report::NamedFigure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;
using report::Table;
using report::Tone;

std::string mode_name(std::size_t r) {
  return fmt::format("v{}", r + 1);
}

// Of the modes, each once: bands of a survey have windows of their own.
std::vector<std::string> window_lengths(const ModalSurvey& survey) {
  std::vector<std::string> lengths;
  for (const SurveyMode& mode : survey.modes) {
    if (!mode.amplitude) continue;
    std::string length = report::format_number(mode.window_s, 4);
    if (lengths.empty() || lengths.back() != length) lengths.push_back(std::move(length));
  }
  return lengths;
}

double shown_top(const ModalSurvey& survey) {
  const double top = survey.spectrum_hz.size() > 0 ? survey.spectrum_hz(survey.spectrum_hz.size() - 1) : 0;
  return survey.options.highest_hz > 0 ? std::min(top, 1.1 * survey.options.highest_hz) : top;
}

// At most about 4000 points: of every stretch of lines the largest value, so that no resonance is lost.
Series largest_of_stretches(const Eigen::VectorXd& x, const Eigen::VectorXd& y, double top) {
  Series series;
  series.role = SeriesRole::data;
  Index count = 0;
  while (count < x.size() && x(count) <= top) ++count;
  const Index stride = std::max<Index>(1, count / 2000);
  for (Index i = 1; i < count; i += stride) {
    Index largest = 0;
    y.segment(i, std::min(stride, count - i)).maxCoeff(&largest);
    series.x.push_back(x(i + largest));
    series.y.push_back(y(i + largest));
  }
  return series;
}

Figure stabilisation_figure(const ModalSurvey& survey) {
  Figure figure;
  figure.title = "Stabilisation diagram";
  figure.x = {"Frequency", "Hz", false, std::pair(0.0, shown_top(survey))};
  Series spectrum = largest_of_stretches(survey.spectrum_hz, survey.spectrum, shown_top(survey));
  const std::string level = survey.references.empty() ? "Spectrum" : "Frequency response";
  figure.panels.push_back(
      {"", {level, survey.references.empty() ? survey.unit : survey.unit + "/N", true, {}}, {spectrum}});
  Series all, partly, fresh;
  all.name = "stable in frequency, damping and shape";
  all.role = SeriesRole::data;
  partly.name = "stable in frequency";
  partly.role = SeriesRole::alternative;
  fresh.name = "new";
  fresh.role = SeriesRole::reference;
  all.style = partly.style = fresh.style = SeriesStyle::points;
  for (const StabilisationPole& pole : survey.diagram.poles) {
    const double frequency = natural_frequency(pole.pole) * to_hz;
    if (frequency > shown_top(survey)) continue;
    Series& series = pole.stable() ? all : (pole.stable_frequency ? partly : fresh);
    series.x.push_back(frequency);
    series.y.push_back(pole.order);
  }
  figure.panels.push_back({"", {"Model order", "", false, {}}, {fresh, partly, all}});
  return figure;
}

Figure amplitude_figure(const ModalSurvey& survey, std::size_t r) {
  Figure figure;
  figure.title = fmt::format("Mode {}: frequency and damping against amplitude", mode_name(r));
  figure.x = {"Mean modal amplitude", survey.unit, false, {}};
  Series frequency, damping, frequency_line, damping_line;
  frequency.name = "windows";
  frequency.style = damping.style = SeriesStyle::error_bars;
  frequency.role = damping.role = SeriesRole::data;
  for (const ModeWindow& window : survey.windows) {
    if (window.mode != static_cast<Index>(r)) continue;
    frequency.x.push_back(window.amplitude);
    frequency.y.push_back(window.pole.imag() * to_hz);
    frequency.y_error.push_back(2 * window.omega_sd * to_hz);
    damping.x.push_back(window.amplitude);
    damping.y.push_back(window.pole.real() * to_hz);
    damping.y_error.push_back(2 * window.growth_sd * to_hz);
  }
  frequency_line.name = "law with the most evidence";
  const AmplitudeDependence& line = *survey.modes[r].amplitude;
  for (int i = 0; i <= 20; ++i) {
    const double x = line.largest_amplitude * i / 20;
    frequency_line.x.push_back(x);
    frequency_line.y.push_back(line.frequency_law.at(x));
    damping_line.x.push_back(x);
    damping_line.y.push_back(line.damping_law.at(x));
  }
  figure.panels.push_back({"", {"Damped natural frequency", "Hz", false, {}}, {frequency, frequency_line}});
  figure.panels.push_back({"", {"Damping factor", "Hz", false, {}}, {damping, damping_line}});
  return figure;
}

Figure shape_figure(const ModalSurvey& survey) {
  Figure figure;
  figure.title = "Mode shapes in the complex plane";
  figure.x = {"Real part", "", false, std::pair(-1.1, 1.1)};
  report::Panel panel{"", {"Imaginary part", "", false, std::pair(-1.1, 1.1)}, {}};
  for (std::size_t r = 0; r < survey.modes.size() && r < 6; ++r) {
    Series series;
    series.name = mode_name(r);
    series.style = SeriesStyle::error_bars;
    series.role = SeriesRole::data;
    series.group = static_cast<int>(r);
    for (Index c = 0; c < survey.modes[r].shape.mean.size(); ++c) {
      series.x.push_back(survey.modes[r].shape.mean(c).real());
      series.y.push_back(survey.modes[r].shape.mean(c).imag());
      series.y_error.push_back(2 * survey.modes[r].shape.imaginary_sd(c));
    }
    panel.series.push_back(std::move(series));
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure response_figure(const ModalSurvey& survey, const SurveyReference& reference) {
  Figure figure;
  figure.title = "Impacts at " + reference.group;
  figure.x = {"Frequency", "Hz", false, std::pair(0.0, shown_top(survey))};
  report::Panel level{"", {"Modulus of H1", survey.unit + "/N", true, {}}, {}};
  report::Panel coherence{"", {"Coherence", "", false, std::pair(0.0, 1.05)}, {}};
  for (Index c = 0; c < reference.response.h1.cols() && c < 6; ++c) {
    const Eigen::VectorXd modulus = reference.response.h1.col(c).cwiseAbs();
    Series series = largest_of_stretches(reference.response.frequency_hz, modulus, shown_top(survey));
    series.name = survey.channel_name(c);
    series.group = static_cast<int>(c);
    level.series.push_back(std::move(series));
    series = largest_of_stretches(reference.response.frequency_hz, reference.response.coherence.col(c),
                                  shown_top(survey));
    series.group = static_cast<int>(c);
    coherence.series.push_back(std::move(series));
  }
  figure.panels.push_back(std::move(level));
  if (reference.response.impacts > 1) figure.panels.push_back(std::move(coherence));
  return figure;
}

constexpr const char* stabilisation_caption =
    "Poles of realizations of rising order above the spectrum of the responses. A pole is stable where the next "
    "lower order has one of nearly the same frequency, damping and shape; a mode is a chain of such poles.";
constexpr const char* shape_caption = "Normal modes lie on the real axis. Bars: two standard deviations.";

constexpr const char* drawing_caption =
    "Solid and dashed: both ends of the motion; grey: at rest. Points without a sensor do not move. A click, or Enter, "
    "sets it going for ten seconds.";

constexpr std::size_t most_amplitude_figures = 6;

std::vector<NamedFigure> amplitude_figures(const ModalSurvey& survey) {
  std::vector<NamedFigure> figures;
  for (std::size_t r = 0; r < survey.modes.size() && figures.size() < most_amplitude_figures; ++r)
    if (survey.modes[r].amplitude)
      figures.push_back({"amplitude_" + mode_name(r), amplitude_figure(survey, r),
                         "Every window of the decays (bars: two standard deviations)."});
  return figures;
}

std::vector<NamedFigure> response_figures(const ModalSurvey& survey) {
  std::vector<NamedFigure> figures;
  for (const SurveyReference& reference : survey.references)
    figures.push_back(
        {"response_" + reference.group, response_figure(survey, reference),
         fmt::format(
             "{} impacts. Force window: {}. Exponential window: exp(-{} t), its damping taken off the poles.",
             reference.response.impacts,
             reference.response.windows.force_s > 0
                 ? report::format_number(reference.response.windows.force_s, 4) + " s"
                 : "none",
             report::format_number(reference.response.windows.decay, 4))});
  return figures;
}

void add_tones(report::HtmlReport& page, const ModalSurvey& survey) {
  if (survey.tones.empty()) return;
  Table table;
  table.caption =
      "Harmonics and combinations of modes, not counted as modes. A mode of the same damping ratio at that "
      "frequency "
      "would look like one of them; four blows of different strength tell them apart";
  table.columns = {{"Frequency", Column::Kind::number, "Hz"},
                   {"Damping ratio", Column::Kind::number, "%"},
                   {"Is", Column::Kind::text, ""},
                   {"Why", Column::Kind::text, ""}};
  for (const SurveyTone& tone : survey.tones)
    table.rows.push_back(
        {report::format_uncertain(tone.found.natural_frequency_hz, tone.found.natural_frequency_sd_hz),
         report::format_uncertain(100 * tone.found.damping_ratio, 100 * tone.found.damping_ratio_sd), tone.name(),
         tone.reason()});
  page.table(table);
}

void add_modes(report::HtmlReport& page, const ModalSurvey& survey) {
  Table table;
  table.columns = {{"Mode", Column::Kind::text, ""},
                   {"Natural frequency", Column::Kind::number, "Hz"},
                   {"Natural frequency", Column::Kind::number, "rad/s"},
                   {"Damping ratio", Column::Kind::number, "%"},
                   {"Motion", Column::Kind::text, ""},
                   {"Phase collinearity", Column::Kind::number, ""},
                   {"Modal mass", Column::Kind::number, "kg"},
                   {"Stable orders", Column::Kind::number, ""},
                   {"From", Column::Kind::text, ""}};
  for (std::size_t r = 0; r < survey.modes.size(); ++r) {
    const SurveyMode& mode = survey.modes[r];
    table.rows.push_back(
        {mode_name(r), report::format_uncertain(mode.natural_frequency_hz, mode.natural_frequency_sd_hz),
         report::format_uncertain(mode.natural_frequency_hz / to_hz, mode.natural_frequency_sd_hz / to_hz),
         report::format_uncertain(100 * mode.damping_ratio, 100 * mode.damping_ratio_sd), to_string(mode.trend()),
         report::format_number(mode.phase_collinearity, 3),
         mode.mass ? report::format_uncertain(*mode.mass, mode.mass_sd) : "", std::to_string(mode.diagram.orders),
         mode.from});
  }
  page.table(table);
  add_tones(page, survey);
  if (survey.dropped.empty()) return;
  Table dropped;
  dropped.caption = "Stable poles that are no modes";
  dropped.columns = {{"Frequency", Column::Kind::number, "Hz"},
                     {"Damping ratio", Column::Kind::number, "%"},
                     {"Why", Column::Kind::text, ""}};
  for (const DroppedPole& pole : survey.dropped)
    dropped.rows.push_back({report::format_number(natural_frequency(pole.pole) * to_hz, 4),
                            report::format_number(100 * damping_ratio(pole.pole), 3), pole.reason});
  page.table(dropped);
}

void add_shapes(report::HtmlReport& page, const ModalSurvey& survey) {
  Table table;
  table.columns = {{"Mode", Column::Kind::text, ""},
                   {"Response", Column::Kind::text, ""},
                   {"Real part", Column::Kind::number, ""},
                   {"Real sd", Column::Kind::number, ""},
                   {"Imaginary part", Column::Kind::number, ""},
                   {"Imaginary sd", Column::Kind::number, ""}};
  for (std::size_t r = 0; r < survey.modes.size(); ++r)
    for (Index c = 0; c < survey.modes[r].shape.mean.size(); ++c) {
      const MeanShape& shape = survey.modes[r].shape;
      const auto sd = [&](double value) {
        return shape.windows > 1 ? report::format_number(value, 2) : std::string();
      };
      table.rows.push_back({c == 0 ? mode_name(r) : "", survey.channel_name(c),
                            report::format_fixed(shape.mean(c).real(), 4), sd(shape.real_sd(c)),
                            report::format_fixed(shape.mean(c).imag(), 4), sd(shape.imaginary_sd(c))});
    }
  page.table(table);
}

void add_matrix(report::HtmlReport& page, const Eigen::MatrixXd& matrix, const std::vector<std::string>& row_names,
                const std::vector<std::string>& column_names, const std::string& caption) {
  Table table;
  table.caption = caption;
  table.columns.push_back({"", Column::Kind::text, ""});
  for (const std::string& name : column_names) table.columns.push_back({name, Column::Kind::number, ""});
  for (Index r = 0; r < matrix.rows(); ++r) {
    std::vector<std::string> row{row_names[static_cast<std::size_t>(r)]};
    for (Index c = 0; c < matrix.cols(); ++c) row.push_back(report::format_number(matrix(r, c), 4));
    table.rows.push_back(std::move(row));
  }
  page.table(table);
}

void add_masses(report::HtmlReport& page, const ModalSurvey& survey) {
  Table table;
  table.columns = {{"Reference", Column::Kind::text, ""}};
  for (std::size_t r = 0; r < survey.modes.size(); ++r)
    table.columns.push_back({mode_name(r), Column::Kind::number, "kg"});
  for (std::size_t m = 0; m < survey.modes.front().masses.size(); ++m) {
    std::vector<std::string> row{survey.modes.front().masses[m].group};
    for (const SurveyMode& mode : survey.modes)
      row.push_back(mode.masses[m].used ? report::format_number(mode.masses[m].mass, 4) : "not used");
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty()) return;
  page.section("Modal masses");
  page.paragraph(
      "One estimate for each point that was struck where a response is measured. A point that hardly moves in a "
      "mode "
      "is not used for it: its estimate divides by a small number.");
  page.table(table);
}

void add_amplitude_dependence(report::HtmlReport& page, const ModalSurvey& survey) {
  page.section("Frequency and damping against amplitude");
  Table table;
  table.columns = {{"Mode", Column::Kind::text, ""},
                   {"Frequency intercept", Column::Kind::number, "Hz"},
                   {"Frequency slope", Column::Kind::number, "Hz/(" + survey.unit + ")"},
                   {"Frequency scatter", Column::Kind::number, "Hz"},
                   {"Damping intercept", Column::Kind::number, "Hz"},
                   {"Damping slope", Column::Kind::number, "Hz/(" + survey.unit + ")"},
                   {"Damping scatter", Column::Kind::number, "Hz"},
                   {"Windows", Column::Kind::number, ""}};
  for (std::size_t r = 0; r < survey.modes.size(); ++r) {
    if (!survey.modes[r].amplitude) continue;
    const AmplitudeDependence& a = *survey.modes[r].amplitude;
    const auto value = [](double v, double sd) { return report::format_uncertain(v, sd); };
    table.rows.push_back({mode_name(r), value(a.frequency_hz.intercept, a.frequency_hz.intercept_sd),
                          value(a.frequency_hz.slope, a.frequency_hz.slope_sd),
                          report::format_number(a.frequency_hz.scatter, 3),
                          value(a.damping_factor_hz.intercept, a.damping_factor_hz.intercept_sd),
                          value(a.damping_factor_hz.slope, a.damping_factor_hz.slope_sd),
                          report::format_number(a.damping_factor_hz.scatter, 3), std::to_string(a.windows)});
  }
  page.table(table);
  page.paragraph(
      fmt::format("Windows of {} s; frequency and damping factor are imaginary and real part of the pole "
                  "over 2 pi.",
                  fmt::join(window_lengths(survey), ", ")));
  for (const NamedFigure& figure : amplitude_figures(survey)) page.figure(figure.figure, figure.caption);
}

void add_responses(report::HtmlReport& page, const ModalSurvey& survey) {
  page.section("Frequency responses");
  for (const NamedFigure& figure : response_figures(survey)) page.figure(figure.figure, figure.caption);
  add_masses(page, survey);
}

// Each mode on the structure, where the campaign says where its channels are.
void add_drawings(report::HtmlReport& page, const ModalSurvey& survey) {
  if (!survey.campaign.geometry || survey.campaign.geometry->sensors.empty()) return;
  const Geometry& geometry = *survey.campaign.geometry;
  for (std::size_t r = 0; r < survey.modes.size(); ++r) {
    const SurveyMode& mode = survey.modes[r];
    report::StructureDrawing drawing;
    drawing.title = fmt::format("{}: {} Hz", mode_name(r), report::format_number(mode.natural_frequency_hz, 4));
    drawing.id = "structure_" + mode_name(r);
    for (const Geometry::Point& point : geometry.points) drawing.points.push_back(point.at);
    drawing.motion.resize(geometry.points.size());
    drawing.lines = geometry.lines;
    for (const Geometry::Sensor& sensor : geometry.sensors)
      for (std::size_t c = 0; c < survey.channels.size(); ++c)
        if (survey.channel_name(static_cast<Index>(c)) == sensor.channel)
          for (std::size_t axis = 0; axis < 3; ++axis)
            drawing.motion[sensor.point][axis] += sensor.direction[axis] * mode.shape.mean(static_cast<Index>(c));
    page.drawing(report::structure_drawing(drawing), drawing.title, drawing_caption);
  }
}

// What warnings say of modes that one damped motion does not explain, in short.
std::string doubts_of(const ModalSurvey& survey) {
  std::vector<std::string> doubtful;
  for (std::size_t r = 0; r < survey.modes.size(); ++r)
    if (survey.modes[r].leaves_more_than_noise()) doubtful.push_back(mode_name(r));
  if (doubtful.empty()) return "";
  return fmt::format("; in the place of {} there may be two modes, or one that changes with amplitude",
                     fmt::join(doubtful, ", "));
}

std::string verdict_of(const ModalSurvey& survey) {
  if (survey.modes.empty()) return "No mode was found.";
  const auto [low, high] = std::minmax_element(
      survey.modes.begin(), survey.modes.end(),
      [](const SurveyMode& a, const SurveyMode& b) { return a.natural_frequency_hz < b.natural_frequency_hz; });
  const auto [soft, hard] = std::minmax_element(
      survey.modes.begin(), survey.modes.end(),
      [](const SurveyMode& a, const SurveyMode& b) { return a.damping_ratio < b.damping_ratio; });
  const auto hertz = [](const SurveyMode& mode) { return report::format_number(mode.natural_frequency_hz, 4); };
  const auto percent = [](const SurveyMode& mode) { return report::format_number(100 * mode.damping_ratio, 2); };
  if (survey.modes.size() == 1)
    return fmt::format("One mode was found, at {} Hz with a damping ratio of {} %{}.", hertz(*low), percent(*low),
                       doubts_of(survey));
  return fmt::format("{} modes were found between {} and {} Hz, with damping ratios from {} to {} %{}.",
                     survey.modes.size(), hertz(*low), hertz(*high), percent(*soft), percent(*hard),
                     doubts_of(survey));
}

}  // namespace

std::vector<NamedFigure> modal_figures(const ModalSurvey& survey) {
  std::vector<NamedFigure> figures = {{"stabilisation", stabilisation_figure(survey), stabilisation_caption},
                                      {"shapes", shape_figure(survey), shape_caption}};
  for (auto* more : {&amplitude_figures, &response_figures})
    for (NamedFigure& figure : more(survey)) figures.push_back(std::move(figure));
  return figures;
}

std::string modal_report(const ModalSurvey& survey, const std::string& command) {
  report::HtmlReport page("Modal survey", "Campaign " + survey.campaign.name);
  std::vector<std::string> modes, channels;
  for (std::size_t r = 0; r < survey.modes.size(); ++r) modes.push_back(mode_name(r));
  for (std::size_t c = 0; c < survey.channels.size(); ++c)
    channels.push_back(survey.channel_name(static_cast<Index>(c)));
  for (const std::string& warning : survey.warnings) page.warn(warning);
  page.verdict(verdict_of(survey), survey.modes.empty()        ? Tone::bad
                                   : doubts_of(survey).empty() ? Tone::neutral
                                                               : Tone::caution);
  for (std::size_t r = 0; r < survey.modes.size() && r < 6; ++r) {
    const SurveyMode& mode = survey.modes[r];
    page.card({"Mode " + mode_name(r),
               report::format_quantity(mode.natural_frequency_hz, mode.natural_frequency_sd_hz, "Hz"),
               fmt::format("{} rad/s, damping {} %",
                           report::format_uncertain(mode.natural_frequency_hz / to_hz,
                                                    mode.natural_frequency_sd_hz / to_hz),
                           report::format_uncertain(100 * mode.damping_ratio, 100 * mode.damping_ratio_sd)),
               mode.phase_collinearity < 0.9 ? Tone::caution : Tone::neutral});
  }
  page.section("Modes");
  add_modes(page, survey);
  page.section("Stabilisation diagram");
  page.figure(stabilisation_figure(survey), stabilisation_caption);
  page.section("Mode shapes");
  page.paragraph(
      "Scaled so that the sum of the squares is one. Standard deviations are the scatter of one window (free "
      "decays) "
      "or those of the estimate (impacts).");
  add_shapes(page, survey);
  page.figure(shape_figure(survey), shape_caption);
  add_drawings(page, survey);
  add_matrix(page, survey.mac, modes, modes, "Modal assurance criterion between the modes");
  if (std::any_of(survey.modes.begin(), survey.modes.end(),
                  [](const SurveyMode& m) { return m.amplitude.has_value(); }))
    add_amplitude_dependence(page, survey);
  if (!survey.references.empty()) add_responses(page, survey);
  if (const std::optional<Eigen::MatrixXd> shapes = survey.mass_normalised()) {
    page.section("Mass-normalised shapes and matrices");
    add_matrix(page, *shapes, channels, modes, "Mass-normalised shapes, kg^(-1/2)");
    if (shapes->cols() <= shapes->rows()) {
      Eigen::VectorXcd poles(shapes->cols());
      for (Index r = 0; r < poles.size(); ++r) poles(r) = survey.modes[static_cast<std::size_t>(r)].pole;
      const DynamicMatrices matrices = dynamic_matrices(*shapes, poles);
      add_matrix(page, matrices.mass, channels, channels, "Mass, kg");
      add_matrix(page, matrices.damping, channels, channels, "Damping, kg/s");
      add_matrix(page, matrices.stiffness, channels, channels, "Stiffness, kg/s^2");
      page.details("For campaign.toml", [&] { page.preformatted(modal_basis_text(survey)); });
    }
  }
  page.provenance({command,
                   report::program_version,
                   {fmt::format("campaign {}, {} records", survey.campaign.name, survey.campaign.records.size())}});
  return page.html();
}

}  // namespace secular
