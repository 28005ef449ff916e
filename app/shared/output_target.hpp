#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace secular::app {

/// What a command reads, to be kept apart from what it writes.
struct CommandInput {
  std::string what;  ///< "the campaign", "the model"
  std::string path;  ///< what is none, as the name of a shipped model, is passed over
  bool may_be_folder = false;
};

/// By name and content.
using ResultFiles = std::vector<std::pair<std::string, std::string>>;

/// -o,--output and --force of a command that writes a folder of results.
class OutputFolder {
 public:
  /// `patterns`: of all files that the command writes there (shell patterns), the first is always among them.
  /// `mark`: what all of them have in their first line, where their names do not tell.
  explicit OutputFolder(std::vector<std::string> patterns, std::string mark = {})
      : patterns_(std::move(patterns)), mark_(std::move(mark)) {}
  void add_to(CLI::App& command, const std::string& description, bool required = true);
  const std::string& path() const { return path_; }
  bool replaces() const { return force_; }

  /// Before any work. Throws InputError where the folder is what is read, lies in it or contains it; where
  /// something stands there without --force; and with it where that is anything but results of this command.
  void check(const std::vector<CommandInput>& inputs) const;
  /// All of them appear at once, or none. Throws InputError where they cannot, and for what has come to stand there
  /// since.
  void write(const ResultFiles& files) const;

 private:
  bool is_own(const std::filesystem::directory_entry& entry) const;

  std::vector<std::string> patterns_;
  std::string mark_, path_;
  bool force_ = false;
};

/// The same of a command that makes a campaign: what may be replaced is one that a command made.
class OutputCampaign {
 public:
  void add_to(CLI::App& command);
  const std::string& path() const { return path_; }
  bool replaces() const { return force_; }
  void check(const std::vector<CommandInput>& inputs) const;

 private:
  std::string path_;
  bool force_ = false;
};

/// Of a command that writes a single file; without one it prints.
class OutputFile {
 public:
  void add_to(CLI::App& command);
  /// Another file beside a folder: its own option, and --force of the folder.
  void add_to(CLI::App& command, const std::string& option, const std::string& description);
  const std::string& path() const { return path_; }

  /// `force`: of another option of the command. `made`: what the command makes before, with the folders above it.
  void check(const std::vector<CommandInput>& inputs, bool force = false,
             const std::filesystem::path& made = {}) const;
  /// To the file, or to standard output.
  void write(const std::string& text) const;

 private:
  std::string path_, option_ = "-o";
  bool force_ = false;
};

}  // namespace secular::app
