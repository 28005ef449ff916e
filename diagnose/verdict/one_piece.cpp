#include "diagnose/verdict/one_piece.hpp"

#include <algorithm>
#include <utility>

#include "diagnose/inference/null_fit.hpp"

namespace secular {

std::string against_one_piece(const DiagnosisOptions& options) {
  const bool has_tones = std::any_of(options.tones.begin(), options.tones.end(),
                                     [](const auto& of_record) { return !of_record.second.empty(); });
  if (has_tones) return "tones that are not the structure's stand beside the motion";
  if (!options.wandering.empty()) return "a sensor's zero wanders";
  if (!options.coloured.empty()) return "noise has a colour";
  return {};
}

bool compares_decays(const Comparison& comparison, const Campaign& campaign) {
  const std::vector<RowLabel> labels = comparison.discrepancy.labels();
  return std::any_of(labels.begin(), labels.end(), [&](const RowLabel& label) {
    return campaign.records[label.record].kind == RecordKind::free_decay;
  });
}

RowsLeft bring_to_rest(FittedAlone& fitted, const DiagnosisOptions& options) {
  Discrepancy& discrepancy = fitted.comparison.discrepancy;
  Inference& inference = fitted.inference;
  Refit& fit = inference.null.fit;
  fit = bring_to_rest(discrepancy, std::move(fit), options_of_fit(options));
  inference.degrees_of_freedom = static_cast<double>(discrepancy.freedom() - fit.rank);
  return {fit.chi_squared, inference.degrees_of_freedom};
}

InOnePiece model_in_one_piece(const CampaignAndModel& sides, const DiagnosisOptions& options, Inference segments,
                              bool late) {
  InOnePiece whole{{compare(sides, {}, options), std::move(segments), late}, {}, {}};
  whole.left = bring_to_rest(whole.fitted, options);
  if (whole.has_converged())
    whole.parts = parts_of_decays(whole.fitted.comparison, whole.fitted.inference.null.fit, sides.campaign,
                                  sides.model.modes());
  return whole;
}

}  // namespace secular
