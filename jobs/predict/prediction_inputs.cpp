#include "jobs/predict/prediction_inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "estimator/model/locked_excitations.hpp"
#include "input/input_error.hpp"
#include "input/nearest_word.hpp"
#include "jobs/predict/prediction_spread.hpp"
#include "jobs/predict/prediction_units.hpp"
#include "jobs/shared/number_file.hpp"
#include "jobs/shared/parameter_file.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Observed over natural frequency, or the other way: no resonance at all, and one.
constexpr double far_off = 2, near_by = 1.1;

bool is_excitation_frequency(const CompiledModel& model, const std::string& name) {
  return std::find(model.excitation_frequencies.begin(), model.excitation_frequencies.end(), name) !=
         model.excitation_frequencies.end();
}

void check_combination(const PredictionRequest& request, const Prediction& prediction) {
  const bool excited = prediction.resonance->excited;
  const std::string name(prediction.resonance->name);
  if (!request.measured.empty() && (!excited || request.against))
    throw InputError("--measured " + request.measured, "", "there is no response to draw it on",
                     "measured dwells belong to a response over --vary of a case with excitation");
  if (!excited && (request.vary || request.against || request.sweep_up || request.sweep_down))
    throw InputError(
        "--vary, --curve, --sweep", "", "case " + name + " is without excitation",
        "leave them out: its backbone and limit cycles are computed; --largest sets how far. Over a parameter "
        "limit cycles are found in a case that does not say excitation = false");
  if (!excited) return;
  if (!request.vary)
    throw InputError("--vary", "", "is missing",
                     prediction.model->excitations.empty()
                         ? "name a parameter and its range, for example --vary mu 0.05 0.5; in a case that says "
                           "excitation = false limit cycles are computed without it"
                         : "name a parameter and its range, for example --vary Omega 150 160");
  if (request.curve.empty() != !request.against)
    throw InputError("--curve, --against", "", "one is given without the other",
                     "for example --vary Omega 150 160 --against F 5 30 --curve saddle_node");
  if (request.against && request.against->name == request.vary->name)
    throw InputError("--against " + request.against->name, "", "is the parameter of --vary", "name another one");
  if (request.against && (request.sweep_up || request.sweep_down))
    throw InputError("--sweep", "", "goes over one parameter", "leave out --curve and --against");
}

// To rad/s, of what a request gives in Hz.
double factor_of(const std::string& name, const PredictionRequest& request, const Prediction& prediction) {
  return request.hz && is_excitation_frequency(*prediction.model, name) ? two_pi : 1;
}

VariedParameter scaled(const VariedParameter& parameter, const char* option, const PredictionRequest& request,
                       const Prediction& prediction) {
  index_of(prediction, parameter.name);
  if (!std::isfinite(parameter.from) || !std::isfinite(parameter.to) || !(parameter.from < parameter.to))
    throw InputError(fmt::format("{} {} {} {}", option, parameter.name, parameter.from, parameter.to), "",
                     "is an empty range", "FROM must be below TO");
  const double factor = factor_of(parameter.name, request, prediction);
  return {parameter.name, factor * parameter.from, factor * parameter.to};
}

// Excitation frequencies are printed in Hz.
std::pair<double, std::string> printed(const std::string& name, const Prediction& prediction) {
  if (is_excitation_frequency(*prediction.model, name)) return {two_pi, "Hz"};
  return {1.0, ""};
}

void take_vary(const PredictionRequest& request, Prediction& prediction) {
  if (request.vary) {
    prediction.vary = scaled(*request.vary, "--vary", request, prediction);
    std::tie(prediction.axis, prediction.axis_unit) = printed(prediction.vary->name, prediction);
  }
  if (request.against) {
    prediction.against = scaled(*request.against, "--against", request, prediction);
    std::tie(prediction.against_axis, prediction.against_unit) = printed(prediction.against->name, prediction);
  }
}

