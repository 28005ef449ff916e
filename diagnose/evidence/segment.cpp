#include "diagnose/evidence/segment.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "diagnose/evidence/record_part.hpp"
#include "diagnose/evidence/unresolved_blows.hpp"
#include "diagnose/thresholds.hpp"
#include "input/input_error.hpp"
#include "measure/data/campaign_clock.hpp"
#include "measure/data/noise_floor.hpp"
#include "measure/signal/free_decay.hpp"
#include "numerics/hertz.hpp"
#include "numerics/spread_by_size.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Samples in a turn of the highest mode that a comparison needs, and steps of integration in a turn.
constexpr auto& wanted_samples = diagnose_thresholds().wanted_samples;
constexpr auto& wanted_steps = diagnose_thresholds().wanted_steps;

/// Turns of the lowest mode in a segment: of decays, and of records that are driven.
constexpr auto& decay_turns = diagnose_thresholds().decay_turns;
constexpr auto& driven_turns = diagnose_thresholds().driven_turns;

/// Of a segment.
constexpr auto& fewest_segment_samples = diagnose_thresholds().segment_samples;

/// Of the lowest natural frequency, below which a zero moves: in a segment of six turns there are as many cosines
/// of its course as terms before them, and four and a half bins between it and the motion.
constexpr auto& zero_share = diagnose_thresholds().zero_share;

/// Into which a record's segments are dealt out in turn.
constexpr int folds_of_a_record = 10;

/// One is held out, and three tell how far they differ.
constexpr std::size_t compared_segments = 4;

/// A decay keeps so many segments whatever the others hold: its laws of the amplitude are read from them, and how
/// they repeat, which takes half as many.
Index fewest_of_a_decay() {
  return static_cast<Index>(2 * diagnose_thresholds().fewest_segments);
}

/// A decay ends where its amplitude is below this many noise levels.
constexpr auto& end_at_noise = diagnose_thresholds().end_at_noise;

/// Nothing measured is trusted beyond this share of the record's largest value.
constexpr auto& floor_share = diagnose_thresholds().trusted_share;

// The part of a record that segments are cut from.
struct Movement {
  RecordPart part;
  bool driven = false;
  double rate_hz = 0;
  Index first = 0;     // sample: of a decay, where it starts
  Index thinning = 1;  // every so many samples one is taken
  double thinned_rate() const { return rate_hz / static_cast<double>(thinning); }
  Index available() const { return (part.samples.rows() - first - 1) / thinning; }
};

class Cutter {
 public:
  Cutter(const SensorModel& sensors, const std::vector<double>& natural_frequency, const SegmentCut& cut,
         std::size_t records, std::vector<std::string>& warnings)
      : sensors_(sensors),
        cut_(cut),
        records_(static_cast<Index>(records)),
        warnings_(warnings),
        lowest_(*std::min_element(natural_frequency.begin(), natural_frequency.end())),
        highest_(*std::max_element(natural_frequency.begin(), natural_frequency.end())),
        responses_(static_cast<Index>(sensors.responses.size())),
        channels_(sensors.responses) {
    channels_.insert(channels_.end(), sensors.excitations.begin(), sensors.excitations.end());
  }

  // Nothing, with a warning that says why, of a record that cannot be used.
  std::optional<Movement> movement(const RecordEntry& entry, const Record& record) {
    Movement m{part_of(record, channels_, cut_.window), false, record.sample_rate_hz};
    if (m.part.samples.rows() < 64) return left_out(entry, "too short");
    m.driven = entry.kind == RecordKind::sweep || entry.kind == RecordKind::broadband;
    const Index inputs = m.part.samples.cols() - responses_;
    const bool excited = inputs > 0 && m.part.samples.rightCols(inputs).norm() > 0;
    if (entry.kind == RecordKind::impact && excited && !cut_.blows_as_decays) m.driven = true;
    if (m.driven && !excited) return left_out(entry, "nothing excites it");
    if (m.driven && cut_.window.band)
      throw InputError("--band", "", "cannot be applied to " + entry.file + ", which is driven",
                       "what is nonlinear answers to all of its excitation, not to what has passed; choose dwells "
                       "and free decays with --records");
    return m.driven ? m : decay(entry, std::move(m));
  }

