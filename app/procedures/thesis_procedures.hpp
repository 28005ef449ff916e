#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "estimator/campaign/campaign.hpp"
#include "estimator/identification/observation_set.hpp"
#include "estimator/procedures/added_last_anova.hpp"
#include "report/figure.hpp"

namespace secular::app {

struct ProcedureRequest {
  std::string campaign, model, resonance;
  std::vector<std::string> methods;             ///< empty: all that the case has
  std::vector<std::vector<std::string>> terms;  ///< tested together in the analysis of variance
  std::vector<std::string> left_out;            ///< lumps that the generated equations leave out (zero)
  std::string truth;                            ///< parameter file or experiment, empty: not known
  Window window;
  bool interpret = false;
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

/// procedures.json and the report page.
std::string procedures_json(const ProcedureRun& run);
std::string procedures_report(const ProcedureRun& run, const std::string& command);

}  // namespace secular::app
