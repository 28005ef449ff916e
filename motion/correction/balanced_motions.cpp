#include "motion/correction/balanced_motions.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "motion/thresholds.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// A motion with a line beside the modes' own and the mean that is larger than these times the largest line that
/// was measured, or whose amplitudes would change by more than the second of themselves in a radian, is none that
/// was measured. (What an excitation drives directly may be any number of times larger than a super- or
/// subharmonic.)
constexpr auto& largest_line = motion_thresholds().largest_line;
constexpr auto& largest_excess = motion_thresholds().largest_excess;

/// Highest line by the highest one on which a mode or a force is; and points of a turn.
constexpr int multiples_of_one = 8, multiples_of_two = 3;
constexpr Index points_by_line = 4;

bool at_rest(const LinePhase& phase) {
  return phase == LinePhase{};
}

}  // namespace

BalancedMotions::BalancedMotions(const CompiledModel& model, const CompiledCase& resonance)
    : model_(model), resonance_(resonance), base_(base_phases(model, resonance)) {
  if (!base_) return;
  const int highest = base_->highest() * (base_->dimensions() == 1 ? multiples_of_one : multiples_of_two);
  torus_ = std::make_shared<const Torus>(base_->dimensions(), highest, points_by_line * highest);
}

std::optional<BalancedMotions::SignedLine> BalancedMotions::find(const LinePhase& phase) const {
  if (const auto line = torus_->find(phase)) return SignedLine{*line, false};
  if (const auto line = torus_->find({-phase[0], -phase[1]})) return SignedLine{*line, true};
  return std::nullopt;
}

std::optional<BalancedMotions::Balanced> BalancedMotions::at(const Eigen::VectorXd& parameters,
                                                             const Observation& o, const Motion* start) const {
  std::optional<Balanced> result = in_balance(parameters, o, start);
  if (result && !is_near_what_was_measured(*result, o)) result.reset();
  return result;
}

std::optional<BalancedMotions::Balanced> BalancedMotions::in_balance(const Eigen::VectorXd& parameters,
                                                                     const Observation& o,
                                                                     const Motion* start) const {
  if (!base_) return std::nullopt;
  return balance(parameters, o, setting_of(o), start);
}

std::optional<BalancedMotions::Balanced> BalancedMotions::under_all_lines(const Eigen::VectorXd& parameters,
                                                                          const Observation& o,
                                                                          const Motion* start) const {
  if (!base_) return std::nullopt;
  MotionSetting setting = setting_of(o);
  for (std::size_t b = 0; b < o.forcing_harmonic.size(); ++b) {
    if (!(o.forcing_harmonic_sd[b] >= 0)) continue;
    // Blocks of several modes share a line.
    if (const auto line = line_of(resonance_.blocks[b].phase))
      setting.excitation(0, line->line) = 0.5 * line->of(o.forcing_harmonic[b]);
  }
  return balance(parameters, o, std::move(setting), start);
}

MotionSetting BalancedMotions::setting_of(const Observation& o) const {
  MotionSetting setting;
  setting.torus = torus_;
  const std::vector<Complex> rates = base_->rates(o);
  for (std::size_t j = 0; j < rates.size(); ++j) setting.rate[j] = rates[j];
  setting.excitation = Eigen::MatrixXcd::Zero(static_cast<Index>(model_.excitations.size()), torus_->lines());
  for (std::size_t j = 0; j < base_->excitation.size(); ++j) {
    const SignedLine line = find(base_->excitation[j]).value();
    setting.excitation(static_cast<Index>(j), line.line) = 0.5 * line.of(o.forcing[j]);  // half of the peak
  }
  return setting;
}

