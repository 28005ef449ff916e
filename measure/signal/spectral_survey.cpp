#include "measure/signal/spectral_survey.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "measure/signal/arma.hpp"
#include "measure/signal/model_order.hpp"
#include "measure/signal/tone_search.hpp"
#include "measure/signal/transform_length.hpp"
#include "numerics/fourier_transform.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Way {
  const char* name;
  PolynomialMethod method;
  bool refine;
};
constexpr Way ways[] = {{"4.3.1 least squares", PolynomialMethod::least_squares, false},
                        {"4.3.2 Pisarenko", PolynomialMethod::noise_eigenvector, false},
                        {"4.3.3 covariance", PolynomialMethod::lagged_covariance, false},
                        {"maximum likelihood", PolynomialMethod::noise_eigenvector, true}};

struct Term {
  PoleFamily family = PoleFamily::circular;
  double frequency_hz = 0, p = 0, q = 0, rate = 0;
  double frequency_sd = std::numeric_limits<double>::quiet_NaN(), amplitude_sd = frequency_sd;
};

// Unknown terms of one channel by frequency. A product of circular and hyperbolic functions is listed with the
// amplitudes of its cosine and sine at the first sample.
std::vector<Term> terms_of(const Decomposition& d, Index channel) {
  std::vector<Term> terms;
  for (std::size_t i = 0; i < d.poles.size(); ++i) {
    const Pole& pole = d.poles[i];
    if (pole.imposed || pole.family == PoleFamily::constant) continue;
    const bool oscillates = pole.family == PoleFamily::circular || pole.family == PoleFamily::product;
    const Index row = d.first_function(i);
    Term term{pole.family, (oscillates ? pole.frequency : pole.rate) * to_hz, d.amplitudes(row, channel),
              d.amplitudes(row + 1, channel), pole.family == PoleFamily::circular ? 0 : pole.rate};
    if (d.covariance.size() > 0) {
      const Index unknown = d.first_parameter(i), at = d.amplitude_row(row, channel);
      const Eigen::Vector2d along = Eigen::Vector2d(term.p, term.q).normalized();
      term.frequency_sd = std::sqrt(d.covariance(unknown, unknown)) * to_hz;
      term.amplitude_sd = std::sqrt(along.dot(d.covariance.block<2, 2>(at, at) * along));
    }
    terms.push_back(term);
  }
  std::stable_sort(terms.begin(), terms.end(),
                   [](const Term& a, const Term& b) { return a.frequency_hz < b.frequency_hz; });
  return terms;
}

struct Spread {
  double mean = 0, sd = 0;
};
Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) spread.mean += v / n;
  for (const double v : values) spread.sd += (v - spread.mean) * (v - spread.mean);
  spread.sd = n > 1 ? std::sqrt(spread.sd / (n - 1)) : std::numeric_limits<double>::quiet_NaN();
  return spread;
}

// Gives the terms of an ensemble the places of those of the first one: within two bins the strongest choose first,
// the others (noise, drifts) are put in order of frequency into what is left.
std::vector<Term> matched(std::vector<Term> terms, const std::vector<Term>& first, double bin_hz) {
  if (terms.size() != first.size()) return {};
  std::vector<std::size_t> order(first.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::hypot(first[a].p, first[a].q) > std::hypot(first[b].p, first[b].q);
  });
  std::vector<Term> placed(first.size());
  std::vector<bool> filled(first.size());
  for (const std::size_t place : order) {
    std::size_t nearest = terms.size();
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const double distance = std::abs(terms[k].frequency_hz - first[place].frequency_hz);
      if (terms[k].family == first[place].family && distance < 2 * bin_hz &&
          (nearest == terms.size() || distance < std::abs(terms[nearest].frequency_hz - first[place].frequency_hz)))
        nearest = k;
    }
    if (nearest == terms.size()) continue;
    placed[place] = terms[nearest];
    filled[place] = true;
    terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(nearest));
  }
  for (std::size_t place = 0, k = 0; place < placed.size(); ++place)
    if (!filled[place]) placed[place] = terms[k++];
  return placed;
}