  // Samples of a segment; 0, with a warning, where there is too little for one. They are shorter where so few would
  // be compared that nothing could be held out.
  Index length(const RecordEntry& entry, const Movement& m, std::size_t records) {
    const auto of_turns = [&](double turns) {
      return static_cast<Index>(std::ceil(turns * two_pi / lowest_ * m.thinned_rate()));
    };
    Index wanted = cut_.length == SegmentLength::whole ? m.available() : of_turns(decay_turns);
    if (cut_.length != SegmentLength::whole && m.driven)
      wanted = std::clamp<Index>(longest_of_several(records), wanted, of_turns(driven_turns));
    else if (cut_.length != SegmentLength::whole && !cut_.whole_decays)
      wanted = std::clamp<Index>(shorter_of_several(m, of_turns(1), records), of_turns(0.5 * decay_turns), wanted);
    const auto length = std::min<Index>(m.available(), std::max(fewest_segment_samples, wanted));
    if (length >= fewest_segment_samples)
      return cut_.whole_decays && !m.driven ? length_to_rest(m, length, noise(m)) : length;
    left_out(entry, "shorter than a few turns of the lowest mode");
    return 0;
  }

  // By response channel.
  Eigen::VectorXd noise(const Movement& m) const {
    Eigen::VectorXd noise(responses_);
    for (Index c = 0; c < responses_; ++c) {
      const Eigen::VectorXd channel = m.part.samples.col(c);
      const auto floor = noise_floor({channel.data(), static_cast<std::size_t>(channel.size())});
      const double largest = channel.cwiseAbs().maxCoeff();
      noise(c) = std::hypot(floor.value_or(1e-3 * largest), floor_share * largest);
    }
    return noise;
  }

  // By excitation channel. What a sweep or a blow leaves of the spectrum's upper half is noise; broadband
  // excitation may fill it.
  Eigen::VectorXd excitation_noise(const RecordEntry& entry, const Movement& m) const {
    Eigen::VectorXd noise = Eigen::VectorXd::Zero(m.part.samples.cols() - responses_);
    for (Index j = 0; m.driven && j < noise.size(); ++j) {
      const Eigen::VectorXd channel = m.part.samples.col(responses_ + j);
      const std::span<const double> samples(channel.data(), static_cast<std::size_t>(channel.size()));
      const auto floor = entry.kind == RecordKind::broadband ? flat_noise_floor(samples) : noise_floor(samples);
      noise(j) = floor.value_or(0);
    }
    return noise;
  }

  // Thinned samples at which segments begin, one after the other or, where the record holds more than its share,
  // spread over it: over a decay evenly as far as it stands out from the noise, over a record that is driven by how
  // much motion there is (a sweep passes a resonance in a small part of its time).
  std::vector<Index> starts(const Movement& m, Index length, const Eigen::VectorXd& noise,
                            const Eigen::VectorXd& excitation_noise, std::size_t records) const {
    const Index share = cut_.most_samples / static_cast<Index>(records) / length;
    std::vector<Index> starts;
    if (m.driven) {
      const std::vector<double> motion = motion_in(m, length, noise, excitation_noise);
      for (const std::size_t piece : spread_by_size(motion, static_cast<std::size_t>(std::max<Index>(1, share))))
        starts.push_back(static_cast<Index>(piece) * length);
      return starts;
    }
    const Index pieces = pieces_that_stand_out(m, length, noise),
                kept = std::min(pieces, std::max(fewest_of_a_decay(), share));
    for (Index s = 0; s < kept; ++s) starts.push_back(s * pieces / kept * length);
    return starts;
  }

