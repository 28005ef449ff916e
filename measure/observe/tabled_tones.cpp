#include "measure/observe/tabled_tones.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "estimator/model/block_frequency.hpp"
#include "estimator/model/zero_frequency.hpp"
#include "estimator/thresholds.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Ratios of frequencies that are one: rounding of what they are computed from.
constexpr double same_ratio = 1e-9;

/// From which a scatter says more of a standard deviation than its order.
constexpr auto& fewest_degrees = estimator_thresholds().fewest_freedom;

}  // namespace

TabledTones::TabledTones(const LineRow& row, const Case& of, const std::vector<double>& excitation,
                         const std::vector<std::size_t>& channels, const Window& window)
    : row_(row),
      resonance_(of.resonance),
      excitation_(excitation.front()),
      channels_(channels),
      window_(window),
      mode_frequency_(of.modes.observed(Eigen::VectorXd(0), excitation)) {
  for (const RegressorBlock& block : of.resonance.blocks)
    block_frequency_.push_back(block_frequency(block, [&](std::size_t i) {
      return i < of.model.modes() ? mode_frequency_(static_cast<Index>(i)) : excitation[i - of.model.modes()];
    }));
  std::vector<double> needed;
  for (std::size_t k = 0; k < of.model.modes(); ++k)
    if (of.modes.oscillates[k]) needed.push_back(frequency_of_mode(k));
  for (const TableLine& line : row.lines) {
    const bool response = std::find(channels.begin(), channels.end(), line.channel) != channels.end();
    const bool used = std::any_of(needed.begin(), needed.end(), [&](double f) {
      return std::abs(line.number.of(excitation_) - f) < same_ratio * f;
    });
    if (response && used && !row.sd_of(line.channel, line.number)) noise_known_ = false;
  }
}

std::optional<TabledTones::Line> TabledTones::of_block(std::size_t block) const {
  return is_zero_frequency(resonance_.blocks[block]) ? at(0) : at(std::abs(frequency_of_block(block)));
}

std::optional<TabledTones::Line> TabledTones::at(double frequency) const {
  if (!window_.passes(frequency)) return std::nullopt;
  Line found{Eigen::RowVectorXcd(static_cast<Index>(channels_.size())),
             Eigen::RowVectorXd(static_cast<Index>(channels_.size()))};
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const auto line = std::find_if(row_.lines.begin(), row_.lines.end(), [&](const TableLine& l) {
      return l.channel == channels_[c] &&
             std::abs(l.number.of(excitation_) - frequency) <= same_ratio * excitation_;
    });
    if (line == row_.lines.end()) return std::nullopt;
    const double share = line->number.is_mean() ? 1 : 0.5;
    found.amplitude(static_cast<Index>(c)) = share * line->amplitude;
    found.sd(static_cast<Index>(c)) =
        noise_known_ ? share * row_.sd_of(line->channel, line->number).value_or(0) : 0;
  }
  return found;
}

void share_conditions(const Campaign& campaign, const std::vector<std::size_t>& dwells,
                      std::vector<ObservationSet>& sets) {
  std::map<std::pair<std::string, long long>, int> first;
  for (std::size_t i = 0; i < dwells.size(); ++i) {
    const auto& row = campaign.records[dwells[i]].row;
    if (!row || !row->condition || sets[i].observations.empty()) continue;
    const auto at = first.try_emplace({row->table, *row->condition}, static_cast<int>(i)).first;
    for (Observation& o : sets[i].observations) o.condition = at->second;
  }
}

void noise_from_repeats(ObservationSet& set) {
  std::map<int, std::vector<Observation*>> conditions;
  for (Observation& o : set.observations)
    if (!o.noise_known) conditions[o.condition].push_back(&o);
  if (conditions.empty()) return;
  // By the phase of the excitation, against which a row's phases are; a line of another part of it keeps its own.
  const std::size_t modes = set.model->modes(), blocks = set.resonance->blocks.size();
  std::vector<double> squares(modes, 0.0), of_blocks(blocks, 0.0), of_blocks_freedom(blocks, 0.0);
  double freedom = 0;
  const auto scatter = [](const std::vector<Complex>& values) {
    Complex mean = 0;
    for (const Complex& value : values) mean += value / static_cast<double>(values.size());
    double sum = 0;
    for (const Complex& value : values) sum += std::norm(value - mean);
    return sum;
  };
  for (const auto& [label, members] : conditions) {
    if (members.size() < 2) continue;
    const auto n = static_cast<double>(members.size());
    freedom += 2 * (n - 1);
    for (std::size_t k = 0; k < modes; ++k) {
      std::vector<Complex> values;
      for (const Observation* o : members) values.push_back(o->amplitude[k]);
      squares[k] += scatter(values);
    }
    for (std::size_t b = 0; b < blocks; ++b) {
      std::vector<Complex> values;
      for (const Observation* o : members)
        if (o->harmonic_sd[b] >= 0) values.push_back(o->harmonic[b]);
      if (values.size() != members.size()) continue;
      of_blocks[b] += scatter(values);
      of_blocks_freedom[b] += (is_zero_frequency(set.resonance->blocks[b]) ? 1 : 2) * (n - 1);
    }
  }
  if (freedom < fewest_degrees) return;
  for (auto& [label, members] : conditions)
    for (Observation* o : members) {
      for (std::size_t k = 0; k < modes; ++k) o->amplitude_sd[k] = std::sqrt(squares[k] / freedom);
      for (std::size_t b = 0; b < blocks; ++b)
        if (o->harmonic_sd[b] >= 0)
          o->harmonic_sd[b] =
              of_blocks_freedom[b] < fewest_degrees ? -1 : std::sqrt(of_blocks[b] / of_blocks_freedom[b]);
      o->noise_known = true;
    }
}

}  // namespace secular
