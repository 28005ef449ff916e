#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "measure/data/campaign.hpp"
#include "measure/signal/band_pass.hpp"

namespace secular {

/// docs/inference.md (44): correlations of what white noise does to a tone in two windows of a decay that overlap,
/// in the frame of the tone.
struct ToneOverlap {
  double amplitudes = 0, slopes = 0;
  double slope_later = 0, slope_earlier = 0;  ///< that with the other window's amplitude
};

/// Of a window with a later one.
struct WindowPair {
  std::vector<ToneOverlap> mode;  ///< [mode]
  std::vector<double> harmonic;   ///< [block] of amplitudes; zero where not measured
};

/// docs/inference.md (54): the motion of a dwell at which its columns are instruments, where natural frequencies
/// differ from record to record.
struct InstrumentMotion {
  std::vector<std::complex<double>> amplitude, rate;  ///< [mode]
  double noise_left = 1;                              ///< of what noise does to the measured motion
  /// Whether the equations have it; else the observation tells no coefficient.
  bool found = false;
};

/// One ensemble of a dwell or one window of a decay, ready for the generated rows. Amplitudes are of modal
/// displacements, half of the peak, with phases at the window's centre.
struct Observation {
  int condition = 0;       ///< what repeats of one test condition share; the clusters of the regression
  std::size_t record = 0;  ///< index into Campaign::records
  double centre_s = 0;     ///< in the record's time
  double length_s = 0;     ///< of a decay's window
  /// Of a decay's window, the same for those of its stretch: [n - 1] with a window that begins n steps later, of
  /// which the length has one more than there are entries.
  std::shared_ptr<const std::vector<WindowPair>> overlap;
  std::vector<double> excitation_frequency;  ///< [excitation] rad/s
  std::vector<double> excitation_frequency_sd;
  std::vector<std::complex<double>> forcing;  ///< [excitation] F exp(i*phase)
  std::vector<double> forcing_sd;             ///< of real and imaginary part
  /// [block] of a harmonic: what the one excitation holds at its line, as `forcing`; sd negative: not measured.
  std::vector<std::complex<double>> forcing_harmonic;
  std::vector<double> forcing_harmonic_sd;
  std::vector<std::complex<double>> amplitude;  ///< [mode]
  std::vector<double> amplitude_sd;
  std::vector<std::complex<double>> rate;  ///< [mode] growth + i*(observed frequency)
  /// [mode]. A negative growth_sd: the mode is not seen here, and its equation says nothing.
  std::vector<double> growth_sd, frequency_sd;
  /// Dwells, of frequencies that the case leaves free (ModeFrequencies::free): what the modes' frequencies share.
  std::vector<double> free_frequency_sd;
  /// False: of a table that does not say its standard deviations. They are 0 then until repeats or what a model
  /// leaves have told them; of what drives it none are known.
  bool noise_known = true;
  /// Of a dwell. Null: columns at the measured motion.
  std::shared_ptr<const InstrumentMotion> instrument;
  std::vector<std::complex<double>> harmonic;  ///< [block] measured harmonic, 0 where not measured
  std::vector<double> harmonic_sd;             ///< [block], negative where not measured
  /// Of a decay's window, [mode]: what the modal coordinate of the channels' own quantity shows at zero frequency.
  std::vector<double> mean, mean_sd;
};

struct ObservationSet {
  const CompiledModel* model = nullptr;
  const CompiledCase* resonance = nullptr;
  std::vector<Observation> observations;
  std::vector<Observation> at_rest;  ///< ensembles of dwells left out because nothing moves
  /// The excitations' phases against the responses are unknown, in every ensemble: no equation may rest on them.
  bool phase_unknown = false;
  /// Of dwells, by mode, rad/s: standard deviation with which the natural frequency differs from record to record.
  /// Empty: records do not differ.
  std::vector<double> frequency_scatter;
  /// observations x blocks: what the truncated equations leave (left minus right side) where they should leave
  /// nothing, by motion_frame; taken out of them before they are fitted. Empty: not known.
  Eigen::MatrixXcd truncation;
  /// With `truncation`: natural frequencies, by mode, at which the equations' columns are taken there and in the
  /// regression. Empty: those that the regression finds.
  std::vector<double> column_frequency;
  /// By direction in which parameters may move without any lump noticing (SharedParameters::null_space): how much
  /// larger `truncation` is where they have moved along it. Empty: not known.
  std::vector<Eigen::MatrixXcd> truncation_change;
  /// The same by column of EstimatePass::moves.
  std::vector<Eigen::MatrixXcd> truncation_of_moves;
  std::vector<std::string> warnings;
};

/// The part of each record to use, and which records.
struct Window {
  double from_s = -1e300, to_s = 1e300;
  std::string records = "*";  ///< shell pattern on the record's file
  /// What the records have been filtered to when they are read (passed_record): nothing else is seen in them.
  std::optional<Band> band;
  std::vector<bool> chosen;  ///< by record: those of one case; empty: all
  unsigned threads = 1;      ///< for reading and observing; the result does not depend on it

  /// Whether it uses a record, by its index and its file.
  bool takes(std::size_t record, const std::string& file) const;
  /// Whether it uses a part of each record only.
  bool cuts() const { return band || from_s != Window{}.from_s || to_s != Window{}.to_s; }
  /// Whether a frequency (rad/s) is in the band.
  bool passes(double frequency) const;
  /// Of standard deviations that come from what a fit of lines leaves of the samples, as if that were white noise:
  /// the band has taken a part of the noise's variance away, and nothing of it beside the lines.
  double noise_factor(double sample_rate_hz) const;
};

/// Samples of one of a campaign's records by its index: read from its file, or replayed on a model. Called from any
/// thread.
using RecordReader = std::function<Record(std::size_t record)>;

/// How an ensemble of a dwell is taken.
enum class DwellMotion {
  steady,     ///< amplitudes stand still; dwells that do not are left out
  transient,  ///< amplitudes may change slowly: their rate is observed too. For noise-free records of a model
};

/// Ensembles of every dwell: excitation by circular-hyperbolic decomposition and maximum likelihood, responses by
/// maximum likelihood at frequencies related to it as the case says; where the resonance leaves a frequency free
/// (Omega = omega1 + omega2: only the sum of the response frequencies is known), that is estimated with them.
/// Dwells on the trivial branch, records that have not settled, combination resonances whose modes are not locked
/// to the excitation and records whose excitation channel holds something else are reported and left out.
ObservationSet observe_dwells(const Campaign& campaign, const RecordReader& read, const CompiledModel& model,
                              const CompiledCase& resonance, const Window& window,
                              DwellMotion motion = DwellMotion::steady);

/// Windows over every free decay, from its start (found) to where its last mode sinks into the noise: amplitudes
/// and rates of all modes that ring, together. They are a twenty-fourth of the decay long, shorter where amplitudes
/// change fast, but separate the tones. A condition is a stretch of two windows' length, with windows a quarter of
/// theirs apart. What their length does to rates (of the order of the rate times the square of the change of
/// amplitude in one) the replayed motion has too: it comes out with the truncation.
ObservationSet observe_free_decays(const Campaign& campaign, const RecordReader& read_samples,
                                   const CompiledModel& model, const CompiledCase& resonance, const Window& window);

}  // namespace secular
