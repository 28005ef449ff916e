#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "blind/run_options.hpp"
#include "blind/sealed_set.hpp"
#include "input/child_process.hpp"

namespace secular::blind {

struct RunSummary {
  std::size_t campaigns = 0, kept = 0;  ///< kept: had a diagnosis before
  std::vector<FailedCampaign> failed;
};

/// Work of one kind on every campaign of a sealed set.
RunSummary run_campaigns(const std::filesystem::path& folder, const RunOptions& options, const char* kind,
                         const Progress& progress);
/// What a campaign says that has a result already, and one that was run: with what went wrong, if anything did.
nlohmann::ordered_json kept_before();
nlohmann::ordered_json done_now(const std::optional<std::string>& fault);

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
