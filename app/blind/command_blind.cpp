#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/word_choice.hpp"
#include "app/shared/progress_line.hpp"
#include "blind/estimate_set.hpp"
#include "blind/follow_up.hpp"
#include "blind/leave_out.hpp"
#include "blind/measured_page.hpp"
#include "blind/measured_run.hpp"
#include "blind/run_set.hpp"
#include "blind/score_set.hpp"
#include "blind/sealed_set.hpp"
#include "input/input_error.hpp"
#include "input/interruption.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

struct BlindArguments {
  std::string folder, set = "short", records = "dwells", page = "docs/blind_check", program;
  std::size_t campaigns = 0;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  double limit_s = 300;
  bool disturbed = false, nothing_withheld = false;
  // Of measured sets.
  std::string data, list = "models/measured/sets.toml", work = "out/measured";
  std::vector<std::string> only;
  bool force = false, again = false;
  const CLI::App* command = nullptr;
  bool json = false;
  std::string told;  ///< of the last step, as JSON
};

// For people; with --json nothing of it is printed.
template <class... Values>
void print_text(const BlindArguments& options, fmt::format_string<Values...> format, Values&&... values) {
  if (!options.json) fmt::print(format, std::forward<Values>(values)...);
}

std::string dumped(const nlohmann::ordered_json& json) {
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

// A file that has just been written is what --json prints.
std::string written_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Before any work: pages of another run are replaced with --force alone.
void check_page(const BlindArguments& options, std::initializer_list<const char*> names) {
  std::error_code error;
  for (const char* name : names)
    if (const fs::path file = fs::path(options.page) / name;
        fs::exists(fs::symlink_status(file, error)) && !options.force)
      throw InputError(file.string(), "", "exists", "name another folder of pages, or add --force to replace it");
}

void check_score(const BlindArguments& options) {
  check_page(options, {"score.md", "score.json", "calibration.svg"});
}

void check_estimates(const BlindArguments& options) {
  check_page(options, {"estimates.md", "estimates.json"});
}

void check_measured(const BlindArguments& options) {
  check_page(options, {"measured.md", "measured.json"});
}

void add_force(CLI::App* command, const std::shared_ptr<BlindArguments>& options) {
  command->add_flag("--force", options->force, "replace pages that stand there");
}

void generate(BlindArguments& options) {
  blind::SetOptions set;
  set.size = options.set == "full" ? blind::SetSize::full_set : blind::SetSize::short_set;
  set.campaigns = options.campaigns > 0 ? options.campaigns : options.set == "full" ? 1000 : 60;
  set.seed = options.seed;
  set.threads = options.threads;
  set.disturbed = options.disturbed;
  set.nothing_withheld = options.nothing_withheld;
  set.programme = blind::programme_named(options.records);
  ProgressLine line("campaigns made");
  blind::generate_set(options.folder, set, [&line](std::size_t done, std::size_t total) { line(done, total); });
  print_text(options, "{} campaigns in {}, labels sealed\n", set.campaigns, options.folder);
  options.told = dumped({{"campaigns", set.campaigns}, {"folder", options.folder}});
}

blind::RunOptions run_options(const BlindArguments& options) {
  blind::RunOptions how;
  // `secular-mpi` lies beside the program that it runs.
  how.program = options.program.empty() ? fs::read_symlink("/proc/self/exe").replace_filename("secular")
                                        : fs::absolute(options.program);
  how.threads = options.threads;
  how.limit_s = options.limit_s;
  return how;
}

void print_failed(const BlindArguments& options, const std::vector<blind::FailedCampaign>& campaigns) {
  for (const blind::FailedCampaign& failed : campaigns)
    print_text(options, "  campaign {:04}: {}\n", failed.number, failed.reason);
}

nlohmann::ordered_json failed_json(const std::vector<blind::FailedCampaign>& campaigns) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const blind::FailedCampaign& failed : campaigns)
    list.push_back({{"campaign", failed.number}, {"reason", failed.reason}});
  return list;
}

void follow(BlindArguments& options) {
  if (blind::options_of(options.folder).programme != blind::Programme::dwells) {
    print_text(options, "nothing to follow: the campaigns hold no dwells, and no other record is drawn anew\n");
    options.told = dumped({{"open", 0}, {"proposed", 0}, {"failed", nlohmann::ordered_json::array()}});
    return;
  }
  ProgressLine line("proposals followed");
  const blind::FollowUpSummary summary = blind::follow_up_set(
      options.folder, run_options(options), [&line](std::size_t done, std::size_t total) { line(done, total); });
  print_text(options, "{} verdicts left a set, {} of them with a dwell proposed; {} diagnoses failed\n",
             summary.sets, summary.proposed, summary.failed.size());
  print_failed(options, summary.failed);
  options.told =
      dumped({{"open", summary.sets}, {"proposed", summary.proposed}, {"failed", failed_json(summary.failed)}});
}

