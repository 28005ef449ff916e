#include "diagnose/verdict/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnose/inference/fold_scatter.hpp"
#include "diagnose/inference/parts_of_rows.hpp"
#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/comparison.hpp"
#include "diagnose/verdict/conclusion.hpp"
#include "diagnose/verdict/gap_detection.hpp"
#include "diagnose/verdict/held_out_gap.hpp"
#include "diagnose/verdict/naming.hpp"
#include "diagnose/verdict/one_piece.hpp"
#include "diagnose/verdict/rivals.hpp"
#include "diagnose/verdict/scattered_inference.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

constexpr const char* metric =
    "root mean square over held-out rows (balance of every resonant line, lines of every channel) in units "
    "of measured repeatability";

void take_share(const ClosedShare& share, GapReport& gap) {
  gap.before = share.before;
  gap.after = share.after;
  gap.closed = share.closed;
  gap.closed_low = share.low;
  gap.closed_high = share.high;
}

}  // namespace

/// Hands what one stage finds to the next, and all of it to the diagnosis.
class OpenDiagnosis::Stages {
 public:
  Stages(const CampaignAndModel& sides, Comparison comparison, const DiagnosisOptions& options)
      : campaign_(sides.campaign),
        model_(sides.model),
        options_(options),
        comparison_(std::move(comparison)),
        free_(comparison_.fitted_beside(sides.own)) {}

  // `near`: see InferenceOptions.
  void run(const Inference* near = nullptr) {
    take_comparison();
    infer_all(near);
    if (!result_.frequency_scatter.suffices) {
      result_.verdict = "unknown";
      return;
    }
    take_own_of_records();
    judge_numbers();
    detect();
    if (result_.gap.detected)
      explain();
    else
      close_without_gap();
  }

  const Diagnosis& result() const { return result_; }

  const Inference& inference() const { return inference_; }
  bool holds_decays() const { return compares_decays(comparison_, campaign_); }
  const std::vector<StateForce>& forces() const { return comparison_.forces; }
  const Refit& fit() const { return best_ != nullptr ? best_->fit : inference_.null.fit; }

  bool leaves_noise_alone() const {
    return best_ != nullptr &&
           !is_more_than_noise(
               rows_left(best_->fit.chi_squared, freedom() - static_cast<double>(best_->fit.rank), discrepancy()));
  }

  bool admits_scatter() const { return is_scatter(comparison_.of_records.frequency_sd); }

  bool has_as_credible(const ModelAlone& scatter) const {
    return is_credible(scatter.log_evidence(inference_.dispersion, inference_.price), best_->log_evidence);
  }

  void make_unknown(const std::string& why) {
    result_.verdict = "unknown";
    result_.cause.clear();
    result_.unknown_because = why;
    doubt_ = why;
  }

  Diagnosis finish() {
    if (contest_) propose();
    if (contest_ && best_) simulate();
    return std::move(result_);
  }

 private:
  const Discrepancy& discrepancy() const { return comparison_.discrepancy; }
  double freedom() const { return static_cast<double>(discrepancy().freedom()); }

  void take_comparison() {
    result_.labels = discrepancy().labels();
    result_.conditions = comparison_.conditions.size() + comparison_.segments;
    result_.unsteady = comparison_.unsteady;
    result_.spans = comparison_.spans;
    result_.data_used = comparison_.data_used;
    result_.decays_in_one_piece = options_.whole_decays && holds_decays();
    result_.gap.judged = whose_gap(options_.given);
    result_.gap.metric = metric;
  }

  void infer_all(const Inference* near) {
    InferenceOptions inference_options;
    inference_options.near = near;
    inference_options.threads = options_.threads;
    inference_options.progress = options_.progress;
    for (const std::size_t s : free_)
      if (s < model_.modes()) inference_options.anchors.push_back(s);  // natural frequencies
    ScatteredInference found = infer_beside_scatter(
        comparison_.discrepancy, comparison_.of_records,
        {comparison_.candidates, comparison_.start, free_, inference_options}, options_.knows_without_scatter);
    inference_ = std::move(found.inference);
    result_.frequency_scatter = std::move(found.scatter);
  }

