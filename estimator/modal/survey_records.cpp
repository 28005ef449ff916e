#include "estimator/modal/survey_records.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "estimator/modal/decimation.hpp"
#include "input/input_error.hpp"

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

// The responses between --from and --to, and the record time of the first row.
struct Part {
  MatrixXd responses;
  Eigen::VectorXd force;
  double start_s = 0, rate = 0;
};

Part part_of(const ModalSurvey& survey, const RecordEntry& entry, std::optional<std::size_t> force) {
  const Record record = read_record(survey.campaign, entry);
  const auto samples = static_cast<Index>(record.samples());
  const auto index_of = [&](double time) {
    const double i = std::ceil((time - record.start_s) * record.sample_rate_hz - 1e-6);
    return static_cast<Index>(std::clamp(i, 0.0, static_cast<double>(samples)));
  };
  const Index first = index_of(survey.options.from_s), last = index_of(survey.options.to_s);
  if (last - first < 64)
    throw InputError((survey.campaign.folder / entry.file).string(), "",
                     fmt::format("has {} samples between --from and --to", last - first),
                     "a modal survey needs 64 or more");
  Part part;
  part.rate = record.sample_rate_hz;
  part.start_s = record.start_s + static_cast<double>(first) / part.rate;
  const auto column = [&](std::size_t channel) {
    return Eigen::Map<const Eigen::VectorXd>(record.channels[channel].data(), samples).segment(first, last - first);
  };
  part.responses.resize(last - first, static_cast<Index>(survey.channels.size()));
  for (std::size_t c = 0; c < survey.channels.size(); ++c)
    part.responses.col(static_cast<Index>(c)) = column(survey.channels[c]);
  if (force) part.force = column(*force);
  return part;
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

SurveyDecay decay_of(const ModalSurvey& survey, std::size_t r) {
  const RecordEntry& entry = survey.campaign.records[r];
  const Part part = part_of(survey, entry, {});
  const Index factor = decimation_factor(part.rate, survey.options.highest_hz);
  const Index begin = release(part.responses, entry.kind == RecordKind::impact, part.rate);
  const auto too_short = [&] {
    return InputError((survey.campaign.folder / entry.file).string(), "",
                      fmt::format("swings freely from {:.4g} s on, too short for this band",
                                  part.start_s + static_cast<double>(begin) / part.rate),
                      "give a longer record, an earlier --from or a higher --band");
  };
  if (begin >= part.responses.rows() || part.responses.rows() - begin < 64 * factor) throw too_short();
  const MatrixXd free = part.responses.bottomRows(part.responses.rows() - begin);
  try {
    const Decimated slow = decimate(free, part.rate, factor);
    if (slow.samples.rows() < 48) throw too_short();
    return {r, part.start_s + static_cast<double>(begin + slow.first) / part.rate, slow.samples,
            slow.sample_rate_hz};
  } catch (const std::invalid_argument&) {
    throw too_short();
  }
}

void cut_impacts(ModalSurvey& survey, const std::vector<std::size_t>& records, std::size_t force,
                 SurveyRecords& result) {
  struct Cut {
    std::string group;
    Part part;
    std::vector<Index> begins;
  };
  std::vector<Cut> cuts;
  Index length = std::numeric_limits<Index>::max();
  for (const std::size_t r : records) {
    const RecordEntry& entry = survey.campaign.records[r];
    Cut cut{entry.group.empty() ? "impacts" : entry.group, part_of(survey, entry, force), {}};
    const ImpactTimes times = find_impacts(cut.part.force, cut.part.rate, 0.5);
    const std::string file = (survey.campaign.folder / entry.file).string();
    if (times.samples.empty())
      throw InputError(file, "channel " + survey.campaign.channels[force].name, "shows no impact",
                       "leave the record out with --records, or call it free_decay");
    if (times.bounces > 0)
      survey.warnings.push_back(
          fmt::format("{}: the hammer bounced ({} more contacts)", entry.file, times.bounces));
    const auto before = std::max<Index>(10, static_cast<Index>(0.002 * cut.part.rate));
    for (const Index hit : times.samples) cut.begins.push_back(std::max<Index>(0, hit - before));
    for (std::size_t i = 0; i < cut.begins.size(); ++i) {
      const Index end = i + 1 < cut.begins.size() ? cut.begins[i + 1] : cut.part.force.size();
      length = std::min(length, end - cut.begins[i]);
    }
    result.impact_rate_hz = cut.part.rate;
    cuts.push_back(std::move(cut));
  }
  length = length / 2 * 2;
  if (length < 128)
    throw InputError(toml_of(survey), "", fmt::format("the shortest impact has {} samples", length),
                     "records of 128 samples or more after each impact");
  for (const Cut& cut : cuts) {
    auto group = std::find_if(result.impacts.begin(), result.impacts.end(),
                              [&](const SurveyImpacts& known) { return known.group == cut.group; });
    if (group == result.impacts.end())
      group = result.impacts.insert(result.impacts.end(), SurveyImpacts{cut.group, {}});
    for (const Index begin : cut.begins)
      group->blocks.push_back(
          {cut.part.force.segment(begin, length), cut.part.responses.middleRows(begin, length)});
  }
}

}  // namespace

SurveyRecords survey_records(ModalSurvey& survey) {
  choose_channels(survey);
  const Campaign& campaign = survey.campaign;
  std::optional<std::size_t> force;
  for (std::size_t c = 0; c < campaign.channels.size() && !force; ++c)
    if (campaign.channels[c].role == ChannelRole::excitation && campaign.channels[c].quantity == Quantity::force)
      force = c;
  SurveyRecords result;
  std::vector<std::size_t> struck;
  bool any = false;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (::fnmatch(survey.options.records.c_str(), entry.file.c_str(), 0) != 0) continue;
    any = true;
    if (entry.kind == RecordKind::impact && force)
      struck.push_back(r);
    else if (entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact)
      result.decays.push_back(decay_of(survey, r));
  }
  if (!any)
    throw InputError(toml_of(survey), "", "no record matches --records " + survey.options.records,
                     "a shell pattern on the files of [[record]]");
  if (struck.empty() && result.decays.empty())
    throw InputError(toml_of(survey), "[[record]]", "none of the records is of kind free_decay or impact",
                     "a modal survey needs free decays or impacts");
  if (!struck.empty()) cut_impacts(survey, struck, *force, result);
  return result;
}

}  // namespace secular
