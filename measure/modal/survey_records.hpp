#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/data/watched_reader.hpp"
#include "measure/modal/frequency_response.hpp"
#include "measure/modal/modal_survey.hpp"

namespace secular {

/// One free decay, filtered down to the band, from where the structure swings freely; or a motion that grows or
/// goes on, up to its largest excursion.
struct SurveyDecay {
  double start_s = 0;       ///< record time of the first row
  bool to_the_end = false;  ///< up to the largest excursion
  Eigen::MatrixXd samples;  ///< rows x responses
  double sample_rate_hz = 0;
};

/// Rows of a decay that are kept: more than a realization takes, since poles are held against noise over all of
/// them, and few enough that some decays of many channels fit into memory and a fit of them into a second.
inline constexpr Eigen::Index most_decay_rows = 8192;

/// What is kept of a decay while others are looked at.
struct DecaySummary {
  std::size_t record = 0;
  Eigen::Index rows = 0;
  double sample_rate_hz = 0;
  bool to_the_end = false;  ///< up to the largest excursion
  Eigen::MatrixXd head;     ///< its first rows (the last ones of what went on to the end)
};

/// The structure after a blow, when the hammer has left it, filtered down to the band.
struct FreeSwing {
  std::string group;
  double sample_rate_hz = 0;
  Eigen::MatrixXd head;  ///< its first rows
};

struct ImpactPlace {
  std::size_t record = 0;
  Eigen::Index begin = 0;  ///< sample of the part between --from and --to
};

/// Impacts at one point.
struct SurveyImpacts {
  std::string group;
  std::vector<ImpactPlace> places;
};

/// What becomes of a decay that is too short for the survey's band.
enum class ShortDecays { refused, left_out };

/// The file that faults of a survey's channels stand in.
std::string toml_of(const ModalSurvey& survey);

/// The records of a survey. Samples are read when they are asked for, and kept as long as all that were fit into
/// 128 MB; of more, the record read last.
class SurveyRecords {
 public:
  /// Reads the records that the options choose once. Fills channels, form, unit and warnings of the survey, which
  /// must outlive this. Throws InputError.
  explicit SurveyRecords(ModalSurvey& survey);
  /// Those of another band of the same survey, too short ones left out: what `read` holds is not read again.
  SurveyRecords(ModalSurvey& survey, const SurveyRecords& read);
  ~SurveyRecords();
  SurveyRecords(const SurveyRecords&) = delete;
  SurveyRecords& operator=(const SurveyRecords&) = delete;

  const std::vector<DecaySummary>& decays() const { return decays_; }
  const std::vector<SurveyImpacts>& impacts() const { return impacts_; }
  double impact_rate_hz() const { return impact_rate_hz_; }
  /// After the impacts, one each where enough rows follow.
  const std::vector<FreeSwing>& swings() const { return swings_; }

  /// Samples of a decay by its place in decays(); valid until the next call.
  const SurveyDecay& decay(std::size_t i);
  ImpactBlock impact(const ImpactPlace& place);

  /// What is wrong with the samples of the records read.
  std::vector<std::string> faults() const { return reader_.warnings(WatchedReader::WhatIsLeft::used); }

 private:
  struct Part;
  /// Samples that were read, by record, as long as they fit into most_bytes.
  struct ReadParts;
  void find_records();
  const Part& part(std::size_t record);
  std::optional<SurveyDecay> cut_decay(std::size_t record);
  void keep_decay(std::size_t record);
  void find_places(const std::vector<std::size_t>& records);
  void keep_swing(const Part& part, const std::string& group, Eigen::Index begin, Eigen::Index end);

  ModalSurvey& survey_;
  ShortDecays too_short_;
  WatchedReader reader_;
  std::optional<std::size_t> force_;  // channel
  std::vector<DecaySummary> decays_;
  std::vector<SurveyImpacts> impacts_;
  std::vector<FreeSwing> swings_;
  double impact_rate_hz_ = 0;
  Eigen::Index impact_length_ = 0;
  std::shared_ptr<ReadParts> read_;
  std::shared_ptr<const Part> part_;  // of the record read last
  std::size_t part_record_ = 0;
  SurveyDecay decay_;
  std::optional<std::size_t> decay_at_;
};

}  // namespace secular