  void take_own_of_records() {
    for (Condition& condition : comparison_.conditions) {
      condition.frequency_offset = discrepancy().frequency_offset(condition.record);
    }
    result_.late = lateness_about(discrepancy());
    for (const OwnLateness& own : result_.late.records)
      for (Condition& condition : comparison_.conditions)
        if (condition.record == own.record) condition.count_as_late(own.late_s);
  }

  void judge_numbers() {
    result_.warnings = comparison_.warnings;
    if (options_.given) {
      judged_ = judge_given(options_.given, model_, free_, discrepancy(), comparison_.start, options_.threads);
      if (!judged_->without_motion.empty())
        result_.warnings.push_back(fmt::format(
            "with the given numbers the model has no steady motion near the measured one in {} of {} records: "
            "how far off it is there is not a number, and counts as {:.0g} standard deviations",
            judged_->without_motion.size(), comparison_.spans.size(), diagnose_thresholds().no_motion));
    }
    for (std::string& warning : disturbed_records(comparison_, campaign_))
      result_.warnings.push_back(std::move(warning));
    result_.rows_before = judged_ ? judged_->rows : inference_.null.fit.rows;
    result_.rows_after = result_.rows_before;
  }

  void detect() {
    // With error bars the sum of all squares is that of the numbers that fit best: how far these are is another
    // question.
    RowsLeft left = rows_left(inference_.null.fit.chi_squared, inference_.degrees_of_freedom, discrepancy());
    if (result_.gap.judged == Judged::given)
      left = rows_left(judged_->rows.squaredNorm(), static_cast<double>(discrepancy().freedom() - judged_->rank),
                       discrepancy());
    std::optional<double> moved;
    if (judged_) moved = moved_p_value(options_.given, *judged_, model_, comparison_.start, inference_.null.fit);
    const DetectedGap found =
        detect_gap(left, inference_, comparison_.candidates, result_.frequency_scatter.freedom, moved);
    result_.gap.p_value = found.p_value;
    result_.gap.detected = found.detected;
    result_.gap.noise_misjudged = found.noise_misjudged;
  }

  void take(const Conclusion& conclusion) {
    result_.verdict = conclusion.verdict;
    result_.cause = conclusion.cause;
    result_.unknown_because = conclusion.unknown_because;
  }

  void take(const Naming& naming) {
    result_.set = naming.set;
    result_.together = naming.together;
    result_.second_or = naming.second_or;
  }

  // Of the explanation that the verdict is about.
  void take_best(const Explanation& explanation) {
    best_ = &explanation;
    std::vector<const Candidate*> members;
    for (const std::size_t m : explanation.members) members.push_back(&comparison_.candidates[m]);
    result_.fitted =
        fitted_numbers(explanation.fit, members, comparison_.unknown_names(model_),
                       covariance_of(explanation.fit, discrepancy().labels(), freedom()), campaign_, model_);
  }

  void close_without_gap() {
    GapReport& gap = result_.gap;
    gap.before = gap.after = std::sqrt(result_.rows_before.squaredNorm() / freedom());
    take_best(inference_.null);
    take(conclude_without_gap(gap.noise_misjudged, result_.unsteady));
    result_.next_experiment.reason =
        result_.verdict == "unknown" ? result_.unknown_because : "there is no gap to explain";
    if (gap.noise_misjudged || !result_.unsteady.detected) return;
    gap.detected = true;
    gap.p_value = result_.unsteady.p_value;
  }

  void explain() {
    contest_ = contest_of(inference_, comparison_.candidates, judged_.has_value());
    naming_ = name_cause(*contest_);
    share_out();
  }

  void propose() {
    NextExperiment& next = result_.next_experiment;
    if (!doubt_.empty()) {
      next.reason = doubt_;
      return;
    }
    if (result_.verdict == "cause" && stands_alone()) {
      next.reason = "no other explanation keeps a twentieth of its odds";
      return;
    }
    next = propose_experiment(contest_->named, naming_, comparison_.condition_model(model_), comparison_.conditions,
                              comparison_.segment_evidence,
                              {options_.highest_level, inference_.dispersion, options_.threads});
    if (next.test) next.test->minutes = next.test->length * minutes_of(next.test->like);
  }

