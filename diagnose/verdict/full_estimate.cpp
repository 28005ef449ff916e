#include "diagnose/verdict/full_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "diagnose/inference/directions.hpp"
#include "diagnose/inference/fold_scatter.hpp"
#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/foreign_search.hpp"
#include "diagnose/verdict/one_piece.hpp"
#include "diagnose/verdict/told_disturbances.hpp"
#include "estimator/identification/value_errors.hpp"
#include "input/input_error.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// How many fits there have been, of about how many.
class FitCount {
 public:
  explicit FitCount(SearchProgress progress) : progress_(std::move(progress)) {}

  void expect(std::size_t more) {
    expected_ = done_ + more;
    report(expected_);
  }
  void add() {
    ++done_;
    report(std::max(done_ + 1, expected_));
  }
  void end() const { report(done_); }

 private:
  void report(std::size_t of) const {
    if (progress_) progress_(done_, of);
  }

  SearchProgress progress_;
  std::size_t done_ = 0, expected_ = 0;
};

/// Of a campaign that the model fits: from a start that is near, and once more with decays in one piece.
constexpr std::size_t usual_fits = 12, usual_fits_in_one_piece = 3;

// A fit from one start.
struct Attempt {
  FittedAlone fitted;
  DiagnosisOptions options;
  ForeignContent foreign;
  RowsLeft left;
  std::size_t symbols = 0;                  // of the model, which come first among the unknowns
  std::optional<PartsOfDecays> parts = {};  // of decays in one piece
  // Where nothing that was measured depends on any number of the model, there is no place to come to an end at.
  bool has_converged() const {
    const Refit& fit = fitted.inference.null.fit;
    std::size_t fitted_symbols = 0, seen = 0;
    for (std::size_t i = 0; i < fit.free.size(); ++i)
      if (fit.free[i] < symbols) {
        ++fitted_symbols;
        if (fit.identifiable[i]) ++seen;
      }
    return fit.ending == SolverEnding::converged && (fitted_symbols == 0 || seen > 0);
  }
  bool suffices() const { return has_converged() && !is_more_than_noise(left); }
};

Attempt attempt(const CampaignAndModel& sides, DiagnosisOptions options, const std::map<std::string, double>& start,
                const std::vector<Disturbance>& found, FitCount& count) {
  count.expect(usual_fits);
  ForeignContent foreign{found, {}, {}};
  for (const auto& [name, value] : start) options.start.emplace(name, value);
  allow_for(foreign, sides.campaign, options);
  FittedAlone fitted = fitted_alone(sides, options);
  const ModelAlone left = left_by(fitted, sides, options);
  if (is_more_than_noise(left.left)) {
    std::optional<FittedAlone> beside;
    const auto fit_beside = [&] {
      count.expect(usual_fits);
      beside = fitted_alone(sides, options);
      return left_by(*beside, sides, options);
    };
    if (holds_beside_foreign_content(left, fit_beside, sides.campaign, foreign, options))
      fitted = std::move(*beside);
  }
  Attempt at_rest{std::move(fitted), std::move(options), std::move(foreign), {}, sides.model.symbols.size()};
  at_rest.left = bring_to_rest(at_rest.fitted, at_rest.options);
  return at_rest;
}

bool is_better(const Attempt& one, const Attempt& other) {
  if (one.has_converged() != other.has_converged()) return one.has_converged();
  return one.left.chi_squared < other.left.chi_squared;
}

Attempt best_attempt(const CampaignAndModel& sides, const DiagnosisOptions& options,
                     const std::vector<std::map<std::string, double>>& starts,
                     const std::vector<Disturbance>& found, FitCount& count) {
  std::optional<Attempt> best;
  std::optional<InputError> refused;  // a start that says too little; another one may say it
  for (const auto& start : starts) {
    try {
      Attempt next = attempt(sides, options, start, found, count);
      if (!best || is_better(next, *best)) best = std::move(next);
    } catch (const InputError& error) {
      refused = error;
    }
    if (best && best->suffices()) break;
  }
  if (!best) throw *refused;
  return std::move(*best);
}

// Why decays are not fitted in one piece; empty: nothing speaks against it.
std::string against_one_piece(const Attempt& segments) {
  if (!segments.has_converged()) return "the fit by the full equations did not come to an end";
  return against_one_piece(segments.options);
}

