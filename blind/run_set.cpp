#include "blind/run_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>
#include <utility>

#include "blind/campaign_work.hpp"
#include "blind/sealed_files.hpp"
#include "input/folder_lock.hpp"
#include "input/input_error.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\r\n");
  if (end == std::string::npos) return "";
  const std::size_t begin = text.find_last_of("\r\n", end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

// Threads that each diagnosis may use, where the command knows that option.
std::vector<std::string> thread_arguments(const RunOptions& options) {
  const std::optional<std::string> help = help_of_diagnose(options.program);
  if (!help)
    throw InputError(options.program.string(), "", "has no command 'diagnose'", "a program that lists its options");
  if (help->find("--threads") == std::string::npos) return {};
  return {"--threads", std::to_string(threads_of_each(options))};
}

}  // namespace

std::optional<std::string> help_of_diagnose(const fs::path& program) {
  ProcessEnd ended = run_process({.arguments = {program.string(), "diagnose", "--help"}, .limit_s = 60});
  // A program without that command prints its own help and ends with status 0 as well.
  if (ended.status != 0 || ended.output.find("--model") == std::string::npos) return std::nullopt;
  return std::move(ended.output);
}

Diagnoser::Diagnoser(const RunOptions& options) : options_(options), threads_(thread_arguments(options)) {}

std::optional<std::string> fault_of(const ProcessEnd& ended, const fs::path& log, double limit_s) {
  if (ended.status == 0) return std::nullopt;
  if (ended.out_of_time) return fmt::format("more than {:.0f} s", limit_s);
  if (ended.status < 0) return "crashed";
  return fmt::format("exit status {}: {}", ended.status, fs::exists(log) ? last_line(read_text(log)) : "");
}

std::optional<std::string> Diagnoser::run(const fs::path& place, const fs::path& campaign, const fs::path& out,
                                          const std::vector<std::string>& without) const {
  std::vector<std::string> arguments = {"diagnose", campaign.string(), "--model", (place / "model.toml").string()};
  if (fs::exists(place / "parameters.json"))
    arguments.insert(arguments.end(), {"--parameters", (place / "parameters.json").string()});
  arguments.insert(arguments.end(), {"-o", (out / "diagnosis").string()});
  for (const std::string& effect : without) arguments.insert(arguments.end(), {"--without", effect});
  return run(std::move(arguments), out).fault;
}

Diagnoser::End Diagnoser::run(std::vector<std::string> arguments, const fs::path& out) const {
  const fs::path result = out / "diagnosis", log = out / "diagnosis.log";
  std::error_code ignored;
  fs::remove_all(result, ignored);
  arguments.insert(arguments.begin(), options_.program.string());
  arguments.insert(arguments.end(), threads_.begin(), threads_.end());
  End end;
  end.process = run_process({.arguments = arguments, .log = log, .limit_s = options_.limit_s});
  const nlohmann::ordered_json how = {
      {"status", end.process.status}, {"out_of_time", end.process.out_of_time}, {"seconds", end.process.seconds}};
  write_text(out / "run.json", how.dump() + "\n");
  end.fault = fault_of(end.process, log, options_.limit_s);
  if (!end.fault && !fs::exists(result / "diagnosis.json")) end.fault = "no diagnosis.json";
  return end;
}

RunSummary run_campaigns(const fs::path& folder, const RunOptions& options, const char* kind,
                         const Progress& progress) {
  const SetOptions set = options_of(folder);
  const FolderLock lock = lock_or_refuse(folder);
  const std::vector<Answer> answers = for_all_campaigns({kind, folder, set, options}, set.campaigns, progress);
  return {set.campaigns, count_of(answers, "kept"), failed_of(answers)};
}

nlohmann::ordered_json kept_before() {
  return {{"kept", true}};
}

nlohmann::ordered_json done_now(const std::optional<std::string>& fault) {
  Answer answer = Answer::object();
  if (fault) answer["faults"] = {*fault};
  return answer;
}

unsigned threads_of_each(const RunOptions& options) {
  return std::max(1U, std::thread::hardware_concurrency() / std::max(1U, options.threads));
}

Performer running(const CampaignWork& work) {
  return [diagnoser = Diagnoser(work.how), work](std::size_t i) {
    const fs::path place = sealed_folder(work.folder, i + 1);
    if (fs::exists(place / "diagnosis" / "diagnosis.json") && fs::exists(place / "run.json")) return kept_before();
    return done_now(diagnoser.run(place, place / "campaign", place));
  };
}

RunSummary run_set(const fs::path& folder, const RunOptions& options, const Progress& progress) {
  return run_campaigns(folder, options, "run", progress);
}

}  // namespace secular::blind
