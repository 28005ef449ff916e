#include "diagnose/verdict/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/inference/held_out.hpp"
#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/comparison.hpp"
#include "diagnose/verdict/naming.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

/// A gap is there where noise alone would look like it less often than this.
constexpr auto& false_alarm = diagnose_thresholds().gap_alarm;

/// Repeatability that is overestimated by more than this, as a variance: a gap as large as the noise itself would
/// not be seen.
constexpr auto& most_overestimated = diagnose_thresholds().most_overestimated;

/// Of the scatter of natural frequencies before it is known, relative (any that is not far below it does); searches
/// beside it: of half as much each, the third differs by little.
constexpr auto& first_scatter = diagnose_thresholds().first_scatter;
constexpr int most_rounds = 3;

/// Predicting what was held out takes longer than all else that is said of a rival.
constexpr int most_neighbours = 6;

constexpr const char* metric =
    "root mean square over held-out rows (balance of every resonant line, lines of every channel) in units "
    "of measured repeatability";

class Diagnoser {
 public:
  Diagnoser(const Campaign& campaign, const CompiledModel& model, const std::vector<std::size_t>& own,
            Comparison comparison, const DiagnosisOptions& options)
      : campaign_(campaign),
        model_(model),
        options_(options),
        comparison_(std::move(comparison)),
        free_(comparison_.fitted_beside(own)) {}

  Diagnosis run() {
    result_.labels = discrepancy().labels();
    result_.conditions = comparison_.conditions.size() + comparison_.segments;
    result_.unsteady = comparison_.unsteady;
    result_.spans = comparison_.spans;
    result_.data_used = comparison_.data_used;
    result_.gap.judged = whose_gap(options_.given);
    result_.gap.metric = metric;
    InferenceOptions inference_options;
    inference_options.threads = options_.threads;
    inference_options.progress = options_.progress;
    for (const std::size_t s : free_)
      if (s < model_.modes()) inference_options.anchors.push_back(s);  // natural frequencies
    infer_beside_scatter(inference_options);
    if (!result_.frequency_scatter.suffices) {
      result_.verdict = "unknown";
      return std::move(result_);
    }
    for (Condition& condition : comparison_.conditions) {
      condition.record_shift = discrepancy().record_shift(condition.record);
      condition.set_record_delay(discrepancy().record_delay(condition.record));
    }
    for (const auto& [record, seconds] : options_.late_s)
      result_.late_s[record] = seconds - discrepancy().record_delay(record);
    if (options_.given)
      judged_ = judge_given(options_.given, model_, free_, discrepancy(), comparison_.start, options_.threads);
    result_.warnings = comparison_.warnings;
    if (!judged_.without_motion.empty())
      result_.warnings.push_back(fmt::format(
          "with the given numbers the model has no steady motion near the measured one in {} of {} records: "
          "how far off it is there is not a number, and counts as {:.0g} standard deviations",
          judged_.without_motion.size(), comparison_.spans.size(), diagnose_thresholds().no_motion));
    for (std::string& warning : disturbed_records(comparison_, campaign_))
      result_.warnings.push_back(std::move(warning));
    detect();
    result_.rows_before = options_.given ? judged_.rows : inference_.null.fit.rows;
    result_.rows_after = result_.rows_before;
    if (!result_.gap.detected) {
      close_without_gap();
      return std::move(result_);
    }
    const std::vector<Rival> all = rivals();
    std::vector<Rival> named;
    for (const Rival& r : all)
      if (!r.open_law) named.push_back(r);
    const Naming naming = name_cause(all, named);
    share_out();
    result_.next_experiment = propose_experiment(named, naming, comparison_.condition_model(model_),
                                                 comparison_.conditions, inference_.dispersion, options_.threads);
    if (best_) simulate();
    return std::move(result_);
  }

 private:
  const Discrepancy& discrepancy() const { return comparison_.discrepancy; }

  // Degrees of freedom of the rows about a fit.
  double freedom_about(const Refit& fit) const { return static_cast<double>(discrepancy().freedom() - fit.rank); }

  bool suffices(const Refit& fit) const {
    return chi_squared_upper_tail(fit.chi_squared, freedom_about(fit)) >= false_alarm;
  }

