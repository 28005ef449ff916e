#pragma once

#include <vector>

#include "measure/disturbances/searched_record.hpp"

/// What the rows of the catalogue find; each in a file of its own. It adds to `found` what one record shows; row
/// and file say by which test.
namespace secular {

void find_foreign_tones(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_converter_steps(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_offsets(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_wander(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_ringing(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_spikes(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_knocks(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_held_samples(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_lost_samples(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_clipped(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_time_scatter(const SearchedRecord& record, std::vector<Disturbance>& found);

}  // namespace secular