using RunOfSet = blind::RunSummary (*)(const std::filesystem::path&, const blind::RunOptions&,
                                       const blind::Progress&);

// Every campaign through one command. `done`: what is done to them, in the past tense.
void run_all(BlindArguments& options, RunOfSet run_of_set, const std::string& done) {
  ProgressLine line("campaigns " + done);
  const blind::RunSummary summary = run_of_set(options.folder, run_options(options),
                                               [&line](std::size_t made, std::size_t total) { line(made, total); });
  print_text(options, "{} campaigns, {} {} before, {} failed\n", summary.campaigns, summary.kept, done,
             summary.failed.size());
  print_failed(options, summary.failed);
  options.told =
      dumped({{"campaigns", summary.campaigns}, {"kept", summary.kept}, {"failed", failed_json(summary.failed)}});
}

void run(BlindArguments& options) {
  run_all(options, blind::run_set, "diagnosed");
}

void leave_out(BlindArguments& options) {
  ProgressLine line("effects left out");
  const blind::LeaveOutSummary summary = blind::leave_out_of_set(
      options.folder, run_options(options), [&line](std::size_t done, std::size_t total) { line(done, total); });
  print_text(options, "{} campaigns without their effect in the catalogue, {} diagnosed before, {} failed\n",
             summary.campaigns, summary.kept, summary.failed.size());
  print_failed(options, summary.failed);
  options.told =
      dumped({{"campaigns", summary.campaigns}, {"kept", summary.kept}, {"failed", failed_json(summary.failed)}});
}

void print_figures(const BlindArguments& options, const std::vector<blind::Figure>& figures, const char* trials) {
  if (options.json) return;
  for (const blind::Figure& f : figures) {
    if (f.trials == 0) continue;
    fmt::print("{:72} {:8.3f}  ({} {})", f.name, f.value, f.trials, trials);
    if (f.target) fmt::print("  target {} {}", f.at_most ? "at most" : "at least", *f.target);
    fmt::print("\n");
  }
}

void score(BlindArguments& options) {
  const blind::Score score = blind::score_set(options.folder);
  blind::write_score(score, blind::name_of_set(options.folder), options.page);
  print_figures(options, score.figures, "campaigns");
  print_text(options, "{} of {} campaigns went wrong, {} without a diagnosis; see {}/score.md\n",
             score.wrong.size(), score.campaigns, score.failed, options.page);
  options.told = written_file(fs::path(options.page) / "score.json");
}

void estimates(BlindArguments& options) {
  run_all(options, blind::identify_set, "identified");
  const blind::EstimateScore score = blind::score_estimates(options.folder);
  blind::write_estimate_score(score, blind::name_of_set(options.folder), options.page);
  print_figures(options, score.figures, "numbers");
  print_text(options, "{} unmarked numbers are off by more than 4 sd; see {}/estimates.md\n", score.far_off.size(),
             options.page);
  options.told = written_file(fs::path(options.page) / "estimates.json");
}

void measured(BlindArguments& options) {
  const blind::MeasuredList list = blind::only_sets(blind::read_measured_list(options.list), options.only);
  ProgressLine line("sets diagnosed");
  blind::RunOptions how = run_options(options);
  how.threads = 1;
  const blind::MeasuredRun run =
      blind::run_measured(list, {options.data, options.work}, how, options.again,
                          [&line](std::size_t done, std::size_t total) { line(done, total); });
  const nlohmann::ordered_json page = blind::measured_json(
      {command_line_of(*options.command), options.list, options.data, options.work}, list, run.results);
  blind::write_measured(page, options.page);
  const auto met = std::count_if(page.at("sets").begin(), page.at("sets").end(),
                                 [](const nlohmann::ordered_json& set) { return set.at("met").get<bool>(); });
  print_text(options, "{} sets, {} diagnosed before; {} meet their aim; see {}/measured.md\n", list.sets.size(),
             run.kept, met, options.page);
  options.told = written_file(fs::path(options.page) / "measured.json");
}

void add_set_options(CLI::App* command, const std::shared_ptr<BlindArguments>& options) {
  command->add_option("--campaigns,--cases", options->campaigns, "how many; without it 60 (short) or 1000 (full)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{9999}));
  command->add_option("--seed", options->seed, "of the draw")->capture_default_str();
  command->add_option("--set", options->set, "short: 20 dwells, 40 and 30 dB; full: 40 dwells, 40 to 10 dB")
      ->check(one_of({"short", "full"}))
      ->capture_default_str();
  command
      ->add_option("--records", options->records,
                   "of every campaign: dwells (and three decays), decays, one_decay, sweeps, broadband or impacts")
      ->check(one_of(blind::programme_names()))
      ->capture_default_str();
  command->add_flag(
      "--disturbed", options->disturbed,
      "every campaign with one to three disturbances drawn by lot: mains, steps of a converter, coloured "
      "noise, late records, ...; structures and effects stay those of the seed");
  command->add_flag("--nothing-withheld", options->nothing_withheld,
                    "every model file is its structure's own: for the check of numbers by `blind estimates`");
  command->add_option("-o,--output", options->folder, "folder to make or to complete")->required();
}

void add_threads(CLI::App* command, const std::shared_ptr<BlindArguments>& options) {
  command->add_option("--threads", options->threads, "campaigns at once; the result does not depend on it")
      ->check(CLI::Range(1U, 1024U));
}

void add_run_options(CLI::App* command, const std::shared_ptr<BlindArguments>& options) {
  command->add_option("--limit", options->limit_s, "wall time of a campaign, s")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--program", options->program, "the secular that is checked; without it this one");
}

}  // namespace

