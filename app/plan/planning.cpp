#include "app/plan/planning.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "app/shared/model_loading.hpp"
#include "app/shared/number_file.hpp"
#include "app/shared/parameter_file.hpp"
#include "app/shared/record_selection.hpp"
#include "app/shared/shipped_models.hpp"
#include "estimator/identification/unit_text.hpp"
#include "input/input_error.hpp"
#include "measure/data/campaign.hpp"
#include "measure/observe/modal_projection.hpp"
#include "numerics/hertz.hpp"

namespace secular::app {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the programme's deviations that a plan without a budget aims at: the prediction is of first order.
constexpr double target_share = 0.9;

class Planner {
 public:
  explicit Planner(const PlanRequest& request) : request_(request) {}

  PlanResult run() {
    const ModelSource source(request_.model, false);
    std::string wanted = request_.resonance;
    if (wanted.empty() && source.cases().size() == 1) wanted = source.cases()[0].name;
    std::string known;
    bool found = false;
    for (const CaseOutline& outline : source.cases()) {
      known += (known.empty() ? "" : ", ") + outline.name;
      found = found || outline.name == wanted;
    }
    if (!found)
      throw InputError("--case " + wanted, "", "model " + source.name() + " has no such case",
                       "its cases are " + known);
    result_.model = source.load({wanted});
    for (const CompiledCase& c : result_.model->cases)
      if (c.name == wanted) result_.resonance = &c;
    if (!result_.resonance->excited || result_.model->excitations.size() != 1)
      throw InputError("--case " + wanted, "", "has no excitation, or several",
                       "dwells are planned for a case with one excitation");
    read_parameters();
    read_sensors();
    const ResponseField field(*result_.model, *result_.resonance);
    field_ = &field;
    find_unknowns();
    find_candidates();
    if (!request_.against.empty()) evaluate_programme();
    choose();
    return std::move(result_);
  }

 private:
  void read_parameters() {
    GivenParameters file = read_parameter_file(request_.parameters);
    std::map<std::string, double>& given = file.values;
    given.merge(file.representative);
    const CompiledModel& model = *result_.model;
    const auto count = static_cast<Index>(model.symbols.size());
    if (std::string unused = unused_numbers(request_.parameters, file.values, model); !unused.empty())
      result_.warnings.push_back(std::move(unused));
    result_.parameters.resize(count);
    std::string missing;
    for (Index s = 0; s < count; ++s) {
      const std::string name(model.symbols[static_cast<std::size_t>(s)].name);
      const auto at = given.find(name);
      result_.parameters(s) = at != given.end() ? at->second : model.nominal[static_cast<std::size_t>(s)];
      if (!std::isfinite(result_.parameters(s))) missing += (missing.empty() ? "" : ", ") + name;
    }
    if (!missing.empty())
      throw InputError(request_.parameters, "", "gives no value for " + missing, "rough values are enough");
  }

  bool against_is_experiment() const {
    return request_.against.rfind("experiments/", 0) == 0 ||
           std::filesystem::path(request_.against).extension() == ".toml";
  }

