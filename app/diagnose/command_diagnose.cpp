#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <thread>

#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "app/shared/selection_options.hpp"
#include "input/input_error.hpp"
#include "jobs/diagnose/diagnosis_json.hpp"
#include "jobs/diagnose/diagnosis_report.hpp"
#include "jobs/diagnose/diagnosis_run.hpp"
#include "jobs/shared/left_out.hpp"
#include "numerics/hertz.hpp"
#include "report/number_format.hpp"

namespace secular::app {
namespace {

struct DiagnoseArguments {
  std::string campaign;
  DiagnosisRequest request;
  SelectionOptions selection;
  OutputFolder output{{"diagnosis.json", "report.html", "gap.svg"}};
  bool json = false;
};

void print_next_experiment(const DiagnosisRun& run) {
  const NextExperiment& next = run.diagnosis.next_experiment;
  if (!next.proposed) {
    if (run.diagnosis.gap.detected) fmt::print("next experiment: none proposed; {}\n", next.reason);
    return;
  }
  const ProposedTest& test = *next.test;
  const RecordEntry& like = run.campaign.records[test.like];
  if (is_steady(like.kind))
    fmt::print(
        "next experiment: a dwell at {:.5g} Hz, {:.3g} times the excitation of {}{} ({}): {:.2g} minutes once "
        "settled\n",
        test.frequency * to_hz, test.level, like.file,
        test.length > 1 ? fmt::format(" and {:.3g} times as long", test.length) : "", test.resonance, test.minutes);
  else
    fmt::print("next experiment: {} like {}, {:.3g} times its level{}: {:.2g} minutes\n", to_string(like.kind),
               like.file, test.level, test.length > 1 ? fmt::format(", {:.3g} of them", test.length) : "",
               test.minutes);
  fmt::print(
      "  to tell {} apart: {:.1f} sd expected, seen in the {}; the right one's probability {} -> {}, chance to "
      "leave it alone {}\n",
      fmt::join(next.separates, ", "), test.separation, test.watch, report::format_percent(test.before),
      report::format_percent(test.probability), report::format_percent(test.chance));
}

void print_summary(const DiagnosisRun& run, const std::string& folder) {
  const report::PlainNumbers plain(prints_for_programs());
  const Diagnosis& d = run.diagnosis;
  fmt::print("model {}: {} condition{}, {} rows, {} of the samples{}\n", run.model->name, d.conditions,
             d.conditions == 1 ? "" : "s", d.labels.size(), report::format_percent(d.data_used),
             d.decays_in_one_piece ? ", free decays in one piece each" : "");
  fmt::print("gap: {} (p = {:.2g}); {:.3g} times the repeatability", d.gap.detected ? "yes" : "none detected",
             d.gap.p_value, d.gap.before);
  if (d.gap.judged == Judged::given) fmt::print(" as given");
  if (d.gap.judged == Judged::within_error_bars)
    fmt::print(" as given{}",
               d.gap.detected ? ", more than the given error bars allow" : ", which the given error bars allow");
  if (d.gap.detected)
    fmt::print(", {:.3g} after; closed {} [{}, {}]", d.gap.after, report::format_percent(d.gap.closed),
               report::format_percent(d.gap.closed_low), report::format_percent(d.gap.closed_high));
  fmt::print("\n");
  if (d.gap.noise_misjudged) fmt::print("noise: misjudged; {}\n", misjudged_noise_sentence());
  for (std::size_t i = 0; i < std::min<std::size_t>(5, d.where.size()); ++i)
    fmt::print("  {:>7} {} of {} at {}, {}\n", report::format_percent(d.where[i].share),
               to_string(d.where[i].component), d.where[i].mode, d.where[i].harmonic, d.where[i].region);
  if (d.verdict == "cause") fmt::print("cause: {}\n", d.cause);
  if (d.verdict == "set") fmt::print("one of: {}\n", fmt::join(d.set, ", "));
  if (d.verdict == "approximate")
    fmt::print("acts like: {}; a structured {} of the gap is left\n", fmt::join(d.set, " or "),
               report::format_percent(*d.gap.left_share));
  if (d.verdict == "unknown")
    fmt::print("cause: unknown{}; {}\n", d.set.empty() ? "" : fmt::format(", nearest: {}", fmt::join(d.set, ", ")),
               d.unknown_because);
  if (d.open_law) fmt::print("  {}\n", open_law_sentence(*d.open_law));
  if (!d.together.empty())
    fmt::print("  together: {}{}\n", fmt::join(d.together, " and "),
               d.second_or.empty() ? "" : fmt::format(" (or {})", fmt::join(d.second_or, " or ")));
  for (std::size_t i = 0; i < std::min<std::size_t>(6, d.causes.size()); ++i) {
    const CauseReport& c = d.causes[i];
    fmt::print("  {:>7} {}{}", report::format_percent(c.probability), c.effect,
               c.subject.empty() ? "" : " (" + c.subject + ")");
    if (!c.coefficient_name.empty())
      fmt::print("  {} = {}{}", c.coefficient_name, report::format_uncertain(c.coefficient, c.sd),
                 c.unit.empty() || c.unit == "1" ? "" : " " + c.unit);
    if (c.closed) fmt::print(", closes {}", report::format_percent(*c.closed));
    fmt::print("\n");
  }
  for (const ParameterMove& m : d.parameters_moved)
    fmt::print("  {} moves from {:.6g} to {}\n", m.name, m.from, report::format_uncertain(m.to, m.sd));
  if (d.simulated)
    for (const SimulatedError& e : d.simulated->apart)
      fmt::print(
          "simulated in the window to check on: {} off by {:.4g} before, {:.4g} after (rms; measured {:.4g})\n",
          e.channel, e.before, e.after, e.signal);
  if (d.simulated)
    for (const SimulatedError& e : d.simulated->apart)
      if (e.before_fitted && e.after_fitted)
        fmt::print("  with the numbers that fit it best: {:.4g} before, {:.4g} after\n", *e.before_fitted,
                   *e.after_fitted);
  print_next_experiment(run);
  print_disturbances(run.disturbances, run.campaign, run.looked_at);
  fmt::print("written: {0}/diagnosis.json, {0}/report.html, {0}/gap.svg\n", folder);
}

int run(DiagnoseArguments& options, const CLI::App& command) {
  options.request.window = options.selection.window();
  if (options.request.check_from_s && options.request.check_to_s &&
      !(*options.request.check_from_s < *options.request.check_to_s))
    throw InputError("--check-from, --check-to", "", "the window is empty",
                     "--check-from must be before --check-to");
  if (options.request.fit_check && !options.request.check_from_s && !options.request.check_to_s)
    throw InputError("--fit-check", "", "has no window", "give --check-from and --check-to");
  options.output.check({{"the campaign", options.campaign, true},
                        {"the model", options.request.model, false},
                        {"the file of parameters", options.request.parameters_name, false}});
  if (!options.request.parameters_name.empty())
    options.request.parameters = read_parameter_file(options.request.parameters_name);
  ProgressLine line("explanations tried (about)");
  options.request.progress = [&line](std::size_t done, std::size_t expected) { line(done, expected); };
  options.request.note = print_note;
  const DiagnosisRun result = run_diagnosis(options.request, read_campaign(options.campaign));
  const std::string json = diagnosis_json(result);
  const std::string html = diagnosis_report(result, command_line_of(command));
  const std::string figure = report::render_figure(gap_figure(result), "gap", report::FigureUse::standalone).svg;
  options.output.write({{"diagnosis.json", json}, {"report.html", html}, {"gap.svg", figure}});
  print_warnings(folded(result.diagnosis.warnings, result.campaign));
  if (options.json)
    fmt::print("{}", json);
  else
    print_summary(result, options.output.path());
  if (result.mostly_left_out) fmt::print(stderr, "secular: {}\n", *result.mostly_left_out);
  return result.mostly_left_out ? 1 : 0;
}

}  // namespace

void add_diagnose_command(CLI::App* command, Action& chosen) {
  auto options = std::make_shared<DiagnoseArguments>();
  DiagnosisRequest& request = options->request;
  request.threads = std::max(1U, std::thread::hardware_concurrency());
  command->add_option("CAMPAIGN", options->campaign, "campaign folder")->required();
  command->add_option("--model", request.model, "model file, or the name of a shipped model")->required();
  options->output.add_to(*command, "folder for diagnosis.json and report.html");
  command->add_option("--parameters", request.parameters_name,
                      "numbers whose gap is diagnosed: an estimate.json or an object of symbol to number");
  options->selection.add_to(*command);
  command->add_option("--check-from", request.check_from_s,
                      "simulate every decay, sweep and broadband record from this time on, s, in one piece");
  command->add_option("--check-to", request.check_to_s, "and up to this time, s");
  command->add_flag("--fit-check", request.fit_check,
                    "simulate them once more with the numbers that fit them best");
  command
      ->add_option("--without", request.without,
                   "an effect of the catalogue that is not to be considered; may be given several times")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--highest-level", request.highest_level,
          "most that the next experiment may ask for, times the highest excitation measured at a resonance")
      ->check(CLI::Range(0.5, 2.0))
      ->capture_default_str();
  command->add_flag("--interpret", request.interpret, "no compiled code: slower, same results");
  command->add_option("--threads", request.threads, "threads; the result does not depend on it")
      ->check(CLI::Range(1U, 1024U));
  command->add_flag("--json", options->json, "print diagnosis.json instead of the summary");
  command->footer("Example: secular diagnose campaign --model two_mass_mode1 -o results");
  command->callback(
      [options, command, &chosen] { chosen = [options, command] { return run(*options, *command); }; });
}

}  // namespace secular::app
