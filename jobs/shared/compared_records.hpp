#pragma once

#include <vector>

#include "diagnose/verdict/diagnosis_options.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/record_assignment.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/disturbances/disturbance.hpp"
#include "measure/disturbances/disturbance_watch.hpp"

namespace secular {

/// Where the records of `options.window` show the natural frequencies that are given, or nominal; notes them in
/// `options.natural_frequency`.
FrequencyStarts start_frequencies(const ModelSource& source, const Campaign& campaign, const RecordReader& read,
                                  DiagnosisOptions& options);

/// What `watch`, which `reader` shows every record of the window to, finds in them. Clipped samples are left out
/// from then on, unless most records are clipped.
std::vector<Disturbance> found_in_records(const Campaign& campaign, const Window& window, SelectedRecords& reader,
                                          const DisturbanceWatch& watch);

}  // namespace secular
