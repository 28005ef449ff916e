#include "diagnose/diagnosis.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "diagnose/contradiction.hpp"
#include "diagnose/held_out.hpp"
#include "diagnose/line_evidence.hpp"
#include "diagnose/naming.hpp"
#include "diagnose/observe_conditions.hpp"
#include "diagnose/remainder.hpp"
#include "diagnose/segment_evidence.hpp"
#include "estimator/identification/short_list.hpp"
#include "estimator/regression/distribution.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A gap is there where noise alone would look like it less often than this.
constexpr double false_alarm = 0.003;

/// Dwells are unsteady where noise alone would vary as much less often than this.
constexpr double unsteady_alarm = 1e-6;

/// The best explanation leaves structure where noise alone would leave as much less often than this.
constexpr double remainder_alarm = 1e-4;

/// An explanation that leaves structure is still the cause if what it leaves beyond repeatability is this share of
/// what was there.
constexpr double small_remainder = 0.1;

/// Samples of decays, sweeps and broadband records that are compared, in all.
constexpr Index most_samples = 6000;

/// A dwell is proposed if it has this chance of leaving one explanation, and leaves no more than this share of the
/// probability that another one is right.
constexpr double worth_a_test = 0.5, most_doubt = 0.5;

/// Explanations that a next experiment is planned for, and the least probability that each counts with there.
constexpr std::size_t most_hypotheses = 4;
constexpr double least_rival = 0.05;

class Diagnoser {
 public:
  Diagnoser(const Campaign& campaign, const RecordReader& read, const CompiledModel& model,
            const std::vector<std::size_t>& own, const std::vector<EquationEffect>& effects,
            const DiagnosisOptions& options)
      : campaign_(campaign),
        model_(model),
        own_(own),
        options_(options),
        sensors_(sensor_model(campaign, model, model.excitations.size() - options.forces.size())),
        faults_(model, sensors_) {
    set_start();
    std::vector<double> natural;
    for (std::size_t k = 0; k < model.modes(); ++k) natural.push_back(start_(static_cast<Index>(k)));
    ObservedConditions observed = observe_conditions(campaign, read, model, sensors_, natural, options.window);
    result_.warnings = std::move(observed.warnings);
    std::vector<Segment> segments =
        cut_segments(campaign, read, sensors_, natural,
                     {options.window, SegmentLength::turns, most_samples, options.band}, result_.warnings);
    if (observed.conditions.empty() && segments.empty())
      throw InputError(
          campaign.folder.string(), "",
          "holds no record that model " + std::string(model.name) + " can be compared with" +
              (result_.warnings.empty() ? "" : " (" + result_.warnings.front() + ")"),
          "settled dwells, free decays, sweeps or broadband records near the model's resonances are expected");
    result_.conditions = observed.conditions.size() + segments.size();
    conditions_ = std::move(observed.conditions);
    judge_steadiness(observed.wander);
    leave_out_unsteady(observed.wander);
    const VectorXd largest = largest_displacements(conditions_, segments, sensors_, natural);
    set_scales(largest, natural);
    candidates_ = candidates_of(effects, model, sensors_, faults_, conditions_, segments, largest);
    check_left_out();
    std::erase_if(candidates_, [&](const Candidate& c) { return options.left_out.contains(c.effect); });
    if (!conditions_.empty())
      discrepancy_.add(std::make_unique<LineEvidence>(condition_model(), conditions_, start_));
    if (!segments.empty()) {
      auto evidence =
          std::make_unique<SegmentEvidence>(model, options_.forces, sensors_, faults_, std::move(segments));
      segments_ = evidence.get();
      discrepancy_.add(std::move(evidence));
    }
    if (options.check) {
      std::vector<Segment> apart =
          cut_segments(campaign, read, sensors_, natural,
                       {*options.check, SegmentLength::whole, most_samples, options.band}, result_.warnings);
      if (apart.empty())
        throw InputError("--check-from, --check-to", "",
                         "hold no part of a free decay, sweep or broadband record of " + campaign.folder.string(),
                         "a window in seconds of the records' own time is expected");
      apart_.emplace(model, options_.forces, sensors_, faults_, std::move(apart));
    }
  }