  // The measured motion from one of the starts, times within `record`, and what drives it.
  Segment segment(const Movement& m, const Record& record, Index begin, Index length,
                  const Eigen::VectorXd& noise) const {
    Segment segment;
    if (cut_.whole_decays && !m.driven) segment.folds = folds_of_a_record;
    segment.sample_s = 1 / m.thinned_rate();
    segment.zeros_below_hz = zero_share * lowest_ / two_pi;
    segment.response.resize(responses_, length);
    const Index offset = m.first + begin * m.thinning;
    for (Index i = 0; i < length; ++i)
      segment.response.col(i) = m.part.samples.row(offset + i * m.thinning).head(responses_).transpose();
    const double steps = segment.folds > 1 ? std::max(wanted_steps, steps_of_whole(segment, noise)) : wanted_steps;
    segment.substeps = std::max(1, static_cast<int>(std::ceil(steps * highest_ / two_pi / m.thinned_rate())));
    segment.in_record_s =
        m.part.start_s - record.start_s + static_cast<double>(offset + length * m.thinning / 2) / m.rate_hz;
    if (m.driven) segment.excitation = excitation(m, offset, length);
    return segment;
  }

 private:
  std::nullopt_t left_out(const RecordEntry& entry, const std::string& why) {
    warnings_.push_back(entry.file + ": " + why + ", left out");
    return std::nullopt;
  }

  // Steps in a turn with which the integrator moves a frequency by a tenth of what the noise of a whole decay, and
  // of the others like it, leaves of it: docs/inference.md (60).
  double steps_of_whole(const Segment& segment, const Eigen::VectorXd& noise) const {
    constexpr double most = 1000;  // 1.3e-11 of the frequency: no sampling clock is as good
    const MatrixXd moved = segment.response.colwise() - segment.response.rowwise().mean();
    const Eigen::RowVectorXd weight = (noise.cwiseInverse().asDiagonal() * moved).colwise().squaredNorm();
    const Eigen::RowVectorXd time =
        Eigen::RowVectorXd::LinSpaced(weight.size(), 0, segment.sample_s * static_cast<double>(weight.size() - 1));
    const double sum = weight.sum(), mean = sum > 0 ? weight.dot(time) / sum : 0;
    const double information =
        static_cast<double>(records_) * (weight.array() * (time.array() - mean).square()).sum();
    return std::min(most, two_pi * std::pow(highest_ * std::sqrt(information) / 12, 0.25));
  }

  // Of a free decay: from its start on, thinned to what its modes need.
  std::optional<Movement> decay(const RecordEntry& entry, Movement m) {
    const Eigen::VectorXd modal = m.part.samples.leftCols(responses_) * sensors_.filter.row(0).transpose();
    const auto start = find_decay_start(modal, m.rate_hz);
    if (!start) return left_out(entry, "no free decay is found in it");
    m.first = cut_.window.band ? 0 : start->sample;  // what has passed a band begins at the release
    m.thinning = std::max<Index>(1, static_cast<Index>(std::floor(two_pi * m.rate_hz / highest_ / wanted_samples)));
    if (cut_.whole_decays) m.thinning = std::min(m.thinning, thinning_of_whole(m));
    return m;
  }

  // Of the samples that are compared, those of one record.
  Index share_of_a_record() const { return std::max<Index>(1, cut_.most_samples / records_); }

  // With which a decay is its share of the samples that are compared. Every sample has noise of its own: one that
  // is left out is information lost.
  Index thinning_of_whole(const Movement& m) const {
    return 1 + (m.part.samples.rows() - m.first - 1) / share_of_a_record();
  }

  // Samples of a segment, of which all records together hold as many as are compared.
  Index longest_of_several(std::size_t records) const {
    const std::size_t of_a_record = (compared_segments + records - 1) / records;
    return cut_.most_samples / static_cast<Index>(records * of_a_record);
  }

  // The same of a decay, of which little stands out from the noise; `turn`: samples of one. docs/inference.md (85).
  Index shorter_of_several(const Movement& m, Index turn, std::size_t records) const {
    const std::size_t of_a_record = (compared_segments + records - 1) / records;
    return pieces_that_stand_out(m, turn, noise(m)) * turn / static_cast<Index>(of_a_record);
  }

