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
#include "input/input_error.hpp"
#include "jobs/inspect/inspection_report.hpp"
#include "jobs/inspect/inspection_run.hpp"
#include "jobs/simulate/simulation.hpp"
#include "measure/data/campaign_target.hpp"

namespace secular::app {

namespace {

std::string report_of(const SimulationRequest& request, const std::string& campaign, const std::string& command) {
  InspectionRequest wanted;
  wanted.path = campaign;
  wanted.pictures = true;
  const auto [model, text] = experiment_text(request.experiment);
  const SimulatedFrom from{model, request.experiment, text, request.seed};
  return inspection_report(inspect(wanted), command, &from);
}

// The report of a campaign stands beside it: what is inside of one was measured.
void check_report(const OutputFile& report, const OutputCampaign& output, const std::string& experiment) {
  if (!overlap(report.path(), output.path()).empty())
    throw InputError(report.path(), "--report", "lies in the campaign's folder", "name a file beside it");
  report.check({{"the experiment", experiment, false}}, output.replaces(), output.path());
}

}  // namespace

void add_simulate_command(CLI::App* command, Action& chosen) {
  struct Options {
    SimulationRequest request;
    OutputCampaign output;
    OutputFile report;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  options->request.threads = std::max(1U, std::thread::hardware_concurrency());
  command
      ->add_option("EXPERIMENT", options->request.experiment,
                   "experiment file, or experiments/NAME of a shipped one")
      ->required();
  options->output.add_to(*command);
  options->report.add_to(*command, "--report",
                         "also write a report to this file: what was simulated, records drawn");
  command->add_option("--seed", options->request.seed, "of the measurement noise")->capture_default_str();
  command
      ->add_option("--threads", options->request.threads,
                   "records computed at once; the result does not depend on it")
      ->check(CLI::Range(1U, 1024U));
  command->add_flag("--interpret", options->request.interpret,
                    "no compiled code of the model: slower, same results");
  command->add_flag("--json", options->json, "summary as JSON");
  command->footer("Example: secular simulate experiments/principal_parametric -o campaign");
  command->callback([options, command, &chosen] {
    chosen = [options, command] {
      options->output.check({{"the experiment", options->request.experiment, false}});
      check_report(options->report, options->output, options->request.experiment);
      ProgressLine line("records");
      options->request.progress = [&line](std::size_t done, std::size_t total) { line(done, total); };
      options->request.note = print_note;
      CampaignWriter writer(options->output.path(), options->output.replaces());
      const Campaign campaign =
          simulate(options->request, [&writer](const Campaign& made, const RecordEntry& entry, Record&& record) {
            writer.write(made, entry, record);
          });
      writer.finish(campaign);
      if (!options->report.path().empty())
        options->report.write(report_of(options->request, options->output.path(), command_line_of(*command)));
      if (options->json)
        fmt::print("{{\"records\": {}, \"seed\": {}}}\n", campaign.records.size(), options->request.seed);
      else
        fmt::print("{} records of {} in {}\nNext: secular inspect {} -o OUT (a report of every record)\n",
                   campaign.records.size(), campaign.name, options->output.path(), options->output.path());
      return 0;
    };
  });
}

}  // namespace secular::app
