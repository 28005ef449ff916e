#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measure/data/campaign.hpp"

namespace secular {

/// Samples of a channel between what was written before its recording began and after it had ended.
struct RecordedSpan {
  std::size_t begin = 0, end = 0;
};

/// Cells without a number at either end of a record, and one value that is repeated to there, stand where nothing
/// was recorded. A motion at rest repeats a value too. Nothing was recorded
/// - where the value lies out of the range of all others, which are many, and further from the sample beside it
/// than
///   twice the largest of all other steps (-999);
/// - at the end of a response with noise: where 32 samples before it have white noise of two steps of the converter
///   or more, and the last is more than two steps away. Rest has noise, or the last swings are of one step. A tone
///   of fewer than four samples a turn looks like noise; what is cut where it stops at once is its rest;
/// - at the end of a displacement or an angle: where the step into it is larger than all changes of step of 32
///   samples before it, and two steps of the converter. A velocity that goes to zero continuously leaves half a
///   change of step at most, acceleration times sampling time squared.
/// The last two only where chance does not explain it (chance_of_repeat, false alarm of one end) and other samples
/// do not repeat the value (a range's end). Rest before the motion stays. An excitation may be switched off, and
/// hold any value it has: of it the first counts alone, and neither for zero nor for a value of both ends. A whole
/// channel of one value is left as it is.
RecordedSpan recorded_span(std::span<const double> samples, const Channel& channel, double false_alarm);

/// Samples of a record that are left at least where ends are cut off: they tell a few more (fill_gaps).
inline constexpr std::size_t fewest_recorded = 256;

struct CutEnds {
  std::size_t first = 0, rows = 0;  ///< how many came first, and how many are gone
  std::vector<Unrecorded> unrecorded;
};

/// Ends a record where the first channel ends, begins it where the last one begins: takes rows off both ends of the
/// stamps and of all channels, before missing samples are filled. At most longest_filled samples of a channel
/// become missing ones (NaN) instead. Nothing where fewer than fewest_recorded rows would be left.
CutEnds cut_unrecorded(const Campaign& campaign, std::vector<double>& stamps,
                       std::vector<std::vector<double>>& channels);

/// The record from one of its samples on, so many samples of it: their places keep their meaning.
void cut_record(Record& record, std::size_t first, std::size_t count);

}  // namespace secular
