#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "measure/data/line_row.hpp"
#include "measure/observe/mode_frequencies.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// The lines of a row of a table at the frequencies that a case asks for: what ResponseTones and a fit to samples
/// are for an ensemble. Of cases whose modes are locked to the excitation.
class TabledTones {
 public:
  /// A case, and what follows from it.
  struct Case {
    const CompiledModel& model;
    const CompiledCase& resonance;
    const ModeFrequencies& modes;
  };

  /// `excitation`: rad/s; `channels`: the responses, in the order of amplitudes. All must outlive this.
  TabledTones(const LineRow& row, const Case& of, const std::vector<double>& excitation,
              const std::vector<std::size_t>& channels, const Window& window);

  /// By channel: half of the peak (of a mean the mean), and the standard deviation of a real part (0: not known).
  struct Line {
    Eigen::RowVectorXcd amplitude;
    Eigen::RowVectorXd sd;
  };

  /// rad/s; of a block it may be negative, and the line is then that of the positive frequency.
  double frequency_of_mode(std::size_t mode) const { return mode_frequency_(static_cast<Eigen::Index>(mode)); }
  double frequency_of_block(std::size_t block) const { return block_frequency_[block]; }
  /// Nothing where the row has no such line in every channel, or the window does not show it.
  std::optional<Line> of_mode(std::size_t mode) const { return at(frequency_of_mode(mode)); }
  std::optional<Line> of_block(std::size_t block) const;
  /// Whether every line of the responses at the excitation's frequency and the modes' says its standard deviation.
  /// A line of a channel that does not has that of the channel at the excitation's frequency: noise of samples has
  /// one level in all lines.
  bool noise_known() const { return noise_known_; }

 private:
  std::optional<Line> at(double frequency) const;

  const LineRow& row_;
  const CompiledCase& resonance_;
  double excitation_;
  const std::vector<std::size_t>& channels_;
  const Window& window_;
  Eigen::VectorXd mode_frequency_;
  std::vector<double> block_frequency_;
  bool noise_known_ = true;
};

/// Observations of rows of one table that bear the same label become repeats of one condition. `dwells`: records by
/// set, each of which is of one record.
void share_conditions(const Campaign& campaign, const std::vector<std::size_t>& dwells,
                      std::vector<ObservationSet>& sets);

/// What repeats of conditions scatter by tells the noise of observations that do not know theirs, if there are
/// enough repeats.
void noise_from_repeats(ObservationSet& set);

}  // namespace secular
