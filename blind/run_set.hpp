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
  unsigned threads = 1;           ///< campaigns at once
  double limit_s = 300;           ///< wall time of a campaign
};

struct FailedCampaign {
  std::size_t number = 0;
  std::string reason;  ///< "exit status 2: message"
};

/// Failures from any thread.
class Failures {
 public:
  void add(std::size_t number, std::string reason);
  std::vector<FailedCampaign> by_number();

 private:
  std::mutex guard_;
  std::vector<FailedCampaign> failed_;
};

struct RunSummary {
  std::size_t campaigns = 0, kept = 0;  ///< kept: had a diagnosis before
  std::vector<FailedCampaign> failed;
};

/// Runs every campaign of a set that has no result yet, several at once. `has_result` and `run` are given the
/// campaign's folder and may be called by any thread; `run` returns what went wrong, if anything did.
RunSummary run_campaigns(const std::filesystem::path& folder, const RunOptions& options,
                         const std::function<bool(const std::filesystem::path&)>& has_result,
                         const std::function<std::optional<std::string>(const std::filesystem::path&)>& run,
                         const Progress& progress);

/// Threads that each of the campaigns at once may use.
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

  /// Diagnoses `campaign` with model and numbers of the sealed one at `place`: OUT/diagnosis/, what it printed in
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

/// `secular diagnose` of every campaign of a set that has no diagnosis yet, each in a process of its own:
/// case_NNNN/diagnosis/, what it printed in case_NNNN/diagnosis.log, how it ended in case_NNNN/run.json.
RunSummary run_set(const std::filesystem::path& folder, const RunOptions& options, const Progress& progress);

}  // namespace secular::blind
