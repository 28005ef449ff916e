#include "diagnose/evidence/segment.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "diagnose/evidence/campaign_clock.hpp"
#include "diagnose/evidence/record_window.hpp"
#include "input/input_error.hpp"
#include "measure/data/noise_floor.hpp"
#include "measure/signal/free_decay.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Samples in a turn of the highest mode that a comparison needs, and steps of integration in a turn.
constexpr double wanted_samples = 24, wanted_steps = 60;

/// Turns of the lowest mode in a segment: of decays, and of records that are driven.
constexpr double decay_turns = 6, driven_turns = 40;

/// Of a segment.
constexpr Index fewest_samples = 48;

/// A decay ends where its amplitude is below this many noise levels.
constexpr double end_at_noise = 8;

/// Nothing measured is trusted beyond this share of the record's largest value.
constexpr double floor_share = 1e-5;

}  // namespace

std::vector<Segment> cut_segments(const Campaign& campaign, const RecordReader& read, const SensorModel& sensors,
                                  const std::vector<double>& natural_frequency, const SegmentCut& cut,
                                  std::vector<std::string>& warnings) {
  const double lowest = *std::min_element(natural_frequency.begin(), natural_frequency.end());
  const double highest = *std::max_element(natural_frequency.begin(), natural_frequency.end());
  std::vector<std::size_t> channels = sensors.responses;
  channels.insert(channels.end(), sensors.excitations.begin(), sensors.excitations.end());
  const auto responses = static_cast<Index>(sensors.responses.size());
  std::vector<std::size_t> records;
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    if (campaign.records[r].kind != RecordKind::dwell &&
        matches_pattern(cut.window.records, campaign.records[r].file))
      records.push_back(r);
  const std::vector<double> began = record_times(campaign);
  std::vector<Segment> segments;
  for (const std::size_t r : records) {
    const RecordEntry& entry = campaign.records[r];
    const Record record = read(r);
    RecordPart part = part_of(record, channels, cut.window);
    if (part.samples.rows() < 64) {
      warnings.push_back(entry.file + ": too short, left out");
      continue;
    }
    bool driven = entry.kind == RecordKind::sweep || entry.kind == RecordKind::broadband;
    const bool excited =
        part.samples.cols() > responses && part.samples.rightCols(part.samples.cols() - responses).norm() > 0;
    if (entry.kind == RecordKind::impact && excited) driven = true;
    if (driven && !excited) {
      warnings.push_back(entry.file + ": nothing excites it, left out");
      continue;
    }
    if (driven && cut.band)
      throw InputError("--band", "", "cannot be applied to " + entry.file + ", which is driven",
                       "only free decays are filtered; choose them with --records");
    const double rate = record.sample_rate_hz;
    const Eigen::VectorXd modal = part.samples.leftCols(responses) * sensors.filter.row(0).transpose();
    Index first = 0;
    if (!driven) {
      const auto start = find_decay_start(modal, rate);
      if (!start) {
        warnings.push_back(entry.file + ": no free decay is found in it, left out");
        continue;
      }
      first = start->sample;
      if (cut.band) {
        // Sample i of what has passed is sample i + reach of the record: free of what was before the decay's start
        // from the sample with the start's own number on.
        if (!(cut.band->high_hz < rate / 2))
          throw InputError("--band", "", "ends above half the sample rate of " + entry.file,
                           fmt::format("below {:.6g} Hz there", rate / 2));
        part.samples = band_pass(part.samples, rate, *cut.band);
        part.start_s += static_cast<double>(band_pass_reach(*cut.band, rate)) / rate;
        if (part.samples.rows() <= first + fewest_samples) {
          warnings.push_back(entry.file + ": shorter than the response of the band's filter, left out");
          continue;
        }
      }
    }
    const auto thinning =
        driven ? Index{1}
               : std::max<Index>(1, static_cast<Index>(std::floor(two_pi * rate / highest / wanted_samples)));
    const double thinned_rate = rate / static_cast<double>(thinning);
    const Index available = (part.samples.rows() - first - 1) / thinning;
    const double turns = driven ? driven_turns : decay_turns;
    const Index wanted = cut.length == SegmentLength::whole
                             ? available
                             : static_cast<Index>(std::ceil(turns * two_pi / lowest * thinned_rate));
    const auto length = std::min<Index>(available, std::max(fewest_samples, wanted));
    if (length < fewest_samples) {
      warnings.push_back(entry.file + ": shorter than a few turns of the lowest mode, left out");
      continue;
    }
    Eigen::VectorXd noise(responses);
    for (Index c = 0; c < responses; ++c) {
      const Eigen::VectorXd channel = part.samples.col(c);
      const auto floor = noise_floor({channel.data(), static_cast<std::size_t>(channel.size())});
      const double largest = channel.cwiseAbs().maxCoeff();
      noise(c) = std::hypot(floor.value_or(1e-3 * largest), floor_share * largest);
    }
    Index pieces = available / length;
    const Index share = std::max<Index>(1, cut.most_samples / static_cast<Index>(records.size()) / length);
    std::vector<Index> starts;
    if (driven && pieces > share)
      for (Index s = 0; s < share; ++s) starts.push_back(s * pieces / share * length);
    else
      for (Index s = 0; s < pieces; ++s) starts.push_back(s * length);
    int number = 0;
    for (const Index begin : starts) {
      Segment segment;
      segment.record = r;
      segment.fold = static_cast<int>(r) + 1000 * (1 + number++ % 10);
      segment.sample_s = 1 / thinned_rate;
      segment.substeps = std::max(1, static_cast<int>(std::ceil(wanted_steps * highest / two_pi / thinned_rate)));
      segment.response.resize(responses, length);
      segment.noise_sd = noise;
      const Index offset = first + begin * thinning;
      for (Index i = 0; i < length; ++i)
        segment.response.col(i) = part.samples.row(offset + i * thinning).head(responses).transpose();
      segment.in_record_s =
          part.start_s - record.start_s + static_cast<double>(offset + length * thinning / 2) / rate;
      segment.time_s = began[r] + segment.in_record_s;
      if (!driven && segment.response.row(0).cwiseAbs().maxCoeff() < end_at_noise * noise(0)) break;
      if (driven) {
        // Half samples: cubic interpolation of the measured excitation.
        const Index inputs = part.samples.cols() - responses;
        segment.excitation.resize(inputs, 2 * length - 1);
        const auto at = [&](Index i, Index j) {
          return part.samples(std::clamp<Index>(i, 0, part.samples.rows() - 1), responses + j);
        };
        for (Index j = 0; j < inputs; ++j)
          for (Index i = 0; i < length; ++i) {
            segment.excitation(j, 2 * i) = at(offset + i, j);
            if (i + 1 < length)
              segment.excitation(j, 2 * i + 1) = (9 * (at(offset + i, j) + at(offset + i + 1, j)) -
                                                  at(offset + i - 1, j) - at(offset + i + 2, j)) /
                                                 16;
          }
      }
      segments.push_back(std::move(segment));
    }
  }
  return segments;
}

}  // namespace secular