  // Whether it closes as much as a cause has to of what the model as it is leaves beyond noise.
  bool leaves_little(const Refit& best) const {
    const auto beyond_noise = [&](const Refit& fit) { return std::sqrt(fit.chi_squared / freedom_about(fit)) - 1; };
    const double open = 1 - diagnose_thresholds().most_of_the_gap;
    return beyond_noise(best) < open * beyond_noise(inference_.null.fit);
  }

  // Natural frequencies scatter about the model where it leaves nothing, else about the best explanation. What a
  // model that lacks something leaves of them is larger: with what is left about its best explanation the search is
  // made again. A smaller scatter allows for less: where the larger one leaves more than noise already, it is not
  // what is there, or not all.
  void infer_beside_scatter(const InferenceOptions& inference_options) {
    RecordNuisances& of_records = comparison_.of_records;
    for (int round = 1;; ++round) {
      inference_ =
          infer(comparison_.discrepancy, comparison_.candidates, comparison_.start, free_, inference_options);
      if (of_records.frequency_sd.size() == 0) return;
      const bool explained = !inference_.explanations.empty() && !suffices(inference_.null.fit) &&
                             inference_.explanations.front().log_evidence > inference_.null.log_evidence;
      const Refit& best = explained ? inference_.explanations.front().fit : inference_.null.fit;
      result_.frequency_scatter = scatter_about(discrepancy(), best.unknowns, model_.modes());
      result_.frequency_scatter.suffices = suffices(best) || (explained && leaves_little(best));
      const VectorXd sd = admitted(result_.frequency_scatter);
      const bool grows = (sd.array() > of_records.frequency_sd.array()).any();
      if ((!result_.frequency_scatter.suffices && !grows) || round == most_rounds ||
          is_as_large(sd, of_records.frequency_sd))
        return;
      of_records.frequency_sd = sd;
      comparison_.discrepancy.admit(of_records);
    }
  }

  // Predicting what was held out takes long, and of some explanations is asked more than once.
  const VectorXd& held_out_rows(const Explanation& explanation) {
    const auto [place, fresh] = held_out_.try_emplace(&explanation);
    if (fresh) place->second = predict_held_out(discrepancy(), explanation.fit, result_.labels).rows;
    return place->second;
  }

  void detect() {
    GapReport& gap = result_.gap;
    // With error bars the sum of all squares is that of the numbers that fit best: how far these are is another
    // question.
    const bool exactly = gap.judged == Judged::given;
    const double chi_squared = exactly ? judged_.rows.squaredNorm() : inference_.null.fit.chi_squared;
    const double freedom =
        exactly ? static_cast<double>(discrepancy().freedom() - judged_.rank) : inference_.degrees_of_freedom;
    const double omnibus = chi_squared_upper_tail(chi_squared, freedom);
    // The best single candidate on its own, corrected for having been looked for.
    double targeted = 1;
    const std::vector<Candidate>& candidates = comparison_.candidates;
    for (std::size_t c = 0; c < candidates.size(); ++c)
      targeted = std::min(targeted, chance_of_gain(candidates[c], c));
    targeted = std::min(1.0, targeted * static_cast<double>(std::max<std::size_t>(1, candidates.size())));
    double moved = 1;
    if (options_.given)
      moved = moved_p_value(options_.given, judged_, model_, comparison_.start, inference_.null.fit);
    gap.p_value = std::min(1.0, (options_.given ? 3 : 2) * std::min({omnibus, targeted, moved}));
    gap.detected = gap.p_value < false_alarm;
    gap.noise_misjudged = chi_squared * most_overestimated < freedom && 1 - omnibus < false_alarm;
  }

  // That a candidate gains as much without acting (docs/inference.md (32)).
  double chance_of_gain(const Candidate& candidate, std::size_t c) const {
    const auto unknowns = static_cast<double>(candidate.strengths.size() + candidate.shapes.size());
    const double share = inference_.gain_of_records[c];
    return f_upper_tail(inference_.linear_gain[c] / unknowns, unknowns,
                        result_.frequency_scatter.freedom / (share * share));
  }

  // Of the explanation that the verdict is about.
  void take_numbers(const Explanation& explanation) {
    std::vector<const Candidate*> members;
    for (const std::size_t m : explanation.members) members.push_back(&comparison_.candidates[m]);
    result_.fitted = fitted_numbers(explanation.fit, members, comparison_.unknown_names(model_),
                                    static_cast<double>(discrepancy().freedom()), campaign_, model_);
  }

