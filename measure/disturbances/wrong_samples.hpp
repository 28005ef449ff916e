#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "measure/disturbances/held_samples.hpp"
#include "measure/disturbances/impulses.hpp"
#include "measure/disturbances/lost_marks.hpp"

namespace secular {

/// Samples of a channel that cannot be what was measured. None is counted twice: what is lost counts as that.
struct WrongSamples {
  HeldSamples held;
  Impulses impulses;
  LostMarks marks;
  std::vector<std::size_t> foreign;  ///< of held runs, the first where it is no measured value either; rising

  bool none() const { return held.runs.empty() && impulses.spikes.empty() && marks.at.empty(); }
};

/// The first sample of a run that is held may be as wrong as the others: a value that is written while the signal
/// is gone. It is where what stands around the run tells another value (fill_gaps), by more than any sample is off
/// its neighbours (find_impulses). A spike of which what stands around it tells more than half is
/// the motion's own. Samples must be finite; false alarm of each kind on this channel.
WrongSamples find_wrong(std::span<const double> samples, const ChannelValues& values, double false_alarm);

/// Places of all held samples, and of foreign ones before them.
std::vector<std::size_t> held_places(const WrongSamples& wrong);
std::vector<std::size_t> places_of(const std::vector<Impulses::One>& impulses);

/// Places of several lists, rising, each once.
std::vector<std::size_t> in_one(std::initializer_list<std::vector<std::size_t>> lists);

}  // namespace secular
