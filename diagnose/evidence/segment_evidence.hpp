#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/evidence/driven_noise.hpp"
#include "diagnose/evidence/noise_bands.hpp"
#include "diagnose/evidence/segment_model.hpp"

namespace secular {

/// Evidence of free decays, impacts, sweeps and broadband records: what the full equations of motion do from a
/// state of each segment's own, sample by sample. The state is eliminated to first order about its best value. The
/// first rows of a segment are the errors that a change of every mode's stiffness and damping would make, the
/// conservative and the dissipative part of the discrepancy; the others hold the rest. Over a long decay those
/// first rows follow a smooth law of the amplitude, whatever the model lacks: how rough they are from segment to
/// segment is their repeatability (a clock that is not even, a knock), where that is more than the noise explains.
/// That of the other rows is what a quarter of the segments stays below: what a model lacks grows and falls with
/// the amplitude. Where they come and go from segment to segment by no law of the amplitude, the record is
/// disturbed, and no segment's other rows count for more than they hold.
class SegmentEvidence : public Evidence {
 public:
  /// `threads`: of freeze().
  SegmentEvidence(const CompiledModel& model, std::vector<StateForce> forces, SensorModel sensors, FaultTable table,
                  std::vector<Segment> segments, unsigned threads = 1);

  Eigen::Index size() const override { return static_cast<Eigen::Index>(labels_.size()); }
  Eigen::Index freedom() const override;
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const Eigen::VectorXd& unknowns, double coarse) override;
  bool measures_errors() const override { return !noise_is_known_; }
  void shift_records(const std::map<std::size_t, Eigen::VectorXd>& shifts) override;
  void evaluate(const Eigen::VectorXd& unknowns, Eigen::Ref<Eigen::VectorXd> rows) const override;
  Eigen::MatrixXd between_samples(const Eigen::VectorXd& unknowns, const BetweenSamples& of_blows) const override;
  /// Offsets of response channels, which no motion depends on, in closed form; the others by differences of motions
  /// that are integrated side by side.
  Eigen::MatrixXd slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                         const Eigen::VectorXd& scale, unsigned threads) const override;

  /// A decay whose segments depart from any smooth law of the amplitude: how many it has, and the middles of those
  /// that depart by more than twice the quiet ones, in seconds of the record.
  struct Disturbed {
    std::size_t record = 0, segments = 0;
    std::vector<double> worst_s;
  };
  std::vector<Disturbed> disturbed() const;

  /// What is left of a response channel in the segments of a record, one behind the other, after freeze(): beside
  /// the state that is fitted for each segment, in the channel's unit, with foreign content that was fitted beside
  /// it.
  struct Left {
    std::size_t record = 0, channel = 0;        ///< of the campaign
    double sample_s = 0, from_s = 0, to_s = 0;  ///< in the record's time
    std::vector<double> rest, reading;
    std::vector<double> noise;     ///< the rest without foreign content
    std::vector<double> unwhited;  ///< the same before anything makes it white
    double rms = 0;                ///< of the rest
    /// In units of noise: the square that zeros which wander would make of it, with its degrees of freedom, and
    /// that of all else.
    double slow = 0, slow_freedom = 0, other = 0, other_freedom = 0;
  };
  std::vector<Left> left(const Eigen::VectorXd& unknowns) const;

  /// How much is in a record: the excitation (first channel), or the response's largest (first channel), in that
  /// channel's unit.
  struct RecordSize {
    std::size_t record = 0;
    bool driven = false;
    double size = 0;
  };
  std::vector<RecordSize> record_sizes() const;
  /// The segments of a record as these unknowns predict them, each from `level` times the state that it begins with
  /// and driven by `level` times its excitation: without noise or foreign content, with the errors that were
  /// measured. Empty: a motion runs away. After freeze().
  std::vector<Segment> predicted(std::size_t record, const Eigen::VectorXd& unknowns, double level) const;
  /// Evidence of other segments by the same model and sensors, whose noise is what they say.
  SegmentEvidence of_known_noise(std::vector<Segment> segments) const;

  /// Mean square of the error over all samples, by response channel, in the square of its unit; every segment from
  /// its best state.
  Eigen::VectorXd mean_square_error(const Eigen::VectorXd& unknowns) const;
  /// That of the channels themselves.
  Eigen::VectorXd mean_square_signal() const;

 private:
  SegmentEvidence(SegmentModel model, std::vector<Segment> segments, unsigned threads);

  struct Frozen {
    Eigen::VectorXd state;
    DrivenNoise driven_noise;  // where errors are not coarse: what whitens them before anything else
    // Orthonormal, samples*channels long: foreign content, then what the state adds to it; 2 modes columns.
    Eigen::MatrixXd state_basis, change_basis;
    Eigen::MatrixXd foreign;          // content that was taken off the responses so far; empty: none
    Eigen::Index beyond_horizon = 0;  // samples at the end that do not count while errors are coarse
    // Samples that do not count: those, and where a channel may read either side of a jump of its signal, since
    // errors there are not continuous in the unknowns.
    std::vector<Eigen::Index> silent;
    double widening = 1;     // errors times this
    double disturbance = 0;  // of a disturbed record what the other rows hold, in units of noise; else 0
  };
  // What a segment repeats to, in units of its channels' noise, as the unknowns leave it at which errors are taken:
  // no trial before them has a part in it. Only how the first rows repeat from segment to segment, which a few
  // segments tell roughly, is the largest since errors were coarse: an explanation that fits better does not take
  // it back.
  struct Noise {
    Eigen::VectorXd change_sd;                            // of the first rows
    double rest_sd = 1;                                   // of the others where they are white
    std::shared_ptr<const NoiseInCosines> coloured = {};  // else
    double white_sd() const { return coloured ? coloured->least : rest_sd; }
  };
  // What the unknowns leave of a segment.
  struct LeftOfSegment {
    double white = 0;         // variance of what is white
    Eigen::VectorXd changes;  // in the first rows
    Eigen::VectorXd rest;     // in the others
    double rest_rms = 0;
  };
  std::vector<LeftOfSegment> left_by(const Eigen::VectorXd& unknowns) const;
  void measure_noise(const Eigen::VectorXd& unknowns);
  /// Of all decays together; nothing where it is white, or where they are too few to tell: fewer than two.
  std::shared_ptr<const NoiseInCosines> coloured_noise(const std::vector<LeftOfSegment>& left,
                                                       const Eigen::VectorXd& unknowns) const;
  /// Errors beside the first rows in units of noise.
  static void whiten(const Noise& noise, const Eigen::VectorXd& error, Eigen::Ref<Eigen::VectorXd> rest);
  /// A segment's rows, from errors of its samples.
  void rows_of(std::size_t segment, Eigen::VectorXd error, Eigen::Ref<Eigen::VectorXd> rows) const;
  /// Slopes by the offset of a response channel, per `scale`.
  Eigen::VectorXd offset_slopes(std::size_t channel, double scale) const;
  /// Of a record's segments.
  Noise noise_of(std::span<const LeftOfSegment> left, std::size_t first,
                 std::shared_ptr<const NoiseInCosines> coloured) const;
  /// Where segments begin, from the first one to before the end, and what does not count of them.
  void freeze_states(std::size_t first, std::size_t end, const Eigen::VectorXd& unknowns);
  void silence_jumps(std::size_t first, std::size_t end, const Eigen::VectorXd& unknowns);
  enum class Stretch { to_the_horizon, whole };
  std::vector<Eigen::VectorXd> states_at(std::size_t first, std::size_t end, const Eigen::VectorXd& unknowns,
                                         Stretch stretch) const;
  /// Samples of a segment that may count, the first ones.
  Eigen::Index horizon(std::size_t segment) const {
    return segments_[segment].response.cols() - frozen_[segment].beyond_horizon;
  }
  /// Directions in which their errors move with the state, and with the change of every mode, where they are.
  void freeze_bases(std::size_t first, std::size_t end, const Eigen::VectorXd& unknowns);
  /// States, and what whitens errors about them.
  void freeze_motions(std::size_t first, std::size_t end, const Eigen::VectorXd& unknowns);
  /// Columns of foreign content that are fitted: while errors are coarse, in which tones are small, of zeros alone.
  Eigen::Index foreign_count(std::size_t segment) const;
  /// Foreign content as errors hold it.
  Eigen::MatrixXd seen_foreign_columns(std::size_t segment) const;
  /// What the errors of a frozen segment hold of foreign content comes off its responses: rows do not see it, but
  /// its state is found beside it, and slopes are those of the motion.
  void take_foreign_content_off(std::size_t segment, const Eigen::VectorXd& unknowns);
  /// What the errors of a frozen segment say of the noise in its excitation comes off the excitation, and what that
  /// does to its errors off its responses: slopes are those of the likeliest excitation, errors stay as they are.
  void take_driven_noise_off(std::size_t segment, const Eigen::VectorXd& unknowns);
  /// A frozen segment as it is.
  SegmentTrial frozen_trial(std::size_t segment, const Eigen::VectorXd& unknowns) const {
    return {segments_[segment], segments_[segment].response.cols(), unknowns, frozen_[segment].state};
  }
  std::vector<std::size_t> all_segments() const;
  /// Errors of a frozen segment as its rows see them.
  Eigen::VectorXd seen(std::size_t segment, Eigen::VectorXd error) const {
    const Frozen& f = frozen_[segment];
    return f.driven_noise.whitened(silenced(std::move(error), segments_[segment].response.cols(), f.silent));
  }
  /// Errors of trials of frozen segments as their rows see them.
  std::vector<Eigen::VectorXd> frozen_errors(const std::vector<std::size_t>& segments,
                                             const std::vector<SegmentTrial>& trials) const;
  /// Errors of all frozen segments.
  std::vector<Eigen::VectorXd> frozen_errors(const Eigen::VectorXd& unknowns) const;
  /// Rows of a segment.
  Eigen::Index rows_in(std::size_t segment) const {
    return static_cast<Eigen::Index>(2 * model_.modes()) + segments_[segment].response.size();
  }
  /// Central differences of half a scale.
  Eigen::MatrixXd differences(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                              const Eigen::VectorXd& scale, unsigned threads) const;

  SegmentModel model_;
  std::vector<Segment> measured_;
  std::vector<Segment> segments_;         // those measured; where a noise of the excitation is known, without it
  std::vector<Eigen::MatrixXd> foreign_;  // of each, foreign_columns()
  unsigned threads_;
  std::vector<Frozen> frozen_;
  std::vector<Noise> noise_;
  bool noise_is_known_ = false;
  bool coarse_ = true;  // frozen at widened errors, beside which nothing repeats worse
  std::vector<RowLabel> labels_;
};

}  // namespace secular
