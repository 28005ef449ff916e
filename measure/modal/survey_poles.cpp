#include "measure/modal/survey_poles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

#include "measure/modal/mode_scaling.hpp"
#include "measure/modal/pole.hpp"
#include "numerics/hertz.hpp"

namespace secular {

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
  std::vector<PoleSupport> support = pole_support(motions, candidates, 0.01, [&survey](double share) {
    if (survey.options.progress) survey.options.progress(static_cast<std::size_t>(100 * share), 100);
  });
  std::size_t next = 0;
  for (std::vector<StableMode>* list : lists) {
    for (StableMode& mode : *list) {
      mode.support = std::move(support[next++]);
      if (!mode.support.stands) survey.dropped.push_back({mode.pole, mode.support.reason});
    }
    std::erase_if(*list, [](const StableMode& mode) { return !mode.support.stands; });
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
