#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace secular::blind {

/// How a child process ended.
struct Ended {
  int status = -1;  ///< exit status; -1: not started, killed by a signal or out of time
  bool out_of_time = false;
  double seconds = 0;  ///< wall time
};

/// Runs arguments[0] (a path) with the other arguments, without a shell; its output goes to the file `log`. After
/// `limit_s` seconds it and whatever it has started are killed.
Ended run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log, double limit_s);

}  // namespace secular::blind
