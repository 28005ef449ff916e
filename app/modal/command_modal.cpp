#include <fmt/format.h>

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "app/shared/selection_options.hpp"
#include "input/input_error.hpp"
#include "jobs/modal/modal_json.hpp"
#include "jobs/modal/modal_report.hpp"
#include "jobs/modal/modal_run.hpp"
#include "measure/modal/modal_survey.hpp"
#include "measure/modal/pole.hpp"
#include "numerics/hertz.hpp"
#include "report/number_format.hpp"

namespace secular::app {
namespace {

struct ModalArguments {
  ModalSurveyOptions survey;
  std::string campaign;
  OutputFolder output{{"modal.json", "report.html"}};
  OutputFile basis;
  SelectionOptions selection;
  std::vector<std::string> driving_points;
  double response_decay = 0;
  bool json = false;
};

void parse_driving_points(ModalArguments& options) {
  for (const std::string& text : options.driving_points) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
      throw InputError("--driving-point " + text, "", "is not GROUP=CHANNEL",
                       "for example --driving-point uplx-=-uprx+");
    options.survey.driving_points[text.substr(0, equals)] = driving_point_of(text.substr(equals + 1));
  }
}

void print_amplitude(const AmplitudeDependence& a, const std::string& unit) {
  fmt::print("       {} windows from {} to {} {}: ", a.windows, report::format_number(a.smallest_amplitude, 3),
             report::format_number(a.largest_amplitude, 3), unit);
  if (a.frequency_law.degree == 0 && a.damping_law.degree == 0) {
    fmt::print("no change with amplitude\n");
    return;
  }
  const auto slope = [](const AmplitudeLaw& law, const StraightLine& line) {
    if (law.degree == 0) return std::string("no change");
    return report::format_uncertain(line.slope, line.slope_sd) + " Hz" + (law.degree == 2 ? " (curved)" : "");
  };
  fmt::print("{} and {} of damping factor per {}\n", slope(a.frequency_law, a.frequency_hz),
             slope(a.damping_law, a.damping_factor_hz), unit);
}

void print_summary(const ModalSurvey& survey, const ModalArguments& options) {
  const report::PlainNumbers plain(prints_for_programs());
  fmt::print("{} mode{} of {} channels\n", survey.modes.size(), survey.modes.size() == 1 ? "" : "s",
             survey.channels.size());
  for (std::size_t r = 0; r < survey.modes.size(); ++r) {
    const SurveyMode& mode = survey.modes[r];
    fmt::print("  v{:<3} {:>16} Hz  damping {:>12} %", r + 1,
               report::format_uncertain(mode.natural_frequency_hz, mode.natural_frequency_sd_hz),
               report::format_uncertain(100 * mode.damping_ratio, 100 * mode.damping_ratio_sd));
    if (mode.trend() == MotionTrend::grows) fmt::print("  GROWS");
    if (mode.mass) fmt::print("  modal mass {} kg", report::format_uncertain(*mode.mass, mode.mass_sd));
    fmt::print("\n");
    if (mode.amplitude) print_amplitude(*mode.amplitude, survey.unit);
  }
  if (!survey.tones.empty())
    fmt::print(
        "not counted as modes, at harmonics or combinations of modes (a mode of the same damping ratio there "
        "would look like it; four blows of different strength tell):\n");
  for (const SurveyTone& tone : survey.tones)
    fmt::print("       {:>16} Hz  {}\n",
               report::format_uncertain(tone.found.natural_frequency_hz, tone.found.natural_frequency_sd_hz),
               tone.name());
  if (!survey.dropped.empty()) {
    std::string list;
    for (const DroppedPole& dropped : survey.dropped)
      list += fmt::format("{}{:.4g}", list.empty() ? "" : ", ", natural_frequency(dropped.pole) * to_hz);
    fmt::print("not modes, though stable in the diagram (reasons in modal.json): {} Hz\n", list);
  }
  const std::string &folder = options.output.path(), &basis = options.basis.path();
  fmt::print("written: {0}/modal.json, {0}/report.html{1}\n", folder, basis.empty() ? "" : ", " + basis);
}

int run(ModalArguments& options, const CLI::App& command) {
  const Window window = options.selection.window();
  const CommandInput read = {"the campaign", options.campaign, true};
  options.output.check({read});
  options.basis.check({read, {"the folder of results", options.output.path(), true}}, options.output.replaces());
  const Campaign campaign = read_campaign(options.campaign);
  parse_driving_points(options);
  if (command.count("--exponential-window")) options.survey.response_decay = options.response_decay;
  ProgressLine line("parts of the survey (about)");
  options.survey.progress = [&line](std::size_t done, std::size_t total) { line(done, total); };
  const ModalSurvey survey = run_modal(campaign, window, options.survey);
  const std::string json = modal_json(survey);
  const std::string html = modal_report(survey, command_line_of(command));
  if (!options.basis.path().empty()) options.basis.write(modal_basis_text(survey));
  options.output.write({{"modal.json", json}, {"report.html", html}});
  print_warnings(survey.warnings);
  if (options.json)
    fmt::print("{}", json);
  else
    print_summary(survey, options);
  return 0;
}

}  // namespace

void add_modal_command(CLI::App* command, Action& chosen) {
  auto options = std::make_shared<ModalArguments>();
  ModalSurveyOptions& survey = options->survey;
  command->add_option("CAMPAIGN", options->campaign, "campaign folder")->required();
  options->output.add_to(*command, "folder for modal.json and report.html");
  command->add_option("--order", survey.largest_order, "largest model order of the stabilisation diagram")
      ->check(CLI::Range(4, 400));
  command->add_option("--modes", survey.modes, "keep this many modes, the strongest")->check(CLI::Range(1, 200));
  command->add_option("--window", survey.window_s, "length of the windows of a free decay, s (default: chosen)");
  command->add_option("--overlap", survey.overlap, "share of a window that the next one sees again")
      ->check(CLI::Range(0.0, 0.95));
  command->add_option("--fit-below", survey.fit_below, "regression over windows up to this amplitude");
  command->add_option("--force-window", survey.force_window_s, "impacts: the force counts for this long, s");
  command->add_option("--exponential-window", options->response_decay,
                      "impacts: exp(-D t) on force and responses, D in 1/s (default: chosen)");
  command
      ->add_option("--driving-point", options->driving_points,
                   "GROUP=CHANNEL: impacts of this group strike where this response is; GROUP=-CHANNEL: against it")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--modal-mass", survey.modal_masses,
                   "M1,M2,... in kg, by mode, where impacts do not determine them")
      ->delimiter(',')
      ->expected(1, 200);
  options->basis.add_to(*command, "--basis", "also write the [modal_basis] table for campaign.toml to this file");
  options->selection.add_to(*command);
  command->add_flag("--json", options->json, "print modal.json instead of the summary");
  command->footer(
      "Records of kind impact with a force channel give frequency responses (H1), modal masses and mass-normalised "
      "shapes;\nrecords of kind free_decay (and impacts without a force) give frequency and damping against "
      "amplitude.\nExample: secular modal beam -o results --band 20:300 --modes 2");
  command->callback(
      [options, command, &chosen] { chosen = [options, command] { return run(*options, *command); }; });
}

}  // namespace secular::app
