#pragma once

#include <vector>

#include "measure/disturbances/searched_record.hpp"

/// What the rows of the catalogue find; each in a file of its own.
namespace secular {

void find_foreign_tones(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_converter_steps(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_offsets(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_wander(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_ringing(const SearchedRecord& record, std::vector<Disturbance>& found);
/// Samples that were lost on their way, and not a motion that sticks.
bool is_held(const SearchedChannel& channel);
/// Single samples that stand out, of no blow and no part of the motion.
bool has_spikes(const SearchedRecord& record, std::size_t channel);
void find_spikes(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_knocks(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_held_samples(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_lost_samples(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_clipped(const SearchedRecord& record, std::vector<Disturbance>& found);
void find_time_scatter(const SearchedRecord& record, std::vector<Disturbance>& found);

}  // namespace secular
