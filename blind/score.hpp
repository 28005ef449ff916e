#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace secular::blind {

/// Of a probability.
struct Interval {
  double low = 0, high = 1;
};

/// 95 % interval of a probability from `hits` of `trials` (E. B. Wilson, J. Am. Stat. Assoc. 22, 1927); all of [0,
/// 1] without trials.
Interval wilson(std::size_t hits, std::size_t trials);

/// A figure beside its target.
struct Figure {
  std::string name;
  double value = 0;
  Interval ci95;
  std::size_t trials = 0;  ///< 0: nothing to judge, no value
  std::optional<double> target;
  bool at_most = false;  ///< the target is an upper bound
};

/// Stated probabilities of one interval and how often they were right.
struct CalibrationBin {
  double low = 0, high = 1, mean_stated = 0;
  std::size_t stated = 0, right = 0;
};

/// How often campaigns that bear one kind of disturbance ended as they should have.
struct DisturbedShare {
  std::size_t campaigns = 0, right = 0;
};

/// A campaign that did not end as it should have.
struct WrongCampaign {
  std::size_t number = 0;
  std::string truth, named, family;
  std::vector<std::string> disturbances;
  double sigma = 0, snr_db = 0;
};

struct Score {
  std::size_t campaigns = 0, failed = 0;
  std::vector<Figure> figures;
  std::map<std::string, std::map<std::string, std::size_t>> confusion;  ///< truth -> named -> campaigns
  std::vector<CalibrationBin> calibration;
  std::map<std::string, DisturbedShare> by_disturbance;  ///< kind -> ...
  std::vector<WrongCampaign> wrong;
};

/// What a diagnosis said of one campaign. A campaign without (whole) diagnosis has verdict "failed".
struct Said {
  std::string verdict = "failed";
  std::string cause;                                              ///< of the largest probability
  std::vector<std::string> set;                                   ///< named together with `cause`
  std::map<std::string, double> probability;                      ///< by effect, all modes together
  std::vector<std::pair<std::string, std::string>> disturbances;  ///< kinds that it lists, with their channels
  bool detected = false;
  std::optional<double> closed;
  double seconds = 0;
  /// By follow-up, "proposed" and "random": the one cause named after one more dwell, empty where none was.
  std::map<std::string, std::string> named_after;
  std::optional<double> placebo_closed;
  /// With the effect left out of the catalogue that is the truth: the verdict, and which effects of the rest
  /// explain the data as well. Empty verdict: not tried.
  std::string verdict_without;
  std::vector<std::string> explained_by_rest;
};

/// Reads the contract's diagnosis.json (section 6); a document that does not follow it gives verdict "failed".
Said what_was_said(const nlohmann::json& diagnosis);

/// Compares `labels.at("labels")` with what was said of each campaign, in their order.
Score score_of(const nlohmann::json& labels, const std::vector<Said>& said);

/// A list, each with its 95 % interval, trials and target; a table of the same, `trials`: of what.
nlohmann::ordered_json figures_json(const std::vector<Figure>& figures);
std::string figures_markdown(const std::vector<Figure>& figures, const std::string& trials);

/// score.json and score.md.
nlohmann::ordered_json score_json(const Score& score);
std::string score_markdown(const Score& score, const std::string& set_name);
/// Stated probability against the share that was right, as an SVG of its own.
std::string calibration_svg(const std::vector<CalibrationBin>& bins);

}  // namespace secular::blind