  Diagnosis run() {
    result_.labels = discrepancy_.labels();
    InferenceOptions inference_options;
    inference_options.threads = options_.threads;
    for (const std::size_t s : own_)
      if (s < model_.modes()) inference_options.anchors.push_back(s);  // natural frequencies
    inference_ = infer(discrepancy_, candidates_, start_, own_, inference_options);
    judge_given();
    warn_of_disturbed_records();
    detect();
    result_.rows_before = given() ? given_.rows : inference_.null.fit.rows;
    result_.rows_after = result_.rows_before;
    if (!result_.gap.detected) {
      close_without_gap();
      return std::move(result_);
    }
    const std::vector<Rival> all = rivals();
    std::vector<Rival> named;
    for (const Rival& r : all)
      if (!r.open_law) named.push_back(r);
    name_cause(all, named);
    share_out();
    propose_experiment(named);
    if (best_) simulate();
    return std::move(result_);
  }

 private:
  bool given() const { return !options_.parameters.empty(); }

  void simulate() {
    const Refit& null = inference_.null.fit;
    result_.simulated =
        simulated_check(condition_model(), conditions_, segments_, apart_ ? &*apart_ : nullptr,
                        given() ? given_.unknowns : null.unknowns, best_->fit.unknowns, options_.threads);
    if (apart_ && options_.fit_check)
      fit_window(*apart_, null, best_->fit, options_.threads, result_.simulated->apart);
  }

  ConditionModel condition_model() const {
    return ConditionModel(MotionBalance(model_, options_.forces), sensors_, faults_);
  }

  static std::string metric() {
    return "root mean square over held-out rows (balance of every resonant line, lines of every channel) in units "
           "of measured repeatability";
  }

  void set_start() {
    start_ = VectorXd::Zero(static_cast<Index>(model_.symbols.size() + faults_.size()));
    for (std::size_t s = 0; s < model_.symbols.size(); ++s) {
      const double nominal = s < model_.nominal.size() ? model_.nominal[s] : NAN;
      if (std::isfinite(nominal)) start_(static_cast<Index>(s)) = nominal;
      const auto found = options_.parameters.find(std::string(model_.symbols[s].name));
      if (found != options_.parameters.end()) start_(static_cast<Index>(s)) = found->second;
    }
    for (const auto& [name, value] : options_.parameters) {
      const bool known =
          std::any_of(own_.begin(), own_.end(), [&](std::size_t s) { return model_.symbols[s].name == name; });
      if (!known)
        throw InputError("--parameters", "symbol " + name, "is no symbol of model " + std::string(model_.name), "");
    }
    for (const std::size_t s : own_) {
      const std::string name(model_.symbols[s].name);
      const bool nominal = s < model_.nominal.size() && std::isfinite(model_.nominal[s]);
      if (given() && !options_.parameters.contains(name) && !nominal)
        throw InputError(
            "--parameters", "symbol " + name, "has no value",
            "the gap of given numbers is that of all of them; leave --parameters out to have them fitted");
    }
    for (std::size_t k = 0; k < model_.modes(); ++k)
      if (!(start_(static_cast<Index>(k)) > 0))
        throw InputError(std::string(model_.name), "[nominal]",
                         "gives no natural frequency " + std::string(model_.symbols[k].name),
                         "a rough one tells which resonance a record excites; or give --parameters");
    start_(static_cast<Index>(model_.symbols.size() + faults_.extra_frequency())) = start_(0);
    start_(static_cast<Index>(model_.symbols.size() + faults_.extra_damping())) = 0.01;
  }