// From a fit in which segments of decays have states of their own, the same with one state a decay
// (docs/inference.md, decays in one piece).
std::optional<Attempt> in_one_piece(const Attempt& segments, const CampaignAndModel& sides, FitCount& count) {
  if (!against_one_piece(segments).empty() || !compares_decays(segments.fitted.comparison, sides.campaign))
    return {};
  count.expect(usual_fits_in_one_piece);
  DiagnosisOptions options = segments.options;
  options.whole_decays = true;
  InOnePiece fit = model_in_one_piece(sides, options, segments.fitted.inference, segments.fitted.late);
  Attempt whole{std::move(fit.fitted), std::move(options), segments.foreign, fit.left, sides.model.symbols.size()};
  if (whole.has_converged()) whole.parts = std::move(fit.parts);
  return whole;
}

// What a lack of fit as large as the one that is seen may do to each free unknown (docs/inference.md (46)).
VectorXd hidden_in(const Refit& fit, const RowsLeft& left) {
  const double beyond = std::sqrt(std::max(0.0, left.chi_squared - left.freedom));
  return beyond * fit.covariance.diagonal().cwiseMax(0).cwiseSqrt();
}

// By free unknown, what a law that hardly shows may have moved it by (docs/inference.md (76)).
VectorXd moved_by_laws(const Attempt& attempt) {
  const auto count = static_cast<Index>(attempt.fitted.inference.null.fit.free.size());
  if (!attempt.parts || attempt.parts->laws.moved.size() != count) return VectorXd::Zero(count);
  return attempt.parts->laws.moved;
}

// The same of what parts of decays differ by (docs/inference.md (67)).
VectorXd hidden_by_parts(const Attempt& whole) {
  const PartsAgreement& worse = whole.parts->worse();
  const RowsLeft left{worse.chi_squared, worse.freedom};
  return hidden_in(whole.fitted.inference.null.fit, left).cwiseMax(2 * moved_by_laws(whole));
}

VectorXd by_symbol(const Attempt& whole, std::size_t symbols) {
  const std::vector<std::size_t>& free = whole.fitted.inference.null.fit.free;
  const VectorXd hidden = hidden_by_parts(whole);
  VectorXd all = VectorXd::Zero(static_cast<Index>(symbols));
  for (std::size_t f = 0; f < free.size(); ++f)
    if (free[f] < symbols) all(static_cast<Index>(free[f])) = hidden(static_cast<Index>(f));
  return all;
}

// Symbols that cannot be told apart, a list for each direction that the rows do not see; first those that move no
// row at all, each by itself.
std::vector<std::vector<std::string>> not_told_apart(const Refit& fit, const std::vector<std::string>& names) {
  std::vector<std::vector<std::string>> open;
  std::vector<Index> moving;
  for (std::size_t f = 0; f < fit.free.size(); ++f)
    if (fit.jacobian.col(static_cast<Index>(f)).isZero(0))
      open.push_back({names[fit.free[f]]});
    else
      moving.push_back(static_cast<Index>(f));
  if (moving.empty()) return open;
  const Directions directions(fit.jacobian(Eigen::all, moving));
  for (Index d = directions.rank(); d < directions.of_unknowns().cols(); ++d) {
    std::vector<std::string> together;
    for (std::size_t m = 0; m < moving.size(); ++m)
      if (std::abs(directions.of_unknowns()(static_cast<Index>(m), d)) > least_part_of_direction)
        together.push_back(names[fit.free[static_cast<std::size_t>(moving[m])]]);
    open.push_back(std::move(together));
  }
  return open;
}

std::string text_of_direction(const std::vector<std::string>& together) {
  return together.size() == 1 ? together.front() + ": moves nothing that was measured"
                              : fmt::format("{}: only together", fmt::join(together, ", "));
}

// Of the noise that rows are measured by, where a record's spectrum tells it: a fourth of its samples
// (docs/inference.md (46)).
double noise_freedom(const RowsLeft& left) {
  return std::max(1.0, 0.25 * left.freedom);
}

// Whether what is left is more than noise, whose own size is known from as many values as noise_freedom() says.
DetectedGap gap_of(const Attempt& best) {
  DetectedGap gap = detect_gap(best.left, best.fitted.inference, {}, 1, {});
  const double freedom = std::max(1.0, best.left.freedom);
  gap.p_value = f_upper_tail(best.left.chi_squared / freedom, freedom, noise_freedom(best.left));
  gap.detected = gap.p_value < diagnose_thresholds().gap_alarm;
  return gap;
}

// What is left of the rows that a model is judged by, and whether that is more than noise.
struct JudgedRows {
  RowsLeft left;
  DetectedGap gap;
  std::optional<PartsOfDecays> parts;
};

double misfit_of(const RowsLeft& left) {
  return left.chi_squared / std::max(1.0, left.freedom);
}

