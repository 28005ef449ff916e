#include "diagnose/verdict/step_by_step.hpp"

#include <cstddef>
#include <set>
#include <utility>

#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/allowances.hpp"
#include "diagnose/verdict/answer.hpp"
#include "diagnose/verdict/foreign_search.hpp"
#include "diagnose/verdict/gap_detection.hpp"
#include "diagnose/verdict/given_numbers.hpp"
#include "diagnose/verdict/left_content.hpp"
#include "diagnose/verdict/one_piece.hpp"
#include "diagnose/verdict/told_disturbances.hpp"

namespace secular {
namespace {

class StepByStep {
 public:
  StepByStep(const CampaignAndModel& sides, const std::vector<EquationEffect>& effects, DiagnosisOptions options,
             std::vector<Disturbance> found)
      : sides_(sides), effects_(effects), options_(std::move(options)), foreign_{std::move(found), {}, {}} {
    allow_for(foreign_, sides_.campaign, options_);
  }

  // What a missing term leaves may look like foreign content: what is found in the rest counts where nothing is
  // left beside it.
  StepwiseDiagnosis run(const EstimatedParameters& identified) {
    StepwiseDiagnosis result;
    const ModelAlone plain = alone({});
    std::vector<Allowance> all{{}};
    if (is_more_than_noise(plain.left) && !holds_beside(plain)) {
      DecayScatter of_decays;
      if (identified) of_decays = find_decay_scatter(identified);
      result.decays_warning = std::move(of_decays.warning);
      Allowances found = find_allowances(
          sides_, plain, of_decays.frequency_sd,
          [&](const Allowance& allowance, std::optional<double> late_s) { return alone(allowance, late_s); });
      scatter_alone_ = std::move(found.scatter_alone);
      all = std::move(found.all);
    }
    // What follows a blow says nothing of effects on what drives it: those are tried before.
    if (has_blows(sides_, options_)) all.push_back({.turn = Allowance::blows, .blows_as_decays = true});
    try_all(in_turn(std::move(all)));
    try_in_one_piece();
    result.diagnosis = std::move(*best_).finish();
    result.disturbances =
        told_disturbances(std::move(foreign_.found), result.diagnosis, options_, sides_.campaign, sides_.model);
    if (blows_) take_blows(result);
    return result;
  }

 private:
  void allow(const Allowance& allowance) {
    options_.late = allowance.late;
    options_.frequency_scatter = allowance.frequency_scatter;
    options_.blows_as_decays = allowance.blows_as_decays;
  }

  OpenDiagnosis diagnosed(const Allowance& allowance) {
    allow(allowance);
    return OpenDiagnosis(sides_, effects_, options_);
  }

  ModelAlone alone(const Allowance& allowance, std::optional<double> common_late_s = {}) {
    allow(allowance);
    return fit_alone(sides_, options_, common_late_s);
  }

  bool holds_beside(const ModelAlone& plain) {
    return holds_beside_foreign_content(
        plain, [&] { return alone({}); }, sides_.campaign, foreign_, options_);
  }

  void try_all(const std::vector<Allowance>& allowances) {
    bool is_answered = false;
    for (const Allowance& allowance : allowances) {
      if (!allowance.blows_as_decays) is_answered = is_answered || tells(allowance);
      // What leaves noise alone and yet tells no cause may follow blows that do not say how strong they are.
      else if (how_much(best_->so_far()) < Accounted::all)
        is_answered = blows_do_not_fit(allowance) || is_answered;
    }
  }

  // States of segments' own take up most of what a damping does along a decay. A cause, or what closes nearly all,
  // needs no more; a campaign without a gap is asked by the model as it is. Rows of few turns are where fits begin:
  // among many turns there are minima a whole turn off.
  void try_in_one_piece() {
    const Diagnosis& segments = best_->so_far();
    const bool is_known = segments.verdict == "cause" || segments.verdict == "approximate" ||
                          how_much(segments) == Accounted::doubtful || blows_;
    if (is_known || sides_.model.modes() > 1 || !best_->holds_decays() || !against_one_piece(options_).empty()) return;
    allow(best_allowance_);
    DiagnosisOptions options = options_;
    options.whole_decays = true;
    options.knows_without_scatter = false;
    options.forces = best_->forces();
    options.keeps_scales = true;
    if (!segments.gap.detected && !model_in_one_piece(sides_, options, best_->inference(), false).misses()) return;
    OpenDiagnosis whole(sides_, effects_, options, &best_->inference());
    if (outranks_segments(whole.so_far(), segments, options_.catalogue)) best_ = std::move(whole);
  }