  // Laws with an exponent: a strength then has much the same size whatever the exponent.
  void set_scales(const VectorXd& largest, const std::vector<double>& natural) {
    for (StateForce& force : options_.forces) {
      const double displacement = std::max(0.5 * largest(static_cast<Index>(force.mode)), 1e-300);
      force.scale = is_of_velocity(force.law) ? displacement * natural[force.mode] : displacement;
    }
  }

  void check_left_out() const {
    const std::vector<std::string> names = effect_names();
    for (const std::string& name : options_.left_out)
      if (!std::binary_search(names.begin(), names.end(), name))
        throw InputError("--without " + name, "", "is no effect of the catalogue",
                         fmt::format("one of {} is expected", fmt::join(names, ", ")));
  }

  void warn_of_disturbed_records() {
    if (!segments_) return;
    for (const SegmentEvidence::Disturbed& d : segments_->disturbed()) {
      std::vector<std::string> times;
      for (const double t : d.worst_s) times.push_back(fmt::format("{:.1f} s", t));
      result_.warnings.push_back(
          fmt::format("{}: what the model leaves in its {} segments follows no law of the amplitude (slips of the "
                      "clock, knocks?){}; it counts as disturbance of the record",
                      campaign_.records[d.record].file, d.segments,
                      times.empty() ? "" : fmt::format(", most of it about {}", fmt::join(times, ", "))));
    }
  }

  void judge_steadiness(const std::vector<Wander>& wander) {
    const WanderTest test = test_wander(wander);
    Unsteadiness& unsteady = result_.unsteady;
    unsteady.p_value = test.p_value;
    unsteady.ratio = test.ratio;
    unsteady.detected = test.p_value < unsteady_alarm;
    if (!unsteady.detected) return;
    unsteady.record = campaign_.records[test.record].file;
    result_.warnings.push_back(
        fmt::format("motion varies within dwells by {:.2g} times what the noise beside it explains (p = {:.1g}, "
                    "most in {}) though the excitation is steady: a force that no channel records, or a structure "
                    "that changes from minute to minute, which no effect of the catalogue does",
                    unsteady.ratio, unsteady.p_value, unsteady.record));
  }

  // A few dwells that wander have no mean motion to compare; where most do, the mean is all there is.
  void leave_out_unsteady(const std::vector<Wander>& wander) {
    std::set<std::size_t> records;
    for (const Wander& w : wander)
      if (test_wander({w}).p_value < unsteady_alarm) records.insert(w.record);
    const auto unsteady = [&](const Condition& c) { return records.contains(c.record); };
    const auto count = std::count_if(conditions_.begin(), conditions_.end(), unsteady);
    if (count == 0 || 2 * static_cast<std::size_t>(count) > conditions_.size()) return;
    std::erase_if(conditions_, unsteady);
    result_.conditions -= static_cast<std::size_t>(count);
    std::vector<std::string> files;
    for (const std::size_t record : records) files.push_back(campaign_.records[record].file);
    result_.warnings.push_back(fmt::format("left out because their motion is not steady: {}", short_list(files)));
  }

  // Mean motions agree with the model; what varies within dwells may not.
  void close_without_gap() {
    GapReport& gap = result_.gap;
    gap.before = gap.after =
        std::sqrt(result_.rows_before.squaredNorm() / static_cast<double>(discrepancy_.freedom()));
    gap.metric = metric();
    if (result_.unsteady.detected) {
      result_.verdict = "unknown";
      gap.detected = true;
      gap.p_value = result_.unsteady.p_value;
      result_.next_experiment.reason = "the mean motions agree with the model; what varies is not the excitation";
    } else {
      result_.verdict = "no_gap";
      result_.next_experiment.reason = "there is no gap to explain";
    }
  }

  // The given numbers with the errors that hold at the fit; what they leave open is the campaign's to choose.
  void judge_given() {
    if (!given()) return;
    result_.gap.judged = options_.parameter_sd.empty() ? Judged::given : Judged::within_error_bars;
    given_.unknowns = start_;
    given_.rows = discrepancy_(start_);
    std::vector<std::size_t> open;
    for (const std::size_t s : own_)
      if (options_.open.contains(std::string(model_.symbols[s].name))) open.push_back(s);
    if (open.empty()) return;
    RefitOptions refit_options;
    refit_options.threads = options_.threads;
    const Refit fit = refit(discrepancy_, start_, open, refit_options);
    given_.unknowns = fit.unknowns;
    given_.rows = fit.rows;
    given_.rank = fit.rank;
  }

