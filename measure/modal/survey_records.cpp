#include "measure/modal/survey_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/clipping.hpp"
#include "measure/data/file_pattern.hpp"
#include "measure/data/resolution.hpp"
#include "measure/disturbances/treatment.hpp"
#include "measure/modal/decimation.hpp"
#include "measure/signal/transform_length.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

void choose_channels(ModalSurvey& survey) {
  const std::vector<Channel>& channels = survey.campaign.channels;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (channels[c].role != ChannelRole::response) continue;
    const std::string place = "channel " + channels[c].name;
    if (channels[c].quantity == Quantity::force || channels[c].quantity == Quantity::voltage)
      throw InputError(toml_of(survey), place,
                       "is a " + to_string(channels[c].quantity) + ", which has no mode shape",
                       "responses are motions: acceleration, velocity, displacement, angle, strain");
    if (!survey.channels.empty() && channels[c].quantity != channels[survey.channels.front()].quantity)
      throw InputError(toml_of(survey), place, "measures another quantity than the other responses",
                       "responses of one modal survey are all accelerations, all velocities or all displacements");
    survey.channels.push_back(c);
  }
  survey.form = response_form(channels[survey.channels.front()].quantity);
  survey.unit = channels[survey.channels.front()].unit;
}

// Rows without which a decay is too short.
constexpr Index least_rows = 48;

std::vector<Index> clipped_rows(const MatrixXd& responses) {
  std::vector<Index> rows;
  for (Index c = 0; c < responses.cols(); ++c) {
    const std::span<const double> samples(responses.col(c).data(), static_cast<std::size_t>(responses.rows()));
    if (!responses.col(c).allFinite()) continue;
    const std::vector<double> sorted = in_order(samples);
    for (const std::size_t at : find_clipping(samples, sorted, grid_of_sorted(sorted)).at)
      rows.push_back(static_cast<Index>(at));
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

// Rows in which the structure is on its own.
struct FreeRows {
  Index begin = 0, end = 0;
  bool to_the_end = false;  // of what went on up to its largest excursion
};

// How often the motion swings over from beyond -level to beyond level or back.
int swings_beyond(const Eigen::Ref<const Eigen::VectorXd>& motion, double level) {
  int count = 0, side = 0;
  for (const double x : motion) {
    const int now = x > level ? 1 : x < -level ? -1 : side;
    count += now != side && side != 0;
    side = now;
  }
  return count;
}

// Whether a motion that swings goes on up to its last row: its energy rises from quarter to quarter, or the last
// quarter holds more than all before, or each quarter swings.
bool goes_on(const Eigen::Ref<const Eigen::VectorXd>& motion, double level) {
  const Index quarter = motion.size() / 4;
  if (quarter == 0) return false;
  std::array<double, 4> energy{};
  bool steady = true, rises = true;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::VectorXd part = motion.segment(static_cast<Index>(k) * quarter, quarter);
    energy[k] = (part.array() - part.mean()).square().sum();
    steady = steady && swings_beyond(part, level) >= 2;
  }
  for (std::size_t k = 0; k < 3; ++k) rises = rises && energy[k] < energy[k + 1];
  rises = rises || energy[3] > energy[0] + energy[1] + energy[2];
  return swings_beyond(motion, level) >= 4 && (steady || rises);
}

// After the last row within 1 % of the largest excursion, and after a blow the time that the hammer stays. Where
// the motion grew up to that row and does not swing as often behind it, that growth is what the record shows.
FreeRows free_rows(const MatrixXd& responses, bool struck, double rate) {
  Index row = 0, channel = 0;
  const Eigen::RowVectorXd rest = responses.bottomRows(responses.rows() / 4).colwise().mean();
  const MatrixXd motion = responses.rowwise() - rest;
  const double largest = motion.cwiseAbs().maxCoeff(&row, &channel);
  for (Index i = row; i < responses.rows(); ++i)
    if (std::abs(motion(i, channel)) >= 0.99 * largest) row = i;
  const Eigen::VectorXd seen = motion.col(channel);
  // A tenth of the largest excursion: a decay with 5 % damping swings 14 times from one to the other.
  const double level = 0.1 * largest;
  const Index behind = responses.rows() - row - 1;
  const bool ends = behind < least_rows || swings_beyond(seen.tail(behind), level) < 8;
  if (ends && goes_on(seen.head(row + 1), level)) return {0, row + 1, true};
  return {row + 1 + (struck ? static_cast<Index>(0.01 * rate) : 0), responses.rows(), false};
}

}  // namespace

std::string toml_of(const ModalSurvey& survey) {
  return (survey.campaign.folder / "campaign.toml").string();
}

// The responses (and the force, where there is one) between --from and --to, and the record time of the first row.
struct SurveyRecords::Part {
  MatrixXd responses;
  Eigen::VectorXd force;
  double start_s = 0, rate = 0;
  std::vector<Index> clipped;  // rows in which a response is at the end of its range, rising

