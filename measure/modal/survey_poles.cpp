#include "measure/modal/survey_poles.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

#include "measure/modal/mode_scaling.hpp"
#include "measure/modal/pole.hpp"
#include "measure/modal/pole_fit.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;

// A mode that the diagram showed as one with a candidate, and the shapes (channels, residues) of the candidate and
// of itself, each of what its residues in all records have most in common.
struct TwoInOne {
  PoleSupport support;
  std::size_t seen_as;
  Eigen::VectorXcd shapes[2];
};

std::vector<TwoInOne> two_in_one(const FreeMotions& motions, const std::vector<PoleSupport>& support,
                                 std::size_t candidates) {
  std::vector<TwoInOne> found;
  if (support.size() == candidates) return found;
  std::vector<std::complex<double>> poles;
  std::vector<Index> row(support.size(), -1);
  for (std::size_t i = 0; i < support.size(); ++i) {
    if (!support[i].stands) continue;
    row[i] = static_cast<Index>(poles.size());
    poles.push_back(support[i].value);
  }
  const PoleFit fit =
      fit_residues(motions.samples, motions.sample_rate_hz,
                   Eigen::Map<const Eigen::VectorXcd>(poles.data(), static_cast<Index>(poles.size())));
  const auto shape = [&](std::size_t i) -> Eigen::VectorXcd {
    const Eigen::MatrixXcd residues =
        fit.residues.row(row[i]).reshaped(motions.channels, motions.samples.cols() / motions.channels);
    const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(residues, Eigen::ComputeThinU);
    return svd.singularValues()(0) * svd.matrixU().col(0);
  };
  for (std::size_t i = candidates; i < support.size(); ++i) {
    const auto first = static_cast<std::size_t>(support[i].beside);
    if (support[i].stands && support[first].stands) found.push_back({support[i], first, {shape(first), shape(i)}});
  }
  return found;
}

void set_shape(StableMode& mode, const Eigen::VectorXcd& residues) {
  mode.shape = residues;
  mode.strength = residues.cwiseAbs().maxCoeff();
}

}  // namespace

StabilisationDiagram diagram_of(const ModalSurvey& survey, const ResponseSequence& responses, double rate,
                                bool feedthrough) {
  StabilisationOptions options;
  options.largest_order = survey.options.largest_order;
  options.lowest_hz = survey.options.lowest_hz;
  options.highest_hz = survey.options.highest_hz;
  const auto samples = static_cast<Eigen::Index>(responses.size());
  const HankelSize size =
      hankel_size(samples, responses.front().rows(), responses.front().cols(), options.largest_order, feedthrough);
  return stabilisation_diagram(EigensystemRealization(responses, rate, feedthrough, size), options);
}

ResponseSequence as_references(const FreeMotions& motions) {
  ResponseSequence responses(static_cast<std::size_t>(motions.samples.rows()));
  for (Eigen::Index k = 0; k < motions.samples.rows(); ++k)
    responses[static_cast<std::size_t>(k)] =
        motions.samples.row(k).reshaped(motions.channels, motions.samples.cols() / motions.channels);
  return responses;
}

void keep_strongest(const std::vector<StabilisationDiagram*>& diagrams, int count) {
  std::vector<double> strengths;
  for (const StabilisationDiagram* diagram : diagrams)
    for (const StableMode& mode : diagram->modes) strengths.push_back(mode.strength);
  if (count <= 0 || static_cast<int>(strengths.size()) <= count) return;
  std::sort(strengths.rbegin(), strengths.rend());
  const double least = strengths[static_cast<std::size_t>(count - 1)];
  for (StabilisationDiagram* diagram : diagrams) {
    for (const StableMode& mode : diagram->modes)
      if (mode.strength < least) diagram->others.push_back(mode);
    std::erase_if(diagram->modes, [&](const StableMode& mode) { return mode.strength < least; });
  }
}

void keep_supported(ModalSurvey& survey, const FreeMotions& motions) {
  const std::array<std::vector<StableMode>*, 2> lists = {&survey.diagram.modes, &survey.diagram.others};
  std::vector<std::complex<double>> candidates;
  for (const std::vector<StableMode>* list : lists)
    for (const StableMode& mode : *list) candidates.push_back(mode.pole);
  const std::vector<PoleSupport> support = pole_support(motions, candidates, 0.01, [&survey](double share) {
    if (survey.options.progress) survey.options.progress(static_cast<std::size_t>(100 * share), 100);
  });
  const std::vector<TwoInOne> seconds = two_in_one(motions, support, candidates.size());
  std::size_t first = 0;
  for (std::vector<StableMode>* list : lists) {
    const std::size_t count = list->size();
    for (std::size_t i = 0; i < count; ++i) (*list)[i].support = support[first + i];
    for (const TwoInOne& second : seconds) {
      if (second.seen_as < first || second.seen_as >= first + count) continue;
      StableMode& known = (*list)[second.seen_as - first];
      StableMode mode = known;
      set_shape(known, second.shapes[0]);
      set_shape(mode, second.shapes[1]);
      mode.support = second.support;
      mode.pole = mode.support.value;
      list->push_back(std::move(mode));
    }
    first += count;
    for (const StableMode& mode : *list) {
      if (mode.support.stands) continue;
      survey.dropped.push_back({mode.pole, mode.support.reason});
      if (mode.support.moves) survey.diagram.no_resonances.push_back(mode);
    }
    std::erase_if(*list, [](const StableMode& mode) { return !mode.support.stands; });
    std::sort(list->begin(), list->end(), [](const StableMode& a, const StableMode& b) {
      return natural_frequency(a.support.value) < natural_frequency(b.support.value);
    });
  }
  std::sort(survey.dropped.begin(), survey.dropped.end(), [](const DroppedPole& a, const DroppedPole& b) {
    return natural_frequency(a.pole) < natural_frequency(b.pole);
  });
}

SurveyMode begin_mode(const StableMode& stable) {
  const PoleSupport& support = stable.support;
  SurveyMode mode;
  mode.diagram = stable;
  mode.pole = support.stands ? support.value : stable.pole;
  const double omega = natural_frequency(mode.pole);
  mode.natural_frequency_hz = omega * to_hz;
  mode.damping_ratio = damping_ratio(mode.pole);
  if (support.stands) {
    const double along = mode.pole.imag() / omega, across = mode.pole.real() / omega;
    mode.natural_frequency_sd_hz = std::hypot(along * support.omega_error, across * support.growth_error) * to_hz;
    mode.damping_ratio_sd = along * std::hypot(along * support.growth_error, across * support.omega_error) / omega;
    mode.degrees_of_freedom = std::numeric_limits<double>::infinity();  // of a noise that all samples tell
    mode.from = "maximum likelihood over the free motions, in their own noise";
  } else {
    mode.natural_frequency_sd_hz = stable.frequency_spread * to_hz;
    mode.damping_ratio_sd = stable.damping_spread;
    mode.from = "stabilisation diagram, spread over orders";
  }
  mode.shape = mean_shape(std::vector<Eigen::VectorXcd>{scale_shape(stable.shape).shape});
  return mode;
}

}  // namespace secular