  // Mean motions agree with the model; what varies within dwells may not.
  void close_without_gap() {
    GapReport& gap = result_.gap;
    gap.before = gap.after =
        std::sqrt(result_.rows_before.squaredNorm() / static_cast<double>(discrepancy().freedom()));
    take_numbers(inference_.null);
    if (gap.noise_misjudged) {
      result_.verdict = "unknown";
      result_.unknown_because = "the noise is misjudged: a gap could not be seen";
      result_.next_experiment.reason = result_.unknown_because;
    } else if (result_.unsteady.detected) {
      result_.verdict = "unknown";
      gap.detected = true;
      gap.p_value = result_.unsteady.p_value;
      result_.unknown_because = "the mean motions agree with the model; what varies is not the excitation";
      result_.next_experiment.reason = result_.unknown_because;
    } else {
      result_.verdict = "no_gap";
      result_.next_experiment.reason = "there is no gap to explain";
    }
  }

  // A stalled fit names nothing; and one that is likelier than all that have converged lets none of these be named.
  std::vector<Rival> only_converged(std::vector<Rival> all) {
    const auto has_converged = [](const Rival& r) { return r.explanation->fit.ending == FitEnding::converged; };
    const auto first = std::find_if(all.begin(), all.end(), has_converged);
    stalled_ = first == all.end() || !is_credible(*first, all.front());
    if (stalled_) return all;
    std::erase_if(all, [&](const Rival& r) { return !has_converged(r); });
    rank(all);
    return all;
  }

  // The model's own numbers moved: an explanation when numbers were given.
  std::vector<Rival> rivals() {
    std::vector<Rival> all;
    if (options_.given) all.push_back({&inference_.null, inference_.null.log_evidence, 0, {"parameters"}, false});
    for (const Explanation& e : inference_.explanations) {
      Rival rival{&e, e.log_evidence, 0, {}, false};
      for (const std::size_t m : e.members) {
        rival.effects.push_back(comparison_.candidates[m].effect);
        const Candidate& c = comparison_.candidates[m];
        rival.open_law = rival.open_law || c.open_law;
        rival.contains.insert(rival.contains.end(), c.contains.begin(), c.contains.end());
      }
      all.push_back(std::move(rival));
    }
    if (!all.empty()) rank(all);
    return only_converged(std::move(all));
  }

  // `named`: those of `all` that the catalogue holds.
  Naming name_cause(const std::vector<Rival>& all, const std::vector<Rival>& named) {
    result_.verdict = "unknown";
    result_.unknown_because = "no effect that was tried fits";
    const VectorXd before = options_.given ? judged_.rows : held_out_rows(inference_.null);
    if (all.empty()) {
      fill_gap(closed_share(before, before, result_.labels, result_.gap.floor));
      return {};
    }
    // An exponent of its own that is credibly no better than a law of the catalogue stands for that law.
    const bool catalogue_will_do =
        all.front().open_law && !named.empty() && is_credible(named.front(), all.front());
    const Rival& best = catalogue_will_do ? named.front() : all.front();
    best_ = best.explanation;
    const ClosedShare closing = closed_share(before, held_out_rows(*best_), result_.labels, result_.gap.floor);
    fill_gap(closing);
    result_.rows_after = best_->fit.rows;
    take_numbers(*best_);
    if (!best_->members.empty())
      result_.gap.placebo_closed = placebo_closed(inference_.null.fit, best_->fit.rows - inference_.null.fit.rows,
                                                  result_.labels, result_.gap.floor);
    const double there_was = options_.given ? judged_.rows.squaredNorm() : inference_.null.fit.chi_squared;
    result_.residual_structure =
        residual_structure_of(best_->fit, result_.labels, static_cast<double>(discrepancy().freedom()),
                              std::max(0.0, there_was - best_->fit.chi_squared));
    const CauseReporter reporter{
        comparison_.candidates, comparison_.unknown_names(model_), inference_.dispersion,
        [&](const Explanation& e) { return closed_share(before, held_out_rows(e), result_.labels, 1).closed; }};
    if (best.open_law) result_.open_law = reporter.open_law(best);
    Naming naming;
    if (!named.empty()) {
      result_.causes = reporter.causes(named);
      naming = name_effects(named, inference_);
      keep_limits(naming, named, options_.catalogue, [&](const Explanation& limit, const Explanation& explanation) {
        return repeats(held_out_rows(limit), held_out_rows(explanation), result_.labels);
      });
      result_.set = naming.set;
      result_.together = naming.together;
      result_.second_or = naming.second_or;
      if (const Rival* wrong = best_wrong_cause(named, naming.set)) {
        result_.gap.wrong_cause = wrong->effects.front();
        result_.gap.wrong_cause_closed = reporter.closed_share(*wrong->explanation);
      }
      result_.unknown_because = why_nothing_is_named(best);
      const Reach reach =
          result_.unknown_because.empty() ? reach_of(result_.residual_structure, closing) : Reach::little;
      if (reach == Reach::all) {
        result_.verdict = naming.set.size() == 1 ? "cause" : "set";
        result_.cause = naming.set.size() == 1 ? naming.set.front() : "";
      } else if (reach == Reach::approximate) {
        result_.verdict = "approximate";
        if (!own_numbers_will_do(before) && !best.explanation->members.empty()) add_neighbours(best, named, before);
        result_.gap.left_share = 1 - result_.gap.closed;
      } else if (result_.unknown_because.empty()) {
        result_.unknown_because = what_is_missing(result_.residual_structure, closing);
      }
    }
    if (options_.given) result_.parameters_moved = moved_parameters(model_, comparison_.start, inference_.null.fit);
    return naming;
  }

