#include <fmt/format.h>

#include <CLI/App.hpp>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/shared/commands.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "codegen/cpp/emit_cpp.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "jobs/shared/shipped_models.hpp"
#include "perturb/model.hpp"

namespace secular::app {

void add_generate_command(CLI::App* command, Action& chosen) {
  struct Options {
    std::vector<std::string> models;
    OutputFolder output{{"registry.hpp", "*.hpp", "*.cpp"}, "generated code, never edited by hand"};
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("MODEL", options->models, "model files, or names of shipped models")->required();
  options->output.add_to(*command, "folder for NAME.hpp, NAME.CASE.hpp, NAME.cpp and the registry");
  command->add_flag("--json", options->json, "list what was written as JSON");
  command->footer("Example: secular generate two_mass_mode1 pendulum -o generated");
  command->callback([options, &chosen] {
    chosen = [options] {
      std::vector<CommandInput> inputs;
      for (const std::string& model : options->models) inputs.push_back({"the model", model, false});
      options->output.check(inputs);
      std::vector<GeneratedFile> files;
      std::vector<std::string> names;
      for (const std::string& name : options->models) {
        const std::string path = resolve_model(name).string();
        ProgressLine progress("steps of " + name);
        const CanonicalModel model =
            canonical_model(read_model(path), {}, CanonicalContent::all, std::ref(progress));
        for (const std::string& other : names)
          if (other == model.name) throw InputError(path, "", "a second model named " + model.name, "names differ");
        if (model.name == registry_name)
          throw InputError(path, "",
                           fmt::format("its files {0}.hpp and {0}.cpp are those that list all models", model.name),
                           "give the model another name");
        for (const CanonicalCase& resonance : model.cases)
          if (!resonance.certificate.holds)
            throw NumericalFailure(Ending::out_of_range,
                                   path + ", case " + resonance.name +
                                       ": its certificate does not hold; see `secular derive`: no code is made "
                                       "from an expansion that is not certified");
        names.push_back(model.name);
        for (GeneratedFile& file : emit_cpp(model)) files.push_back(std::move(file));
      }
      for (GeneratedFile& file : emit_registry(names)) files.push_back(std::move(file));
      ResultFiles written;
      nlohmann::json list = nlohmann::json::array();
      for (GeneratedFile& file : files) {
        list.push_back(file.name);
        written.emplace_back(std::move(file.name), std::move(file.text));
      }
      options->output.write(written);
      if (options->json)
        fmt::print("{}\n", nlohmann::json{{"folder", options->output.path()}, {"files", list}}.dump(2));
      else
        fmt::print("{} files in {}\n", files.size(), options->output.path());
      return 0;
    };
  });
}

}  // namespace secular::app
