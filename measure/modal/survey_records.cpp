#include "measure/modal/survey_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "input/input_error.hpp"
#include "measure/data/file_pattern.hpp"
#include "measure/modal/decimation.hpp"
#include "measure/signal/transform_length.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::string toml_of(const ModalSurvey& survey) {
  return (survey.campaign.folder / "campaign.toml").string();
}

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

// Rows of a decay that the Hankel matrix can take: its beginning, where every mode still moves.
Index realization_samples(Index channels, const ModalSurveyOptions& options) {
  return 4000 / channels + 2 * options.largest_order;
}

// First row after which the structure is on its own: the last one within 1 % of the largest excursion, and after a
// blow the time that the hammer stays.
Index release(const MatrixXd& responses, bool struck, double rate) {
  Index row = 0, channel = 0;
  const Eigen::RowVectorXd rest = responses.bottomRows(responses.rows() / 4).colwise().mean();
  const MatrixXd excursion = (responses.rowwise() - rest).cwiseAbs();
  const double largest = excursion.maxCoeff(&row, &channel);
  for (Index i = row; i < responses.rows(); ++i)
    if (excursion(i, channel) >= 0.99 * largest) row = i;
  return row + 1 + (struck ? static_cast<Index>(0.01 * rate) : 0);
}

}  // namespace

// The responses (and the force, where there is one) between --from and --to, and the record time of the first row.
struct SurveyRecords::Part {
  MatrixXd responses;
  Eigen::VectorXd force;
  double start_s = 0, rate = 0;
};

SurveyRecords::~SurveyRecords() = default;

SurveyRecords::SurveyRecords(ModalSurvey& survey) : survey_(survey) {
  choose_channels(survey);
  const Campaign& campaign = survey.campaign;
  for (std::size_t c = 0; c < campaign.channels.size() && !force_; ++c)
    if (campaign.channels[c].role == ChannelRole::excitation && campaign.channels[c].quantity == Quantity::force)
      force_ = c;
  std::vector<std::size_t> struck;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (!matches_pattern(survey.options.records, entry.file)) continue;
    if (entry.kind == RecordKind::impact && force_) {
      struck.push_back(r);
    } else if (entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact) {
      decays_.push_back({r, 0, 0, {}});
      const SurveyDecay& whole = decay(decays_.size() - 1);
      const Index kept =
          std::min<Index>(whole.samples.rows(), realization_samples(whole.samples.cols(), survey.options));
      decays_.back() = {r, whole.samples.rows(), whole.sample_rate_hz, whole.samples.topRows(kept)};
    }
  }
  if (struck.empty() && decays_.empty())
    throw InputError(toml_of(survey), "[[record]]", "none of the records is of kind free_decay or impact",
                     "a modal survey needs free decays or impacts");
  if (!struck.empty()) find_places(struck);
}

const SurveyRecords::Part& SurveyRecords::part(std::size_t r) {
  if (part_ && part_record_ == r) return *part_;
  part_.reset();
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
  auto read = std::make_unique<Part>();
  read->rate = record.sample_rate_hz;
  read->start_s = record.start_s + static_cast<double>(first) / read->rate;
  const auto column = [&](std::size_t channel) {
    return Eigen::Map<const Eigen::VectorXd>(record.channels[channel].data(), samples).segment(first, count);
  };
  read->responses.resize(count, static_cast<Index>(survey_.channels.size()));
  for (std::size_t c = 0; c < survey_.channels.size(); ++c)
    read->responses.col(static_cast<Index>(c)) = column(survey_.channels[c]);
  if (force_) read->force = column(*force_);
  part_ = std::move(read);
  part_record_ = r;
  return *part_;
}

SurveyDecay SurveyRecords::cut_decay(std::size_t r) {
  const RecordEntry& entry = survey_.campaign.records[r];
  const Part& whole = part(r);
  const Index factor = decimation_factor(whole.rate, survey_.options.highest_hz);
  const Index begin = release(whole.responses, entry.kind == RecordKind::impact, whole.rate);
  const auto too_short = [&] {
    return InputError((survey_.campaign.folder / entry.file).string(), "",
                      fmt::format("swings freely from {:.4g} s on, too short for this band",
                                  whole.start_s + static_cast<double>(begin) / whole.rate),
                      "give a longer record, an earlier --from or a higher --band");
  };
  if (begin >= whole.responses.rows() || whole.responses.rows() - begin < 64 * factor) throw too_short();
  try {
    Decimated slow = decimate(whole.responses.bottomRows(whole.responses.rows() - begin), whole.rate, factor);
    if (slow.samples.rows() < 48) throw too_short();
    return {whole.start_s + static_cast<double>(begin + slow.first) / whole.rate, std::move(slow.samples),
            slow.sample_rate_hz};
  } catch (const std::invalid_argument&) {
    throw too_short();
  }
}

const SurveyDecay& SurveyRecords::decay(std::size_t i) {
  if (decay_at_ != i) {
    decay_at_.reset();
    decay_ = {};
    decay_ = cut_decay(decays_[i].record);
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
    }
    impact_rate_hz_ = whole.rate;
  }
  impact_length_ = cut_transform_length(length);
  if (impact_length_ < 128)
    throw InputError(toml_of(survey_), "", fmt::format("the shortest impact has {} samples", impact_length_),
                     "records of 128 samples or more after each impact");
}

ImpactBlock SurveyRecords::impact(const ImpactPlace& place) {
  const Part& whole = part(place.record);
  return {whole.force.segment(place.begin, impact_length_),
          whole.responses.middleRows(place.begin, impact_length_)};
}

}  // namespace secular