  // Of the given numbers' error bars by the free unknowns of a fit.
  VectorXd given_sd(const Refit& fit) const {
    VectorXd sd(static_cast<Index>(fit.free.size()));
    for (Index f = 0; f < sd.size(); ++f) {
      const std::string name(model_.symbols[fit.free[static_cast<std::size_t>(f)]].name);
      const auto found = options_.parameter_sd.find(name);
      sd(f) = options_.open.contains(name)           ? std::numeric_limits<double>::infinity()
              : found == options_.parameter_sd.end() ? 0
                                                     : found->second;
    }
    return sd;
  }

  // Whether the given numbers are other than those that fit best, p of that.
  double moved_p_value() const {
    const Refit& fit = inference_.null.fit;
    if (!given()) return 1;
    if (options_.parameter_sd.empty())
      return chi_squared_upper_tail(given_.rows.squaredNorm() - fit.chi_squared,
                                    static_cast<double>(fit.rank - given_.rank));
    VectorXd numbers(static_cast<Index>(fit.free.size()));
    for (Index f = 0; f < numbers.size(); ++f)
      numbers(f) = start_(static_cast<Index>(fit.free[static_cast<std::size_t>(f)]));
    const Contradiction found = contradiction(fit, numbers, given_sd(fit));
    return chi_squared_upper_tail(found.chi_squared, static_cast<double>(found.rank));
  }

  void detect() {
    GapReport& gap = result_.gap;
    // With error bars the sum of all squares is that of the numbers that fit best: how far these are is another
    // question.
    const bool exactly = gap.judged == Judged::given;
    const double chi_squared = exactly ? given_.rows.squaredNorm() : inference_.null.fit.chi_squared;
    const double freedom =
        exactly ? static_cast<double>(discrepancy_.freedom() - given_.rank) : inference_.degrees_of_freedom;
    const double omnibus = chi_squared_upper_tail(chi_squared, freedom);
    // The best single candidate on its own, corrected for having been looked for.
    double targeted = 1;
    for (std::size_t c = 0; c < candidates_.size(); ++c)
      targeted = std::min(targeted, chi_squared_upper_tail(inference_.linear_gain[c],
                                                           static_cast<double>(candidates_[c].strengths.size() +
                                                                               candidates_[c].shapes.size())));
    targeted = std::min(1.0, targeted * static_cast<double>(std::max<std::size_t>(1, candidates_.size())));
    const double moved = moved_p_value();
    gap.p_value = std::min(1.0, (given() ? 3 : 2) * std::min({omnibus, targeted, moved}));
    gap.detected = gap.p_value < false_alarm;
  }

  // The model's own numbers moved: an explanation when numbers were given.
  std::vector<Rival> rivals() const {
    std::vector<Rival> all;
    if (given()) all.push_back({&inference_.null, inference_.null.log_evidence, 0, {"parameters"}, false});
    for (const Explanation& e : inference_.explanations) {
      Rival rival{&e, e.log_evidence, 0, {}, false};
      for (const std::size_t m : e.members) {
        rival.effects.push_back(candidates_[m].effect);
        rival.open_law = rival.open_law || candidates_[m].open_law;
      }
      all.push_back(std::move(rival));
    }
    if (!all.empty()) rank(all);
    return all;
  }