std::vector<TermStatistics> statistics_of(const std::vector<std::vector<Term>>& ensembles, double bin_hz) {
  std::vector<std::vector<Term>> rows(ensembles.front().size());
  for (const std::vector<Term>& terms : ensembles) {
    const std::vector<Term> placed = matched(terms, ensembles.front(), bin_hz);
    for (std::size_t i = 0; i < placed.size(); ++i) rows[i].push_back(placed[i]);
  }
  std::vector<TermStatistics> result;
  for (const std::vector<Term>& terms : rows) {
    int counts[5] = {};
    for (const Term& term : terms) ++counts[static_cast<int>(term.family)];
    TermStatistics row;
    row.family =
        static_cast<PoleFamily>(std::max_element(std::begin(counts), std::end(counts)) - std::begin(counts));
    row.p = terms.front().p;
    row.q = terms.front().q;
    std::vector<double> frequency, amplitude, rate;
    for (const Term& term : terms) {
      if (term.family != row.family) continue;
      rate.push_back(term.rate);
      frequency.push_back(term.frequency_hz);
      amplitude.push_back(std::hypot(term.p, term.q));
    }
    row.ensembles = static_cast<int>(frequency.size());
    const Spread f = spread_of(frequency), a = spread_of(amplitude);
    row.frequency_hz = f.mean;
    row.frequency_sd = terms.size() > 1 ? f.sd : terms.front().frequency_sd;
    row.amplitude = a.mean;
    row.amplitude_sd = terms.size() > 1 ? a.sd : terms.front().amplitude_sd;
    row.rate = spread_of(rate).mean;
    result.push_back(row);
  }
  return result;
}

// Decompositions of one channel by one method over all ensembles.
MethodStatistics method_statistics(const Eigen::Ref<const VectorXd>& channel, const SpectralSurvey& survey,
                                   const Way& way, bool offset) {
  MethodStatistics statistics;
  statistics.name = way.name;
  DecompositionOptions options;
  options.order = survey.order;
  options.method = way.method;
  options.refine = way.refine;
  options.offset = offset;
  std::vector<std::vector<Term>> ensembles;
  std::vector<double> correlation, ratio;
  if (survey.layout.length < fewest_for_polynomial(survey.order + (offset ? 1 : 0), way.method)) return statistics;
  for (Index k = 0; k < survey.layout.count; ++k) {
    const Decomposition d =
        decompose(channel.segment(k * survey.layout.step, survey.layout.length), survey.sample_rate_hz, options);
    if (!d.determined || !d.amplitudes.allFinite() || !std::isfinite(d.correlation(0)))
      continue;  // a rate beyond all numbers
    ensembles.push_back(terms_of(d, 0));
    correlation.push_back(d.correlation(0));
    ratio.push_back(d.signal_to_noise_db(0));
  }
  statistics.ensembles = static_cast<int>(ensembles.size());
  if (ensembles.empty()) return statistics;
  statistics.terms = statistics_of(ensembles, survey.sample_rate_hz / static_cast<double>(survey.layout.length));
  statistics.correlation = spread_of(correlation).mean;
  statistics.signal_to_noise_db = spread_of(ratio).mean;
  return statistics;
}

