#pragma once

#include <functional>

#include "diagnose/verdict/diagnosis_options.hpp"
#include "diagnose/verdict/left_content.hpp"
#include "diagnose/verdict/model_alone.hpp"
#include "measure/data/campaign.hpp"

namespace secular {

/// Whether the model as it is leaves no more than noise beside foreign content that is found in what it leaves,
/// `left` at first, round by round. `fit`: once more, by `options` as they are then. Where it does not, `foreign`
/// and `options` are as they were: what a missing term leaves may look like foreign content.
bool holds_beside_foreign_content(ModelAlone left, const std::function<ModelAlone()>& fit, const Campaign& campaign,
                                  ForeignContent& foreign, DiagnosisOptions& options);

}  // namespace secular