  void read_sensors() {
    const std::size_t modes = result_.model->modes();
    PlanningNoise& noise = result_.noise;
    noise.response_sd.assign(modes, request_.noise);
    noise.excitation_sd = request_.excitation_noise;
    noise.sample_rate_hz = request_.sample_rate_hz;
    noise.ensemble_s = request_.ensemble_s;
    noise.repeatability = request_.repeatability;
    if (request_.against.empty() || !against_is_experiment()) return;
    if (request_.against_records.records != Window{}.records)
      throw InputError("--records " + request_.against_records.records, "",
                       request_.against + " is an experiment, which has no records", "--against a campaign folder");
    result_.sensors = read_experiment(resolve_model(request_.against), *result_.model);
    const Experiment& experiment = *result_.sensors;
    Campaign campaign;
    campaign.folder = experiment.file;
    if (experiment.excitation) campaign.channels.push_back(experiment.excitation->channel);
    for (const SimulatedChannel& response : experiment.responses) campaign.channels.push_back(response.channel);
    campaign.modal_basis = experiment.modal_basis;
    const ModalProjection projection = modal_projection(campaign, *result_.model);
    const std::size_t first = experiment.excitation ? 1 : 0;
    for (std::size_t k = 0; k < modes; ++k) {
      double variance = 0;
      for (std::size_t c = 0; c < projection.channels.size(); ++c)
        variance += std::pow(projection.matrix(static_cast<Index>(k), static_cast<Index>(c)) *
                                 experiment.responses[projection.channels[c] - first].noise_sd,
                             2);
      noise.response_sd[k] = std::sqrt(variance);
    }
    noise.derivatives = projection.derivatives;
    noise.excitation_sd = experiment.excitation ? experiment.excitation->noise_sd : 0;
    noise.sample_rate_hz = experiment.sample_rate_hz;
    if (!experiment.dwells.empty()) noise.ensemble_s = experiment.dwells.front().ensemble_s;
    if (*std::min_element(noise.response_sd.begin(), noise.response_sd.end()) <= 0)
      throw InputError(experiment.file, "noise_sd", "is zero",
                       "a plan weighs dwells by their noise: give the sensors some");
  }

