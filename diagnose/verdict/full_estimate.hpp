#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/verdict/campaign_and_model.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "estimator/identification/estimate.hpp"
#include "measure/disturbances/disturbance.hpp"

namespace secular {

/// Samples of a record without a gap, as they were measured, and as the model makes them from the state that their
/// segment begins with.
struct ComparedStretch {
  double from_s = 0;  ///< in the record's time
  std::vector<double> measured, computed;
};

/// All samples of a record that count, in the first channel of the responses.
struct ComparedRecord {
  std::size_t record = 0, channel = 0;  ///< of the campaign
  double sample_s = 0;
  std::vector<ComparedStretch> stretches;  ///< none is empty
  std::size_t loudest = 0;                 ///< of them, by the sum of the squares that are computed
  std::size_t fitted = 0;                  ///< numbers of states that were fitted, of all segments together
};

/// Numbers of a model by its full equations of motion.
struct FullEstimate {
  /// One parameter for every symbol of the model, lack_of_fit of all rows together; no lumps, no cases.
  Estimate estimate;
  bool has_converged = false;  ///< else no parameter has a value
  /// Why free decays are not fitted in one piece each; empty: they are.
  std::string against_one_piece;
  /// Of decays alone that have come to rest in one piece each: whether parts of them tell the same numbers; where
  /// they do not, by symbol what a misfit as large may have done to it (else empty).
  std::optional<LackOfFit> parts;
  Eigen::VectorXd hidden_by_parts;
  double alarm = 0;              ///< probability at which what is seen is significant
  bool noise_misjudged = false;  ///< the rows scatter far less than the repeatability that they are measured in
  std::vector<Disturbance> disturbances;
  std::set<std::size_t> records;  ///< that the numbers rest on
  std::size_t conditions = 0;     ///< dwells, and segments of the other records
  double data_used = 0;           ///< of the samples within the window
  std::vector<RowLabel> labels;
  Eigen::VectorXd rows;                  ///< what is left, of unit variance where the model holds
  std::vector<ComparedRecord> compared;  ///< sample by sample
};

/// Fits the model as it is to all records of the window at once, dwells by their lines and all others sample by
/// sample, by the rows that a diagnosis compares with (docs/inference.md (46)). Foreign content of the readings is
/// allowed for as there.
///
/// `sides.own`: symbols that are fitted; others are held at `options.start`. `starts`: by symbol, in turn until a
/// fit ends and leaves no more than noise; the best of them is taken. `found`: what the records hold beside the
/// motion. `progress`: fits so far, of about how many. Throws InputError as compare().
FullEstimate estimate_by_full_equations(const CampaignAndModel& sides, const DiagnosisOptions& options,
                                        const std::vector<std::map<std::string, double>>& starts,
                                        std::vector<Disturbance> found, const SearchProgress& progress = {});

}  // namespace secular
