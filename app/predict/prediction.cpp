#include "app/predict/prediction.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "app/predict/expansion_range.hpp"
#include "app/predict/measured_points.hpp"
#include "app/shared/model_loading.hpp"
#include "app/shared/number_file.hpp"
#include "app/shared/parameter_file.hpp"
#include "input/input_error.hpp"
#include "numerics/hertz.hpp"
#include "numerics/in_parallel.hpp"

namespace secular::app {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A change between two dwells by this share of the sweep's largest amplitude, and so many times the changes before
/// and after it, is a jump. A continuous onset like a square root changes 2.4 times as much in its first step as in
/// its second.
constexpr double share_of_a_jump = 0.2, ratio_of_a_jump = 3;

/// Share of the predicted typical amplitude with which every dwell of a simulated sweep is disturbed.
constexpr double disturbance_share = 2e-3;

constexpr int backbone_points = 200;

const CompiledCase& case_of(const CompiledModel& model, const std::string& name) {
  std::string known;
  for (const CompiledCase& resonance : model.cases) {
    if (resonance.name == name) return resonance;
    known += (known.empty() ? "" : ", ") + std::string(resonance.name);
  }
  if (name.empty() && model.cases.size() == 1) return model.cases[0];
  throw InputError("--case " + name, "", "model " + std::string(model.name) + " has no such case",
                   "its cases are " + known);
}

bool is_excitation_frequency(const CompiledModel& model, const std::string& name) {
  return std::find(model.excitation_frequencies.begin(), model.excitation_frequencies.end(), name) !=
         model.excitation_frequencies.end();
}

class Predictor {
 public:
  Predictor(const PredictionRequest& request, const SweepProgress& progress)
      : request_(request), progress_(progress) {}

  Prediction run() {
    const ModelSource source(request_.model, false);
    std::string wanted = request_.resonance;
    if (wanted.empty() && source.cases().size() == 1) wanted = source.cases()[0].name;
    result_.model = source.load(wanted.empty() ? std::vector<std::string>{} : std::vector<std::string>{wanted});
    result_.resonance = &case_of(*result_.model, request_.resonance);
    result_.names = ResponseField::parameter_names(*result_.model);
    check_combination();
    take_vary();
    read_parameters();
    const ResponseField field(*result_.model, *result_.resonance);
    try {
      range_.emplace(*result_.model, *result_.resonance,
                     source.expansion_sizes(std::string(result_.resonance->name)));
    } catch (const InputError& error) {  // a compiled model without its file
      result_.warnings.push_back(std::string("where the expansion ends is not known: ") + error.what());
    }
    if (!result_.resonance->excited) {
      add_backbones(field);
      return std::move(result_);
    }
    ResponseRequest response;
    response.parameters = result_.parameters;
    response.parameter = index_of(result_.vary->name);
    response.lower = result_.vary->from;
    response.upper = result_.vary->to;
    response.largest = request_.largest / 2;
    if (result_.against)
      add_curves(field, response);
    else
      add_diagram(field, response);
    return std::move(result_);
  }

 private:
  Index index_of(const std::string& name) const {
    const auto found = std::find(result_.names.begin(), result_.names.end(), name);
    if (found == result_.names.end())
      throw InputError(name, "", "is no parameter of model " + std::string(result_.model->name),
                       fmt::format("its parameters are {}", fmt::join(result_.names, ", ")));
    return found - result_.names.begin();
  }

  void check_combination() const {
    const bool excited = result_.resonance->excited;
    const std::string name(result_.resonance->name);
    if (!request_.measured.empty() && (!excited || request_.against))
      throw InputError("--measured " + request_.measured, "", "there is no response to draw it on",
                       "measured dwells belong to a response over --vary of a case with excitation");
    if (!excited && (request_.vary || request_.against || request_.sweep_up || request_.sweep_down))
      throw InputError(
          "--vary, --curve, --sweep", "", "case " + name + " is without excitation",
          "leave them out: its backbone is computed; --largest sets how far. Limit cycles of a model that "
          "excites itself are found over a parameter in a case that does not say excitation = false");
    if (!excited) return;
    if (!request_.vary)
      throw InputError("--vary", "", "is missing",
                       "name a parameter and its range, for example --vary Omega 150 160");
    if (request_.curve.empty() != !request_.against)
      throw InputError("--curve, --against", "", "one is given without the other",
                       "for example --vary Omega 150 160 --against F 5 30 --curve saddle_node");
    if (request_.against && request_.against->name == request_.vary->name)
      throw InputError("--against " + request_.against->name, "", "is the parameter of --vary", "name another one");
    if (request_.against && (request_.sweep_up || request_.sweep_down))
      throw InputError("--sweep", "", "goes over one parameter", "leave out --curve and --against");
  }

