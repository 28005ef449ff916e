#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/observe/observation_set.hpp"
#include "report/figure.hpp"
#include "thesis/procedures/added_last_anova.hpp"

namespace secular::app {

struct ProcedureRequest {
  std::string campaign, model, resonance;
  std::vector<std::string> methods;             ///< empty: all that the case has
  std::vector<std::vector<std::string>> terms;  ///< tested together in the analysis of variance
  std::vector<std::string> left_out;            ///< lumps that the generated equations leave out (zero)
  std::string truth;                            ///< parameter file or experiment, empty: not known
  Window window;
  bool interpret = false;
  bool bias = true;      ///< see ProcedureBias
  unsigned threads = 1;  ///< the result does not depend on it
};

/// What a method does beside the truth: the equations behind it end at second order, its points are near
/// saddle-nodes and not on them, exact resonance is known to a bracket. Seen on steady motions that the full
/// equations of motion make of the parameters that `secular identify` finds in the same campaign, where the truth
/// is known.
struct ProcedureBias {
  double value = 0;               ///< recovered minus true there, mean over draws of the measured noise
  double noise_sd = 0;            ///< of `recovered` and, by way of the identified parameters, of the bias
  double open_sd = 0;             ///< by what the campaign leaves open of the parameters
  double degrees_of_freedom = 0;  ///< of noise_sd

  double sd() const { return std::hypot(noise_sd, open_sd); }
};

/// One quantity: recovered beside true beside printed.
struct ProcedureRow {
  std::string name, unit, equation;
  double recovered = 0;
  std::optional<double> sd;          ///< clustered by condition
  std::optional<double> scatter;     ///< between conditions: what the source's tables give as standard deviation
  std::optional<double> as_printed;  ///< what the printed equation makes of the same data
  std::optional<double> truth, source, source_sd;
  std::string table;
  std::optional<ProcedureBias> bias;  ///< of `recovered`

  /// `recovered` without its bias, where that is known, and the standard deviation that goes with it.
  double best() const { return bias ? recovered - bias->value : recovered; }
  std::optional<double> best_sd() const { return bias ? std::optional(bias->sd()) : sd; }
};

struct ProcedureSection {
  std::string method, title, text;
  std::vector<ProcedureRow> rows;
  std::vector<std::pair<std::string, AnovaTable>> anova;
  std::vector<std::pair<report::Figure, std::string>> figures;  ///< with captions
};

struct ProcedureRun {
  Campaign campaign;
  std::shared_ptr<const CompiledModel> model;
  const CompiledCase* resonance = nullptr;
  ObservationSet measured;
  std::vector<ProcedureSection> sections;
  std::vector<std::string> warnings;
};

/// The named methods of the source, chapters 5 and 6 and Appendix D, on a campaign. Throws InputError for a case
/// they do not cover and for data that are not enough.
ProcedureRun run_procedures(const ProcedureRequest& request);

/// The same for records that are not in files: `request.campaign` is not read.
ProcedureRun run_procedures(const ProcedureRequest& request, const Campaign& measured, const RecordReader& read);

/// procedures.json and the report page.
std::string procedures_json(const ProcedureRun& run);
std::string procedures_report(const ProcedureRun& run, const std::string& command);

}  // namespace secular::app
