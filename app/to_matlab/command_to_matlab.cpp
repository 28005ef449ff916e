#include <fmt/format.h>

#include <CLI/App.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "app/shared/commands.hpp"
#include "input/input_error.hpp"
#include "jobs/matlab/result_conversion.hpp"
#include "report/whole_file.hpp"

namespace secular::app {

void add_to_matlab_command(CLI::App* command, Action& chosen) {
  struct Options {
    std::string folder;
    bool force = false, json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("OUT", options->folder, "folder of results, made by another command with -o")->required();
  command->add_flag("--force", options->force, "replace MAT files that stand there");
  command->add_flag("--json", options->json, "the names of the files as JSON");
  command->footer(
      "Beside every JSON file a MAT file with one variable that bears its name: load('out/estimate.mat') gives "
      "estimate.lumps(1).value.\nExample: secular to-matlab out");
  command->callback([options, &chosen] {
    chosen = [options] {
      const std::filesystem::path folder = options->folder;
      const auto files = mat_files_of(folder);
      std::error_code error;
      for (const auto& [name, content] : files)
        if (!options->force && std::filesystem::exists(std::filesystem::symlink_status(folder / name, error)))
          throw InputError((folder / name).string(), "", "exists", "add --force to replace it");
      nlohmann::ordered_json written = nlohmann::ordered_json::array();
      for (const auto& [name, content] : files) {
        report::write_whole_file(folder / name, content);
        written.push_back((folder / name).string());
        if (!options->json) fmt::print("written: {}\n", (folder / name).string());
      }
      if (options->json)
        fmt::print("{}\n", nlohmann::ordered_json{{"written", written}}.dump(
                               2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
      return 0;
    };
  });
}

}  // namespace secular::app
