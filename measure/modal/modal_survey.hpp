#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/time_span.hpp"
#include "measure/modal/amplitude_dependence.hpp"
#include "measure/modal/frequency_response.hpp"
#include "measure/modal/pole_support.hpp"
#include "measure/modal/residue_conversion.hpp"
#include "measure/modal/stabilisation.hpp"
#include "numerics/confidence.hpp"

namespace secular {

/// Where a reference (a group of impact records) strikes: a response channel, and the sense of the blow along it.
struct DrivingPoint {
  std::string channel;
  int sign = 1;
};

struct ModalSurveyOptions {
  std::string records = "*";             ///< shell pattern on the record's file
  TimeSpan span{};                       ///< of every record
  double lowest_hz = 0, highest_hz = 0;  ///< band of the modes; no upper limit where it is zero
  int largest_order = 40;
  int modes = 0;                                       ///< keep this many, the strongest; zero: all that stand
  double window_s = 0;                                 ///< of free decays; zero: chosen
  double overlap = 0.33;                               ///< of the windows
  double fit_below = 0;                                ///< regression over windows up to this amplitude; zero: all
  double force_window_s = 0;                           ///< of impacts; zero: none
  std::optional<double> response_decay;                ///< exponential window of impacts, 1/s; chosen without it
  std::map<std::string, DrivingPoint> driving_points;  ///< by group
  std::vector<double> modal_masses;                    ///< kg, by mode, where the records do not tell them
  std::function<void(std::size_t, std::size_t)> progress{};  ///< percent done, of 100
};

/// Impacts at one point: the records of one group.
struct SurveyReference {
  std::string group;
  Eigen::Index driving_channel = -1;  ///< index into ModalSurvey::channels; -1: no response is measured there
  int sign = 1;
  FrequencyResponse response;
};

struct MassEstimate {
  std::string group;
  double mass = 0;    ///< kg, real part of Eq. (2.7)
  bool used = false;  ///< false: the reference hardly moves in this mode
};

/// What a motion did in the records: the 95 % interval of its damping over them (PoleSupport).
enum class MotionTrend { decays, grows, undetermined };
/// As in modal.json.
std::string to_string(MotionTrend trend);

struct SurveyMode {
  double natural_frequency_hz = 0, natural_frequency_sd_hz = 0;
  double damping_ratio = 0, damping_ratio_sd = 0;
  double degrees_of_freedom = 0;  ///< of the two standard deviations, for Student's t; zero: nothing tells
  std::string from;               ///< where these come from
  std::complex<double> pole;      ///< rad/s
  StableMode diagram;             ///< what stood in the stabilisation diagram
  MeanShape shape;                ///< scaled by Eq. (2.2)
  double phase_collinearity = 0;
  double window_s = 0;  ///< length of its windows; 0: it has none
  std::optional<AmplitudeDependence> amplitude;
  std::vector<MassEstimate> masses;
  std::optional<double> mass;        ///< kg
  double mass_sd = 0;                ///< kg; zero where it was given or cannot be determined
  std::vector<std::string> remarks;  ///< a warning says each once, behind the names of the modes that it holds for

  /// Its values are those of a fit that leaves more than noise near its pole (docs/inference.md (M7)).
  bool leaves_more_than_noise() const { return diagram.support.more_than_noise && pole == diagram.support.value; }
  /// Undetermined also where free motions do not tell the pole.
  MotionTrend trend() const;
  /// 95 % by Student's law; nothing where the standard deviations have one degree of freedom or none.
  std::optional<Interval> frequency_interval_hz() const;
  std::optional<Interval> damping_interval() const;
};

/// A pole that stood in the stabilisation diagram and is no mode.
struct DroppedPole {
  std::complex<double> pole;  ///< rad/s
  std::string reason;
};

/// A motion that modes make together: a harmonic of one or a combination of two.
struct SurveyTone {
  SurveyMode found;          ///< as it was found among the modes
  std::size_t modes[2];      ///< of which modes, by their place among the survey's modes
  int times[2];              ///< how often each; the second is zero of a harmonic, negative of a difference
  Interval expected_hz;      ///< where these modes put it, from small to large amplitude
  Interval expected_rate;    ///< 1/s: the rate at which it decays
  double chance = 0;         ///< that a mode is there by chance
  std::string name() const;  ///< "2 v1", "v2 - v1"
  std::string reason() const;
};

/// Modal parameters of a campaign of impacts or free decays.
struct ModalSurvey {
  Campaign campaign;
  ModalSurveyOptions options;
  std::vector<std::size_t> channels;  ///< the responses, indices into campaign.channels
  ResponseForm form = ResponseForm::accelerance;
  std::string unit;  ///< of the responses
  StabilisationDiagram diagram;
  std::vector<SurveyMode> modes;            ///< by frequency
  std::vector<SurveyTone> tones;            ///< by frequency
  std::vector<DroppedPole> dropped;         ///< by frequency
  Eigen::MatrixXd mac;                      ///< of the modes' shapes
  std::vector<SurveyReference> references;  ///< empty without measured forces
  std::vector<ModeWindow> windows;          ///< of the free decays; centre_s in record time
  Eigen::VectorXd spectrum_hz, spectrum;    ///< root-mean-square over channels (and references), for the diagram
  std::vector<std::string> warnings;

  /// Mass-normalised shapes, real parts (p x modes), Eq. (2.13); nothing unless every mode has its mass.
  std::optional<Eigen::MatrixXd> mass_normalised() const;
  /// Of `channels`.
  std::string channel_name(Eigen::Index channel) const;
};

/// Modes from the impacts where the campaign has records of kind `impact` with a force channel (H1, realization
/// with feed-through, poles and residues refined on the lines of the band, error bars of shapes and masses by
/// leaving out one impact at a time; frequencies and dampings by the same fit of free motions as those of decays,
/// or by the lines where nothing follows the blows); otherwise from the free decays (an impact without a force
/// channel is one). Of the poles that stand in the stabilisation diagram those that the free motions do not support
/// (pole_support) are dropped. Frequency and damping against amplitude from the free decays where there are any.
/// Throws InputError for a campaign with neither, responses of different quantities, options that do not fit the
/// campaign, records too short; NumericalFailure where no mode stands out of the noise.
ModalSurvey modal_survey(const Campaign& campaign, const ModalSurveyOptions& options);
/// The same of a campaign folder.
ModalSurvey modal_survey(const std::filesystem::path& folder, const ModalSurveyOptions& options);

/// The [modal_basis] table of campaign.toml, mode names v1, v2, ... Throws InputError where a mass is missing.
std::string modal_basis_text(const ModalSurvey& survey);

}  // namespace secular
