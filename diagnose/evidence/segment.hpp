#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/evidence/foreign_content.hpp"
#include "diagnose/evidence/sensor_model.hpp"
#include "diagnose/evidence/wandering_zeros.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/integrate/motion_integrator.hpp"

namespace secular {

/// From one fold of a record to the next.
inline constexpr int fold_step = 1000;

/// A stretch of a record that is compared sample by sample with the full equations of motion, from a state of its
/// own.
struct Segment {
  std::size_t record = 0;
  int fold = 0;
  int folds = 1;  ///< of its samples, one after the other; the first is `fold`, each fold_step from the last
  bool is_in_folds() const { return folds > 1; }
  double time_s = 0, in_record_s = 0;  ///< of its middle: of record_times, since the record began
  /// By mode, relative: the record's natural frequencies next to those of all. Empty: none differs.
  Eigen::VectorXd frequency_offset;
  double sample_s = 0;
  Eigen::MatrixXd excitation;           ///< excitation channels x (2*samples - 1), every half sample; empty: none
  Eigen::MatrixXd response;             ///< response channels x samples
  Eigen::VectorXd noise_sd;             ///< response channels
  Eigen::VectorXd excitation_noise_sd;  ///< excitation channels; zero where the record does not tell it
  int substeps = 1;
  std::vector<Eigen::Index> wandering;  ///< response channels whose zero moves slowly
  std::vector<ForeignTone> tones;       ///< in response channels
  std::vector<ColouredNoise> coloured;
  double zeros_below_hz = 0;             ///< what they move with
  std::vector<Eigen::Index> uncompared;  ///< samples, in order, whose readings do not count
};

/// Samples on either side of a place halfway between two that its value is made of.
inline constexpr Eigen::Index half_sample_reach = 5;

/// Channels x samples -> channels x (2*samples - 1): values and those halfway between, by the polynomial through
/// the ten around them (beyond either end the last value stands), which is off by 2.4e-4 (w h)^10 of a tone w at
/// steps h: 3e-5 at eight samples a turn, where six samples would be off by 1.2e-3.
Eigen::MatrixXd at_half_samples(const Eigen::MatrixXd& samples);

enum class SegmentLength {
  turns,  ///< some turns of the lowest mode
  whole   ///< all that the window holds of a record
};

/// How segments are cut.
struct SegmentCut {
  Window window;
  SegmentLength length = SegmentLength::turns;
  Eigen::Index most_samples = 0;  ///< in all; of no effect on whole ones
  WanderingZeros wandering = {};
  ForeignTones tones = {};
  ColouredNoises coloured = {};
  bool blows_as_decays = false;  ///< of impacts what follows the blow, whatever drove it
  bool whole_decays = false;     ///< a free decay is one segment, as far as it stands out from the noise
  bool skips_blows = false;      ///< readings during a blow do not count, what it does afterwards does
};

/// Free decays, impacts, sweeps and broadband records as segments. Of a record that holds more than its share of
/// `most_samples` they are spread over it: evenly over a decay, by how much motion there is over one that is driven
/// (docs/inference.md (40)). Decays begin where the structure swings freely. Samples are thinned where the record
/// is much faster than the highest mode. Throws InputError for driven records with a band: what is nonlinear
/// answers to all of its excitation.
std::vector<Segment> cut_segments(const Campaign& campaign, const RecordReader& read, const SensorModel& sensors,
                                  const std::vector<double>& natural_frequency, const SegmentCut& cut,
                                  std::vector<std::string>& warnings);

}  // namespace secular
