#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "blind/sealed_set.hpp"
#include "input/child_process.hpp"

namespace secular::blind {

struct RunOptions {
  std::filesystem::path program;  ///< the `secular` that is checked
  unsigned threads = 1;           ///< cases at once
  double limit_s = 300;           ///< wall time of a case
};

struct FailedCase {
  std::size_t number = 0;
  std::string reason;  ///< "exit status 2: message"
};

/// Failures from any thread.
class Failures {
 public:
  void add(std::size_t number, std::string reason);
  std::vector<FailedCase> by_number();

 private:
  std::mutex guard_;
  std::vector<FailedCase> failed_;
};

struct RunSummary {
  std::size_t cases = 0, kept = 0;  ///< kept: had a diagnosis before
  std::vector<FailedCase> failed;
};

/// Runs every case of a set that has no result yet, several at once. `has_result` and `run` are given the case's
/// folder and may be called by any thread; `run` returns what went wrong, if anything did.
RunSummary run_cases(const std::filesystem::path& folder, const RunOptions& options,
                     const std::function<bool(const std::filesystem::path&)>& has_result,
                     const std::function<std::optional<std::string>(const std::filesystem::path&)>& run,
                     const Progress& progress);

/// Threads that each of the cases at once may use.
unsigned threads_of_each(const RunOptions& options);

/// What `PROGRAM diagnose --help` prints; nothing where the program has no such command.
std::optional<std::string> help_of_diagnose(const std::filesystem::path& program);

/// What went wrong with a run of the program, if anything did: that its time was up, or the last line of its log.
std::optional<std::string> fault_of(const ProcessEnd& ended, const std::filesystem::path& log, double limit_s);

/// `secular diagnose` as a process of its own.
class Diagnoser {
 public:
  struct End {
    ProcessEnd process;
    std::optional<std::string> fault;  ///< what went wrong, if anything did
  };

  /// Throws InputError where the program has no such command.
  explicit Diagnoser(const RunOptions& options);

  /// Diagnoses `campaign` with model and numbers of the case at `place`: OUT/diagnosis/, what it printed in
  /// OUT/diagnosis.log, how it ended in OUT/run.json. Returns what went wrong, if anything did.
  /// `without`: effects that the diagnosis must not consider.
  std::optional<std::string> run(const std::filesystem::path& place, const std::filesystem::path& campaign,
                                 const std::filesystem::path& out,
                                 const std::vector<std::string>& without = {}) const;

  /// `PROGRAM ARGUMENTS`, which are those of a diagnosis that writes OUT/diagnosis/; the same files beside it.
  End run(std::vector<std::string> arguments, const std::filesystem::path& out) const;

 private:
  RunOptions options_;
  std::vector<std::string> threads_;
};

/// `secular diagnose` of every case of a set that has no diagnosis yet, each in a process of its own:
/// CASE/diagnosis/, what it printed in CASE/diagnosis.log, how it ended in CASE/run.json.
RunSummary run_set(const std::filesystem::path& folder, const RunOptions& options, const Progress& progress);

}  // namespace secular::blind