  // A law is told where it is likelier than frequencies that scatter about the model as it is, also where too few
  // records tell whether these follow the settings.
  bool may_be_scatter(const OpenDiagnosis& plain, bool blows_as_decays) {
    const std::string& verdict = plain.so_far().verdict;
    if (scatter_alone_.size() == 0 || verdict == "no_gap" || verdict == "unknown") return false;
    return plain.has_as_credible(alone({.frequency_scatter = scatter_alone_, .blows_as_decays = blows_as_decays}));
  }

  void doubt_what_may_be_of_records(OpenDiagnosis& fresh, bool may_scatter, bool blows_as_decays) {
    if (const std::string why = doubt_of_own(fresh.so_far()); !why.empty()) fresh.make_unknown(why);
    if (may_scatter && may_be_scatter(fresh, blows_as_decays))
      fresh.make_unknown(
          "natural frequencies that differ from record to record make as much of it; too few records tell which");
  }

  // Keeps what accounts for most of the gap, of two that do as much the one that leaves less, or needs nothing of
  // the records' own to leave noise alone. Whether that is the answer: it accounts for all of the gap, or needs
  // nothing of their own.
  bool tells(const Allowance& allowance) {
    const bool is_known = known_without_scatter_.contains(allowance.late);
    if (is_known && allowance.frequency_scatter.size() == 0) return false;
    options_.knows_without_scatter = is_known;
    OpenDiagnosis fresh = diagnosed(allowance);
    const bool is_without_scatter = !fresh.admits_scatter(), is_plain = is_without_scatter && !allowance.late;
    if (is_without_scatter) known_without_scatter_.insert(allowance.late);
    doubt_what_may_be_of_records(fresh, is_plain, false);
    const bool suffices = is_plain && fresh.leaves_noise_alone();
    if (!best_ || accounts_for_more(fresh.so_far(), best_->so_far()) ||
        (suffices && how_much(fresh.so_far()) >= how_much(best_->so_far()))) {
      best_ = std::move(fresh);
      best_allowance_ = allowance;
    }
    return suffices || how_much(best_->so_far()) == Accounted::all;
  }

  // Keeps what follows the blows where it accounts for all of the gap and the blows themselves do not fit. Rows of
  // these are gone: less that is left of the others is no better answer by itself.
  bool blows_do_not_fit(const Allowance& allowance) {
    options_.knows_without_scatter = false;
    OpenDiagnosis fresh = diagnosed(allowance);
    doubt_what_may_be_of_records(fresh, true, true);
    if (how_much(fresh.so_far()) != Accounted::all) return false;
    blows_ = fit_blows_alone(sides_, options_, {fresh.fit(), fresh.forces()});
    if (blows_->do_not_fit())
      best_ = std::move(fresh);
    else
      blows_.reset();
    return blows_.has_value();
  }

  void take_blows(StepwiseDiagnosis& result) {
    result.blows_warning =
        "blows do not do what their excitation says, or an effect of the excitation acts that is not found: they "
        "are compared from where the structure swings freely on, and numbers by which excitations act are missing "
        "where no other record tells them";
    for (Disturbance& d : blow_mismatches(*blows_, result.diagnosis, sides_.model))
      result.disturbances.push_back(std::move(d));
    result.blows = std::move(blows_);
  }

  const CampaignAndModel& sides_;
  const std::vector<EquationEffect>& effects_;
  DiagnosisOptions options_;
  ForeignContent foreign_;
  Eigen::VectorXd scatter_alone_;         // of frequencies about the model as it is
  std::set<bool> known_without_scatter_;  // late or not: what a diagnosis says whose frequencies are all the same
  std::optional<OpenDiagnosis> best_;
  Allowance best_allowance_;  // beside which it was found
  std::optional<BlowsAlone> blows_;
};

}  // namespace

StepwiseDiagnosis diagnose_step_by_step(const CampaignAndModel& sides, const std::vector<EquationEffect>& effects,
                                        DiagnosisOptions options, std::vector<Disturbance> found,
                                        const EstimatedParameters& identified) {
  const bool rough = are_rough_frequencies(options.given, sides.model, sides.own);
  if (rough) options.given = {};
  StepwiseDiagnosis result = StepByStep(sides, effects, std::move(options), std::move(found)).run(identified);
  result.numbers_were_a_start = rough;
  return result;
}

}  // namespace secular
