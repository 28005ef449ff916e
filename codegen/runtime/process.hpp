#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace secular {

/// The executable file of a program name (looked up in $PATH) or path; nothing if there is none.
std::optional<std::filesystem::path> find_program(const std::string& name);

struct ProcessResult {
  int status = -1;     ///< exit status; -1: could not be started, or ended by a signal
  std::string output;  ///< standard output and standard error together
};

/// Runs arguments[0] with the other arguments, each passed as it is: no shell sees them. Standard input is empty,
/// messages are not translated.
ProcessResult run_process(const std::vector<std::string>& arguments);

}  // namespace secular