  double factor_of(const std::string& name) const {
    return request_.hz && is_excitation_frequency(*result_.model, name) ? two_pi : 1;
  }

  VariedParameter scaled(const VariedParameter& parameter, const char* option) const {
    index_of(parameter.name);
    if (!std::isfinite(parameter.from) || !std::isfinite(parameter.to) || !(parameter.from < parameter.to))
      throw InputError(fmt::format("{} {} {} {}", option, parameter.name, parameter.from, parameter.to), "",
                       "is an empty range", "FROM must be below TO");
    const double factor = factor_of(parameter.name);
    return {parameter.name, factor * parameter.from, factor * parameter.to};
  }

  // Excitation frequencies are printed in Hz.
  std::pair<double, std::string> printed(const std::string& name) const {
    if (is_excitation_frequency(*result_.model, name)) return {two_pi, "Hz"};
    return {1.0, ""};
  }

  void take_vary() {
    if (request_.vary) {
      result_.vary = scaled(*request_.vary, "--vary");
      std::tie(result_.axis, result_.axis_unit) = printed(result_.vary->name);
    }
    if (request_.against) {
      result_.against = scaled(*request_.against, "--against");
      std::tie(result_.against_axis, result_.against_unit) = printed(result_.against->name);
    }
  }

  // Steady motions of the case are the same whatever else has the lumps that were told; harmonics and sweeps of the
  // full equations are those of one such set.
  template <typename Take>
  void take_representative(const GivenParameters& given, const Take& take) {
    std::vector<std::string> open;
    for (const auto& [name, value] : given.representative) {
      if (request_.at.contains(name)) continue;
      take(name, value);
      open.push_back(name);
    }
    if (!open.empty())
      result_.warnings.push_back(
          fmt::format("{} does not tell {}: values that go with its lumps are taken. Amplitudes, frequencies and "
                      "stability do not depend on the choice; harmonics, sweeps and other cases do",
                      request_.parameters, fmt::join(open, ", ")));
  }

  void read_parameters() {
    const CompiledModel& model = *result_.model;
    const GivenParameters given = read_parameter_file(request_.parameters);
    const auto count = static_cast<Index>(result_.names.size());
    result_.parameters = VectorXd::Constant(count, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t s = 0; s < model.nominal.size(); ++s)
      result_.parameters(static_cast<Index>(s)) = model.nominal[s];
    if (std::string unused = unused_numbers(request_.parameters, given.values, model); !unused.empty())
      result_.warnings.push_back(std::move(unused));
    const auto take = [&](const std::string& name, double value) {
      const auto found = std::find(result_.names.begin(), result_.names.end(), name);
      if (found != result_.names.end()) result_.parameters(found - result_.names.begin()) = value;
    };
    for (const auto& [name, value] : given.values) take(name, value);
    if (given.identified_cases.contains(std::string(result_.resonance->name))) take_representative(given, take);
    for (const auto& [name, value] : request_.at) result_.parameters(index_of(name)) = factor_of(name) * value;
    for (const auto* varied : {&result_.vary, &result_.against})
      if (*varied) result_.parameters(index_of((*varied)->name)) = 0.5 * ((*varied)->from + (*varied)->to);
    if (!result_.resonance->excited)
      for (Index p = static_cast<Index>(model.symbols.size()); p < count; ++p) result_.parameters(p) = 0;
    std::string missing;
    for (Index p = 0; p < count; ++p)
      if (!std::isfinite(result_.parameters(p)))
        missing += (missing.empty() ? "" : ", ") + result_.names[static_cast<std::size_t>(p)];
    if (!missing.empty())
      throw InputError(request_.parameters, "", "gives no value for " + missing,
                       "add them to the file, or give them with --at NAME=VALUE");
    for (std::size_t k = 0; k < model.modes(); ++k)
      if (!(result_.parameters(static_cast<Index>(k)) > 0))
        throw InputError(request_.parameters, "key " + result_.names[k], "is not positive",
                         "a natural frequency in rad/s was expected");
  }

