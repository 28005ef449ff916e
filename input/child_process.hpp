#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace secular {

/// The executable file of a program name (looked up in $PATH) or path; nothing if there is none.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// A program and what it is given. It has a group of its own, so that whatever it has started ends with it, where
/// its time is limited or this process ends what it has started (Interruption::is_on). Else it stays in the group
/// of this process, so that an interrupt from the terminal ends both.
struct ChildProcess {
  std::vector<std::string> arguments;      ///< the first is a path, or a name that is looked up in $PATH
  std::string_view input = {};             ///< its standard input
  std::vector<std::string> hidden = {};    ///< settings of the environment that it does not see, by how they begin
  std::vector<std::string> settings = {};  ///< NAME=VALUE that it sees besides
  bool errors_apart = false;               ///< else standard error goes where standard output goes
  std::filesystem::path log = {};          ///< the file that both go to, as they come; empty: ProcessEnd holds them
  double limit_s = 0;  ///< wall time after which it is killed, without that for which both were stopped; 0: none
};

/// How it ended.
struct ProcessEnd {
  int status = -1;  ///< exit status; -1: not started, ended by a signal or out of time
  int refused = 0;  ///< errno of what kept it from being started or waited for; 0: nothing
  bool out_of_time = false;
  double seconds = 0;  ///< wall time
  std::string output, errors;
};

/// Runs it to its end. Every argument is passed as it is: no shell sees them.
ProcessEnd run_process(const ChildProcess& process);

}  // namespace secular
