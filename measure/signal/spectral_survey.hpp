#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "measure/signal/coherent_share.hpp"
#include "measure/signal/decomposition.hpp"
#include "measure/signal/ensembles.hpp"
#include "measure/signal/exponential_fit.hpp"
#include "measure/signal/principal_components.hpp"
#include "measure/signal/settling.hpp"

namespace secular {

struct SpectralOptions {
  int order = 0;           ///< n, pairs of poles of a decomposition; zero: the number of tones found by the test
  double ensemble_s = 0;   ///< zero: the whole record is one ensemble
  double overlap = 0;      ///< share of an ensemble that the next one sees again
  int delays = 60;         ///< columns of the Hankel matrices
  int largest_order = 12;  ///< where the test stops adding tones
  int arma_order = 20;     ///< delays of excitation and response whose correlation is looked at
  bool offset = false;     ///< a constant per channel beside the functions
};

/// One term of a decomposition over the ensembles: those next in frequency to a term of the first ensemble. Of one
/// ensemble there is no scatter: the deviations are maximum likelihood's own, and NaN for the other ways.
struct TermStatistics {
  PoleFamily family = PoleFamily::circular;   ///< of most ensembles
  int ensembles = 0;                          ///< that have such a term of this family
  double frequency_hz = 0, frequency_sd = 0;  ///< mean and scatter; a rate over 2 pi for hyperbolic terms
  double amplitude = 0, amplitude_sd = 0;     ///< |p + i q| of the channel (|a + i b| for hyperbolic terms)
  double rate = 0;                            ///< 1/s, mean: of growth or decay, zero for circular terms
  double p = 0, q = 0;                        ///< (or a and b) of the first ensemble, at its first sample
};

/// What one way of estimation says of one channel.
struct MethodStatistics {
  std::string name;               ///< "4.3.1 least squares", "maximum likelihood", ...
  int ensembles = 0;              ///< in which it found a decomposition
  double correlation = 0;         ///< gamma^2, mean over ensembles
  double signal_to_noise_db = 0;  ///< mean over ensembles
  std::vector<TermStatistics> terms;
};

/// How many functions of time a Hankel matrix needs (section 3.1.1), by the largest step of its singular values.
struct OrderStep {
  int functions = 0;   ///< singular values before the step
  double ratio = 1;    ///< across the step
  bool clear = false;  ///< a factor of ten or more
};
/// `singular_values`: from the largest on. Without any, or where the first is zero, no step.
OrderStep largest_step(const Eigen::Ref<const Eigen::VectorXd>& singular_values);

/// What a linear relation with delays can make of input and output (Appendix C).
struct LinearRelation {
  Eigen::VectorXd response, excitation, cross;  ///< correlation with v(i) of v(i+k), of u(i) with u(i+k), v with u
  double block_correlation = 0;                 ///< RV coefficient of the two blocks of Eq. (C.4)
  int delays = 0;
  double explained = 0;  ///< share of the response's variance that so many delays explain by least squares
  std::optional<CoherentShare> coherent;  ///< what a filter of any form explains
};
/// The fewest samples for it: three times the delays and two more.
Eigen::Index fewest_for_relation(int delays);
/// `delays`: of both, in samples. Throws std::invalid_argument for signals of different lengths, and for one of
/// fewer samples than fewest_for_relation.
LinearRelation linear_relation(const Eigen::Ref<const Eigen::VectorXd>& excitation,
                               const Eigen::Ref<const Eigen::VectorXd>& response, int delays);

/// One record as a sum of functions of time (chapter 4) and of space (chapter 3).
struct SpectralSurvey {
  double sample_rate_hz = 0;
  EnsembleLayout layout;
  int order = 0;
  bool order_by_test = false;
  int tones = 0;                                      ///< by the test
  bool tones_limited = false;                         ///< the test would have gone on
  std::vector<std::vector<MethodStatistics>> tables;  ///< [channel][method]
  std::vector<std::vector<SpectrumPeak>> peaks;       ///< [channel][term]: the transform's, first ensemble
  Decomposition decomposition;                        ///< of all channels together, first ensemble, refined
  std::optional<SettlingReport> settling;             ///< with four ensembles or more
  Eigen::VectorXd temporal, biased, unbiased;         ///< singular values: (3.18); section 4.4.1
  OrderStep step;                                     ///< of `temporal`
  Eigen::VectorXd spatial;                            ///< singular values (3.17)
  SpatialCount spatial_count;                         ///< by the test, with two channels or more
};

/// What of a record or of the options stands in the way of a survey.
enum class SurveyObstacle {
  none,
  few_samples,         ///< fewer than 16
  not_finite,          ///< a sample is no number
  silence,             ///< every sample is zero
  ensemble,            ///< longer than the record, or shorter than a sample; or the overlap is not in [0, 1)
  order,               ///< more terms than an ensemble determines: see most_terms
  ensemble_for_delays  ///< shorter than eight samples for every channel; or fewer than two delays
};
SurveyObstacle obstacle_to_survey(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                                  const SpectralOptions& options);
/// The most terms of a decomposition of so many samples.
int most_terms(Eigen::Index samples, bool offset);

/// Analyses samples x channels. Throws std::invalid_argument where an obstacle stands in the way. Where the
/// decomposition is not determined, what follows from it is left out.
SpectralSurvey spectral_survey(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                               const SpectralOptions& options);

/// Amplitude spectrum of every channel (Hann window over segments of `length` samples that overlap by half, root
/// mean square over segments; a tone in the middle of a bin shows its peak amplitude): lines x channels, from zero
/// to half the sample rate. `length` is cut to one that transforms are fast at; throws std::invalid_argument where
/// that is below four.
struct AmplitudeSpectrum {
  Eigen::VectorXd frequency_hz;
  Eigen::MatrixXd amplitude;
};
AmplitudeSpectrum amplitude_spectrum(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                                     Eigen::Index length);

}  // namespace secular