  struct Place {
    VectorXd parameters;
    const std::vector<std::complex<double>>* amplitude;
    bool* outside;
    bool counts;  ///< special points lie among others
  };

  // A motion at rest is one of the full equations.
  void mark(std::vector<Place> places) {
    if (!range_) return;
    std::erase_if(places, [](const Place& place) {
      return std::all_of(place.amplitude->begin(), place.amplitude->end(),
                         [](const std::complex<double>& a) { return a == 0.0; });
    });
    in_parallel(places.size(), request_.threads, [&](std::size_t i) {
      *places[i].outside = range_->excludes(places[i].parameters, *places[i].amplitude);
    });
    const auto outside = std::count_if(places.begin(), places.end(),
                                       [](const Place& place) { return place.counts && *place.outside; });
    if (outside == 0) return;
    result_.warnings.push_back(fmt::format(
        "{} of {} points lie outside of the expansion's range: there its last order, or what the full equations "
        "add "
        "to it, exceeds every order before. The full equations need not have such a motion. These points are "
        "marked "
        "(outside_expansion)",
        outside, std::count_if(places.begin(), places.end(), [](const Place& place) { return place.counts; })));
  }

  void mark_diagram(const ResponseRequest& response) {
    std::vector<Place> places;
    const auto add = [&](ResponsePoint& point, bool counts) {
      VectorXd parameters = response.parameters;
      parameters(response.parameter) = point.parameter;
      places.push_back({std::move(parameters), &point.modes.amplitude, &point.outside, counts});
    };
    for (ResponseBranch& branch : result_.diagram.branches) {
      for (ResponsePoint& point : branch.points) add(point, true);
      for (ResponseSpecial& special : branch.special) add(special.at, false);
    }
    mark(std::move(places));
  }

  void mark_curves(const CurveRequest& request) {
    std::vector<Place> places;
    const auto add = [&](ResponseCurvePoint& point, bool counts) {
      VectorXd parameters = request.response.parameters;
      parameters(request.response.parameter) = point.first;
      parameters(request.second) = point.second;
      places.push_back({std::move(parameters), &point.modes.amplitude, &point.outside, counts});
    };
    for (ResponseCurve& curve : result_.curves) {
      for (ResponseCurvePoint& point : curve.points) add(point, true);
      for (auto& [kind, at] : curve.special) add(at, false);
    }
    mark(std::move(places));
  }

  void mark_backbones(const ResponseField& field) {
    std::vector<std::vector<std::complex<double>>> amplitudes;
    for (std::size_t k = 0; k < result_.backbones.size(); ++k)
      for (const BackbonePoint& point : result_.backbones[k].second) {
        amplitudes.emplace_back(result_.model->modes());
        amplitudes.back()[field.active()[k]] = point.amplitude;
      }
    std::vector<Place> places;
    for (auto& [name, points] : result_.backbones)
      for (BackbonePoint& point : points)
        places.push_back({result_.parameters, &amplitudes[places.size()], &point.outside, true});
    mark(std::move(places));
  }

  void add_backbones(const ResponseField& field) {
    double largest = request_.largest / 2;
    if (largest == 0)
      largest =
          amplitude_scale(field, result_.parameters, 0, result_.parameters(0), 1.0001 * result_.parameters(0));
    for (std::size_t k = 0; k < field.active().size(); ++k)
      result_.backbones.emplace_back(std::string(result_.model->coordinates[field.active()[k]]),
                                     backbone(field, result_.parameters, k, largest, backbone_points));
    mark_backbones(field);
  }

