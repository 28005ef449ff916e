#include "jobs/shared/compared_records.hpp"

#include <cstddef>

#include "diagnose/verdict/clipped_records.hpp"
#include "diagnose/verdict/given_numbers.hpp"

namespace secular {

FrequencyStarts start_frequencies(const ModelSource& source, const Campaign& campaign, const RecordReader& read,
                                  DiagnosisOptions& options) {
  std::vector<double> nominal = source.nominal_frequencies();
  nominal.resize(source.modes());
  const std::vector<double> claimed = claimed_frequencies(options.given, source.frequency_names(), nominal);
  FrequencyStarts starts = frequency_starts(source, campaign, read, claimed, {}, options.window);
  options.natural_frequency = frequencies_of_records(claimed, starts.frequency, starts.moved);
  return starts;
}

std::vector<Disturbance> found_in_records(const Campaign& campaign, const Window& window, SelectedRecords& reader,
                                          const DisturbanceWatch& watch) {
  std::size_t chosen = 0;
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    if (window.takes(r, campaign.records[r].file)) {
      reader.read(r);
      ++chosen;
    }
  std::vector<Disturbance> found = watch.found();
  if (leaves_clipped_out(reader.clipped_records(), chosen)) {
    reader.leave_clipped_out();
    list_clipped_as_left_out(found);
  }
  return found;
}

}  // namespace secular
