#pragma once

#include <memory>
#include <span>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/evidence/frozen_segment.hpp"
#include "diagnose/evidence/left_in_channels.hpp"
#include "diagnose/evidence/record_summaries.hpp"
#include "diagnose/evidence/segment_noise.hpp"
#include "diagnose/evidence/segment_rows.hpp"

namespace secular {

/// Evidence of free decays, impacts, sweeps and broadband records: what the full equations of motion do from a
/// state of each segment's own, sample by sample. freeze() takes states and all that goes with them
/// (freeze_segments()), then what the segments repeat to (SegmentNoise); rows are SegmentRows.
class SegmentEvidence : public Evidence {
 public:
  using Disturbed = DisturbedRecord;
  using Left = LeftInChannel;
  using RecordSize = secular::RecordSize;

  /// `threads`: of freeze().
  SegmentEvidence(const CompiledModel& model, std::vector<StateForce> forces, SensorModel sensors, FaultTable table,
                  std::vector<Segment> segments, unsigned threads = 1);

  Eigen::Index size() const override { return static_cast<Eigen::Index>(labels_.size()); }
  Eigen::Index freedom() const override { return freedom_of(rows()); }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const Eigen::VectorXd& unknowns, double coarse) override;
  bool measures_errors() const override { return !noise_is_known_; }
  Eigen::Index measured_rows() const override { return noise_in_use().empty() || noise_is_known_ ? 0 : freedom(); }
  void set_frequency_offsets(const std::map<std::size_t, Eigen::VectorXd>& offsets) override;
  void evaluate(const Eigen::VectorXd& unknowns, Eigen::Ref<Eigen::VectorXd> rows) const override;
  Eigen::VectorXd by_balance(const Eigen::VectorXd& rows) const override { return this->rows().by_balance(rows); }
  Eigen::MatrixXd between_samples(const Eigen::VectorXd& unknowns, const BetweenSamples& of_blows) const override;
  Eigen::MatrixXd slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                         const Eigen::VectorXd& scale, unsigned threads) const override;

  /// By the noise of the last freeze() at true errors.
  std::vector<Disturbed> disturbed() const { return disturbed_records(segments_, noise_); }
  /// After freeze().
  std::vector<Left> left(const Eigen::VectorXd& unknowns) const {
    return left_in_channels(model_, segments_, unknowns);
  }
  std::vector<RecordSize> record_sizes() const { return secular::record_sizes(segments_); }
  /// The segments of a record, as predicted_segments(). After freeze().
  std::vector<Segment> predicted(std::size_t record, const Eigen::VectorXd& unknowns, double level) const;
  /// Evidence of other segments by the same model and sensors, whose noise is what they say.
  SegmentEvidence of_known_noise(std::vector<Segment> segments) const;
  Eigen::VectorXd mean_square_error(const Eigen::VectorXd& unknowns) const {
    return secular::mean_square_error(model_, segments_, unknowns);
  }
  Eigen::VectorXd mean_square_signal() const { return secular::mean_square_signal(model_, segments_); }

 private:
  SegmentEvidence(SegmentModel model, std::vector<Segment> segments, unsigned threads);

  std::vector<SegmentNoise> noise_at(const Eigen::VectorXd& unknowns, std::span<const SegmentNoise> before) const;
  /// Of true errors; empty while they are wide.
  std::span<const SegmentNoise> noise_in_use() const {
    return coarse_ ? std::span<const SegmentNoise>() : std::span(noise_);
  }
  SegmentRows rows() const { return {model_, segments_, noise_in_use()}; }

  SegmentModel model_;
  std::vector<FrozenSegment> segments_;
  unsigned threads_;
  std::vector<SegmentNoise> noise_;  // at the last true errors
  bool noise_is_known_ = false;
  bool coarse_ = true;  // frozen at widened errors
  std::vector<RowLabel> labels_;
};

}  // namespace secular
