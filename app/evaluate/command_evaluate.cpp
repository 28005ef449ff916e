#include <fmt/format.h>

#include <CLI/App.hpp>
#include <memory>
#include <string>

#include "app/shared/commands.hpp"
#include "app/shared/word_choice.hpp"
#include "app/shared/notices.hpp"
#include "jobs/derive/evaluation_run.hpp"
#include "jobs/shared/number_file.hpp"

namespace secular::app {

void add_evaluate_command(CLI::App* command, Action& chosen) {
  struct Options {
    EvaluationRequest request;
    std::string policy = "nominal";
    bool json = true;
  };
  auto options = std::make_shared<Options>();
  command->add_option("MODEL", options->request.model, "model file, or the name of a shipped model")->required();
  command->add_option("--case", options->request.resonance, "resonance case of the model")->required();
  command->add_option("--at", options->request.values_name, "JSON object: a number for every symbol")->required();
  command->add_option("--omega-policy", options->policy, "excitation frequency inside coefficients")
      ->check(one_of({"nominal", "kept"}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "JSON is what it prints in any case");
  command->footer("Example: secular evaluate two_mass_mode1 --case principal_parametric --at values.json");
  command->callback([options, &chosen] {
    chosen = [options] {
      options->request.omega_kept = options->policy == "kept";
      options->request.values = read_numbers(options->request.values_name);
      const Evaluation found = evaluate(options->request);
      fmt::print("{}", found.json);
      print_warnings(found.warnings);
      return 0;
    };
  });
}

}  // namespace secular::app
