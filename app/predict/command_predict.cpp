#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "app/shared/selection_options.hpp"
#include "app/shared/word_choice.hpp"
#include "input/input_error.hpp"
#include "jobs/predict/prediction.hpp"
#include "jobs/predict/prediction_files.hpp"
#include "jobs/predict/prediction_report.hpp"
#include "jobs/predict/uncertain_text.hpp"
#include "numerics/hertz.hpp"
#include "report/number_format.hpp"

namespace secular::app {
namespace {

struct PredictArguments {
  PredictionRequest request;
  SelectionOptions selection;
  OutputFolder output{{"prediction.json", "prediction.csv", "report.html", "response.svg", "phases.svg",
                       "plane.svg", "amplitude.svg", "backbone_*.svg"}};
  std::vector<std::string> vary, against, at, sweeps;
  bool json = false;
};

double number_of(const std::string& text, const std::string& option) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
    throw InputError(option, "", "'" + text + "' is not a number", "for example --vary Omega 150 160, --at F=22.5");
  return value;
}

std::optional<VariedParameter> varied(const std::vector<std::string>& texts, const std::string& option) {
  if (texts.empty()) return {};
  return VariedParameter{texts[0], number_of(texts[1], option), number_of(texts[2], option)};
}

void parse(PredictArguments& options) {
  PredictionRequest& request = options.request;
  request.window = options.selection.window();
  request.vary = varied(options.vary, "--vary");
  request.against = varied(options.against, "--against");
  for (const std::string& text : options.at) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError("--at " + text, "", "is not NAME=VALUE", "for example --at F=22.5");
    request.at[text.substr(0, equals)] = number_of(text.substr(equals + 1), "--at " + text);
  }
  request.sweep_up = std::find(options.sweeps.begin(), options.sweeps.end(), "up") != options.sweeps.end();
  request.sweep_down = std::find(options.sweeps.begin(), options.sweeps.end(), "down") != options.sweeps.end();
}

std::string located(double value, double axis, const std::string& unit, int digits = 6) {
  return report::format_number(value / axis, digits) + (unit.empty() ? "" : " " + unit);
}

void print_summary(const Prediction& prediction, const std::vector<report::NamedFigure>& figures,
                   const std::string& folder) {
  const report::PlainNumbers plain(prints_for_programs());
  fmt::print("model {}, case {}\n", prediction.model->name, prediction.resonance->name);
  for (const std::string& note : prediction.diagram.notes) fmt::print("  {}\n", note);
  for (std::size_t b = 0; b < prediction.diagram.branches.size(); ++b) {
    const ResponseBranch& branch = prediction.diagram.branches[b];
    const auto outside = std::count_if(branch.points.begin(), branch.points.end(),
                                       [](const ResponsePoint& point) { return point.outside; });
    fmt::print("branch {}{}: {} points{}\n", b + 1, branch.at_rest ? ", at rest" : "", branch.points.size(),
               outside > 0 ? fmt::format(", {} outside of the expansion's range", outside) : "");
    for (const ResponseSpecial& special : branch.special) {
      std::string line = fmt::format("  {:<12} {} = {}{}", special_name(special), prediction.vary->name,
                                     special_place(prediction, special),
                                     prediction.axis_unit.empty() ? "" : " " + prediction.axis_unit);
      for (std::size_t k = 0; k < prediction.model->modes(); ++k)
        if (!prediction.resonance->mode_at_rest[k] && !special.at.at_rest)
          line +=
              fmt::format("  amplitude of {} = {}", prediction.model->coordinates[k],
                          located(2 * std::abs(special.at.modes.amplitude[k]), 1, prediction.coordinate_unit, 4));
      if (special.at.outside) line += "  (outside of the expansion's range)";
      fmt::print("{}\n", line);
    }
  }
  for (const LargestResponse& largest : prediction.largest) {
    std::optional<double> place_sd = largest.parameter_sd;
    if (place_sd) *place_sd /= prediction.axis;
    fmt::print("largest stable response of {}: amplitude {}{} at {} = {}{}\n",
               prediction.model->coordinates[largest.mode],
               uncertain_number(largest.amplitude, largest.amplitude_sd, 4),
               prediction.coordinate_unit.empty() ? "" : " " + prediction.coordinate_unit, prediction.vary->name,
               uncertain_number(largest.parameter / prediction.axis, place_sd, 6),
               prediction.axis_unit.empty() ? "" : " " + prediction.axis_unit);
  }
  for (std::size_t k = 0; k < prediction.backbones.size(); ++k) {
    const auto& [mode, points] = prediction.backbones[k];
    fmt::print("backbone of {}: {} Hz at rest, {} Hz at amplitude {}\n", mode,
               report::format_number(points.front().frequency * to_hz, 6),
               report::format_number(points.back().frequency * to_hz, 6),
               report::format_number(2 * points.back().amplitude, 4));
    for (std::size_t c = 0; c < prediction.limit_cycles[k].size(); ++c)
      fmt::print("  limit cycle, {}: amplitude {}, {} Hz{}\n",
                 prediction.limit_cycles[k][c].stable ? "stable" : "unstable", cycle_amplitude(prediction, k, c),
                 cycle_frequency(prediction, k, c),
                 prediction.limit_cycles[k][c].at.outside ? "  (outside of the expansion's range)" : "");
  }
  for (const PredictedSweep& sweep : prediction.sweeps)
    for (const PredictedSweep::Jump& jump : sweep.jumps)
      fmt::print("simulated sweep {}: {} jumps between {} and {}\n", sweep.direction,
                 prediction.model->coordinates[jump.mode],
                 located(jump.from, prediction.axis, prediction.axis_unit),
                 located(jump.to, prediction.axis, prediction.axis_unit));
  if (!prediction.measured.empty()) fmt::print("measured dwells drawn: {}\n", prediction.measured.size());
  for (const ResponseCurve& curve : prediction.curves) {
    fmt::print("curve of {}: {} points\n", in_words(curve.kind), curve.points.size());
    for (const auto& [kind, at] : curve.special)
      fmt::print("  {} {} = {}, {} = {}\n", kind == CodimensionTwo::cusp ? "cusp" : "double zero",
                 prediction.vary->name, located(at.first, prediction.axis, prediction.axis_unit),
                 prediction.against->name, located(at.second, prediction.against_axis, prediction.against_unit));
  }
  fmt::print("written: {0}/prediction.json, {0}/prediction.csv, {0}/report.html", folder);
  for (const report::NamedFigure& figure : figures) fmt::print(", {}/{}.svg", folder, figure.name);
  fmt::print("\n");
}