  // Whether the model's own numbers, fitted, close most of the gap of those that were given: what an effect that is
  // tried beside them closes is their doing then.
  bool own_numbers_will_do(const VectorXd& before) {
    if (!options_.given || best_->members.empty()) return false;
    const ClosedShare closing =
        closed_share(before, held_out_rows(inference_.null), result_.labels, result_.gap.floor);
    if (!closes_most(closing)) return false;
    best_ = &inference_.null;
    fill_gap(closing);
    take_numbers(inference_.null);
    result_.rows_after = inference_.null.fit.rows;
    result_.set = {"parameters"};
    result_.together.clear();
    result_.second_or.clear();
    return true;
  }

  // Where even the best explanation is not all, how much likelier it is than others rests on a model that does not
  // hold: an effect in the place of one of its own acts as much like what is there if it does nine tenths of what
  // that one does beside the other.
  void add_neighbours(const Rival& best, const std::vector<Rival>& named, const VectorXd& before) {
    const auto left_by = [&](const VectorXd& rows) {
      return closed_share(before, rows, result_.labels, result_.gap.floor).after;
    };
    const auto alone = [&](const std::vector<std::string>& effects) {
      return std::find_if(named.begin(), named.end(), [&](const Rival& r) { return r.effects == effects; });
    };
    int tried = 0;
    for (const Rival& rival : named) {
      const std::vector<std::string> instead = only_in(rival.effects, best.effects),
                                     of = only_in(best.effects, rival.effects);
      if (rival.effects.size() != best.effects.size() || instead.size() != 1 || of.size() != 1) continue;
      std::vector<std::string>& names = of.front() == result_.set.front() ? result_.set : result_.second_or;
      const auto holds = [&](const std::vector<std::string>& list, const std::string& name) {
        return std::find(list.begin(), list.end(), name) != list.end();
      };
      if (holds(names, instead.front()) || holds(rival.contains, of.front())) continue;
      const std::vector<std::string> shared = only_in(best.effects, of);
      const auto beside = alone(shared);
      if (!shared.empty() && beside == named.end()) continue;
      if (tried++ == most_neighbours) return;
      const double without = shared.empty() ? result_.gap.before : left_by(held_out_rows(*beside->explanation));
      if (without - left_by(held_out_rows(*rival.explanation)) >=
          diagnose_thresholds().most_of_the_gap * (without - result_.gap.after))
        names.push_back(instead.front());
    }
  }

  // Whatever an explanation closes; empty: nothing speaks against it.
  std::string why_nothing_is_named(const Rival& best) const {
    if (result_.gap.noise_misjudged) return "the noise is misjudged";
    if (stalled_) return "the fit that explains most did not converge";
    if (best.open_law) return "a law outside of the catalogue explains better than all that are in it";
    if (is_restless()) return "the motion varies within dwells by more than the best explanation removes";
    return "";
  }

