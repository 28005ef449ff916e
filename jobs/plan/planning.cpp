#include "jobs/plan/planning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "input/stop_request.hpp"
#include "jobs/plan/dwell_evaluation.hpp"
#include "jobs/plan/plan_inputs.hpp"
#include "jobs/plan/programme_in_use.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the programme's deviations that a plan without a budget aims at: the prediction is of first order.
constexpr double target_share = 0.9;

/// A dwell that a plan may choose: a candidate, by its index, and how many ensembles are recorded there.
using DwellOptions = std::vector<std::pair<std::size_t, int>>;

// Tells how far the search is, and ends it when its time is over: how long it takes grows with the grid, and for
// the choice with the square of what fits into the budget.
class SearchClock {
 public:
  explicit SearchClock(const PlanRequest& request) : request_(request) {}

  void operator()(const char* what, std::size_t done, std::size_t total) const {
    end_if_stopped();
    if (request_.progress) request_.progress(what, done, total);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begun_;
    if (spent.count() <= request_.limit_s) return;
    throw NumericalFailure(
        Ending::stalled,
        fmt::format(
            "the search for a plan has taken more than {:g} s, with {} of {} {}: ask for fewer --frequencies, "
            "--levels or --ensembles, narrower ranges or a smaller --budget-s, or give it more time with "
            "--limit",
            request_.limit_s, done, total, what));
  }

