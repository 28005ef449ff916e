#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "blind/run_set.hpp"
#include "blind/score.hpp"

namespace secular::blind {

/// What `identify` says of one of the model's own numbers, beside the truth.
struct JudgedNumber {
  std::size_t number = 0;  ///< of the campaign
  std::string symbol;
  double truth = 0;
  bool given = false;     ///< it has a value and an error bar
  bool doubtful = false;  ///< and a mark that it may be off by more than its error bar
  bool held = false;      ///< its 95 % interval holds the truth
  double off = 0;         ///< from the truth, in its standard deviations
};

/// What is asked of the numbers of one group of campaigns: of a family, of a disturbance, of all.
struct NumberShare {
  std::size_t campaigns = 0, asked = 0, given = 0, unmarked = 0, held = 0;  ///< held: of the unmarked ones
  double largest_off = 0;                                                   ///< of the unmarked ones
};

struct EstimateScore {
  std::size_t campaigns = 0;
  std::vector<FailedCampaign> failed;
  std::vector<Figure> figures;
  std::map<std::string, NumberShare> by_family, by_disturbance;  ///< "none": no disturbance
  std::vector<JudgedNumber> far_off;                             ///< unmarked and by more than 4 sd, furthest first
};

/// `secular identify` of every campaign of a set that has no estimate yet, with the campaign's own model, each in a
/// process of its own: case_NNNN/estimate/, what it printed in case_NNNN/estimate.log.
RunSummary identify_set(const std::filesystem::path& folder, const RunOptions& options, const Progress& progress);

/// Reads the contract's estimate.json (section 3) for every symbol in `truth`.
std::vector<JudgedNumber> judged_numbers(std::size_t number, const std::map<std::string, double>& truth,
                                         const nlohmann::json& estimate);

/// Opens the labels of a set whose models are the structures' own. Throws InputError where something was withheld.
EstimateScore score_estimates(const std::filesystem::path& folder);

/// PAGE/estimates.md and PAGE/estimates.json.
void write_estimate_score(const EstimateScore& score, const std::string& set_name,
                          const std::filesystem::path& page);

}  // namespace secular::blind