  auto piece_of(const Movement& m, Index length, Index piece, Index channel) const {
    return m.part.samples.col(channel)(Eigen::seqN(m.first + piece * length * m.thinning, length, m.thinning));
  }

  // From a decay's start on.
  Index pieces_that_stand_out(const Movement& m, Index length, const Eigen::VectorXd& noise) const {
    const Index pieces = m.available() / length;
    Index loud = 0;
    while (loud < pieces && piece_of(m, length, loud, 0).cwiseAbs().maxCoeff() >= end_at_noise * noise(0)) ++loud;
    return loud;
  }

  // Samples of a decay in one piece, of which `length` are a few turns: to the end of the last few that hold more
  // than noise (chi-squared at three standard deviations), and a few turns more, which tell where it came to rest.
  // A model that holds tells the motion far below the noise of one sample. No more than the record's share.
  Index length_to_rest(const Movement& m, Index length, const Eigen::VectorXd& noise) const {
    const double most = 1 + 3 * std::sqrt(2 / static_cast<double>(length));
    const Index pieces = m.available() / length;
    Index held = 0;
    for (; held < pieces; ++held) {
      const Eigen::VectorXd piece = piece_of(m, length, held, 0);
      if (!((piece.array() - piece.mean()).square().mean() > most * noise(0) * noise(0))) break;
    }
    const Index wanted = held + 1 < pieces ? (held + 1) * length : m.available();
    return std::min(wanted, std::max(length, share_of_a_record()));
  }

  // By piece, the square of the motion over that of what it is known to (docs/inference.md (40)): of its own noise
  // and of what white noise in the reading of what drives makes at a resonance. About the mean of each: a zero may
  // wander.
  std::vector<double> motion_in(const Movement& m, Index length, const Eigen::VectorXd& noise,
                                const Eigen::VectorXd& excitation_noise) const {
    std::vector<double> motion(static_cast<std::size_t>(m.available() / length));
    const double of_excitation = 2 * noise_share(m, excitation_noise) / static_cast<double>(length);
    for (Index c = 0; c < responses_; ++c)
      for (std::size_t p = 0; p < motion.size(); ++p) {
        const Eigen::VectorXd piece = piece_of(m, length, static_cast<Index>(p), c);
        const double square = (piece.array() - piece.mean()).square().mean() / (noise(c) * noise(c));
        motion[p] += square / (1 + of_excitation * square);
      }
    return motion;
  }

  // Of the excitations' variance: what moves with it is known no better.
  double noise_share(const Movement& m, const Eigen::VectorXd& excitation_noise) const {
    const MatrixXd inputs = m.part.samples.rightCols(excitation_noise.size());
    const double all = (inputs.rowwise() - inputs.colwise().mean()).squaredNorm();
    return all > 0 ? std::min(1.0, excitation_noise.squaredNorm() * static_cast<double>(inputs.rows()) / all) : 0;
  }

  MatrixXd excitation(const Movement& m, Index offset, Index length) const {
    constexpr Index beside = half_sample_reach - 1;  // more on either side, for the interpolation
    const MatrixXd& samples = m.part.samples;
    MatrixXd around(samples.cols() - responses_, length + 2 * beside);
    for (Index i = 0; i < around.cols(); ++i)
      around.col(i) =
          samples.row(std::clamp<Index>(offset + i - beside, 0, samples.rows() - 1)).tail(around.rows());
    return at_half_samples(around).middleCols(2 * beside, 2 * length - 1);
  }

  const SensorModel& sensors_;
  const SegmentCut& cut_;
  Index records_;
  std::vector<std::string>& warnings_;
  double lowest_, highest_;
  Index responses_;
  std::vector<std::size_t> channels_;
};

// A tone in a reading of the excitation that the structure does not feel moves the computed motion: to first order
// by a tone of that frequency in every response, from any state.
std::vector<ForeignTone> tones_in(const SensorModel& sensors, const std::vector<ForeignTone>& of_record) {
  std::vector<ForeignTone> tones;
  for (const ForeignTone& tone : of_record) {
    const auto& excitations = sensors.excitations;
    const bool of_all = std::find(excitations.begin(), excitations.end(), tone.channel) != excitations.end();
    for (std::size_t c = 0; c < sensors.responses.size(); ++c)
      if (of_all || sensors.responses[c] == tone.channel) tones.push_back({c, tone.frequency, tone.rate});
  }
  return tones;
}