void write_files(const Prediction& prediction, const std::vector<report::NamedFigure>& figures,
                 const OutputFolder& output, const std::string& json, const std::string& line) {
  ResultFiles files = {{"prediction.json", json},
                       {"prediction.csv", prediction_csv(prediction)},
                       {"report.html", prediction_report(prediction, figures, line)}};
  for (const report::NamedFigure& figure : figures)
    files.emplace_back(figure.name + ".svg",
                       report::render_figure(figure.figure, "figure", report::FigureUse::standalone).svg);
  output.write(files);
}

}  // namespace

void add_predict_command(CLI::App* command, Action& chosen) {
  auto options = std::make_shared<PredictArguments>();
  PredictionRequest& request = options->request;
  request.threads = std::max(1U, std::thread::hardware_concurrency());
  command->add_option("MODEL", request.model, "model file, or the name of a shipped model")->required();
  command->add_option("--case", request.resonance, "resonance case; may be left out where there is only one");
  command
      ->add_option("--parameters", request.parameters,
                   "estimate.json, or a JSON object of symbol to number; a shipped one by its name")
      ->required();
  command->add_option("--vary", options->vary, "NAME FROM TO: response over this parameter (frequencies in rad/s)")
      ->expected(3);
  command->add_option("--at", options->at, "NAME=VALUE: a parameter, an excitation's amplitude or frequency")
      ->allow_extra_args(false);
  command->add_option("--curve", request.curve, "curve of these points in two parameters, --vary and --against")
      ->check(one_of({"saddle_node", "threshold", "hopf", "peak"}));
  command->add_option("--against", options->against, "NAME FROM TO: second parameter of --curve")->expected(3);
  command->add_flag("--hz", request.hz, "excitation frequencies in --vary, --against and --at are in Hz");
  command
      ->add_option("--largest", request.largest,
                   "peak amplitude up to which responses are looked for; chosen from the equations without it")
      ->check(CLI::PositiveNumber);
  command->add_option("--sweep", options->sweeps, "up, down: simulated sweeps of the full equations on the curve")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->check(one_of({"up", "down"}));
  command->add_option("--sweep-steps", request.sweep_steps, "dwells of a simulated sweep")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  CLI::Option* measured = command->add_option("--measured", request.measured,
                                              "campaign whose dwells at this excitation are drawn on the response");
  options->selection.add_to(*command, {}, measured);
  options->output.add_to(*command,
                         "folder for prediction.json, prediction.csv, report.html and the figures as SVG");
  command->add_option("--threads", request.threads, "threads; the result does not depend on it")
      ->check(CLI::Range(1U, 1024U));
  command->add_flag("--json", options->json, "print prediction.json instead of the summary");
  command->footer(
      "Example: secular predict two_mass_mode1 --case principal_parametric --parameters predictions/table_5_4 "
      "--at F=22.55 --vary Omega 24.3 25.1 --hz -o out");
  command->callback([options, command, &chosen] {
    chosen = [options, command] {
      parse(*options);
      options->output.check({{"the model", options->request.model, false},
                             {"the file of parameters", options->request.parameters, false},
                             {"the campaign", options->request.measured, true}});
      options->request.note = print_note;
      ProgressLine line("dwells");
      const Prediction prediction =
          predict(options->request, [&line](std::size_t done, std::size_t total) { line(done, total); });
      const std::string json = prediction_json(prediction);
      const std::vector<report::NamedFigure> figures = prediction_figures(prediction);
      write_files(prediction, figures, options->output, json, command_line_of(*command));
      print_warnings(prediction.warnings);
      if (options->json)
        fmt::print("{}", json);
      else
        print_summary(prediction, figures, options->output.path());
      return 0;
    };
  });
}

}  // namespace secular::app