std::optional<BalancedMotions::Balanced> BalancedMotions::balance(const Eigen::VectorXd& parameters,
                                                                  const Observation& o, MotionSetting setting,
                                                                  const Motion* start) const {
  Balanced result{std::move(setting), {}};
  std::vector<Complex> amplitudes;
  for (std::size_t k = 0; k < model_.modes(); ++k) {
    if (at_rest(base_->mode[k])) continue;
    const SignedLine line = find(base_->mode[k]).value();
    result.setting.masters.push_back({k, line.line});
    amplitudes.push_back(line.of(o.amplitude[k]));
  }
  result.motion =
      MotionBalance(model_, {})
          .solve(result.setting,
                 Eigen::Map<const Eigen::VectorXcd>(amplitudes.data(), static_cast<Index>(amplitudes.size())),
                 std::span(parameters.data(), static_cast<std::size_t>(parameters.size())), start);
  if (!result.motion.converged()) return std::nullopt;
  return result;
}

bool BalancedMotions::is_near_what_was_measured(const Balanced& balanced, const Observation& o) const {
  const std::vector<MasterLine>& masters = balanced.setting.masters;
  Eigen::MatrixXd lines = balanced.motion.displacement.cwiseAbs();
  double seen = 0;
  for (const MasterLine& m : masters) {
    double& line = lines(static_cast<Index>(m.mode), m.line);
    seen = std::max(seen, std::exchange(line, 0));
  }
  for (std::size_t b = 0; b < o.harmonic.size(); ++b)
    if (o.harmonic_sd[b] >= 0) seen = std::max(seen, std::abs(o.harmonic[b]));
  if (!(lines.rightCols(lines.cols() - 1).maxCoeff() <= largest_line * seen)) return false;
  return std::all_of(masters.begin(), masters.end(), [&](const MasterLine& m) {
    return std::abs(excess_rate(m.mode, balanced)) <= largest_excess * std::abs(balanced.setting.line_rate(m.line));
  });
}

const MasterLine* BalancedMotions::master(std::size_t mode, const Balanced& balanced) const {
  const std::vector<MasterLine>& all = balanced.setting.masters;
  const auto found = std::find_if(all.begin(), all.end(), [&](const MasterLine& m) { return m.mode == mode; });
  return found == all.end() ? nullptr : &*found;
}

Complex BalancedMotions::excess_rate(std::size_t mode, const Balanced& balanced) const {
  const MasterLine* line = master(mode, balanced);
  if (!line) return 0;
  const Complex amplitude = balanced.motion.displacement(static_cast<Index>(mode), line->line);
  if (amplitude == Complex(0)) return 0;
  const Complex left = balanced.motion.balance(line - balanced.setting.masters.data());
  return find(base_->mode[mode]).value().of(left / (2.0 * balanced.setting.line_rate(line->line) * amplitude));
}

std::optional<Complex> BalancedMotions::rate_of(std::size_t mode, const Balanced& balanced) const {
  const MasterLine* line = master(mode, balanced);
  if (!line) return std::nullopt;
  return find(base_->mode[mode]).value().of(balanced.setting.line_rate(line->line)) + excess_rate(mode, balanced);
}

std::optional<BalancedMotions::SignedLine> BalancedMotions::line_of(std::span<const int> phase) const {
  LinePhase sum{};
  for (std::size_t i = 0; i < phase.size(); ++i) {
    const bool of_mode = i < base_->mode.size();
    if (phase[i] == 0 || (!of_mode && base_->excitation.empty())) continue;  // a decay has no excitation's phase
    const LinePhase& one = of_mode ? base_->mode[i] : base_->excitation[i - base_->mode.size()];
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += phase[i] * one[j];
  }
  return find(sum);
}

std::optional<Complex> BalancedMotions::amplitude_of(std::size_t mode, std::span<const int> phase,
                                                     const Balanced& balanced) const {
  const auto line = line_of(phase);
  if (!line) return std::nullopt;
  return line->of(balanced.motion.displacement(static_cast<Index>(mode), line->line));
}

void BalancedMotions::show(const Balanced& balanced, Observation& seen) const {
  for (std::size_t k = 0; k < seen.rate.size(); ++k)
    if (const auto rate = rate_of(k, balanced)) seen.rate[k] = *rate;
  for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
    const RegressorBlock& block = resonance_.blocks[b];
    if (block.kind != BlockKind::harmonic) continue;
    if (const auto amplitude = amplitude_of(static_cast<std::size_t>(block.mode), block.phase, balanced))
      seen.harmonic[b] = *amplitude;
  }
}

}  // namespace secular