void check_settled(SpectralSurvey& survey, const Eigen::Ref<const MatrixXd>& channels) {
  if (survey.layout.count < 4) return;
  // The tones that stand in the refined decomposition, two bins from zero, Nyquist and each other.
  const double bin = two_pi * survey.sample_rate_hz / static_cast<double>(survey.layout.length);
  std::vector<double> frequencies;
  for (std::size_t i = 0; i < survey.decomposition.poles.size(); ++i) {
    const Pole& pole = survey.decomposition.poles[i];
    if (pole.family != PoleFamily::circular || pole.frequency < 2 * bin ||
        pole.frequency > std::numbers::pi * survey.sample_rate_hz - 2 * bin)
      continue;
    bool stands = false;
    for (Index c = 0; c < channels.cols(); ++c) {
      const ToneEstimate tone = survey.decomposition.tone(i, c);
      stands = stands || tone.amplitude > 8 * tone.amplitude_sd;
    }
    const bool apart = frequencies.empty() || pole.frequency - frequencies.back() > 2 * bin;
    if (stands && apart) frequencies.push_back(pole.frequency);
  }
  if (frequencies.empty()) return;
  survey.settling = check_settling(channels, survey.sample_rate_hz, frequencies, survey.layout, true);
}

}  // namespace

OrderStep largest_step(const Eigen::Ref<const VectorXd>& values) {
  OrderStep step;
  // Below the rounding of the largest one there is nothing to compare.
  const double floor = values.size() > 0 ? values(0) * 1e-14 : 0;
  for (Index m = 0; m + 1 < values.size() && values(m) > floor; ++m) {
    const double ratio = values(m) / std::max(values(m + 1), floor);
    if (ratio > step.ratio) {
      step.ratio = ratio;
      step.functions = static_cast<int>(m) + 1;
    }
  }
  step.clear = step.ratio >= 10;
  return step;
}

Index fewest_for_relation(int delays) {
  return 3 * static_cast<Index>(delays) + 2;
}

LinearRelation linear_relation(const Eigen::Ref<const VectorXd>& excitation,
                               const Eigen::Ref<const VectorXd>& response, int delays) {
  LinearRelation relation;
  const MatrixXd correlation = delayed_correlation(excitation, response, delays, delays);
  const Index n = delays + 1;
  relation.response = correlation.block(0, 0, n, 1);
  relation.cross = correlation.block(n, 0, n, 1);
  relation.excitation = correlation.block(n, n, n, 1);
  relation.block_correlation = input_output_correlation(excitation, response, delays, delays);
  // Two tones of unit correlation matrices: rank decides how many delays count.
  const MatrixXd inner = correlation.bottomRightCorner(n, n);
  const VectorXd solution = inner.completeOrthogonalDecomposition().solve(relation.cross);
  relation.delays = delays;
  relation.explained = std::clamp(relation.cross.dot(solution), 0.0, 1.0);
  relation.coherent = coherent_share(excitation, response);
  return relation;
}

int most_terms(Index samples, bool offset) {
  // A polynomial needs three samples for every pair, a constant being one. Refinement needs, of every term, two
  // amplitudes and a frequency, and two samples more.
  return static_cast<int>((samples - (offset ? 3 : 2)) / 3);
}

SurveyObstacle obstacle_to_survey(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                                  const SpectralOptions& options) {
  if (channels.cols() < 1 || channels.rows() < 16) return SurveyObstacle::few_samples;
  if (!channels.allFinite()) return SurveyObstacle::not_finite;
  if (!(channels.cwiseAbs().maxCoeff() > 0)) return SurveyObstacle::silence;
  const auto rows = static_cast<double>(channels.rows());
  const double length = options.ensemble_s > 0 ? std::round(options.ensemble_s * sample_rate_hz) : rows;
  if (!(length >= 1 && length <= rows && options.overlap >= 0 && options.overlap < 1))
    return SurveyObstacle::ensemble;
  if (std::max(options.order, 1) > most_terms(static_cast<Index>(length), options.offset))
    return SurveyObstacle::order;
  if (length < 8 * static_cast<double>(channels.cols()) || options.delays < 2)
    return SurveyObstacle::ensemble_for_delays;
  return SurveyObstacle::none;
}

