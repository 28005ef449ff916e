#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/shared/commands.hpp"
#include "app/shared/shipped_models.hpp"
#include "codegen/cpp/emit_cpp.hpp"
#include "input/input_error.hpp"
#include "perturb/model.hpp"

namespace secular::app {

void add_generate_command(CLI::App& root, Action& chosen) {
  struct Options {
    std::vector<std::string> models;
    std::string folder;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = root.add_subcommand(
      "generate", "C++ of models: regressor rows, residuals, Jacobians, modulation equations, equations of motion");
  command->add_option("MODEL", options->models, "model files, or names of shipped models")->required();
  command->add_option("-o,--output", options->folder, "folder for NAME.hpp and NAME.cpp and the registry")
      ->required();
  command->add_flag("--json", options->json, "list what was written as JSON");
  command->footer("Example: secular generate two_mass_mode1 pendulum -o generated");
  command->callback([options, &chosen] {
    chosen = [options] {
      std::vector<GeneratedFile> files;
      std::vector<std::string> names;
      for (const std::string& name : options->models) {
        const std::string path = resolve_model(name).string();
        const CanonicalModel model = canonical_model(read_model(path));
        for (const std::string& other : names)
          if (other == model.name) throw InputError(path, "", "a second model named " + model.name, "names differ");
        if (model.name == registry_name)
          throw InputError(path, "",
                           fmt::format("its files {0}.hpp and {0}.cpp are those that list all models", model.name),
                           "give the model another name");
        for (const CanonicalCase& resonance : model.cases)
          if (!resonance.certificate.holds)
            throw InputError(path, "case " + resonance.name, "its certificate does not hold",
                             "see `secular derive`: no code is made from an expansion that is not certified");
        names.push_back(model.name);
        for (GeneratedFile& file : emit_cpp(model)) files.push_back(std::move(file));
      }
      for (GeneratedFile& file : emit_registry(names)) files.push_back(std::move(file));
      write_generated(files, options->folder);
      nlohmann::json list = nlohmann::json::array();
      for (const GeneratedFile& file : files) list.push_back(file.name);
      if (options->json)
        fmt::print("{}\n", nlohmann::json{{"folder", options->folder}, {"files", list}}.dump(2));
      else
        fmt::print("{} files in {}\n", files.size(), options->folder);
      return 0;
    };
  });
}

}  // namespace secular::app
