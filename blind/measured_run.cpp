#include "blind/measured_run.hpp"

#include <fmt/format.h>

#include <optional>
#include <system_error>

#include "blind/sealed_files.hpp"
#include "input/child_process.hpp"
#include "input/folder_lock.hpp"
#include "input/input_error.hpp"
#include "input/toml_table.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;
using Outcome = MeasuredResult::Outcome;

constexpr int refused_status = 2;

// How a set ended, WORK/NAME/result.json: what a later run decides by whether it keeps it.
struct Ended {
  MeasuredCommands commands;
  Outcome outcome = Outcome::failed;
  std::string reason;
  double seconds = 0, limit_s = 0;
  bool out_of_time = false;
};

void write_ended(const fs::path& file, const Ended& e) {
  const nlohmann::ordered_json document = {{"import", e.commands.import}, {"diagnose", e.commands.diagnose},
                                           {"outcome", e.outcome},        {"reason", e.reason},
                                           {"seconds", e.seconds},        {"limit_s", e.limit_s},
                                           {"out_of_time", e.out_of_time}};
  write_text(file, document.dump(1) + "\n");
}

std::optional<Ended> read_ended(const fs::path& place) {
  const fs::path file = place / "result.json";
  if (!fs::exists(file)) return std::nullopt;
  const nlohmann::json document = nlohmann::json::parse(read_text(file));
  Ended e;
  e.commands = {document.at("import"), document.at("diagnose")};
  e.outcome = document.at("outcome").get<Outcome>();
  e.reason = document.at("reason");
  e.seconds = document.at("seconds");
  e.limit_s = document.at("limit_s");
  e.out_of_time = document.at("out_of_time");
  if (e.outcome == Outcome::diagnosed && !fs::exists(place / "diagnosis" / "diagnosis.json")) return std::nullopt;
  return e;
}

class Runner {
 public:
  explicit Runner(const RunOptions& options) : options_(options), diagnoser_(options) {}

  Ended run(const MeasuredCommands& commands, const fs::path& place) const {
    std::error_code ignored;
    fs::remove_all(place, ignored);
    make_folder(place);
    Ended e;
    e.commands = commands;
    e.limit_s = options_.limit_s;
    std::vector<std::string> arguments = commands.import;
    arguments.insert(arguments.begin(), options_.program.string());
    const fs::path log = place / "import.log";
    const ProcessEnd imported = run_process({.arguments = arguments, .log = log, .limit_s = options_.limit_s});
    e.seconds = imported.seconds;
    if (const std::optional<std::string> fault = fault_of(imported, log, options_.limit_s)) {
      note_fault(e, imported, *fault);
      return e;
    }
    const Diagnoser::End diagnosed = diagnoser_.run(commands.diagnose, place);
    e.seconds += diagnosed.process.seconds;
    if (diagnosed.fault)
      note_fault(e, diagnosed.process, *diagnosed.fault);
    else
      e.outcome = Outcome::diagnosed;
    return e;
  }

 private:
  static void note_fault(Ended& e, const ProcessEnd& process, const std::string& fault) {
    e.outcome = process.status == refused_status ? Outcome::refused : Outcome::failed;
    e.reason = fault;
    e.out_of_time = process.out_of_time;
  }

  RunOptions options_;
  Diagnoser diagnoser_;
};

MeasuredResult result_of(const Ended& ended, const fs::path& place) {
  MeasuredResult result{ended.outcome, ended.reason, ended.seconds, {}, {}};
  if (ended.outcome != Outcome::diagnosed) return result;
  result.diagnosis = nlohmann::json::parse(read_text(place / "diagnosis" / "diagnosis.json"));
  for (const TomlTable& channel : TomlTable::from_file(place / "campaign" / "campaign.toml").tables("channel"))
    result.units[channel.string("name")] = channel.string_or("unit", "");
  return result;
}

bool is_kept(const std::optional<Ended>& before, const MeasuredCommands& commands, double limit_s) {
  return before && before->commands.import == commands.import && before->commands.diagnose == commands.diagnose &&
         !(before->out_of_time && limit_s > before->limit_s);
}

}  // namespace

MeasuredCommands commands_of(const MeasuredSet& set, const fs::path& models, const fs::path& data,
                             const fs::path& place) {
  MeasuredCommands commands;
  commands.import = {"import"};
  for (const std::string& file : set.files) commands.import.push_back((data / file).string());
  commands.import.insert(commands.import.end(), {"-o", (place / "campaign").string()});
  commands.import.insert(commands.import.end(), set.import.begin(), set.import.end());
  commands.diagnose = {"diagnose", (place / "campaign").string(), "--model",
                       ((set.model_is_data ? data : models) / set.model).string()};
  commands.diagnose.insert(commands.diagnose.end(), set.diagnose.begin(), set.diagnose.end());
  commands.diagnose.insert(commands.diagnose.end(), {"-o", (place / "diagnosis").string()});
  return commands;
}

MeasuredRun run_measured(const MeasuredList& list, const MeasuredPlaces& places, const RunOptions& options,
                         bool again, const Progress& progress) {
  require_data(list, places.data);
  make_folder(places.work);
  const FolderLock lock = lock_or_refuse(places.work);
  const Runner runner(options);
  MeasuredRun run;
  for (const MeasuredSet& set : list.sets) {
    const fs::path place = places.work / set.name;
    const MeasuredCommands commands = commands_of(set, list.folder, places.data, place);
    std::optional<Ended> ended = again ? std::nullopt : read_ended(place);
    if (is_kept(ended, commands, options.limit_s)) {
      ++run.kept;
    } else {
      ended = runner.run(commands, place);
      write_ended(place / "result.json", *ended);
    }
    run.results.push_back(result_of(*ended, place));
    if (progress) progress(run.results.size(), list.sets.size());
  }
  return run;
}

}  // namespace secular::blind