// Whether one state a decay does as well as a state for each segment of it.
bool does_as_well(const Attempt& whole, const Attempt& segments) {
  return whole.has_converged() && (!gap_of(whole).detected || (gap_of(segments).detected &&
                                                               misfit_of(whole.left) <= misfit_of(segments.left)));
}

// All rows as one equation.
LackOfFit lack_of_all_rows(const JudgedRows& judged, std::size_t conditions) {
  const RowsLeft& left = judged.left;
  const DetectedGap& gap = judged.gap;
  LackOfFit test;
  test.name = "full equations of motion, all records";
  test.conditions = conditions;
  test.f = left.chi_squared / std::max(1.0, left.freedom);
  test.misfit_ratio = std::sqrt(test.f);
  test.scatter_ratio = 1;
  test.beyond = left.chi_squared - left.freedom;
  test.numerator_df = left.freedom;
  test.denominator_df = noise_freedom(left);
  test.p_value = gap.p_value;
  test.significant = gap.detected;
  return test;
}

std::vector<std::string> warnings_of(const Attempt& best, const JudgedRows& judged, std::size_t stretches,
                                     const Campaign& campaign) {
  std::vector<std::string> warnings;
  const DetectedGap& gap = judged.gap;
  const double ratio = std::sqrt(misfit_of(judged.left));
  if (best.fitted.inference.null.fit.ending == SolverEnding::converged && !best.has_converged())
    warnings.push_back(
        "nothing that was measured depends on the model's numbers where the fit ended: there are none (do the "
        "records hold a motion that the excitation makes?)");
  else if (!best.has_converged())
    warnings.push_back(
        "the fit by the full equations did not come to an end: there are no numbers (rough values of the model's "
        "parameters under [nominal], or dwells and free decays in the same campaign, are a better start)");
  if (gap.detected && best.has_converged())
    warnings.push_back(fmt::format(
        "the model does not hold: with the numbers that fit best the full equations leave {:.3g} times what the "
        "measurement repeats to (p = {:.2g}); error bars allow for a misfit as large that the numbers have taken "
        "up, and where that dominates a number is doubtful. `secular diagnose` looks for what is missing",
        ratio, gap.p_value));
  if (judged.parts && judged.parts->differ()) warnings.push_back(warning_of(*judged.parts));
  if (stretches == 1)
    warnings.push_back(
        "all numbers rest on one stretch of one record: how far they differ from stretch to stretch is in no error "
        "bar");
  if (gap.noise_misjudged)
    warnings.push_back(fmt::format(
        "noise is misjudged: the full equations leave {:.2g} times what the measurement is said to repeat to",
        ratio));
  const Comparison& comparison = best.fitted.comparison;
  warnings.insert(warnings.end(), comparison.warnings.begin(), comparison.warnings.end());
  for (std::string& warning : disturbed_records(comparison, campaign)) warnings.push_back(std::move(warning));
  return warnings;
}

std::string reason_of_segments(const Attempt& whole) {
  return whole.has_converged() ? fmt::format("the model leaves {:.3g} times what the measurement repeats to",
                                             std::sqrt(misfit_of(whole.left)))
                               : "the fit did not come to an end";
}

std::string why_segments_stay(const Attempt& whole) {
  return "free decays are compared in segments with a state each: in one piece " + reason_of_segments(whole) +
         "; error bars are larger than those of a model that holds all along a decay";
}

// Relative standard deviation of what only blows tell of a symbol by which an excitation acts: what is between
// their samples is not known, and may be alike in all (docs/inference.md (42)). 0 where another record is driven,
// too.
double blows_are_open_to(const Attempt& best, const CampaignAndModel& sides) {
  const BetweenSamples& blows = best.fitted.comparison.of_records.of_blows;
  if (!best.fitted.comparison.conditions.empty()) return 0;
  for (const RowLabel& label : best.fitted.comparison.discrepancy.labels()) {
    const RecordKind kind = sides.campaign.records[label.record].kind;
    if (kind == RecordKind::sweep || kind == RecordKind::broadband) return 0;
  }
  return blows.share;
}

bool acts_by_an_excitation(const CompiledModel& model, std::size_t symbol) {
  const auto dimension = model.symbols[symbol].dimension;
  for (std::size_t e = 0; e < model.excitations.size() && !dimension.empty(); ++e)
    if (dimension[model.modes() + e].numerator != 0) return true;
  return false;
}

