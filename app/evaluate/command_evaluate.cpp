#include <fmt/format.h>

#include <CLI/App.hpp>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "codegen/canonical/evaluation.hpp"
#include "jobs/shared/number_file.hpp"
#include "jobs/shared/shipped_models.hpp"
#include "perturb/model.hpp"
#include "perturb/rest_position.hpp"

namespace secular::app {

void add_evaluate_command(CLI::App* command, Action& chosen) {
  struct Options {
    std::string model, resonance, values, policy = "nominal";
    bool json = true;
  };
  auto options = std::make_shared<Options>();
  command->add_option("MODEL", options->model, "model file, or the name of a shipped model")->required();
  command->add_option("--case", options->resonance, "resonance case of the model")->required();
  command->add_option("--at", options->values, "JSON object: a number for every symbol")->required();
  command->add_option("--omega-policy", options->policy, "excitation frequency inside coefficients")
      ->check(CLI::IsMember({"nominal", "kept"}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "JSON is what it prints in any case");
  command->footer("Example: secular evaluate two_mass_mode1 --case principal_parametric --at values.json");
  command->callback([options, &chosen] {
    chosen = [options] {
      const Model model = read_model(resolve_model(options->model));
      const OmegaPolicy policy = options->policy == "kept" ? OmegaPolicy::kept : OmegaPolicy::nominal;
      const Derivation derivation = derive(model, model.find_case(options->resonance), policy);
      std::map<std::string, double> values = read_numbers(options->values);
      take_rest_position(model, values, options->values);
      std::map<std::string, double> at = values;
      add_values_at_rest(model, at);
      fmt::print("{}", evaluation_json(derivation, at, options->values));
      std::set<std::string, std::less<>> known;
      for (const auto& [name, value] : values)
        if (model.symbols.contains(name)) known.insert(name);
      if (const std::string unused = unused_numbers(options->values, values, known); !unused.empty())
        print_warning(unused);
      return 0;
    };
  });
}

}  // namespace secular::app
