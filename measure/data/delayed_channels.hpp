#pragma once

#include "measure/data/campaign.hpp"
#include "measure/data/line_row.hpp"

namespace secular {

/// The record with every channel as much earlier as it is late (Channel::delay_s), by an all-pass, which leaves
/// white noise white and as large as it is; next to the ends, and in records with unusable rows, by polynomials
/// through up to 32 samples, which take off up to 7 % of it (both to 4e-6 of a tone of four samples a turn). Rows
/// that some channel has no samples for are cut off (Record::cut_for_delay). Throws InputError, with `file` as its
/// record, where that is half of the record or more.
Record without_delays(const Campaign& campaign, Record record, const std::string& file);

/// The same of a row of a table: phases of all lines.
LineRow without_delays(const Campaign& campaign, LineRow row);

}  // namespace secular