  // The first row behind the clipped ones from `begin` up to `end`; what is clipped is no sum of decaying motions.
  Index behind_clipped(Index begin, Index end) const {
    const auto last = std::lower_bound(clipped.begin(), clipped.end(), end);
    return last == clipped.begin() ? begin : std::max(begin, *std::prev(last) + 1);
  }
};

struct SurveyRecords::ReadParts {
  static constexpr std::size_t most_bytes = std::size_t{128} << 20;
  std::map<std::size_t, std::shared_ptr<const Part>> parts;
  std::size_t bytes = 0;

  void keep(std::size_t record, const std::shared_ptr<const Part>& part) {
    const auto more = static_cast<std::size_t>(part->responses.size() + part->force.size()) * sizeof(double);
    if (bytes + more > most_bytes) return;
    bytes += more;
    parts[record] = part;
  }
};

SurveyRecords::~SurveyRecords() = default;

SurveyRecords::SurveyRecords(ModalSurvey& survey)
    : survey_(survey),
      too_short_(ShortDecays::refused),
      reader_(survey.campaign, {}, treatments_of(survey.campaign)),
      read_(std::make_shared<ReadParts>()) {
  find_records();
}

SurveyRecords::SurveyRecords(ModalSurvey& survey, const SurveyRecords& read)
    : survey_(survey),
      too_short_(ShortDecays::left_out),
      reader_(survey.campaign, {}, treatments_of(survey.campaign)),
      read_(read.read_) {
  find_records();
}

void SurveyRecords::find_records() {
  choose_channels(survey_);
  const Campaign& campaign = survey_.campaign;
  for (std::size_t c = 0; c < campaign.channels.size() && !force_; ++c)
    if (campaign.channels[c].role == ChannelRole::excitation && campaign.channels[c].quantity == Quantity::force)
      force_ = c;
  std::vector<std::size_t> struck;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (!matches_record(survey_.options.records, entry.file)) continue;
    if (entry.kind == RecordKind::impact && force_) {
      struck.push_back(r);
    } else if (entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact) {
      keep_decay(r);
    }
  }
  if (struck.empty() && decays_.empty() && too_short_ == ShortDecays::refused)
    throw InputError(
        toml_of(survey_), "[[record]]", "none of the records is of kind free_decay or impact",
        std::any_of(campaign.records.begin(), campaign.records.end(),
                    [](const RecordEntry& entry) { return entry.row != nullptr; })
            ? "a modal survey needs free decays or impacts; of tables of lines, `secular identify` with a "
              "model that is linear tells frequency and damping"
            : "a modal survey needs free decays or impacts");
  if (!struck.empty()) find_places(struck);
}

const SurveyRecords::Part& SurveyRecords::part(std::size_t r) {
  if (part_ && part_record_ == r) return *part_;
  part_.reset();
  if (const auto known = read_->parts.find(r); known != read_->parts.end()) {
    part_ = known->second;
    part_record_ = r;
    return *part_;
  }
  const RecordEntry& entry = survey_.campaign.records[r];
  const Record record = reader_.read(r);
  const auto samples = static_cast<Index>(record.samples());
  const SpanOfSamples span =
      samples_within(survey_.options.span, record.start_s, record.sample_rate_hz, record.samples());
  const auto first = static_cast<Index>(span.first), count = static_cast<Index>(span.count);
  if (count < 64)
    throw InputError((survey_.campaign.folder / entry.file).string(), "",
                     fmt::format("has {} samples between --from and --to", count),
                     "a modal survey needs 64 or more");
  auto read = std::make_shared<Part>();
  read->rate = record.sample_rate_hz;
  read->start_s = record.start_s + static_cast<double>(first) / read->rate;
  const auto column = [&](std::size_t channel) {
    return Eigen::Map<const Eigen::VectorXd>(record.channels[channel].data(), samples).segment(first, count);
  };
  read->responses.resize(count, static_cast<Index>(survey_.channels.size()));
  for (std::size_t c = 0; c < survey_.channels.size(); ++c)
    read->responses.col(static_cast<Index>(c)) = column(survey_.channels[c]);
  if (force_) read->force = column(*force_);
  read->clipped = clipped_rows(read->responses);
  read_->keep(r, read);
  part_ = std::move(read);
  part_record_ = r;
  return *part_;
}

