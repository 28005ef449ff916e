#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "app/commands.hpp"
#include "app/progress_line.hpp"
#include "blind/sealed_set.hpp"

namespace secular::app {
namespace {

struct Options {
  std::string folder, set = "short";
  std::size_t cases = 0;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

void generate(const Options& options) {
  blind::SetOptions set;
  set.size = options.set == "full" ? blind::SetSize::full_set : blind::SetSize::short_set;
  set.cases = options.cases > 0 ? options.cases : options.set == "full" ? 1000 : 60;
  set.seed = options.seed;
  set.threads = options.threads;
  ProgressLine line("cases");
  blind::generate_set(options.folder, set, [&line](std::size_t done, std::size_t total) { line(done, total); });
  fmt::print("{} cases in {}, labels sealed\n", set.cases, options.folder);
}

void add_set_options(CLI::App* command, const std::shared_ptr<Options>& options) {
  command->add_option("--cases", options->cases, "how many; without it 60 (short) or 1000 (full)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{9999}));
  command->add_option("--seed", options->seed, "of the draw")->capture_default_str();
  command->add_option("--set", options->set, "short: 20 dwells, 40 and 30 dB; full: 40 dwells, 40 to 10 dB")
      ->check(CLI::IsMember({"short", "full"}))
      ->capture_default_str();
}

void add_threads(CLI::App* command, const std::shared_ptr<Options>& options) {
  command->add_option("--threads", options->threads, "cases at once; the result does not depend on it")
      ->check(CLI::Range(1U, 1024U));
}

}  // namespace

void add_blind_command(CLI::App& root, Action& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App* blind = root.add_subcommand("blind", "Check of the diagnosis on campaigns whose cause it cannot know");
  blind->require_subcommand(1);
  blind->footer("Example: secular blind generate --cases 60 --seed 1 -o blind_set");
  CLI::App* command = blind->add_subcommand("generate", "Draw structures, effects and noise; write campaigns");
  add_set_options(command, options);
  add_threads(command, options);
  command->add_option("-o,--output", options->folder, "folder to make or to complete")->required();
  command->callback([options, &chosen] {
    chosen = [options] {
      generate(*options);
      return 0;
    };
  });
}

}  // namespace secular::app