  bool stands_alone() const {
    return std::none_of(contest_->named.begin() + 1, contest_->named.end(),
                        [&](const Rival& r) { return is_credible(r, contest_->named.front()); });
  }

  // Of what was read of a record.
  double minutes_of(std::size_t record) const {
    const auto span = result_.spans.find(record);
    return span == result_.spans.end() ? 0 : (span->second.to_s - span->second.from_s) / 60;
  }

  Naming name_cause(const Contest& contest) {
    std::optional<VectorXd> given;
    if (judged_) given = judged_->rows;
    HeldOutGap gap(discrepancy(), result_.labels, given, inference_.null, result_.gap.floor);
    take({"unknown", "", "no effect that was tried fits"});
    if (contest.all.empty()) {
      take_share(gap.unclosed(), result_.gap);
      return {};
    }
    const Rival& best = contest.best();
    take_best(*best.explanation);
    gap.measure_in(span_of_gap(inference_.null.fit, inference_.explanations, given.value_or(VectorXd())));
    const ClosedShare closing = gap.closed_by(*best_);
    take_share(closing, result_.gap);
    result_.rows_after = best_->fit.rows;
    if (!best_->members.empty())
      result_.gap.placebo_closed = placebo_closed(inference_.null.fit, best_->fit.rows - inference_.null.fit.rows,
                                                  result_.labels, result_.gap.floor, gap.span());
    const double there_was = judged_ ? judged_->rows.squaredNorm() : inference_.null.fit.chi_squared;
    result_.residual_structure = residual_structure_of(best_->fit, result_.labels, freedom(),
                                                       std::max(0.0, there_was - best_->fit.chi_squared));
    if (options_.whole_decays) result_.residual_structure.smooth_p_value = p_value_of_parts();
    const SymbolUnits units(campaign_, model_);
    const CauseReporter reporter{comparison_.candidates, comparison_.unknown_names(model_),
                                 [&](std::size_t unknown) { return units.of(unknown); },
                                 [&](const Refit& fit) { return covariance_of(fit, result_.labels, freedom()); },
                                 [&](const Explanation& e) { return gap.closed_by(e).closed; }};
    if (best.open_law) result_.open_law = reporter.open_law(best);
    if (judged_) result_.parameters_moved = moved_parameters(model_, comparison_.start, inference_.null.fit);
    if (contest.named.empty()) return {};
    result_.causes = reporter.causes(contest.named);
    Naming naming = name_effects(contest.named, inference_);
    keep_limits(naming, contest.named, options_.catalogue,
                [&](const Explanation& limit, const Explanation& e) { return gap.repeats_step(limit, e); });
    take(naming);
    if (const Rival* wrong = best_wrong_cause(contest.named, naming.set)) {
      result_.gap.wrong_cause = wrong->effects.front();
      result_.gap.wrong_cause_closed = reporter.closed_share(*wrong->explanation);
    }
    take(conclude(naming, result_.residual_structure, closing,
                  what_speaks_against(contest, result_.gap.noise_misjudged, result_.unsteady, closing)));
    if (result_.verdict == "approximate") approximate(contest.named, naming, closing, gap);
    return naming;
  }

  // That parts of decays in one piece differ by as much in the numbers of the best explanation.
  double p_value_of_parts() const { return agreement_of_parts(best_->fit, parts_by_fold(result_.labels)).p_value; }

  // The best explanation is not all of the gap. Where the model's own numbers, fitted, close most of that of the
  // given ones, what an effect that is tried beside them closes is their doing.
  void approximate(const std::vector<Rival>& named, Naming naming, const ClosedShare& closing, HeldOutGap& gap) {
    result_.gap.left_share = 1 - closing.closed;
    if (best_->members.empty()) return;
    if (judged_) {
      const ClosedShare own = gap.closed_by(inference_.null);
      if (closes_most(own)) {
        take_best(inference_.null);
        take_share(own, result_.gap);
        result_.rows_after = inference_.null.fit.rows;
        result_.gap.left_share = 1 - own.closed;
        take(Naming{{"parameters"}, {}, {}});
        return;
      }
    }
    add_neighbours(naming, named, closing, [&](const Explanation& e) { return gap.closed_by(e).after; });
    take(naming);
  }