// Nothing where too short ones are left out.
std::optional<SurveyDecay> SurveyRecords::cut_decay(std::size_t r) {
  const RecordEntry& entry = survey_.campaign.records[r];
  const Part& whole = part(r);
  const Index factor = decimation_factor(whole.rate, survey_.options.highest_hz);
  FreeRows free = free_rows(whole.responses, entry.kind == RecordKind::impact, whole.rate);
  if (!free.to_the_end) free.begin = whole.behind_clipped(free.begin, free.end);
  const auto is_too_short = [&]() -> std::optional<SurveyDecay> {
    if (too_short_ == ShortDecays::left_out) return std::nullopt;
    throw InputError((survey_.campaign.folder / entry.file).string(), "",
                     fmt::format("swings freely from {:.4g} s to {:.4g} s, too short for this band",
                                 whole.start_s + static_cast<double>(free.begin) / whole.rate,
                                 whole.start_s + static_cast<double>(free.end) / whole.rate),
                     "give a longer record, an earlier --from or a higher --band");
  };
  if (free.end - free.begin < std::max(64 * factor, fewest_to_decimate(factor))) return is_too_short();
  Decimated slow = decimate(whole.responses.middleRows(free.begin, free.end - free.begin), whole.rate, factor);
  if (slow.samples.rows() < least_rows) return is_too_short();
  return SurveyDecay{whole.start_s + static_cast<double>(free.begin + slow.first) / whole.rate, free.to_the_end,
                     std::move(slow.samples), slow.sample_rate_hz};
}

void SurveyRecords::keep_decay(std::size_t r) {
  decay_at_.reset();
  std::optional<SurveyDecay> whole = cut_decay(r);
  part_.reset();
  if (!whole) return;
  decay_ = std::move(*whole);
  decay_at_ = decays_.size();
  const Index kept = std::min<Index>(decay_.samples.rows(), most_decay_rows);
  decays_.push_back({r, decay_.samples.rows(), decay_.sample_rate_hz, decay_.to_the_end,
                     decay_.to_the_end ? decay_.samples.bottomRows(kept) : decay_.samples.topRows(kept)});
}

const SurveyDecay& SurveyRecords::decay(std::size_t i) {
  if (decay_at_ != i) {
    decay_at_.reset();
    decay_ = {};
    decay_ = cut_decay(decays_[i].record).value();
    decay_at_ = i;
    part_.reset();
  }
  return decay_;
}

void SurveyRecords::find_places(const std::vector<std::size_t>& records) {
  Index length = std::numeric_limits<Index>::max();
  for (const std::size_t r : records) {
    const RecordEntry& entry = survey_.campaign.records[r];
    const std::string name = entry.group.empty() ? "impacts" : entry.group;
    const Part& whole = part(r);
    const ImpactTimes times = find_impacts(whole.force, whole.rate, 0.5);
    const std::string file = (survey_.campaign.folder / entry.file).string();
    if (times.samples.empty())
      throw InputError(file, "channel " + survey_.campaign.channels[*force_].name, "shows no impact",
                       "leave the record out with --records, or call it free_decay");
    if (times.bounces > 0)
      survey_.warnings.push_back(
          fmt::format("{}: the hammer bounced ({} more contacts)", entry.file, times.bounces));
    auto group = std::find_if(impacts_.begin(), impacts_.end(),
                              [&](const SurveyImpacts& known) { return known.group == name; });
    if (group == impacts_.end()) group = impacts_.insert(impacts_.end(), SurveyImpacts{name, {}});
    const auto before = std::max<Index>(10, static_cast<Index>(0.002 * whole.rate));
    for (std::size_t i = 0; i < times.samples.size(); ++i) {
      const auto begin = [&](std::size_t hit) { return std::max<Index>(0, times.samples[hit] - before); };
      const Index end = i + 1 < times.samples.size() ? begin(i + 1) : whole.force.size();
      length = std::min(length, end - begin(i));
      group->places.push_back({r, begin(i)});
      keep_swing(whole, name, begin(i), end);
    }
    impact_rate_hz_ = whole.rate;
  }
  impact_length_ = cut_transform_length(length);
  if (impact_length_ < 128)
    throw InputError(toml_of(survey_), "", fmt::format("the shortest impact has {} samples", impact_length_),
                     "records of 128 samples or more after each impact");
}

// From when the hammer has left: its force falls below a tenth of its largest value for the last time, and as long
// a time again as it was above lets the rest of it pass.
void SurveyRecords::keep_swing(const Part& part, const std::string& group, Index begin, Index end) {
  const Eigen::VectorXd force = part.force.segment(begin, end - begin).cwiseAbs();
  const double level = 0.1 * force.maxCoeff();
  Index first = force.size(), last = 0;
  for (Index i = 0; i < force.size(); ++i)
    if (force(i) >= level) {
      first = std::min(first, i);
      last = i;
    }
  const Index left = part.behind_clipped(begin + last + 1 + (last - first + 1), end);
  if (end - left < least_rows) return;
  const Index factor = decimation_factor(part.rate, survey_.options.highest_hz);
  const MatrixXd swing = part.responses.middleRows(left, end - left);
  const Decimated slow = decimate(swing, part.rate, end - left < 2 * least_rows * factor ? 1 : factor);
  const Index kept = std::min<Index>(slow.samples.rows(), most_decay_rows);
  swings_.push_back({group, slow.sample_rate_hz, slow.samples.topRows(kept)});
}

ImpactBlock SurveyRecords::impact(const ImpactPlace& place) {
  const Part& whole = part(place.record);
  return {whole.force.segment(place.begin, impact_length_),
          whole.responses.middleRows(place.begin, impact_length_)};
}

}  // namespace secular