  void find_unknowns() {
    try {
      result_.unknowns = plan_unknowns(*result_.model, *result_.resonance, result_.parameters, request_.fixed);
    } catch (const std::invalid_argument& error) {
      throw InputError(
          "--fix", "", error.what(),
          fmt::format(
              "the case's unknowns are {}",
              fmt::join(plan_unknowns(*result_.model, *result_.resonance, result_.parameters, {}).names, ", ")));
    }
    const std::vector<std::string>& names = result_.unknowns.names;
    for (const std::string& name : request_.wanted) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end())
        throw InputError("--for " + name, "",
                         "is nothing that case " + std::string(result_.resonance->name) + " sees by itself",
                         fmt::format("dwells there determine {}", fmt::join(names, ", ")));
      result_.wanted.push_back(found - names.begin());
    }
    if (request_.criterion == DesignCriterion::c && result_.wanted.size() != 1)
      throw InputError("--criterion c", "", "is for one parameter", "name one with --for");
    for (std::size_t u = 0; u < names.size(); ++u) {
      const int lump = result_.unknowns.lump[u];
      const std::span<const Ratio> dimension =
          lump >= 0 ? result_.resonance->lumps[static_cast<std::size_t>(lump)].dimension : std::span<const Ratio>();
      const std::vector<std::string> coordinates(result_.model->modes(), "kg^(1/2) m");
      result_.units.push_back(lump < 0 ? "rad/s" : unit_text(dimension, coordinates, {"m/s^2"}));
    }
  }

  CandidateRequest candidate_request() const {
    CandidateRequest request;
    request.parameters.resize(result_.parameters.size() + 2);
    request.parameters << result_.parameters, 0, 0;
    // Values that a file shows in full: 0.1 mHz and four digits.
    for (int i = 0; i < request_.frequencies; ++i) {
      const double hz = request_.lowest_hz +
                        (request_.highest_hz - request_.lowest_hz) * i / std::max(1, request_.frequencies - 1);
      request.frequencies.push_back(std::round(hz * 1e4) / 1e4 / to_hz);
    }
    const double digit = std::pow(10.0, std::floor(std::log10(request_.highest_amplitude)) - 3);
    for (int l = 0; l < request_.levels; ++l) {
      const double level = request_.lowest_amplitude + (request_.highest_amplitude - request_.lowest_amplitude) *
                                                           l / std::max(1, request_.levels - 1);
      request.forcings.push_back(std::round(level / digit) * digit);
    }
    request.settled = request_.settled;
    request.settle_limit = request_.settle_limit_s;
    return request;
  }

  // Symmetry directions over all modes.
  MatrixXd symmetry() const {
    const MatrixXd& rows = field_->symmetries();
    MatrixXd all = MatrixXd::Zero(rows.rows(), static_cast<Index>(result_.model->modes()));
    for (Index r = 0; r < rows.rows(); ++r)
      for (Index k = 0; k < rows.cols(); ++k)
        all(r, static_cast<Index>(field_->active()[static_cast<std::size_t>(k)])) = rows(r, k);
    return all;
  }

  MatrixXd information(const DwellState& state, int ensembles) const {
    return dwell_information(
        {*result_.model, *result_.resonance, result_.parameters, result_.unknowns, result_.noise}, state,
        symmetry(), ensembles);
  }

  void find_candidates() {
    if (!(request_.lowest_hz < request_.highest_hz) || !(request_.lowest_hz > 0))
      throw InputError("--range-frequency", "", "is empty", "LOW:HIGH in Hz, for example 24.4:25.1");
    if (!(request_.lowest_amplitude <= request_.highest_amplitude) || !(request_.lowest_amplitude > 0))
      throw InputError("--range-amplitude", "", "is empty", "LOW:HIGH in the excitation's unit, for example 10:30");
    result_.candidates = response_candidates(*field_, candidate_request());
    if (result_.candidates.empty())
      throw InputError(
          "--range-frequency, --range-amplitude", "",
          fmt::format("no stable response in these ranges settles within {:g} s", request_.settle_limit_s),
          "look where the model responds with `secular predict`, or raise --settle-limit");
    MatrixXd all = MatrixXd::Zero(result_.unknowns.values.size(), result_.unknowns.values.size());
    for (const DwellCandidate& candidate : result_.candidates) all += information(candidate.state, 1);
    const VectorXd sd = standard_deviations(all);
    for (const Index w : result_.wanted)
      if (!std::isfinite(sd(w))) {
        std::string with;
        for (Index u = 0; u < sd.size(); ++u)
          if (u != w && !std::isfinite(sd(u)))
            with += (with.empty() ? "" : ", ") + result_.unknowns.names[static_cast<std::size_t>(u)];
        throw InputError(
            "--for " + result_.unknowns.names[static_cast<std::size_t>(w)], "",
            "no dwell of these ranges determines it" +
                (with.empty() ? "" : "; undetermined as well, so some of them entangled with it: " + with),
            "take one of them as known with --fix, widen the ranges, or use another case");
      }
    for (Index u = 0; u < sd.size(); ++u)
      if (!std::isfinite(sd(u)))
        result_.warnings.push_back(result_.unknowns.names[static_cast<std::size_t>(u)] +
                                   " is not determined by any dwell of these ranges");
  }

  // ------------------------------------------------------------------------------------- the programme in use
  static void add_dwell(Programme& programme, double hz, double amplitude, int ensembles, double settle_s) {
    PlannedDwell dwell;
    dwell.frequency_hz = hz;
    dwell.amplitude = amplitude;
    dwell.ensembles = ensembles;
    dwell.settle_s = settle_s;
    dwell.responds = false;
    programme.dwells.push_back(std::move(dwell));
  }

  // At every dwell the stable response with the largest amplitude, level by level.
  void find_responses(Programme& programme) const {
    std::map<double, std::vector<PlannedDwell*>> levels;
    for (PlannedDwell& dwell : programme.dwells) levels[dwell.amplitude].push_back(&dwell);
    for (auto& [level, dwells] : levels) {
      CandidateRequest request = candidate_request();
      request.settle_limit = std::numeric_limits<double>::max();
      request.reached = false;
      request.forcings = {level};
      for (const PlannedDwell* dwell : dwells) request.frequencies.push_back(dwell->frequency_hz / to_hz);
      std::sort(request.frequencies.begin(), request.frequencies.end());
      for (const DwellCandidate& candidate : response_candidates(*field_, request))
        for (PlannedDwell* dwell : dwells) {
          if (std::abs(candidate.state.frequency * to_hz - dwell->frequency_hz) > 1e-9) continue;
          const auto size = [](const DwellState& state) {
            double sum = 0;
            for (const auto& b : state.amplitude) sum += std::norm(b);
            return sum;
          };
          if (dwell->responds && size(candidate.state) <= size(dwell->candidate.state)) continue;
          dwell->responds = true;
          dwell->candidate = candidate;
          dwell->needed_s = candidate.settle_s;
        }
    }
  }

  void evaluate_programme() {
    Programme programme;
    programme.name = request_.against;
    if (result_.sensors) {
      for (const DwellProgramme& dwells : result_.sensors->dwells)
        for (const double amplitude : dwells.amplitudes)
          for (const double hz : dwells.frequencies_hz)
            add_dwell(programme, hz, amplitude, dwells.ensembles, dwells.settle_s);
    } else {
      const Campaign campaign = read_campaign(request_.against);
      require_match(campaign, request_.against_records);
      double end = 0;
      for (std::size_t r = 0; r < campaign.records.size(); ++r) {
        const RecordEntry& entry = campaign.records[r];
        if (entry.kind != RecordKind::dwell || !entry.excitation_frequency_hz || !entry.excitation_amplitude)
          continue;
        const Record record = read_record(campaign, entry);
        const double duration = static_cast<double>(record.samples()) / campaign.sample_rate_hz;
        const int ensembles = std::max(1, static_cast<int>(duration / entry.ensemble_s.value_or(duration)));
        const double settle = entry.started_s ? std::max(0.0, *entry.started_s - end) : -1;
        if (request_.against_records.takes(r, entry.file))
          add_dwell(programme, *entry.excitation_frequency_hz, *entry.excitation_amplitude, ensembles, settle);
        end = entry.started_s.value_or(end) + duration;
      }
    }
    if (programme.dwells.empty())
      throw InputError(request_.against, "", "has no dwells with frequency and amplitude",
                       "nothing to compare with");
    find_responses(programme);
    for (PlannedDwell& dwell : programme.dwells)
      if (dwell.settle_s < 0) dwell.settle_s = dwell.needed_s;  // a campaign that does not say when
    finish(programme);
    const auto quiet =
        std::count_if(programme.dwells.begin(), programme.dwells.end(), [](const auto& d) { return !d.responds; });
    if (quiet > 0)
      result_.warnings.push_back(
          fmt::format("{} of {} dwells of {} have no stable response: they cost time and say "
                      "nothing here",
                      quiet, programme.dwells.size(), request_.against));
    result_.against = std::move(programme);
  }

  void finish(Programme& programme) const {
    MatrixXd sum = MatrixXd::Zero(result_.unknowns.values.size(), result_.unknowns.values.size());
    for (const PlannedDwell& dwell : programme.dwells) {
      const double recorded = dwell.ensembles * result_.noise.ensemble_s;
      programme.time_s += dwell.settle_s + recorded;
      programme.settled_time_s += (dwell.responds ? dwell.needed_s : dwell.settle_s) + recorded;
      if (dwell.responds) sum += information(dwell.candidate.state, dwell.ensembles);
    }
    programme.sd = standard_deviations(sum);
  }

  // ------------------------------------------------------------------------------------------------ the plan
  Programme programme_of(const Design& design, const std::vector<std::pair<std::size_t, int>>& options) const {
    Programme programme;
    programme.name = "plan";
    for (const std::size_t i : design.chosen) {
      const auto& [c, ensembles] = options[i];
      PlannedDwell dwell;
      dwell.candidate = result_.candidates[c];
      dwell.frequency_hz = std::round(dwell.candidate.state.frequency * to_hz * 1e4) / 1e4;
      dwell.amplitude = dwell.candidate.state.forcing;
      dwell.ensembles = ensembles;
      dwell.settle_s = dwell.needed_s = std::ceil(dwell.candidate.settle_s);
      programme.dwells.push_back(std::move(dwell));
    }
    std::sort(programme.dwells.begin(), programme.dwells.end(), [](const PlannedDwell& a, const PlannedDwell& b) {
      return std::pair(a.amplitude, a.frequency_hz) < std::pair(b.amplitude, b.frequency_hz);
    });
    finish(programme);
    return programme;
  }

  bool reaches_target(const Programme& programme) const {
    return std::all_of(result_.wanted.begin(), result_.wanted.end(),
                       [&](Index w) { return programme.sd(w) <= target_share * result_.against->sd(w); });
  }

  void choose() {
    DesignProblem problem;
    std::vector<std::pair<std::size_t, int>> options;
    for (std::size_t c = 0; c < result_.candidates.size(); ++c)
      for (const int ensembles : request_.ensembles) {
        const double cost = std::ceil(result_.candidates[c].settle_s) + ensembles * result_.noise.ensemble_s;
        problem.items.push_back({information(result_.candidates[c].state, ensembles), cost, static_cast<int>(c)});
        options.emplace_back(c, ensembles);
      }
    problem.wanted = result_.wanted;
    problem.scale = result_.unknowns.values.cwiseAbs();
    for (Index u = 0; u < problem.scale.size(); ++u)
      if (!(problem.scale(u) > 0)) problem.scale(u) = 1;
    problem.criterion = request_.criterion;
    // Error bars come from the scatter between dwells: one more than the widest equation has columns, and one to
    // spare.
    std::size_t widest = 0;
    for (const RegressorBlock& block : result_.resonance->blocks)
      if (block.kind == BlockKind::modulation) widest = std::max(widest, block.lumps.size() + 1);
    problem.least = static_cast<std::size_t>(request_.least.value_or(static_cast<int>(widest) + 2));
    if (request_.budget_s) {
      problem.budget = *request_.budget_s;
      const Design design = optimal_design(problem);
      if (!design.feasible)
        throw InputError(fmt::format("--budget-s {:g}", *request_.budget_s), "",
                         fmt::format("is too short for {} dwells, as many as error bars need", problem.least),
                         "give more time, or fewer dwells with --least");
      result_.plan = programme_of(design, options);
      result_.budget_s = problem.budget;
      if (result_.against) result_.meets_target = reaches_target(result_.plan);
      return;
    }
    if (!result_.against)
      throw InputError("--budget-s, --against", "", "both are missing",
                       "give the laboratory time in seconds, or a programme whose error bars are to be reached");
    // The shortest time that reaches the programme's error bars, to 4 %: the sum of variances over those of the
    // programme is what an exchange can follow towards it.
    problem.criterion = DesignCriterion::a;
    problem.scale = result_.against->sd;
    for (const Index w : result_.wanted)
      if (!std::isfinite(problem.scale(w)))
        throw InputError("--against " + request_.against, "",
                         "does not determine " + result_.unknowns.names[static_cast<std::size_t>(w)],
                         "give --budget-s");
    double high = std::max(result_.against->time_s, result_.against->settled_time_s), low = 0;
    std::optional<Programme> best;
    for (int step = 0; step < 12 && high - low > 0.04 * high; ++step) {
      problem.budget = step == 0 ? high : 0.5 * (low + high);
      const Design design = optimal_design(problem);
      Programme programme = programme_of(design, options);
      if (design.feasible && reaches_target(programme)) {
        high = std::min(problem.budget, programme.time_s);
        best = std::move(programme);
      } else if (step == 0) {
        result_.plan = std::move(programme);
        break;
      } else {
        low = problem.budget;
      }
    }
    result_.meets_target = best.has_value();
    if (best) result_.plan = std::move(*best);
    result_.budget_s = high;
    if (!result_.meets_target)
      result_.warnings.push_back(
          "no plan within the time of the programme in use reaches all of its error bars: this is the best within "
          "it");
  }

  const PlanRequest& request_;
  PlanResult result_;
  const ResponseField* field_ = nullptr;
};

}  // namespace

PlanResult plan_test(const PlanRequest& request) {
  return Planner(request).run();
}

}  // namespace secular::app