  // `named`: those of `all` that the catalogue holds.
  void name_cause(const std::vector<Rival>& all, const std::vector<Rival>& named) {
    HeldOut before;
    if (given())
      before.rows = given_.rows;
    else
      before = predict_held_out(discrepancy_, inference_.null.fit, result_.labels);
    if (all.empty()) {
      result_.verdict = "unknown";
      fill_gap(before.rows, before.rows);
      return;
    }
    // An exponent of its own that is credibly no better than a law of the catalogue stands for that law.
    const bool catalogue_will_do =
        all.front().open_law && !named.empty() && is_credible(named.front(), all.front());
    const Rival& best = catalogue_will_do ? named.front() : all.front();
    best_ = best.explanation;
    const HeldOut after = predict_held_out(discrepancy_, best.explanation->fit, result_.labels);
    fill_gap(before.rows, after.rows);
    result_.rows_after = best.explanation->fit.rows;
    if (!best_->members.empty())
      result_.gap.placebo_closed = placebo_closed(inference_.null.fit, best_->fit.rows - inference_.null.fit.rows,
                                                  result_.labels, result_.gap.floor);

    const double left =
        chi_squared_upper_tail(best.explanation->fit.chi_squared,
                               static_cast<double>(discrepancy_.freedom() - best.explanation->fit.rank));
    const bool structured = left < remainder_alarm;
    const auto beyond_floor = [&](double rms) {
      return std::sqrt(std::max(0.0, rms * rms - result_.gap.floor * result_.gap.floor));
    };
    const SmoothRemainder smooth = smooth_remainder(best.explanation->fit, result_.labels);
    const double before_squares = given() ? given_.rows.squaredNorm() : inference_.null.fit.chi_squared;
    const double explained = std::max(0.0, before_squares - best.explanation->fit.chi_squared);
    RemainderReport& remainder = result_.remainder;
    remainder.p_value = left;
    remainder.smooth_p_value = smooth.p_value;
    remainder.smooth_share = smooth.excess() > 0 ? std::sqrt(smooth.excess() / (smooth.excess() + explained)) : 0;
    const bool leaves_structure =
        (structured && beyond_floor(result_.gap.after) > small_remainder * beyond_floor(result_.gap.before)) ||
        (smooth.p_value < remainder_alarm && remainder.smooth_share > small_remainder);
    // What varies within dwells counts against an explanation of their means that is worth less.
    const auto squares = [](double rms) { return rms * rms; };
    const bool restless = result_.unsteady.detected && squares(result_.unsteady.ratio) - 1 >
                                                           squares(result_.gap.before) - squares(result_.gap.after);
    const bool unknown = leaves_structure || restless;

    if (best.open_law) describe_open_law(best);
    result_.verdict = "unknown";
    if (!named.empty()) {
      collect_causes(named, before.rows);
      Naming naming = name_effects(named, inference_);
      result_.set = std::move(naming.set);
      result_.together = std::move(naming.together);
      result_.second_or = std::move(naming.second_or);
      compare_with_wrong_cause(named, before.rows);
      if (!unknown && !best.open_law) {
        result_.verdict = result_.set.size() == 1 ? "cause" : "set";
        result_.cause = result_.set.size() == 1 ? result_.set.front() : "";
      }
    }
    if (given()) list_moved_parameters();
  }

  void describe_open_law(const Rival& rival) {
    const Candidate& law = candidates_[rival.explanation->members.front()];
    const Refit& fit = rival.explanation->fit;
    const std::size_t exponent = law.shapes.front();
    const auto at = static_cast<Index>(std::find(fit.free.begin(), fit.free.end(), exponent) - fit.free.begin());
    result_.open_law =
        OpenLaw{law.subject, law.effect, fit.unknowns(static_cast<Index>(exponent)),
                std::sqrt(std::max(0.0, fit.covariance(at, at) * inference_.dispersion)), rival.probability};
  }

  // The best single effect that is not in the set, as a control.
  void compare_with_wrong_cause(const std::vector<Rival>& all, const VectorXd& rows_before) {
    for (const Rival& r : all) {
      if (r.effects.size() != 1 ||
          std::find(result_.set.begin(), result_.set.end(), r.effects.front()) != result_.set.end())
        continue;
      const HeldOut wrong = predict_held_out(discrepancy_, r.explanation->fit, result_.labels);
      result_.gap.wrong_cause = r.effects.front();
      result_.gap.wrong_cause_closed = closed_share(rows_before, wrong.rows, result_.labels, 1).closed;
      break;
    }
  }

