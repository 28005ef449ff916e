#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <thread>

#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "jobs/simulate/simulation.hpp"

namespace secular::app {

void add_simulate_command(CLI::App* command, Action& chosen) {
  struct Options {
    SimulationRequest request;
    OutputCampaign output;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  options->request.threads = std::max(1U, std::thread::hardware_concurrency());
  command
      ->add_option("EXPERIMENT", options->request.experiment,
                   "experiment file, or experiments/NAME of a shipped one")
      ->required();
  options->output.add_to(*command);
  command->add_option("--seed", options->request.seed, "of the measurement noise")->capture_default_str();
  command
      ->add_option("--threads", options->request.threads,
                   "records computed at once; the result does not depend on it")
      ->check(CLI::Range(1U, 1024U));
  command->add_flag("--interpret", options->request.interpret,
                    "no compiled code of the model: slower, same results");
  command->add_flag("--json", options->json, "summary as JSON");
  command->footer("Example: secular simulate experiments/principal_parametric -o campaign");
  command->callback([options, &chosen] {
    chosen = [options] {
      options->output.check({{"the experiment", options->request.experiment, false}});
      ProgressLine line("records");
      options->request.progress = [&line](std::size_t done, std::size_t total) { line(done, total); };
      options->request.note = print_note;
      CampaignWriter writer(options->output.path(), options->output.replaces());
      const Campaign campaign =
          simulate(options->request, [&writer](const Campaign& made, const RecordEntry& entry, Record&& record) {
            writer.write(made, entry, record);
          });
      writer.finish(campaign);
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
