#pragma once

#include <vector>

#include "app/procedure/procedure_data.hpp"
#include "report/figure.hpp"
#include "thesis/procedures/frequency_response_regression.hpp"
#include "thesis/procedures/saddle_node_regression.hpp"

namespace secular::app {

/// Points close to the saddle-nodes and both fitted lines after their shift.
report::Figure saddle_node_figure(const ProcedureData& test, const std::vector<const DwellMean*>& points,
                                  const SaddleNodeFit& right, const SaddleNodeFit& printed, bool cubic);

/// Measured amplitudes at the level of most dwells, and Eq. (5.25) with the recovered numbers there.
report::Figure response_figure(const ProcedureData& test, const SaddleNodeFit& damping,
                               const FrequencyResponseFit& response, NonlinearDamping law);

}  // namespace secular::app