// Parameters of the model's symbols with their covariance.
void take_parameters(Estimate& estimate, const Attempt& best, const CampaignAndModel& sides,
                     const JudgedRows& judged) {
  const Refit& fit = best.fitted.inference.null.fit;
  const Discrepancy& discrepancy = best.fitted.comparison.discrepancy;
  const auto symbols = static_cast<Index>(sides.model.symbols.size());
  const SymbolUnits units(sides.campaign, sides.model);
  const MatrixXd covariance = covariance_of(fit, discrepancy.labels(), static_cast<double>(discrepancy.freedom()),
                                            best.parts ? best.parts->dispersion() : 1);
  VectorXd hidden = VectorXd::Zero(static_cast<Index>(fit.free.size()));
  if (judged.gap.detected) hidden = hidden_in(fit, judged.left);
  const bool differ = best.parts && best.parts->differ();
  if (differ) hidden = hidden.cwiseMax(hidden_by_parts(best));
  const VectorXd moved = differ ? VectorXd::Zero(hidden.size()).eval() : moved_by_laws(best);
  const double open_share = blows_are_open_to(best, sides);
  estimate.covariance = MatrixXd::Zero(symbols, symbols);
  estimate.parameter_values = VectorXd::Constant(symbols, NAN);
  if (best.has_converged()) estimate.parameter_values = fit.unknowns.head(symbols);
  std::vector<Index> place(static_cast<std::size_t>(symbols), -1);
  for (std::size_t f = 0; f < fit.free.size(); ++f)
    if (fit.free[f] < place.size()) place[fit.free[f]] = static_cast<Index>(f);
  for (std::size_t s = 0; s < place.size(); ++s) {
    EstimatedValue value;
    value.name = sides.model.symbols[s].name;
    value.unit = units.of(s);
    value.from = "full equations of motion";
    const Index at = place[s];
    if (at < 0) {
      value.fixed = value.identifiable = true;
      value.value = fit.unknowns(static_cast<Index>(s));
      estimate.parameter_values(static_cast<Index>(s)) = *value.value;
    } else if (best.has_converged() && fit.identifiable[static_cast<std::size_t>(at)]) {
      value.identifiable = true;
      value.value = fit.unknowns(static_cast<Index>(s));
      value.noise_sd = std::sqrt(std::max(0.0, covariance(at, at)));
      if (acts_by_an_excitation(sides.model, s)) value.open_sd = open_share * std::abs(*value.value);
      value.sd = std::hypot(value.noise_sd, value.open_sd, moved(at));
      value.degrees_of_freedom = best.left.freedom;
      add_misfit(value, hidden(at));
      value.significant = is_significant(value);
    }
    estimate.parameters.push_back(std::move(value));
  }
  for (std::size_t s = 0; s < place.size(); ++s)
    for (std::size_t t = 0; t < place.size(); ++t)
      if (place[s] >= 0 && place[t] >= 0 && estimate.parameters[s].value && estimate.parameters[t].value)
        estimate.covariance(static_cast<Index>(s), static_cast<Index>(t)) = covariance(place[s], place[t]);
}

void take_directions(Estimate& estimate, const Attempt& best, const CompiledModel& model) {
  const std::vector<std::string> names = best.fitted.comparison.unknown_names(model);
  for (const std::vector<std::string>& together : not_told_apart(best.fitted.inference.null.fit, names)) {
    for (EstimatedValue& value : estimate.parameters) {
      if (std::find(together.begin(), together.end(), value.name) == together.end()) continue;
      for (const std::string& other : together)
        if (other != value.name && std::find(value.entangled_with.begin(), value.entangled_with.end(), other) ==
                                       value.entangled_with.end())
          value.entangled_with.push_back(other);
    }
    estimate.null_directions.push_back({together, text_of_direction(together), {}});
  }
}

// The parts of a segment between samples that do not count; `reading`: of its samples.
void add_stretches(ComparedRecord& to, const Segment& computed, std::span<const double> reading, double& largest) {
  const Index samples = computed.response.cols();
  const double begin = computed.in_record_s - 0.5 * static_cast<double>(samples) * computed.sample_s;
  auto skipped = computed.uncompared.begin();
  bool open = false;
  const std::size_t before = to.stretches.size();
  for (Index i = 0; i < samples; ++i) {
    if (skipped != computed.uncompared.end() && *skipped == i) {
      ++skipped;
      open = false;
      continue;
    }
    if (!open) to.stretches.push_back({begin + static_cast<double>(i) * computed.sample_s, {}, {}});
    open = true;
    to.stretches.back().measured.push_back(reading[static_cast<std::size_t>(i)]);
    to.stretches.back().computed.push_back(computed.response(0, i));
  }
  for (std::size_t s = before; s < to.stretches.size(); ++s) {
    const std::vector<double>& made = to.stretches[s].computed;
    const double size = std::inner_product(made.begin(), made.end(), made.begin(), 0.0);
    if (size <= largest) continue;
    largest = size;
    to.loudest = s;
  }
}

