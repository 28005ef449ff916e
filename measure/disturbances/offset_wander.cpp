#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "measure/data/noise_floor.hpp"
#include "measure/disturbances/motion_tones.hpp"
#include "measure/disturbances/rows.hpp"
#include "measure/thresholds.hpp"
#include "numerics/confidence.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr auto& slow_terms =
    measure_thresholds().slow_terms;  // cosines of up to two periods a record: what is slower than all else in it
constexpr double entangled = 1e-6;    // a coefficient of which others take up more than this has no value

// Means of blocks under the window of the lines, half overlapping (which leaves 4 % of their noise in common), and
// the mean square about them.
struct BlockMeans {
  VectorXd mean, square;
};

BlockMeans block_means(std::span<const double> samples, std::size_t length) {
  const std::vector<double> window = lobe_window(length);
  const std::size_t hop = length / 2, count = (samples.size() - length) / hop + 1;
  BlockMeans blocks{VectorXd::Zero(static_cast<Index>(count)), VectorXd::Zero(static_cast<Index>(count))};
  double sum = 0;
  for (const double w : window) sum += w;
  for (std::size_t b = 0; b < count; ++b) {
    double mean = 0, square = 0;
    for (std::size_t i = 0; i < length; ++i) {
      const double x = samples[b * hop + i];
      mean += window[i] * x;
      square += window[i] * x * x;
    }
    const auto at = static_cast<Index>(b);
    blocks.mean(at) = mean / sum;
    blocks.square(at) = std::max(0.0, square / sum - blocks.mean(at) * blocks.mean(at));
  }
  return blocks;
}

// Columns: one, what the motion's own mean may follow, slow cosines.
MatrixXd columns(const MatrixXd& follows) {
  const Index rows = follows.rows(), own = follows.cols();
  MatrixXd x(rows, 1 + own + slow_terms);
  x.col(0).setOnes();
  x.middleCols(1, own) = follows;
  for (Index k = 0; k < slow_terms; ++k)
    for (Index l = 0; l < rows; ++l)
      x(l, 1 + own + k) = std::cos(std::numbers::pi * static_cast<double>(k + 1) * (static_cast<double>(l) + 0.5) /
                                   static_cast<double>(rows));
  return x;
}

// Powers of the motion's mean square that its own mean may follow, with quadratic and quartic terms.
Index own_terms(const Channel& channel) {
  return has_no_mean(channel) ? 0 : 2;
}

// The course of a channel's zero.
struct Zero {
  double offset = 0, offset_sd = 0;
  VectorXd wander;         // slow cosines at the blocks
  double probability = 1;  // of as much wander in the noise of the blocks
  double freedom = 0;
};

// Blocks up to the last in which the motion is as large as noise and step: where it comes to rest, dry friction has
// a say.
Index blocks_in_motion(const SearchedChannel& channel, const VectorXd& square) {
  const double noise = std::max(noise_floor(channel.intact).value_or(0), channel.values->grid.step.value_or(0));
  Index last = square.size();
  while (last > 0 && square(last - 1) <= 2 * noise * noise) --last;
  return last;
}

// A decay begins behind its largest sample: before that the structure is led or held there, or struck.
std::span<const double> motion_of(const SearchedRecord& record, std::span<const double> samples) {
  if (record.entry().kind != RecordKind::free_decay && record.entry().kind != RecordKind::impact) return samples;
  double mean = 0, largest = 0;
  for (const double x : samples) mean += x / static_cast<double>(samples.size());
  std::size_t begin = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (std::abs(samples[i] - mean) >= largest) {
      largest = std::abs(samples[i] - mean);
      begin = i;
    }
  return samples.subspan(begin);
}

bool is_driven(const SearchedRecord& record) {
  return record.entry().kind == RecordKind::sweep || record.entry().kind == RecordKind::broadband;
}

// What the motion's own mean may follow: its mean square, and the mean of what drives it (below all resonances a
// structure follows as a spring), each over its largest.
MatrixXd followed(const SearchedRecord& record, std::size_t c, const VectorXd& square, std::size_t length) {
  const std::size_t first = record.channels[c].intact_from(), count = record.channels[c].intact.size();
  std::vector<VectorXd> drives;
  for (std::size_t e = 0; e < record.channels.size() && is_driven(record); ++e)
    if (record.is_excitation(e) && e != c)
      drives.push_back(
          block_means(record.channels[e].samples.subspan(first, count), length).mean.head(square.size()));
  const Index own = own_terms(record.channel(c));
  MatrixXd follows(square.size(), own + static_cast<Index>(drives.size()));
  const VectorXd relative = square / std::max(square.maxCoeff(), 1e-300);
  for (Index p = 0; p < own; ++p) follows.col(p) = relative.array().pow(static_cast<double>(p + 1));
  for (const VectorXd& drive : drives)
    follows.col(own + (&drive - drives.data())) = drive / std::max(drive.cwiseAbs().maxCoeff(), 1e-300);
  return follows;
}