  // The gap row by row: what the named effect does to the rows, all else as it is; without a name, what is left.
  VectorXd gap_rows() const {
    if (result_.verdict == "unknown") return result_.rows_before;
    if (!best_ || best_->members.empty()) return result_.rows_before - result_.rows_after;
    return discrepancy()(switched_off(best_->fit.unknowns, best_->members, comparison_.candidates)) -
           best_->fit.rows;
  }

  // Where the cause says which force is missing, the balances are its own.
  void share_out() {
    const Candidate* named = nullptr;
    if (result_.verdict == "cause" && best_)
      for (const std::size_t m : best_->members)
        if (comparison_.candidates[m].effect == result_.cause) named = &comparison_.candidates[m];
    const VectorXd rows = discrepancy().by_balance(gap_rows());
    result_.where = gap_shares(rows, discrepancy().unmixed(rows), result_.labels, named);
  }

  void simulate() {
    const Refit& null = inference_.null.fit;
    const VectorXd& before = judged_ ? judged_->unknowns : null.unknowns;
    const VectorXd& after = best_->fit.unknowns;
    SimulatedCheck check = simulated_dwells(comparison_.condition_model(model_), comparison_.conditions, before,
                                            after, options_.threads);
    const auto& apart = comparison_.apart;
    if (const SegmentEvidence* segments = comparison_.segment_evidence)
      check.segments = simulated_window(*segments, comparison_.sensors, before, after);
    if (apart) check.apart = simulated_window(*apart, comparison_.sensors, before, after);
    result_.simulated = std::move(check);
    if (apart && options_.fit_check)
      fit_window(*apart, null, best_->fit, options_.threads, result_.simulated->apart);
  }

  const Campaign& campaign_;
  const CompiledModel& model_;
  DiagnosisOptions options_;
  Comparison comparison_;
  std::vector<std::size_t> free_;        // beside every explanation
  std::optional<JudgedNumbers> judged_;  // where numbers were given
  Inference inference_;
  std::optional<Contest> contest_;     // where a gap was found
  Naming naming_;                      // of its explanations
  const Explanation* best_ = nullptr;  // that the verdict is about
  std::string doubt_;                  // of the whole; empty: none
  Diagnosis result_;
};

OpenDiagnosis::OpenDiagnosis(const CampaignAndModel& sides, const std::vector<EquationEffect>& effects,
                             const DiagnosisOptions& options, const Inference* near)
    : stages_(std::make_unique<Stages>(sides, compare(sides, effects, options), options)) {
  stages_->run(near);
}

OpenDiagnosis::OpenDiagnosis(OpenDiagnosis&&) noexcept = default;
OpenDiagnosis& OpenDiagnosis::operator=(OpenDiagnosis&&) noexcept = default;
OpenDiagnosis::~OpenDiagnosis() = default;

bool OpenDiagnosis::leaves_noise_alone() const {
  return stages_->leaves_noise_alone();
}

bool OpenDiagnosis::admits_scatter() const {
  return stages_->admits_scatter();
}

const Diagnosis& OpenDiagnosis::so_far() const {
  return stages_->result();
}

bool OpenDiagnosis::has_as_credible(const ModelAlone& scatter) const {
  return stages_->has_as_credible(scatter);
}

void OpenDiagnosis::make_unknown(const std::string& why) {
  stages_->make_unknown(why);
}

const Refit& OpenDiagnosis::fit() const {
  return stages_->fit();
}

const Inference& OpenDiagnosis::inference() const {
  return stages_->inference();
}

bool OpenDiagnosis::holds_decays() const {
  return stages_->holds_decays();
}

const std::vector<StateForce>& OpenDiagnosis::forces() const {
  return stages_->forces();
}

Diagnosis OpenDiagnosis::finish() && {
  return stages_->finish();
}

Diagnosis diagnose(const CampaignAndModel& sides, const std::vector<EquationEffect>& effects,
                   const DiagnosisOptions& options) {
  return OpenDiagnosis(sides, effects, options).finish();
}

bool is_told(const Diagnosis& d) {
  return d.verdict == "no_gap" || d.verdict == "cause" || d.verdict == "set";
}

}  // namespace secular