// Of each record its first response.
std::vector<ComparedRecord> compared_in_time(const Attempt& best, const CompiledModel& model,
                                             const std::set<std::size_t>& records) {
  std::vector<ComparedRecord> all;
  const Comparison& comparison = best.fitted.comparison;
  if (!comparison.segment_evidence) return all;
  const VectorXd& unknowns = best.fitted.inference.null.fit.unknowns;
  for (const SegmentEvidence::Left& left : comparison.segment_evidence->left(unknowns)) {
    if (left.channel != comparison.sensors.responses.front() || !records.contains(left.record)) continue;
    ComparedRecord one{left.record, left.channel, left.sample_s, {}, 0, 0};
    std::span<const double> reading = left.reading;
    double largest = -1;
    for (const Segment& computed : comparison.segment_evidence->predicted(left.record, unknowns, 1)) {
      add_stretches(one, computed, reading, largest);
      reading = reading.subspan(static_cast<std::size_t>(computed.response.cols()));
      one.fitted += 2 * model.modes();
    }
    if (!one.stretches.empty()) all.push_back(std::move(one));
  }
  return all;
}

// The disturbances of a diagnosis that says what this fit does.
std::vector<Disturbance> disturbances_of(const Attempt& best, const CampaignAndModel& sides) {
  const Comparison& comparison = best.fitted.comparison;
  const Refit& fit = best.fitted.inference.null.fit;
  Diagnosis told;
  told.spans = comparison.spans;
  if (best.has_converged())
    told.fitted = fitted_numbers(
        fit, {}, comparison.unknown_names(sides.model),
        covariance_of(fit, comparison.discrepancy.labels(), static_cast<double>(comparison.discrepancy.freedom())),
        sides.campaign, sides.model);
  return told_disturbances(best.foreign.found, told, best.options, sides.campaign, sides.model);
}

}  // namespace

FullEstimate estimate_by_full_equations(const CampaignAndModel& sides, const DiagnosisOptions& options,
                                        const std::vector<std::map<std::string, double>>& starts,
                                        std::vector<Disturbance> found, const SearchProgress& progress) {
  FitCount count(progress);
  DiagnosisOptions counted = options;
  counted.after_own_fit = [&] { count.add(); };
  Attempt best = best_attempt(sides, counted, starts, found, count);
  std::optional<Attempt> whole = in_one_piece(best, sides, count);
  count.end();
  const bool keeps_segments = whole && !does_as_well(*whole, best);
  if (whole && !keeps_segments) best = std::move(*whole);
  const Comparison& comparison = best.fitted.comparison;
  JudgedRows judged{best.left, gap_of(best), best.parts};
  // States of their own take up what a missing law makes along a decay: that is seen in one piece.
  if (keeps_segments && whole->has_converged()) judged = {whole->left, gap_of(*whole), whole->parts};
  FullEstimate result;
  result.has_converged = best.has_converged();
  result.alarm = diagnose_thresholds().gap_alarm;
  result.noise_misjudged = judged.gap.noise_misjudged;
  result.conditions = comparison.conditions.size() + comparison.segments;
  result.data_used = comparison.data_used;
  result.labels = comparison.discrepancy.labels();
  result.rows = best.fitted.inference.null.fit.rows;
  for (const RowLabel& label : result.labels) result.records.insert(label.record);
  result.compared = compared_in_time(best, sides.model, result.records);
  result.disturbances = disturbances_of(best, sides);
  take_parameters(result.estimate, best, sides, judged);
  if (result.has_converged) take_directions(result.estimate, best, sides.model);
  // Where a fit has not come to an end, what it leaves says nothing of the model.
  if (result.has_converged) result.estimate.lack_of_fit = {{"", {lack_of_all_rows(judged, result.conditions)}}};
  if (result.has_converged && judged.parts) {
    result.parts = lack_of_parts(*judged.parts, comparison.segments);
    result.estimate.lack_of_fit.front().equations.push_back(*result.parts);
    if (judged.parts->differ() && !judged.parts->only_records_differ())
      result.hidden_by_parts = by_symbol(keeps_segments ? *whole : best, sides.model.symbols.size());
  }
  result.estimate.warnings = warnings_of(best, judged, result.conditions, sides.campaign);
  if (keeps_segments) result.estimate.warnings.push_back(why_segments_stay(*whole));
  result.against_one_piece = keeps_segments ? reason_of_segments(*whole) : whole ? "" : against_one_piece(best);
  return result;
}

}  // namespace secular