// The zero of a channel, from means of blocks of that length.
std::optional<Zero> zero_of(const SearchedRecord& record, std::size_t c, std::size_t length) {
  const SearchedChannel& channel = record.channels[c];
  // What stays wrong has a mean of its own.
  const std::span<const double> samples = motion_of(record, channel.intact);
  if (samples.size() < 2 * length) return std::nullopt;
  BlockMeans blocks = block_means(samples, length);
  const Index rows =
      own_terms(record.channel(c)) > 0 ? blocks_in_motion(channel, blocks.square) : blocks.mean.size();
  if (rows == 0) return std::nullopt;  // noise is all there is
  blocks.mean.conservativeResize(rows);
  blocks.square.conservativeResize(rows);
  const MatrixXd x = columns(followed(record, c, blocks.square, length));
  const Index own = x.cols() - 1 - slow_terms;
  if (rows <= x.cols()) return std::nullopt;
  const Eigen::CompleteOrthogonalDecomposition<MatrixXd> all(x), without(x.leftCols(1 + own));
  // Of the pseudo-inverse one row: the whole takes a square of the blocks.
  const VectorXd inverse = all.transpose().solve(VectorXd(VectorXd::Unit(x.cols(), 0))),
                 fit = all.solve(blocks.mean);
  Zero zero;
  zero.freedom = static_cast<double>(rows - all.rank());
  const double noise = (blocks.mean - x * fit).squaredNorm(), variance = noise / zero.freedom;
  if (!(variance > 0)) return std::nullopt;
  const double slow =
      (blocks.mean - x.leftCols(1 + own) * VectorXd(without.solve(blocks.mean))).squaredNorm() - noise;
  const auto terms = static_cast<double>(all.rank() - without.rank());
  if (terms > 0) zero.probability = f_upper_tail(slow / (terms * variance), terms, zero.freedom);
  zero.wander = x.rightCols(slow_terms) * fit.tail(slow_terms);
  zero.offset = fit(0);
  // Of a motion that is as large all the time nothing tells what its own mean is, and what the sensor's zero.
  const bool told = (x.transpose() * inverse - VectorXd::Unit(x.cols(), 0)).norm() < entangled;
  zero.offset_sd = told ? std::sqrt(variance) * inverse.norm() : INFINITY;
  return zero;
}

// Of a record whose excitation is no tone: its strongest response, next to what an amplitude makes of it. Slower
// than lines are looked for nothing moves.
double lowest_of_any(const SearchedRecord& record) {
  double strongest = 0, lowest = 0;
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const std::vector<double>& powers = record.channels[c].powers;
    if (record.is_excitation(c) || powers.size() <= static_cast<std::size_t>(2 * line_reach)) continue;
    const auto most = std::max_element(powers.begin() + line_reach, powers.end());
    if (!(*most > strongest)) continue;
    strongest = *most;
    lowest = 0.5 * record.rate * static_cast<double>(most - powers.begin()) /
             static_cast<double>(powers.size() - 1) / static_cast<double>(measure_thresholds().softest);
  }
  return lowest;
}

// Samples of a block that is so long that the lowest line lies beside the window's main lobe; zero where there is
// none, or the record too short.
std::size_t block_length(const SearchedRecord& record) {
  const RecordKind kind = record.entry().kind;
  const bool tonal = kind == RecordKind::dwell || kind == RecordKind::free_decay;
  double lowest = tonal ? MotionTones(record).lowest_hz() : lowest_of_any(record);
  for (const SearchedChannel& channel : record.channels)
    for (const Line& line : channel.lines)
      lowest = lowest > 0 && tonal ? std::min(lowest, line.frequency_hz) : lowest;
  if (!(lowest > 0)) return 0;
  const auto length = static_cast<std::size_t>(std::ceil(lobe_bins * record.rate / lowest)) / 2 * 2 + 2;
  return length > record.samples() / 2 ? 0 : length;
}

}  // namespace

bool has_no_mean(const Channel& channel) {
  return channel.role == ChannelRole::excitation || channel.quantity == Quantity::acceleration ||
         channel.quantity == Quantity::velocity;
}

void find_offsets(const SearchedRecord& record, std::vector<Disturbance>& found) {
  const std::size_t length = block_length(record);
  for (std::size_t c = 0; length > 0 && c < record.channels.size(); ++c) {
    const bool no_mean = has_no_mean(record.channel(c));
    if (!no_mean && record.entry().kind == RecordKind::dwell) continue;  // the motion's own mean is as steady
    const std::optional<Zero> zero = zero_of(record, c, length);
    if (!zero || two_sided_p_value(zero->offset / zero->offset_sd, zero->freedom) > record.level) continue;
    Disturbance offset = record.found_in_intact("offset", c, std::abs(zero->offset));
    offset.text = fmt::format("the zero is off by {:.3g} {} (sd {:.1g}){}", zero->offset, offset.unit,
                              zero->offset_sd, no_mean ? "" : ", or the position of rest is");
    found.push_back(std::move(offset));
  }
}

void find_wander(const SearchedRecord& record, std::vector<Disturbance>& found) {
  const std::size_t length = block_length(record);
  for (std::size_t c = 0; length > 0 && c < record.channels.size(); ++c) {
    const std::optional<Zero> zero = zero_of(record, c, length);
    if (!zero || zero->probability > record.level) continue;
    Disturbance wander = record.found_in_intact(
        "offset_wander", c, std::sqrt(zero->wander.squaredNorm() / static_cast<double>(zero->wander.size())));
    wander.text = fmt::format("the zero wanders by {:.3g} {} rms, from {:.3g} to {:.3g} about its mean",
                              wander.size, wander.unit, zero->wander.minCoeff(), zero->wander.maxCoeff());
    found.push_back(std::move(wander));
  }
}

}  // namespace secular