SpectralSurvey spectral_survey(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                               const SpectralOptions& options) {
  if (obstacle_to_survey(channels, sample_rate_hz, options) != SurveyObstacle::none)
    throw std::invalid_argument("a survey that its record or its options do not allow");
  SpectralSurvey survey;
  survey.sample_rate_hz = sample_rate_hz;
  const Index length = options.ensemble_s > 0 ? static_cast<Index>(std::lround(options.ensemble_s * sample_rate_hz))
                                              : channels.rows();
  survey.layout = ensemble_layout(channels.rows(), length, options.overlap);
  const MatrixXd first = channels.topRows(length);
  ToneSearchOptions search;
  search.max_tones = std::min<int>(options.largest_order, static_cast<int>(length / 16));
  if (options.offset) search.beside.push_back({PoleFamily::constant, 0, 0, true});
  const ToneSearch found = search_tones(first, sample_rate_hz, search);
  survey.tones = found.tones;
  survey.tones_limited = found.tones >= search.max_tones && found.probability.back() <= search.false_alarm;
  survey.order_by_test = options.order == 0;
  survey.order = options.order > 0 ? options.order : std::max(1, found.tones);
  DecompositionOptions refined;
  refined.order = survey.order;
  refined.refine = true;
  refined.offset = options.offset;
  survey.decomposition = decompose(first, sample_rate_hz, refined);
  if (!survey.decomposition.determined) return survey;
  for (Index c = 0; c < channels.cols(); ++c) {
    survey.tables.emplace_back();
    survey.peaks.emplace_back();
    if (!(channels.col(c).cwiseAbs().maxCoeff() > 0)) continue;
    for (const Way& way : ways)
      survey.tables.back().push_back(method_statistics(channels.col(c), survey, way, options.offset));
    for (const TermStatistics& term : survey.tables.back().back().terms)
      if (term.family == PoleFamily::circular)
        survey.peaks.back().push_back(spectrum_peak(first.col(c), sample_rate_hz, term.frequency_hz / to_hz));
  }
  check_settled(survey, channels);
  const auto delays = static_cast<int>(std::min<Index>(options.delays, length / 4 / channels.cols()));
  survey.temporal = temporal_singular_values(first, delays);
  survey.step = largest_step(survey.temporal);
  const OrderSingularValues orders = order_singular_values(first, std::min(delays, static_cast<int>(length / 3)));
  survey.biased = orders.biased;
  survey.unbiased = orders.unbiased;
  survey.spatial = spatial_components(first).singular_values;
  if (channels.cols() > 1) {
    const bool noise_known = survey.decomposition.noise_sd.minCoeff() > 0;
    survey.spatial_count = noise_known ? count_spatial_functions(first, survey.decomposition.noise_sd)
                                       : count_spatial_functions(first);
  }
  return survey;
}

AmplitudeSpectrum amplitude_spectrum(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                                     Index length) {
  length = cut_transform_length(std::min(length, channels.rows()));
  if (length < 4) throw std::invalid_argument("a spectrum needs 4 samples or more");
  AmplitudeSpectrum spectrum;
  const Index lines = length / 2 + 1;
  spectrum.frequency_hz = VectorXd::LinSpaced(lines, 0, 0.5 * sample_rate_hz);
  spectrum.amplitude = MatrixXd::Zero(lines, channels.cols());
  VectorXd window(length);
  for (Index i = 0; i < length; ++i)
    window(i) = 1 - std::cos(two_pi * static_cast<double>(i) / static_cast<double>(length));
  double segments = 0;
  for (Index begin = 0; begin + length <= channels.rows(); begin += length / 2, ++segments)
    for (Index c = 0; c < channels.cols(); ++c) {
      VectorXd part = channels.col(c).segment(begin, length);
      part.array() -= part.mean();
      part.array() *= window.array();
      spectrum.amplitude.col(c) += half_spectrum(part).cwiseAbs2();
    }
  spectrum.amplitude = (spectrum.amplitude / segments).cwiseSqrt() * (2 / static_cast<double>(length));
  return spectrum;
}

}  // namespace secular