void add_blind_command(CLI::App* blind, Action& chosen) {
  blind->require_subcommand(1);
  blind->footer("Example: secular blind all --set short -o blind_set");
  const auto add = [&](const char* name, const char* what, auto... steps) {
    auto options = std::make_shared<BlindArguments>();
    CLI::App* command = blind->add_subcommand(name, what);
    command->add_flag("--json", options->json, "what came of it as JSON; of a score or a page its JSON file");
    command->callback([options, &chosen, steps...] {
      chosen = [options, steps...] {
        Interruption::instance().set_message("what is done is kept; the same command goes on with the rest");
        (steps(*options), ...);
        if (options->json) fmt::print("{}", options->told);
        return 0;
      };
    });
    return std::pair(command, options);
  };
  const auto [making, make_options] =
      add("generate", "Draw structures, effects and noise; write campaigns; seal what they are", generate);
  add_set_options(making, make_options);
  add_threads(making, make_options);
  const auto [following, follow_options] =
      add("follow", "Run the dwell that each open verdict proposes, and a random one; diagnose again", follow);
  following->add_option("FOLDER", follow_options->folder, "made by generate, diagnosed by run")->required();
  add_threads(following, follow_options);
  add_run_options(following, follow_options);
  const auto [running, running_options] = add("run", "Diagnose every campaign that has no diagnosis yet", run);
  running->add_option("FOLDER", running_options->folder, "made by generate")->required();
  add_threads(running, running_options);
  add_run_options(running, running_options);
  const auto [leaving, leave_options] =
      add("leave-out", "Diagnose every campaign of one effect as if the catalogue did not hold it", leave_out);
  leaving->add_option("FOLDER", leave_options->folder, "made by generate")->required();
  add_threads(leaving, leave_options);
  add_run_options(leaving, leave_options);
  const auto [scoring, score_options] = add("score", "Open the labels and compare", check_score, score);
  scoring->add_option("FOLDER", score_options->folder, "made by generate, diagnosed by run")->required();
  scoring->add_option("-o,--output", score_options->page, "folder of score.md, score.json and calibration.svg")
      ->capture_default_str();
  add_force(scoring, score_options);
  const auto [estimating, estimate_options] =
      add("estimates", "Identify every campaign of a set with nothing withheld; compare its numbers with the truth",
          check_estimates, estimates);
  estimating->add_option("FOLDER", estimate_options->folder, "made by generate --nothing-withheld")->required();
  estimating->add_option("-o,--output", estimate_options->page, "folder of estimates.md and estimates.json")
      ->capture_default_str();
  add_threads(estimating, estimate_options);
  add_run_options(estimating, estimate_options);
  add_force(estimating, estimate_options);
  const auto [measuring, measured_options] =
      add("measured", "Diagnose records that others measured and compare with what is known of them",
          check_measured, measured);
  measured_options->command = measuring;
  measured_options->page.clear();
  measuring->add_option("DATA", measured_options->data, "folder of the measured data")->required();
  measuring->add_option("-o,--output", measured_options->page, "folder of measured.md and measured.json")
      ->required();
  measuring->add_option("--list", measured_options->list, "the sets, their models and their aims")
      ->capture_default_str();
  measuring
      ->add_option("--work", measured_options->work,
                   "folder of results; sets that have one there are not run again")
      ->capture_default_str();
  measuring->add_option("--only", measured_options->only, "a set by its name; may be given several times")
      ->allow_extra_args(false);
  add_force(measuring, measured_options);
  measuring->add_flag("--again", measured_options->again, "run sets that have a result as well");
  add_run_options(measuring, measured_options);
  const auto [all, all_options] = add("all", "generate, run, follow, leave-out and score", check_score, generate,
                                      run, follow, leave_out, score);
  add_set_options(all, all_options);
  add_threads(all, all_options);
  add_run_options(all, all_options);
  all->add_option("--page", all_options->page, "folder of score.md, score.json and calibration.svg")
      ->capture_default_str();
  add_force(all, all_options);
}

}  // namespace secular::app