std::vector<ColouredNoise> coloured_in(const SensorModel& sensors, const std::vector<ColouredNoise>& of_record,
                                       const Eigen::VectorXd& floor) {
  std::vector<ColouredNoise> noises;
  for (const ColouredNoise& noise : of_record)
    for (std::size_t c = 0; c < sensors.responses.size(); ++c)
      if (sensors.responses[c] == noise.channel)
        noises.push_back({c, noise.sd / floor(static_cast<Index>(c)), noise.time_s,
                          noise.white_sd / floor(static_cast<Index>(c))});
  return noises;
}

}  // namespace

MatrixXd at_half_samples(const MatrixXd& samples) {
  const Index count = samples.cols();
  MatrixXd all(samples.rows(), 2 * count - 1);
  const auto at = [&](Index i) { return samples.col(std::clamp<Index>(i, 0, count - 1)); };
  for (Index i = 0; i < count; ++i) {
    all.col(2 * i) = at(i);
    if (i + 1 < count)
      all.col(2 * i + 1) =
          (39690 * (at(i) + at(i + 1)) - 8820 * (at(i - 1) + at(i + 2)) + 2268 * (at(i - 2) + at(i + 3)) -
           405 * (at(i - 3) + at(i + 4)) + 35 * (at(i - 4) + at(i + 5))) /
          65536;
  }
  return all;
}

std::vector<Segment> cut_segments(const Campaign& campaign, const RecordReader& read, const SensorModel& sensors,
                                  const std::vector<double>& natural_frequency, const SegmentCut& cut,
                                  std::vector<std::string>& warnings) {
  std::vector<std::size_t> records;
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    if (!is_steady(campaign.records[r].kind) && cut.window.takes(r, campaign.records[r].file)) records.push_back(r);
  const std::vector<double> began = record_times(campaign);
  Cutter cutter(sensors, natural_frequency, cut, records.size(), warnings);
  std::vector<Segment> segments;
  for (const std::size_t r : records) {
    const RecordEntry& entry = campaign.records[r];
    const Record record = read(r);
    const std::optional<Movement> movement = cutter.movement(entry, record);
    const Index length = movement ? cutter.length(entry, *movement, records.size()) : 0;
    if (length == 0) continue;
    const Eigen::VectorXd noise = cutter.noise(*movement),
                          excitation_noise = cutter.excitation_noise(entry, *movement);
    int number = 0;
    for (const Index begin : cutter.starts(*movement, length, noise, excitation_noise, records.size())) {
      Segment segment = cutter.segment(*movement, record, begin, length, noise);
      segment.record = r;
      segment.fold = static_cast<int>(r) + fold_step * (1 + number++ % folds_of_a_record);
      segment.time_s = began[r] + segment.in_record_s;
      segment.noise_sd = noise;
      segment.excitation_noise_sd = excitation_noise;
      for (std::size_t c = 0; c < sensors.responses.size(); ++c)
        if (cut.wandering.contains(sensors.responses[c])) segment.wandering.push_back(static_cast<Index>(c));
      if (const auto tones = cut.tones.find(r); tones != cut.tones.end())
        segment.tones = tones_in(sensors, tones->second);
      if (const auto noises = cut.coloured.find(r); noises != cut.coloured.end())
        segment.coloured = coloured_in(sensors, noises->second, noise);
      if (cut.skips_blows && entry.kind == RecordKind::impact && movement->driven)
        segment.uncompared = samples_of_blow(segment);
      // What is taken off is seen by no row, and a state is found without it.
      for (const Index c : segment.wandering) segment.response.row(c).array() -= segment.response.row(c).mean();
      segments.push_back(std::move(segment));
    }
  }
  return segments;
}

}  // namespace secular
