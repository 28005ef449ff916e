#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <thread>

#include "app/shared/commands.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "app/shared/shipped_models.hpp"
#include "app/simulate/experiment_loading.hpp"
#include "input/input_error.hpp"
#include "motion/simulate/virtual_test.hpp"

namespace secular::app {

void add_simulate_command(CLI::App* command, Action& chosen) {
  struct Options {
    std::string experiment;
    OutputCampaign output;
    std::uint64_t seed = 1;
    unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    bool interpret = false, json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("EXPERIMENT", options->experiment, "experiment file, or experiments/NAME of a shipped one")
      ->required();
  options->output.add_to(*command);
  command->add_option("--seed", options->seed, "of the measurement noise")->capture_default_str();
  command->add_option("--threads", options->threads, "records computed at once; the result does not depend on it")
      ->check(CLI::Range(1U, 1024U));
  command->add_flag("--interpret", options->interpret, "no compiled code of the model: slower, same results");
  command->add_flag("--json", options->json, "summary as JSON");
  command->footer("Example: secular simulate experiments/principal_parametric -o campaign");
  command->callback([options, &chosen] {
    chosen = [options] {
      options->output.check({{"the experiment", options->experiment, false}});
      const std::filesystem::path path = resolve_model(options->experiment);
      const auto [model, experiment] = load_experiment(path, options->interpret);
      ProgressLine line("records");
      CampaignWriter writer(options->output.path(), options->output.replaces());
      const Campaign campaign = run_virtual_test(
          experiment, *model, options->seed, options->threads,
          [&writer](const Campaign& made, const RecordEntry& entry, Record&& record) {
            writer.write(made, entry, record);
          },
          [&line](std::size_t done, std::size_t total) { line(done, total); });
      writer.finish(campaign);
      if (options->json)
        fmt::print("{{\"records\": {}, \"seed\": {}}}\n", campaign.records.size(), options->seed);
      else
        fmt::print("{} records of {} in {}\n", campaign.records.size(), experiment.name, options->output.path());
      return 0;
    };
  });
}

}  // namespace secular::app
