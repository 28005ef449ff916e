#pragma once

#include <Eigen/Core>
#include <vector>

#include "measure/observe/modal_projection.hpp"
#include "measure/observe/mode_frequencies.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

struct SlowToneFit;

/// What one window of a free decay shows.
struct DecayWindow {
  Observation observation;        ///< without condition, record and centre
  Eigen::VectorXd noise_sd;       ///< [mode], of the modal coordinate's samples
  double degrees_of_freedom = 0;  ///< of the noise levels
  /// [mode], rms of the modal coordinate's samples: what a decay at a steady rate leaves beside an amplitude of
  /// second degree in time. No noise, though it is counted as such.
  Eigen::VectorXd beyond_degree;
  /// Over all modes that are seen, in parts of their amplitude: how far it and its phase are from a straight line
  /// at the window's ends, and by how much the amplitude changes from end to end; two standard deviations less.
  double bend = 0, fall = 0;
};

/// Windows of free decays of one case. A window is fitted by the tones that the expansion of the case says are
/// there (every mode's own, harmonics, combinations, the slow motion at zero frequency), all with complex
/// amplitudes of second degree in time. Tones that an internal resonance makes the same are one.
class DecayWindows {
 public:
  /// Of records that are read with `window`'s band.
  DecayWindows(const Campaign& campaign, const CompiledModel& model, const CompiledCase& resonance,
               const Window& window);

  const std::vector<std::size_t>& oscillating() const { return oscillating_; }
  const ModalProjection& projection() const { return projection_; }

  /// Samples of the modal coordinates, samples x modes, of the measured quantity.
  Eigen::MatrixXd modal_samples(const Record& record, Eigen::Index first, Eigen::Index count) const;

  /// Shortest window (s) that separates each mode's tone from its neighbours at these frequencies (rad/s, [mode]).
  double shortest_s(const Eigen::VectorXd& frequency, double rate) const;

  /// `modal`: samples of one window. `frequency`: [mode], rad/s, those of the oscillating modes within half a bin
  /// of the shortest window; moved to what is found. A mode that is found further away is not seen, nor one that
  /// noise hides; its frequency stays.
  DecayWindow fit(const Eigen::MatrixXd& modal, double rate, Eigen::VectorXd& frequency) const;

  /// Observation::overlap of windows of so many samples, `steps` to a length, at these frequencies (rad/s, [mode]).
  std::vector<WindowPair> overlaps(Eigen::Index samples, double rate, const Eigen::VectorXd& frequency,
                                   int steps) const;

  /// The window of `like` in another record of the same sampling.
  Observation fit_again(const Record& record, const Observation& like) const;

 private:
  struct Tones {
    std::vector<double> frequency;  // rad/s
    std::vector<bool> reversed;     // by block: its frequency is negative, the tone is its conjugate
    std::vector<std::ptrdiff_t> of_mode, of_block;
  };
  Tones tones(const Eigen::VectorXd& frequency, double seconds, double rate) const;
  /// Appends the harmonics of `o` with their errors; a negative one: not seen.
  void read_harmonics(const SlowToneFit& seen, const Tones& list, Observation& o) const;
  bool same(const std::vector<int>& a, const std::vector<int>& b) const;
  std::vector<int> own_phase(std::size_t mode) const;
  std::vector<int> block_phase(std::size_t block) const;
  double frequency_of(const std::vector<int>& phase, const Eigen::VectorXd& frequency) const;

  const CompiledModel& model_;
  const CompiledCase& resonance_;
  ModalProjection projection_;
  std::vector<std::size_t> oscillating_;
  bool rectifies_ = false;  // the expansion has a slow motion at zero frequency
  Window window_;
};

}  // namespace secular