 private:
  const PlanRequest& request_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

void find_candidates(const PlanRequest& request, const DwellEvaluation& evaluation, const SearchClock& clock,
                     PlanResult& plan) {
  if (!(request.lowest_hz < request.highest_hz) || !(request.lowest_hz > 0))
    throw InputError("--range-frequency", "", request.lowest_hz > 0 ? "is empty" : "is not positive",
                     "LOW:HIGH in Hz, for example 24.4:25.1");
  if (!(request.lowest_amplitude <= request.highest_amplitude) || !(request.lowest_amplitude > 0))
    throw InputError("--range-amplitude", "", request.lowest_amplitude > 0 ? "is empty" : "is not positive",
                     "LOW:HIGH in the excitation's unit, for example 10:30");
  CandidateRequest grid = evaluation.grid();
  grid.progress = [&clock](std::size_t done, std::size_t total) { clock("levels searched", done, total); };
  plan.candidates = response_candidates(evaluation.field(), grid);
  if (plan.candidates.empty())
    throw InputError(
        "--range-frequency, --range-amplitude", "",
        fmt::format("no stable response in these ranges settles within {:g} s", request.settle_limit_s),
        "look where the model responds with `secular predict`, or raise --settle-limit");
  MatrixXd all = MatrixXd::Zero(plan.unknowns.values.size(), plan.unknowns.values.size());
  for (const DwellCandidate& candidate : plan.candidates) all += evaluation.information(candidate.state, 1);
  const VectorXd sd = standard_deviations(all);
  for (const Index w : plan.wanted)
    if (!std::isfinite(sd(w))) {
      std::string with;
      for (Index u = 0; u < sd.size(); ++u)
        if (u != w && !std::isfinite(sd(u)))
          with += (with.empty() ? "" : ", ") + plan.unknowns.names[static_cast<std::size_t>(u)];
      throw InputError(
          "--for " + plan.unknowns.names[static_cast<std::size_t>(w)], "",
          "no dwell of these ranges determines it" +
              (with.empty() ? "" : "; undetermined as well, so some of them entangled with it: " + with),
          "take one of them as known with --fix, widen the ranges, or use another case");
    }
  for (Index u = 0; u < sd.size(); ++u)
    if (!std::isfinite(sd(u)))
      plan.warnings.push_back(plan.unknowns.names[static_cast<std::size_t>(u)] +
                              " is not determined by any dwell of these ranges");
}

Programme programme_of(const Design& design, const DwellOptions& options, const DwellEvaluation& evaluation,
                       const PlanResult& plan) {
  Programme programme;
  programme.name = "plan";
  for (const std::size_t i : design.chosen) {
    const auto& [c, ensembles] = options[i];
    PlannedDwell dwell;
    dwell.candidate = plan.candidates[c];
    dwell.frequency_hz = std::round(dwell.candidate.state.frequency * to_hz * 1e4) / 1e4;
    dwell.amplitude = dwell.candidate.state.forcing;
    dwell.ensembles = ensembles;
    dwell.settle_s = dwell.needed_s = std::ceil(dwell.candidate.settle_s);
    programme.dwells.push_back(std::move(dwell));
  }
  std::sort(programme.dwells.begin(), programme.dwells.end(), [](const PlannedDwell& a, const PlannedDwell& b) {
    return std::pair(a.amplitude, a.frequency_hz) < std::pair(b.amplitude, b.frequency_hz);
  });
  evaluation.finish(programme);
  return programme;
}

bool reaches_target(const Programme& programme, const PlanResult& plan) {
  return std::all_of(plan.wanted.begin(), plan.wanted.end(),
                     [&](Index w) { return programme.sd(w) <= target_share * plan.against->sd(w); });
}

struct Choice {
  DesignProblem problem;  // of every option an item
  DwellOptions options;
};

Choice choice_of(const PlanRequest& request, const DwellEvaluation& evaluation, const PlanResult& plan) {
  Choice choice;
  DesignProblem& problem = choice.problem;
  for (std::size_t c = 0; c < plan.candidates.size(); ++c)
    for (const int ensembles : request.ensembles) {
      const double cost = std::ceil(plan.candidates[c].settle_s) + ensembles * plan.noise.ensemble_s;
      problem.items.push_back(
          {evaluation.information(plan.candidates[c].state, ensembles), cost, static_cast<int>(c)});
      choice.options.emplace_back(c, ensembles);
    }
  problem.wanted = plan.wanted;
  problem.scale = plan.unknowns.values.cwiseAbs();
  for (Index u = 0; u < problem.scale.size(); ++u)
    if (!(problem.scale(u) > 0)) problem.scale(u) = 1;
  problem.criterion = request.criterion;
  // Error bars come from the scatter between dwells: one more than the widest equation has columns, and one to
  // spare.
  std::size_t widest = 0;
  for (const RegressorBlock& block : plan.resonance->blocks)
    if (block.kind == BlockKind::modulation) widest = std::max(widest, block.lumps.size() + 1);
  problem.least = static_cast<std::size_t>(request.least.value_or(static_cast<int>(widest) + 2));
  return choice;
}

void choose_within_budget(const PlanRequest& request, Choice choice, const DwellEvaluation& evaluation,
                          const SearchClock& clock, PlanResult& plan) {
  DesignProblem& problem = choice.problem;
  problem.budget = *request.budget_s;
  problem.pulse = [&] { clock("designs", 0, 1); };
  const Design design = optimal_design(problem);
  if (!design.feasible)
    throw InputError(fmt::format("--budget-s {:g}", *request.budget_s), "",
                     fmt::format("is too short for {} dwells, as many as error bars need", problem.least),
                     "give more time, or fewer dwells with --least");
  plan.plan = programme_of(design, choice.options, evaluation, plan);
  plan.budget_s = problem.budget;
  if (plan.against) plan.meets_target = reaches_target(plan.plan, plan);
}

// The shortest time that reaches the error bars of the programme in use, to 4 %: the sum of variances over those of
// the programme is what an exchange can follow towards it.
void choose_shortest(const PlanRequest& request, Choice choice, const DwellEvaluation& evaluation,
                     const SearchClock& clock, PlanResult& plan) {
  DesignProblem& problem = choice.problem;
  problem.criterion = DesignCriterion::a;
  problem.scale = plan.against->sd;
  for (const Index w : plan.wanted)
    if (!std::isfinite(problem.scale(w)))
      throw InputError("--against " + request.against, "",
                       "does not determine " + plan.unknowns.names[static_cast<std::size_t>(w)], "give --budget-s");
  double high = std::max(plan.against->time_s, plan.against->settled_time_s), low = 0;
  std::optional<Programme> best;
  constexpr std::size_t most_steps = 12;
  for (std::size_t step = 0; step < most_steps && high - low > 0.04 * high; ++step) {
    problem.pulse = [&clock, step] { clock("designs", step, most_steps); };
    problem.budget = step == 0 ? high : 0.5 * (low + high);
    const Design design = optimal_design(problem);
    Programme programme = programme_of(design, choice.options, evaluation, plan);
    if (design.feasible && reaches_target(programme, plan)) {
      high = std::min(problem.budget, programme.time_s);
      best = std::move(programme);
    } else if (step == 0) {
      plan.plan = std::move(programme);
      break;
    } else {
      low = problem.budget;
    }
  }
  plan.meets_target = best.has_value();
  if (best) plan.plan = std::move(*best);
  plan.budget_s = high;
  if (!plan.meets_target)
    plan.warnings.push_back(
        "no plan within the time of the programme in use reaches all of its error bars: this is the best within "
        "it");
}

}  // namespace

PlanResult plan_test(const PlanRequest& request) {
  PlanResult plan = plan_inputs(request);
  const DwellEvaluation evaluation(request, plan);
  const SearchClock clock(request);
  find_candidates(request, evaluation, clock, plan);
  if (!request.against.empty()) plan.against = programme_in_use(request, plan, evaluation, plan.warnings);
  if (!request.budget_s && !plan.against)
    throw InputError("--budget-s, --against", "", "both are missing",
                     "give the laboratory time in seconds, or a programme whose error bars are to be reached");
  const auto choose = request.budget_s ? choose_within_budget : choose_shortest;
  choose(request, choice_of(request, evaluation, plan), evaluation, clock, plan);
  return plan;
}

}  // namespace secular