  void fill_gap(const ClosedShare& share) {
    GapReport& gap = result_.gap;
    gap.before = share.before;
    gap.after = share.after;
    gap.closed = share.closed;
    gap.closed_low = share.low;
    gap.closed_high = share.high;
  }

  // What varies within dwells counts against an explanation of their means that is worth less.
  bool is_restless() const {
    const auto squares = [](double rms) { return rms * rms; };
    return result_.unsteady.detected &&
           squares(result_.unsteady.ratio) - 1 > squares(result_.gap.before) - squares(result_.gap.after);
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
    const VectorXd rows = gap_rows();
    result_.where = gap_shares(rows, discrepancy().unmixed(rows), result_.labels, named);
  }

  void simulate() {
    const Refit& null = inference_.null.fit;
    const VectorXd& before = options_.given ? judged_.unknowns : null.unknowns;
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
  const DiagnosisOptions& options_;
  Comparison comparison_;
  std::vector<std::size_t> free_;  // beside every explanation
  JudgedNumbers judged_;           // where numbers were given
  Inference inference_;
  const Explanation* best_ = nullptr;
  std::map<const Explanation*, VectorXd> held_out_;
  bool stalled_ = false;  // the likeliest explanation is no minimum, and no other comes near it
  Diagnosis result_;
};

Inference null_of(Comparison& comparison, const std::vector<std::size_t>& fitted, const DiagnosisOptions& options) {
  InferenceOptions inference_options;
  inference_options.threads = options.threads;
  return infer(comparison.discrepancy, {}, comparison.start, fitted, inference_options);
}

bool misses(const Inference& null) {
  return chi_squared_upper_tail(null.null.fit.chi_squared, null.degrees_of_freedom) < false_alarm;
}

}  // namespace

Diagnosis diagnose(const Campaign& campaign, const RecordReader& read, const CompiledModel& model,
                   const std::vector<std::size_t>& own, const std::vector<EquationEffect>& effects,
                   const DiagnosisOptions& options) {
  return Diagnoser(campaign, model, own, compare(campaign, read, model, own, effects, options), options).run();
}

bool misses(const Campaign& campaign, const RecordReader& read, const CompiledModel& model,
            const std::vector<std::size_t>& own, const DiagnosisOptions& options,
            std::optional<double> common_delay_s) {
  Comparison comparison = compare(campaign, read, model, own, {}, options);
  std::vector<std::size_t> fitted = comparison.fitted_beside(own);
  if (common_delay_s) {
    const std::size_t delay = model.symbols.size() + comparison.faults.delay(comparison.sensors.responses.size());
    comparison.start(static_cast<Eigen::Index>(delay)) = -*common_delay_s;
    fitted.push_back(delay);
  }
  return misses(null_of(comparison, fitted, options));
}

std::optional<std::vector<SegmentEvidence::Left>> left_where_missed(const Campaign& campaign,
                                                                    const RecordReader& read,
                                                                    const CompiledModel& model,
                                                                    const std::vector<std::size_t>& own,
                                                                    const DiagnosisOptions& options) {
  Comparison comparison = compare(campaign, read, model, own, {}, options);
  const Inference null = null_of(comparison, comparison.fitted_beside(own), options);
  if (!misses(null)) return std::nullopt;
  const SegmentEvidence* segments = comparison.segment_evidence;
  return segments ? segments->left(null.null.fit.unknowns) : std::vector<SegmentEvidence::Left>();
}

FrequencyScatter find_frequency_scatter(const Campaign& campaign, const RecordReader& read,
                                        const CompiledModel& model, const std::vector<std::size_t>& own,
                                        const DiagnosisOptions& options) {
  DiagnosisOptions wanted = options;
  wanted.frequency_scatter = VectorXd::Constant(static_cast<Eigen::Index>(model.modes()), first_scatter);
  Comparison comparison = compare(campaign, read, model, own, {}, wanted);
  const std::vector<std::size_t> fitted = comparison.fitted_beside(own);
  InferenceOptions inference_options;
  inference_options.threads = options.threads;
  const Inference null = infer(comparison.discrepancy, {}, comparison.start, fitted, inference_options);
  return scatter_about(comparison.discrepancy, null.null.fit.unknowns, model.modes());
}

bool is_told(const Diagnosis& d) {
  return d.verdict == "no_gap" || d.verdict == "cause" || d.verdict == "set";
}

}  // namespace secular