// Steady motions of the case are the same whatever else has the identified lumps; harmonics and sweeps of the
// full equations are those of one such set.
template <typename Take>
void take_representative(const GivenParameters& given, const PredictionRequest& request, Prediction& prediction,
                         const Take& take) {
  std::vector<std::string> open;
  for (const auto& [name, value] : given.representative) {
    if (request.at.contains(name)) continue;
    take(name, value);
    open.push_back(name);
  }
  if (!open.empty())
    prediction.warnings.push_back(
        fmt::format("{} does not identify {}: values that go with its lumps are taken. Amplitudes, frequencies and "
                    "stability do not depend on the choice; harmonics, sweeps and other cases do",
                    request.parameters, fmt::join(open, ", ")));
}

// Frequencies that follow others: they may be given where they agree.
void follow_locked(const PredictionRequest& request, Prediction& prediction) {
  const CompiledModel& model = *prediction.model;
  const LockedExcitations locked(model, *prediction.resonance);
  const auto symbols = static_cast<Index>(model.symbols.size());
  const VectorXd given = prediction.parameters;
  locked.follow(prediction.parameters.data() + symbols);
  for (std::size_t j = 0; j < model.excitations.size(); ++j) {
    if (!locked.follows(j)) continue;
    const Index at = symbols + static_cast<Index>(j);
    const std::string& name = prediction.names[static_cast<std::size_t>(at)];
    const auto is_varied = [&](const auto& parameter) { return parameter && parameter->name == name; };
    if (is_varied(prediction.vary) || is_varied(prediction.against))
      throw InputError("--vary " + name, "", "follows from the relations: " + locked.text(j),
                       "vary the frequency that it follows");
    if (std::isfinite(given(at)) && std::isfinite(prediction.parameters(at)) &&
        std::abs(given(at) - prediction.parameters(at)) > 1e-9 * std::abs(given(at)))
      throw InputError(request.parameters, name,
                       fmt::format("is {:g} rad/s, and {} makes it {:g} rad/s{}", given(at), locked.text(j),
                                   prediction.parameters(at), prediction.vary ? " in the middle of the range" : ""),
                       "leave it out: it follows");
  }
}

// Largest ratio, as a logarithm, between the observed frequency of a mode and its natural one at the place of the
// range where it is least, of the mode with the least, all excitation frequencies times `factor`. Nothing where no
// excitation's frequency is observed.
std::optional<double> distance_from_resonance(const Prediction& prediction, double factor) {
  const CompiledModel& model = *prediction.model;
  const CompiledCase& resonance = *prediction.resonance;
  const std::size_t columns = model.modes() + model.excitations.size();
  std::optional<double> least;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    VectorXd p = prediction.parameters;
    p(index_of(prediction, prediction.vary->name)) =
        prediction.vary->from + share * (prediction.vary->to - prediction.vary->from);
    double* const frequency = p.data() + model.symbols.size();
    LockedExcitations(model, resonance).follow(frequency);
    for (std::size_t k = 0; k < model.modes(); ++k) {
      double observed = 0;
      bool driven = false;
      for (std::size_t c = 0; c < columns; ++c) {
        const Ratio weight = resonance.observed_frequency[k * columns + c];
        driven = driven || (c >= model.modes() && weight.numerator != 0);
        observed += static_cast<double>(weight.numerator) / weight.denominator *
                    (c < model.modes() ? p(static_cast<Index>(c)) : factor * frequency[c - model.modes()]);
      }
      if (!driven || resonance.mode_at_rest[k] || !(observed > 0)) continue;
      const double here = std::abs(std::log(observed / p(static_cast<Index>(k))));
      least = std::min(least.value_or(here), here);
    }
  }
  return least;
}

// Hz taken for rad/s, or the other way: the range is far from resonance as it is read and at it in the other unit.
void notice_unit(const PredictionRequest& request, Prediction& prediction) {
  if (!prediction.vary) return;
  const auto is_frequency = [&](const std::string& name) {
    return is_excitation_frequency(*prediction.model, name);
  };
  if (!is_frequency(prediction.vary->name) &&
      std::none_of(request.at.begin(), request.at.end(),
                   [&](const auto& entry) { return is_frequency(entry.first); }))
    return;
  const std::optional<double> as_read = distance_from_resonance(prediction, 1),
                              otherwise = distance_from_resonance(prediction, request.hz ? 1 / two_pi : two_pi);
  if (!as_read || !otherwise || *as_read < std::log(far_off) || *otherwise > std::log(near_by)) return;
  prediction.warnings.push_back(fmt::format(
      "excitation frequencies are read in {}, {:.1f} times off resonance at least; in {} they would be at "
      "it: {} --hz?",
      request.hz ? "Hz" : "rad/s", std::exp(*as_read), request.hz ? "rad/s" : "Hz",
      request.hz ? "leave out" : "forgotten"));
}