  void list_moved_parameters() {
    for (std::size_t f = 0; f < own_.size(); ++f) {
      const auto u = static_cast<Index>(own_[f]);
      const Refit& fit = inference_.null.fit;
      const double sd = std::sqrt(std::max(0.0, fit.covariance(static_cast<Index>(f), static_cast<Index>(f))));
      const double change = fit.unknowns(u) - start_(u);
      if (fit.identifiable[f] && std::abs(change) > 3 * sd)
        result_.parameters_moved.push_back(
            {std::string(model_.symbols[own_[f]].name), start_(u), fit.unknowns(u), sd});
    }
  }

  // Rivals of the best explanation: the others of its set; where it stands alone, the one that comes nearest.
  void propose_experiment(const std::vector<Rival>& all) {
    NextExperiment& next = result_.next_experiment;
    std::vector<Hypothesis> hypotheses;
    std::vector<std::vector<std::string>> taken;
    for (const Rival& r : all) {
      const bool in_set = std::all_of(r.effects.begin(), r.effects.end(), [&](const std::string& effect) {
        return std::find(result_.set.begin(), result_.set.end(), effect) != result_.set.end() ||
               std::find(result_.together.begin(), result_.together.end(), effect) != result_.together.end();
      });
      const bool wanted = hypotheses.empty() || in_set || (result_.set.size() < 2 && hypotheses.size() < 2);
      if (!wanted || std::find(taken.begin(), taken.end(), r.effects) != taken.end()) continue;
      hypotheses.push_back({r.explanation, std::max(r.probability, least_rival)});
      taken.push_back(r.effects);
      if (hypotheses.size() == most_hypotheses) break;
    }
    if (conditions_.empty()) {
      next.reason = "dwells are proposed by changing measured ones, and the campaign has none that has settled";
      return;
    }
    if (hypotheses.size() < 2) {
      next.reason = "nothing competes with the explanation";
      return;
    }
    const ProposedDwell dwell =
        next_experiment(condition_model(), conditions_, hypotheses, inference_.dispersion, options_.threads);
    if (dwell.compared == 0) {
      next.reason = "no steady motion near the measured ones could be predicted under every explanation";
      return;
    }
    for (const std::vector<std::string>& effects : taken)
      next.separates.push_back(fmt::format("{}", fmt::join(effects, " + ")));
    next.dwell = dwell;
    next.proposed = dwell.chance >= worth_a_test && 1 - dwell.probability <= most_doubt * (1 - dwell.before);
    if (!next.proposed)
      next.reason = fmt::format(
          "no dwell between half the lowest and twice the highest level used would part {}: the best has a chance "
          "of {:.0f} % and takes the right one's probability from {:.1f} to {:.1f} %; it takes another kind of "
          "test, for example a second sensor, a calibration of the excitation, or a resonance that was not "
          "measured yet",
          fmt::join(next.separates, ", "), 100 * dwell.chance, 100 * dwell.before, 100 * dwell.probability);
  }

  void fill_gap(const VectorXd& before, const VectorXd& after) {
    GapReport& gap = result_.gap;
    const ClosedShare share = closed_share(before, after, result_.labels, gap.floor);
    gap.before = share.before;
    gap.after = share.after;
    gap.closed = share.closed;
    gap.closed_low = share.low;
    gap.closed_high = share.high;
    gap.metric = metric();
  }