  void add_diagram(const ResponseField& field, const ResponseRequest& response) {
    result_.diagram = response_diagram(field, response);
    mark_diagram(response);
    if (result_.diagram.status != DiagramStatus::complete)
      result_.warnings.push_back("some responses may be missing: " + result_.diagram.reason);
    if (!request_.measured.empty()) result_.measured = measured_points(request_, result_, result_.warnings);
    std::vector<std::string> directions;
    if (request_.sweep_up) directions.emplace_back("up");
    if (request_.sweep_down) directions.emplace_back("down");
    const std::size_t total = directions.size() * static_cast<std::size_t>(request_.sweep_steps);
    result_.sweeps.resize(directions.size());
    std::atomic<std::size_t> done{0};
    in_parallel(directions.size(), request_.threads, [&](std::size_t s) {
      result_.sweeps[s] = sweep(response, directions[s], [&] {
        const std::size_t finished = ++done;
        if (progress_) progress_(finished, total);
      });
    });
    for (const PredictedSweep& swept : result_.sweeps)
      if (!std::all_of(swept.points.begin(), swept.points.end(), [](const SweepPoint& p) { return p.settled; }))
        result_.warnings.push_back("the simulated sweep " + swept.direction +
                                   " has dwells that did not settle within their time");
  }

  PredictedSweep sweep(const ResponseRequest& response, const std::string& direction,
                       const std::function<void()>& done) const {
    const CompiledModel& model = *result_.model;
    const auto symbols = static_cast<Index>(model.symbols.size());
    const auto excitations = static_cast<Index>(model.excitations.size());
    if (response.parameter < symbols)
      throw InputError("--sweep", "", "the varied parameter " + result_.vary->name + " is not of the excitation",
                       "sweeps go over an excitation frequency or amplitude");
    PredictedSweep swept;
    swept.direction = direction;
    SteppedSweep steps;
    steps.parameters = response.parameters;
    steps.disturbance = disturbance_share * 2 * result_.diagram.scale;
    for (int i = 0; i < request_.sweep_steps; ++i) {
      const double share = static_cast<double>(i) / (request_.sweep_steps - 1);
      VectorXd p = response.parameters;
      p(response.parameter) = direction == "up" ? response.lower + share * (response.upper - response.lower)
                                                : response.upper - share * (response.upper - response.lower);
      swept.parameter.push_back(p(response.parameter));
      SweepStep step;
      for (Index j = 0; j < excitations; ++j) {
        step.frequency.push_back(p(symbols + j));
        step.forcing.push_back(p(symbols + excitations + j));
      }
      steps.steps.push_back(std::move(step));
    }
    swept.points = stepped_sweep(model, *result_.resonance, steps, done);
    for (std::size_t k = 0; k < model.modes(); ++k) {
      double largest = 0;
      for (const SweepPoint& point : swept.points) largest = std::max(largest, point.amplitude[k]);
      for (std::size_t i = 1; i < swept.points.size(); ++i) {
        const auto change = [&](std::size_t to) {
          if (to < 1 || to >= swept.points.size()) return 0.0;
          return std::abs(swept.points[to].amplitude[k] - swept.points[to - 1].amplitude[k]);
        };
        const double before = swept.points[i - 1].amplitude[k], after = swept.points[i].amplitude[k];
        if (swept.points[i - 1].settled && change(i) > share_of_a_jump * largest &&
            change(i) > ratio_of_a_jump * std::max(change(i - 1), change(i + 1)))
          swept.jumps.push_back({swept.parameter[i - 1], swept.parameter[i], before, after, k});
      }
    }
    return swept;
  }

  void add_curves(const ResponseField& field, const ResponseRequest& response) {
    CurveRequest request;
    request.response = response;
    request.second = index_of(result_.against->name);
    request.second_lower = result_.against->from;
    request.second_upper = result_.against->to;
    request.kind = request_.curve == "saddle_node" ? CurveKind::saddle_node
                   : request_.curve == "threshold" ? CurveKind::threshold
                   : request_.curve == "peak"      ? CurveKind::peak
                                                   : CurveKind::hopf;
    result_.curves = response_curves(field, request);
    mark_curves(request);
    result_.diagram.notes.push_back(field.description());
    if (result_.curves.empty())
      result_.warnings.push_back("no point of kind " + request_.curve + " was found in these ranges");
  }

  const PredictionRequest& request_;
  const SweepProgress& progress_;
  std::optional<ExpansionRange> range_;
  Prediction result_;
};

}  // namespace

Prediction predict(const PredictionRequest& request, const SweepProgress& progress) {
  return Predictor(request, progress).run();
}

}  // namespace secular::app
