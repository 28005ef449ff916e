#include "app/shared/output_target.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "input/input_error.hpp"
#include "input/whole_folder.hpp"
#include "jobs/matlab/mat_text.hpp"
#include "measure/data/campaign_target.hpp"
#include "report/whole_file.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* force_description = "replace what stands there";

void check_apart(const std::string& output, const std::string& option, const std::vector<CommandInput>& inputs) {
  if (output.empty()) throw InputError(option, "", "has no name", "name what is to be written");
  for (const CommandInput& input : inputs) {
    std::error_code error;
    if (input.path.empty() || !fs::exists(input.path, error)) continue;
    if (fs::is_directory(input.path, error) && !input.may_be_folder) continue;
    const std::string how = overlap(output, input.path);
    if (how.empty()) continue;
    throw InputError(output, option, fmt::format("{} {} that is read ({})", how, input.what, input.path),
                     "name another place: what is read is never written to");
  }
}

[[noreturn]] void refuse_without_force(const std::string& output, const std::string& option) {
  throw InputError(output, option, "exists", "name another place, or add --force to replace it");
}

// Of a folder; whether something in it has to be replaced.
bool stands(const std::string& output, bool force) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(output, error);
  if (!fs::exists(status)) return false;
  if (!fs::is_directory(output, error))
    throw InputError(output, "-o", "exists and is no folder", "name a folder, or one that does not exist yet");
  if (fs::is_empty(output, error) && !error) return false;
  if (!force) refuse_without_force(output, "-o");
  return true;
}

[[noreturn]] void refuse_others(const std::string& output, const std::string& why) {
  throw InputError(output, "-o", why,
                   "name another folder, or remove this one yourself: --force replaces results alone");
}

bool matches(const std::string& name, const std::string& pattern) {
  return fnmatch(pattern.c_str(), name.c_str(), FNM_PERIOD) == 0;
}

void check_campaign_made(const std::string& output) {
  if (const std::string fault = fault_of_replaced(output); !fault.empty()) refuse_others(output, fault);
}

}  // namespace

void OutputFolder::add_to(CLI::App& command, const std::string& description, bool required) {
  command.add_option("-o,--output", path_, description)->required(required);
  command.add_flag("--force", force_, force_description);
}

bool OutputFolder::is_own(const fs::directory_entry& entry) const {
  const std::string name = entry.path().filename().string();
  const auto fits_any = [&](const std::string& file) {
    return std::any_of(patterns_.begin(), patterns_.end(),
                       [&](const std::string& pattern) { return matches(file, pattern); });
  };
  if (entry.is_symlink() || !entry.is_regular_file()) return false;
  std::ifstream stream(entry.path());
  std::string line;
  std::getline(stream, line);
  // `secular to-matlab` puts a MAT file beside a JSON file.
  if (entry.path().extension() == ".mat" && fits_any(entry.path().stem().string() + ".json"))
    return line.starts_with(mat_heading);
  return fits_any(name) && line.find(mark_) != std::string::npos;
}

void OutputFolder::check(const std::vector<CommandInput>& inputs) const {
  check_apart(path_, "-o", inputs);
  if (!stands(path_, force_)) return;
  bool any = false;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    if (!is_own(entry)) refuse_others(path_, fmt::format("holds {}, which this command does not write", name));
    any = any || matches(name, patterns_.front());
  }
  if (!any) refuse_others(path_, "exists and holds no results of this command");
}

void OutputFolder::write(const ResultFiles& files) const {
  check({});
  WholeFolder folder(path_);
  for (const auto& [name, content] : files) {
    std::string piece = content;
    folder.write(name, [&piece] { return std::exchange(piece, {}); });
  }
  folder.finish(force_);
}

void OutputCampaign::add_to(CLI::App& command) {
  command.add_option("-o,--output", path_, "campaign folder to make")->required();
  command.add_flag("--force", force_, force_description);
}

void OutputCampaign::check(const std::vector<CommandInput>& inputs) const {
  check_apart(path_, "-o", inputs);
  if (stands(path_, force_)) check_campaign_made(path_);
}

void OutputFile::add_to(CLI::App& command) {
  command.add_option("-o,--output", path_, "file to write; standard output without it");
  command.add_flag("--force", force_, force_description);
}

void OutputFile::add_to(CLI::App& command, const std::string& option, const std::string& description) {
  option_ = option;
  command.add_option(option, path_, description);
}

void OutputFile::check(const std::vector<CommandInput>& inputs, bool force, const fs::path& made) const {
  if (path_.empty()) return;
  check_apart(path_, option_, inputs);
  std::error_code error;
  const fs::path folder = fs::absolute(path_).lexically_normal().parent_path();
  bool is_made = false;
  if (!made.empty()) {
    const fs::path beside = fs::absolute(made).lexically_normal().parent_path();
    is_made = std::mismatch(folder.begin(), folder.end(), beside.begin(), beside.end()).first == folder.end();
  }
  if (!is_made && !fs::is_directory(folder, error))
    throw InputError(path_, option_, folder.string() + " is no folder", "make it first");
  if (!fs::exists(fs::symlink_status(path_, error))) return;
  if (!fs::is_regular_file(path_, error))
    throw InputError(path_, option_, "exists and is no regular file", "name a file");
  if (!force && !force_) refuse_without_force(path_, option_);
}

void OutputFile::write(const std::string& text) const {
  if (path_.empty())
    fmt::print("{}", text);
  else
    report::write_whole_file(path_, text);
}

}  // namespace secular::app