  void collect_causes(const std::vector<Rival>& all, const VectorXd& before) {
    std::map<std::string, std::size_t> places;
    for (const Rival& r : all) {
      for (std::size_t m = 0; m < r.effects.size(); ++m) {
        const bool own = r.explanation->members.empty();
        const Candidate* candidate = own ? nullptr : &candidates_[r.explanation->members[m]];
        const std::string key = r.effects[m] + "\n" + (candidate ? candidate->subject : "");
        const auto [place, fresh] = places.emplace(key, result_.causes.size());
        if (!fresh) {
          result_.causes[place->second].probability += r.probability;
          continue;
        }
        CauseReport cause;
        cause.effect = r.effects[m];
        cause.probability = r.probability;
        if (candidate) {
          cause.subject = candidate->subject;
          const Refit& fit = r.explanation->fit;
          const std::size_t strength = candidate->strengths.front();
          cause.coefficient = fit.unknowns(static_cast<Index>(strength));
          cause.coefficient_name = name_of(strength);
          const auto at =
              static_cast<Index>(std::find(fit.free.begin(), fit.free.end(), strength) - fit.free.begin());
          cause.sd = std::sqrt(std::max(0.0, fit.covariance(at, at) * inference_.dispersion));
        }
        if (r.effects.size() == 1 && result_.causes.size() < 6)
          cause.closed =
              closed_share(before, predict_held_out(discrepancy_, r.explanation->fit, result_.labels).rows,
                           result_.labels, 1)
                  .closed;
        result_.causes.push_back(std::move(cause));
      }
    }
    std::stable_sort(result_.causes.begin(), result_.causes.end(),
                     [](const CauseReport& a, const CauseReport& b) { return a.probability > b.probability; });
  }

  std::string name_of(std::size_t unknown) const {
    return unknown < model_.symbols.size() ? std::string(model_.symbols[unknown].name)
                                           : faults_.names()[unknown - model_.symbols.size()];
  }

  // The gap row by row: what the named effect does to the rows, all else as it is; without a name, what is left.
  VectorXd gap_rows() const {
    const Explanation* best = best_;
    if (result_.verdict != "cause" && result_.verdict != "set") return result_.rows_before;
    if (!best || best->members.empty()) return result_.rows_before - result_.rows_after;
    VectorXd without = best->fit.unknowns;
    for (const std::size_t m : best->members)
      for (const std::size_t u : candidates_[m].strengths) without(static_cast<Index>(u)) = 0;
    return discrepancy_(without) - best->fit.rows;
  }

  // Where the cause says which force is missing, the balances are its own.
  void share_out() {
    const Candidate* named = nullptr;
    if (result_.verdict == "cause" && best_)
      for (const std::size_t m : best_->members)
        if (candidates_[m].effect == result_.cause) named = &candidates_[m];
    const VectorXd rows = gap_rows();
    result_.where = gap_shares(rows, discrepancy_.unmixed(rows), result_.labels, named);
  }

  const Campaign& campaign_;
  const CompiledModel& model_;
  std::vector<std::size_t> own_;
  DiagnosisOptions options_;
  SensorModel sensors_;
  FaultTable faults_;
  VectorXd start_;
  std::vector<Candidate> candidates_;
  std::vector<Condition> conditions_;
  Discrepancy discrepancy_;
  /// With what they leave open fitted; `rank` of that.
  struct GivenNumbers {
    VectorXd unknowns, rows;
    Index rank = 0;
  } given_;
  const SegmentEvidence* segments_ = nullptr;  // of discrepancy_
  std::optional<SegmentEvidence> apart_;       // of the window to check on
  Inference inference_;
  const Explanation* best_ = nullptr;
  Diagnosis result_;
};

}  // namespace

std::string to_string(Judged judged) {
  switch (judged) {
    case Judged::fitted:
      return "fitted parameters";
    case Judged::given:
      return "given numbers";
    case Judged::within_error_bars:
      return "given numbers within their error bars";
  }
  return "";
}

Diagnosis diagnose(const Campaign& campaign, const RecordReader& read, const CompiledModel& model,
                   const std::vector<std::size_t>& own, const std::vector<EquationEffect>& effects,
                   const DiagnosisOptions& options) {
  return Diagnoser(campaign, read, model, own, effects, options).run();
}

}  // namespace secular