// Returns what is given.
GivenParameters read_parameters(const ModelSource& source, const PredictionRequest& request,
                                Prediction& prediction) {
  const CompiledModel& model = *prediction.model;
  GivenParameters given = request.given ? *request.given : read_parameter_file(request.parameters);
  const std::map<std::string, double> before = given.values;
  source.take_rest_position(given.values, request.parameters);
  const auto count = static_cast<Index>(prediction.names.size());
  prediction.parameters = VectorXd::Constant(count, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t s = 0; s < model.nominal.size(); ++s)
    prediction.parameters(static_cast<Index>(s)) = model.nominal[s];
  if (std::string unused = unused_numbers(request.parameters, given.values, model); !unused.empty())
    prediction.warnings.push_back(std::move(unused));
  const auto take = [&](const std::string& name, double value) {
    const auto found = std::find(prediction.names.begin(), prediction.names.end(), name);
    if (found != prediction.names.end()) prediction.parameters(found - prediction.names.begin()) = value;
  };
  for (const auto& [name, value] : given.values) take(name, value);
  if (given.identified_cases.contains(std::string(prediction.resonance->name)))
    take_representative(given, request, prediction, take);
  for (const auto& [name, value] : request.at)
    prediction.parameters(index_of(prediction, name)) = factor_of(name, request, prediction) * value;
  for (const auto* varied : {&prediction.vary, &prediction.against})
    if (*varied)
      prediction.parameters(index_of(prediction, (*varied)->name)) = 0.5 * ((*varied)->from + (*varied)->to);
  if (!prediction.resonance->excited)
    for (Index p = static_cast<Index>(model.symbols.size()); p < count; ++p) prediction.parameters(p) = 0;
  follow_locked(request, prediction);
  std::string missing;
  for (Index p = 0; p < count; ++p)
    if (!std::isfinite(prediction.parameters(p)))
      missing += (missing.empty() ? "" : ", ") + prediction.names[static_cast<std::size_t>(p)];
  if (!missing.empty())
    throw InputError(request.parameters, "", "gives no value for " + missing,
                     "add them to the file, or give them with --at NAME=VALUE");
  for (std::size_t k = 0; k < model.modes(); ++k)
    if (!(prediction.parameters(static_cast<Index>(k)) > 0))
      throw InputError(request.parameters, "key " + prediction.names[k], "is not positive",
                       "a natural frequency in rad/s was expected");
  find_uncertainty(request, given, given.values != before, prediction);
  return given;
}

}  // namespace

Index index_of(const Prediction& prediction, const std::string& name) {
  const auto found = std::find(prediction.names.begin(), prediction.names.end(), name);
  if (found == prediction.names.end())
    throw InputError(name, "", "is no parameter of model " + std::string(prediction.model->name),
                     remedy_for_word(fmt::format("its parameters are {}", fmt::join(prediction.names, ", ")), name,
                                     prediction.names));
  return found - prediction.names.begin();
}

void read_prediction_inputs(const ModelSource& source, const PredictionRequest& request, Prediction& prediction) {
  prediction.names = ResponseField::parameter_names(*prediction.model);
  check_combination(request, prediction);
  take_vary(request, prediction);
  find_units(request, read_parameters(source, request, prediction), prediction);
  const auto unit = [&](const VariedParameter& varied) {
    return prediction.units[static_cast<std::size_t>(index_of(prediction, varied.name))];
  };
  if (prediction.vary && prediction.axis_unit.empty()) prediction.axis_unit = unit(*prediction.vary);
  if (prediction.against && prediction.against_unit.empty()) prediction.against_unit = unit(*prediction.against);
  notice_unit(request, prediction);
}

}  // namespace secular
