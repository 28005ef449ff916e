#include <fmt/format.h>

#include <CLI/App.hpp>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/word_choice.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "app/shared/selection_options.hpp"
#include "input/input_error.hpp"
#include "jobs/plan/planning.hpp"
#include "report/number_format.hpp"

namespace secular::app {
namespace {

struct PlanArguments {
  PlanRequest request;
  SelectionOptions selection;
  std::string frequency, amplitude, criterion = "D";
  OutputFolder output{{"plan.json", "plan.toml", "report.html"}};
  bool json = false;
};

// "24.4:25.1"
std::pair<double, double> range_of(const std::string& text, const std::string& option) {
  const std::size_t colon = text.find(':');
  char *first = nullptr, *second = nullptr;
  const std::string low = text.substr(0, colon), high = colon == std::string::npos ? "" : text.substr(colon + 1);
  const double a = std::strtod(low.c_str(), &first), b = std::strtod(high.c_str(), &second);
  if (low.empty() || high.empty() || *first != '\0' || *second != '\0' || !std::isfinite(a) || !std::isfinite(b))
    throw InputError(option + " " + text, "", "is no range", "LOW:HIGH, for example 24.4:25.1");
  return {a, b};
}

void print_summary(const PlanResult& plan, const std::string& folder) {
  const report::PlainNumbers plain(prints_for_programs());
  fmt::print("model {}, case {}: {} candidates\n", plan.model->name, plan.resonance->name, plan.candidates.size());
  fmt::print("plan: {} dwells, {:.0f} s\n", plan.plan.dwells.size(), plan.plan.time_s);
  for (const PlannedDwell& d : plan.plan.dwells)
    fmt::print("  {:.4f} Hz at {:<6.4g} {:>3} ensembles, settle {:.0f} s\n", d.frequency_hz, d.amplitude,
               d.ensembles, d.settle_s);
  if (plan.against)
    fmt::print("in use: {} dwells, {:.0f} s as programmed, {:.0f} s with the plan's settling\n",
               plan.against->dwells.size(), plan.against->time_s, plan.against->settled_time_s);
  for (const Eigen::Index w : plan.wanted) {
    std::string line =
        fmt::format("  {:<12} {}  sd {}", plan.unknowns.names[static_cast<std::size_t>(w)],
                    report::format_number(plan.unknowns.values(w), 5), report::format_number(plan.plan.sd(w), 3));
    if (plan.against) line += "  in use " + report::format_number(plan.against->sd(w), 3);
    fmt::print("{}\n", line);
  }
  fmt::print("written: {0}/plan.json, {0}/plan.toml, {0}/report.html\n", folder);
}

void declare_options(CLI::App* command, PlanArguments* options) {
  PlanRequest& request = options->request;
  command->add_option("MODEL", request.model, "model file, or the name of a shipped model")->required();
  command->add_option("--case", request.resonance, "resonance case; may be left out where there is only one");
  command->add_option("--parameters", request.parameters, "rough values: estimate.json or a JSON object")
      ->required();
  command->add_option("--for", request.wanted, "lumps or natural frequencies to be determined")
      ->required()
      ->delimiter(',');
  command->add_option("--fix", request.fixed, "lumps or natural frequencies taken as known")->delimiter(',');
  command->add_option("--criterion", options->criterion, "D: determinant, A: relative variances, c: one parameter")
      ->check(one_of({"D", "A", "c"}))
      ->capture_default_str();
  command->add_option("--range-frequency", options->frequency, "LOW:HIGH of the excitation, Hz")->required();
  command->add_option("--range-amplitude", options->amplitude, "LOW:HIGH of the excitation, peak")->required();
  command
      ->add_option("--budget-s", request.budget_s,
                   "laboratory time, s; without it what --against needs to be reached")
      ->check(CLI::PositiveNumber);
  CLI::Option* against =
      command->add_option("--against", request.against, "experiment or campaign in use, to compare with");
  options->selection.add_to(*command, {.band = false, .span = false}, against);
  command
      ->add_option("--noise", request.noise,
                   "sd of a sample of the modal acceleration; --against EXPERIMENT has its own")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--excitation-noise", request.excitation_noise, "sd of a sample of the excitation")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--dwell-scatter,--repeatability", request.dwell_scatter,
                   "relative scatter of amplitudes from dwell to dwell; --repeatability is its old name")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--ensembles", request.ensembles, "numbers of ensembles that a dwell may have")
      ->delimiter(',')
      ->check(CLI::Range(1, 10000));
  command->add_option("--ensemble-s", request.ensemble_s, "length of an ensemble, s")->check(CLI::PositiveNumber);
  command->add_option("--sample-rate", request.sample_rate_hz, "Hz")->check(CLI::PositiveNumber);
  command
      ->add_option("--least", request.least, "dwells at least; without it what error bars from their scatter need")
      ->check(CLI::Range(1, 1000));
  command->add_option("--settled", request.settled, "share of a disturbance that may be left when recording starts")
      ->check(CLI::Range(1e-9, 0.5))
      ->capture_default_str();
  command->add_option("--settle-limit", request.settle_limit_s, "slower responses are no candidates, s")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--frequencies", request.frequencies, "of the grid")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command->add_option("--levels", request.levels, "of the grid")->check(CLI::Range(1, 200))->capture_default_str();
  command->add_option("--limit", request.limit_s, "wall time of the search, s")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  options->output.add_to(*command, "folder for plan.json, plan.toml and report.html");
  command->add_flag("--json", options->json, "print plan.json instead of the summary");
  command->footer(
      "Example: secular plan two_mass_mode1 --case principal_parametric --parameters predictions/table_5_4 "
      "--for mu1,mu3,alpha_e,eta_e --range-frequency 24.4:25.1 --range-amplitude 10:30 "
      "--against experiments/thesis_chapter5 -o out");
}

int run(PlanArguments& options, const CLI::App& command) {
  static const std::map<std::string, DesignCriterion> criteria = {
      {"D", DesignCriterion::d}, {"A", DesignCriterion::a}, {"c", DesignCriterion::c}};
  PlanRequest& asked = options.request;
  options.output.check({{"the model", asked.model, false},
                        {"the file of parameters", asked.parameters, false},
                        {"the test in use", asked.against, true}});
  asked.criterion = criteria.at(options.criterion);
  asked.against_records = options.selection.window();
  std::tie(asked.lowest_hz, asked.highest_hz) = range_of(options.frequency, "--range-frequency");
  std::tie(asked.lowest_amplitude, asked.highest_amplitude) = range_of(options.amplitude, "--range-amplitude");
  std::optional<ProgressLine> line;
  asked.progress = [&line, stage = std::string()](const char* what, std::size_t done, std::size_t total) mutable {
    if (stage != what) line.emplace(stage = what);
    (*line)(done, total);
  };
  asked.note = print_note;
  const PlanResult plan = plan_test(asked);
  const std::string json = plan_json(asked, plan);
  const std::string html = plan_report(asked, plan, command_line_of(command));
  options.output.write({{"plan.json", json}, {"plan.toml", plan_experiment(asked, plan)}, {"report.html", html}});
  print_warnings(plan.warnings);
  if (options.json)
    fmt::print("{}", json);
  else
    print_summary(plan, options.output.path());
  return 0;
}

}  // namespace

void add_plan_command(CLI::App* command, Action& chosen) {
  auto options = std::make_shared<PlanArguments>();
  declare_options(command, options.get());
  command->callback(
      [options, command, &chosen] { chosen = [options, command] { return run(*options, *command); }; });
}

}  // namespace secular::app
