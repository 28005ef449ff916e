#include "app/diagnose/diagnosis_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include "app/diagnose/decay_scatter.hpp"
#include "app/diagnose/left_content.hpp"
#include "app/shared/model_loading.hpp"
#include "app/shared/number_file.hpp"
#include "app/shared/parameter_file.hpp"
#include "app/shared/record_assignment.hpp"
#include "app/shared/record_selection.hpp"
#include "diagnose/verdict/blows_alone.hpp"
#include "diagnose/verdict/model_alone.hpp"
#include "input/input_error.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "measure/disturbances/disturbance_watch.hpp"
#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/hertz.hpp"
#include "numerics/median.hpp"

namespace secular::app {
namespace {

// Of others the diagnosis has descriptions of its own: they are not terms that a line of a steady motion sees.
bool is_seen_by_lines(const EffectTerm& term, const EffectCatalogue& catalogue) {
  const Effect& effect = *catalogue.find(term.effect);
  return effect.kind == Effect::Kind::term && !effect.is_of_time();
}

std::string subject_of(const EffectTerm& term, const CompiledModel& model) {
  std::string subject(model.coordinates[term.mode]);
  if (term.other != EffectTerm::none) subject += ", " + std::string(model.coordinates[term.other]);
  return subject;
}

std::size_t symbol_index(const CompiledModel& model, const std::string& name) {
  const auto found = std::find_if(model.symbols.begin(), model.symbols.end(),
                                  [&](const CompiledSymbol& symbol) { return symbol.name == name; });
  return static_cast<std::size_t>(found - model.symbols.begin());
}

// Numbers that say where the modes are and nothing else, of a model that has further parameters: no numbers whose
// gap could be judged.
bool only_rough_frequencies(const GivenNumbers& given, const ModelSource& source, const CompiledModel& model,
                            const std::vector<std::size_t>& own) {
  const std::vector<std::string>& frequencies = source.frequency_names();
  const auto is_frequency = [&](const std::string& name) {
    return std::find(frequencies.begin(), frequencies.end(), name) != frequencies.end();
  };
  if (!given || !std::all_of(given.values.begin(), given.values.end(),
                             [&](const auto& value) { return is_frequency(value.first); }))
    return false;
  return std::any_of(own.begin(), own.end(), [&](std::size_t s) {
    return !given.values.contains(std::string(model.symbols[s].name)) && !std::isfinite(model.nominal[s]);
  });
}

// The place of a response's offset among the numbers of the fit; nothing where it is none of them.
std::optional<Eigen::Index> fitted_offset(const Channel& channel, const Diagnosis& diagnosis) {
  const std::vector<std::string>& names = diagnosis.fitted.names;
  const auto found = std::find(names.begin(), names.end(), "offset(" + channel.name + ")");
  if (channel.role != ChannelRole::response || found == names.end()) return std::nullopt;
  return found - names.begin();
}

// Whether the fit allows for something that was found in the records.
bool is_fitted(const Disturbance& d, const DiagnosisRun& run, const DiagnosisOptions& options) {
  if (!d.channel) return false;
  const Channel& channel = run.campaign.channels[*d.channel];
  if (d.kind == tone_kind) {
    const auto tones = options.tones.find(d.record);
    return tones != options.tones.end() &&
           std::any_of(tones->second.begin(), tones->second.end(), [&](const auto& t) {
             return t.channel == *d.channel && t.rate == 0 && t.frequency == two_pi * *d.frequency_hz;
           });
  }
  if (d.kind == wander_kind) return channel.role == ChannelRole::response && options.wandering.contains(*d.channel);
  if (d.kind == "offset" && options.wandering.contains(*d.channel)) return true;
  return d.kind == "offset" && fitted_offset(channel, run.diagnosis).has_value();
}

// Something that the fit tells of a record, within the window.
Disturbance fitted_in(std::size_t record, std::string_view kind, const Diagnosis& diagnosis) {
  Disturbance d;
  d.kind = kind;
  d.record = record;
  d.treated = "fitted";
  if (const auto span = diagnosis.spans.find(record); span != diagnosis.spans.end()) {
    d.from_s = span->second.from_s;
    d.to_s = span->second.to_s;
  }
  return d;
}

// Offsets of responses that the fit tells and the records alone do not, at the level of all disturbances.
std::vector<Disturbance> fitted_offsets(const Diagnosis& diagnosis, const Campaign& campaign,
                                        const std::vector<Disturbance>& found) {
  std::vector<Disturbance> offsets;
  for (std::size_t c = 0; c < campaign.channels.size(); ++c) {
    const Channel& channel = campaign.channels[c];
    const bool known = std::any_of(found.begin(), found.end(),
                                   [&](const Disturbance& d) { return d.kind == "offset" && d.channel == c; });
    const std::optional<Eigen::Index> place = fitted_offset(channel, diagnosis);
    if (known || !place) continue;
    const double value = diagnosis.fitted.values(*place),
                 sd = std::sqrt(diagnosis.fitted.covariance(*place, *place));
    const double level =
        measure_thresholds().disturbance_false_alarm / static_cast<double>(campaign.channels.size());
    if (!(sd > 0) || 2 * normal_upper_tail(std::abs(value) / sd) > level) continue;
    Disturbance d = fitted_in(diagnosis.spans.empty() ? 0 : diagnosis.spans.begin()->first, "offset", diagnosis);
    d.channel = c;
    d.size = std::abs(value);
    d.unit = channel.unit;
    d.text = fmt::format("reads {:.3g} {} (sd {:.1g}) at rest, the same in all records", value, channel.unit, sd);
    offsets.push_back(std::move(d));
  }
  return offsets;
}

// By how much records are late, where phases of their own made the equations hold.
std::vector<Disturbance> late_records(const Diagnosis& diagnosis) {
  std::vector<Disturbance> found;
  for (const OwnLateness& own : diagnosis.late.records) {
    Disturbance d = fitted_in(own.record, "late_record", diagnosis);
    d.size = own.late_s;
    d.unit = "s";
    d.share = std::abs(own.late_s) / own.period_s;
    d.text = fmt::format(
        "responses are {:.3g} ms {} their excitation, up to whole periods of {:.3g} ms (half ones, if the force "
        "has the other sign)",
        1e3 * std::abs(own.late_s), own.late_s < 0 ? "ahead of" : "behind", 1e3 * own.period_s);
    found.push_back(std::move(d));
  }
  return found;
}

// By how much natural frequencies of each record's own depart from their mean.
std::vector<Disturbance> own_frequencies(const Diagnosis& diagnosis, const CompiledModel& model) {
  std::vector<Disturbance> found;
  const FrequencyScatter& scatter = diagnosis.frequency_scatter;
  for (const OwnFrequency& own : scatter.records) {
    Disturbance d = fitted_in(own.record, "record_scatter", diagnosis);
    d.size = own.shift;
    d.share = std::abs(own.shift);
    d.text = fmt::format("{} is {:.2g} % {} the mean (sd {:.1g} %); records differ by {:.2g} % (sd)",
                         model.symbols[own.mode].name, 100 * std::abs(own.shift), own.shift < 0 ? "below" : "above",
                         100 * std::sqrt(own.variance), 100 * scatter.sd(static_cast<Eigen::Index>(own.mode)));
    found.push_back(std::move(d));
  }
  return found;
}

// Blows that do not do what their excitation says: only what follows them counts.
std::vector<Disturbance> mismatches(const BlowsAlone& blows, const Diagnosis& diagnosis,
                                    const CompiledModel& model) {
  const BlowStrengths* strengths = blows.most_different();
  std::vector<Disturbance> found;
  for (const std::size_t record : blows.records) {
    Disturbance d = fitted_in(record, "blow_mismatch", diagnosis);
    d.treated = "left_out";
    const std::string left = fmt::format(
        "blows, each at its own strength, leave {:.3g} times the noise, and what they do between their "
        "samples is open to {:.2g} %; what drives them does not count, what follows them does",
        std::sqrt(blows.left.chi_squared / std::max(1.0, blows.left.freedom)), 100 * blows.between_samples);
    d.text = left;
    if (const BlowStrength* own = strengths ? strengths->of(record) : nullptr; own && strengths->mean != 0) {
      const double mean = std::abs(strengths->mean);
      d.size = own->value / strengths->mean - 1;
      d.share = std::abs(d.size);
      d.text = fmt::format(
          "its excitation acts {:.2g} % {} the mean of all blows (sd {:.1g} %): {} would be {:.5g}; blows differ "
          "by {:.2g} % (sd); {}",
          100 * d.share, d.size < 0 ? "below" : "above", 100 * std::sqrt(own->variance) / mean,
          model.symbols[strengths->symbol].name, own->value, 100 * strengths->sd / mean, left);
    }
    found.push_back(std::move(d));
  }
  return found;
}

DiagnosisOptions options_of(const DiagnosisRequest& request) {
  DiagnosisOptions options;
  options.catalogue = request.catalogue;
  options.window = request.window;
  options.threads = request.threads;
  options.progress = request.progress;
  options.highest_level = request.highest_level;
  options.left_out.insert(request.without.begin(), request.without.end());
  if (request.check_from_s || request.check_to_s) {
    options.check = request.window;
    options.check->from_s = request.check_from_s.value_or(Window{}.from_s);
    options.check->to_s = request.check_to_s.value_or(Window{}.to_s);
    options.fit_check = request.fit_check;
  }
  if (request.parameters.empty()) return options;
  GivenParameters given = read_parameter_file(request.parameters);
  options.given.values = std::move(given.values);
  for (const auto& [name, value] : given.representative)
    if (options.given.values.emplace(name, value).second) options.given.open.insert(name);
  options.given.sd = std::move(given.sd);
  return options;
}

// A model with every effect that it can be tried with.
struct TriedModel {
  std::shared_ptr<const CompiledModel> model;
  std::vector<EquationEffect> effects;
  std::vector<StateForce> forces;
  std::vector<std::size_t> own;  // symbols of the model as it was
};

TriedModel with_effects(const ModelSource& source, const EffectCatalogue& catalogue) {
  std::vector<EffectTerm> terms;
  for (const EffectTerm& term : source.applicable_effects())
    if (is_seen_by_lines(term, catalogue)) terms.push_back(term);
  for (const EffectTerm& term : source.open_law_terms()) terms.push_back(term);
  const AugmentedCompiledModel augmented = source.load_with_effects(terms, {});
  TriedModel tried;
  tried.model = augmented.model;
  std::vector<bool> added(tried.model->symbols.size(), false);
  for (const AddedEffect& effect : augmented.effects) {
    EquationEffect equation;
    equation.effect = effect.term.effect;
    equation.form = effect.term.form;
    equation.mode = effect.term.mode;
    equation.subject = subject_of(effect.term, *tried.model);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const std::size_t symbol = symbol_index(*tried.model, effect.parameters[p]);
      if (symbol >= added.size()) continue;  // a symbol that no equation holds
      added[symbol] = true;
      if (p == 0)
        equation.strength = symbol;
      else
        equation.shapes.push_back(symbol);
    }
    if (effect.signal != EffectTerm::none)
      tried.forces.push_back({effect.law, effect.signal, effect.term.mode, equation.strength,
                              equation.shapes.empty() ? StateForce::none : equation.shapes.back()});
    tried.effects.push_back(std::move(equation));
  }
  for (std::size_t s = 0; s < added.size(); ++s)
    if (!added[s]) tried.own.push_back(s);
  return tried;
}

// Why what records have of their own beside an explanation is doubtful; empty: it is not.
std::string doubt_of_own(const Diagnosis& d) {
  if (d.frequency_scatter.follows_settings)
    return "natural frequencies of each record's own beside it follow the records' settings, as what a missing law "
           "does to them";
  if (d.late.records.empty() || d.late.comes_at_random()) return "";
  switch (d.late.following) {
    case Following::too_few:
      return "too few records to tell whether they are late beside it";
    case Following::settings:
      return "how late records are beside it follows their settings, as what a missing law does to phases";
    case Following::at_random:
      break;
  }
  return "records are not late by different times beside it";
}

constexpr int all_told = 2;  // of how_told()

// How much of the gap a diagnosis accounts for; where it is none any more and that is doubtful, nothing.
int how_told(const Diagnosis& d) {
  if (!d.frequency_scatter.suffices || (d.verdict == "unknown" && !d.gap.detected)) return -1;
  return is_told(d) ? all_told : d.verdict == "approximate" ? 1 : 0;
}

// What records are allowed to have of their own.
struct Allowance {
  bool late = false;
  Eigen::VectorXd frequency_scatter = {};  // DiagnosisOptions::frequency_scatter
  enum Turn { at_random, plain, blows, at_last, both } turn = plain;
  double left = 0;               // beside the model as it is, mean square in variances
  bool blows_as_decays = false;  // nothing of what drives them
};

/// Share of what frequencies differ by that chance may have, beside what follows the settings, without being looked
/// at: what follows them is nine tenths then.
constexpr double little = 0.1;

/// Searches for foreign content, each beside what the one before found.
constexpr int most_rounds = 3;

// What differs from record to record: natural frequencies or lateness of each record's own are tried first where
// they plainly come at random, in the order of what the model as it is leaves beside them, and else after the
// plain equations: what a law that the model lacks does follows the settings. Both at once take all that the
// resonant line of a dwell tells, and come last. They count where the diagnosis then accounts for more than
// without.
class StepByStep {
 public:
  StepByStep(const DiagnosisRequest& request, const TriedModel& tried, const Campaign& campaign,
             const RecordReader& read, DiagnosisOptions& options, ForeignContent& foreign)
      : request_(request), tried_(tried), campaign_(campaign), read_(read), options_(options), foreign_(foreign) {}

  // What a missing term leaves may look like foreign content: what is found in the rest counts where nothing is
  // left beside it.
  Diagnosis run() {
    const ModelAlone plain = alone({});
    std::vector<Allowance> all{{}};
    if (is_more_than_noise(plain.left) && !holds_beside_foreign_content(plain)) {
      of_decays_ = find_decay_scatter(request_);
      all = allowances(plain);
    }
    // What follows a blow says nothing of effects on what drives it: those are tried before.
    if (has_blows()) all.push_back({.turn = Allowance::blows, .blows_as_decays = true});
    std::stable_sort(all.begin(), all.end(), [](const Allowance& a, const Allowance& b) {
      return std::tie(a.turn, a.left) < std::tie(b.turn, b.left);
    });
    bool is_answered = false;
    for (const Allowance& allowance : all) {
      if (!allowance.blows_as_decays) is_answered = is_answered || tells(allowance);
      // What leaves noise alone and yet tells no cause may follow blows that do not say how strong they are.
      else if (how_told(best_->so_far()) < all_told)
        is_answered = blows_do_not_fit(allowance) || is_answered;
    }
    return std::move(*best_).finish();
  }

  const std::string& warning() const { return of_decays_.warning; }
  /// Of blows whose excitation does not count; nothing where all do.
  const std::optional<BlowsAlone>& blows() const { return blows_; }

 private:
  void allow(const Allowance& allowance) {
    options_.late = allowance.late;
    options_.frequency_scatter = allowance.frequency_scatter;
    options_.blows_as_decays = allowance.blows_as_decays;
  }

  OpenDiagnosis diagnosed(const Allowance& allowance) {
    allow(allowance);
    return OpenDiagnosis({campaign_, read_, *tried_.model, tried_.own}, tried_.effects, options_);
  }

  ModelAlone alone(const Allowance& allowance, std::optional<double> common_late_s = {}) {
    allow(allowance);
    return fit_alone({campaign_, read_, *tried_.model, tried_.own}, options_, common_late_s);
  }

  // What is in the readings and no term of the equations makes is allowed for before anything is tried. What is
  // large hides what is small, and where a line falls is known better beside a model that is fitted beside it.
  bool holds_beside_foreign_content(ModelAlone left) {
    const ForeignContent in_records = foreign_;
    for (int round = 0; round < most_rounds && search(left.of_segments, campaign_, foreign_) > 0; ++round) {
      admit(foreign_, campaign_, options_);
      left = alone({});
      if (!is_more_than_noise(left.left)) return true;
    }
    foreign_ = in_records;
    admit(foreign_, campaign_, options_);
    return false;
  }

  std::vector<Allowance> allowances(const ModelAlone& plain) {
    std::vector<Allowance> all{{}};
    ModelAlone scatter = alone({false, first_frequency_scatter(tried_.model->modes())});
    take_decays(scatter.scatter);
    if (at_random(scatter.scatter))
      all.push_back({false, admitted(scatter.scatter), Allowance::at_random, scatter.dispersion()});
    if (scatter.scatter.any()) scatter_alone_ = admitted(scatter.scatter);
    const auto of_records_in_step = [&] {
      if (scatter.scatter.any() && !at_random(scatter.scatter))
        all.push_back({false, admitted(scatter.scatter), Allowance::at_last, scatter.dispersion()});
      return all;
    };
    if (!may_be_late()) return of_records_in_step();
    const ModelAlone late = alone({true, {}});
    if (!are_late(late, plain)) return of_records_in_step();
    if (late.late.comes_at_random() || late.late.following == Following::too_few)
      all.push_back(
          {true, {}, late.late.is_plain() ? Allowance::at_random : Allowance::at_last, late.dispersion()});
    // Frequencies of late records follow the settings as their phases do, until they are in step.
    ModelAlone both = alone({true, first_frequency_scatter(tried_.model->modes())});
    take_decays(both.scatter);
    if (at_random(both.scatter) && both.late.comes_at_random() && lateness_takes_more_than_chance(scatter, both))
      all.push_back({true, admitted(both.scatter), Allowance::both, both.dispersion()});
    return all;
  }

  // What decays tell of a mode outranks what the model as it is leaves of it.
  void take_decays(FrequencyScatter& scatter) const {
    const Eigen::VectorXd& decays = of_decays_.frequency_sd;
    for (Eigen::Index k = 0; k < std::min(decays.size(), scatter.sd.size()); ++k)
      if (decays(k) > 0) scatter.sd(k) = decays(k);
  }

  static bool at_random(const FrequencyScatter& scatter) {
    return scatter.any() && (!scatter.follows_settings || scatter.at_random > little);
  }

  bool may_be_late() const {
    const bool dwells = std::any_of(campaign_.records.begin(), campaign_.records.end(),
                                    [](const RecordEntry& record) { return record.kind == RecordKind::dwell; });
    return !tried_.model->excitations.empty() && excitation_channels() == 1 && dwells;
  }

  std::ptrdiff_t excitation_channels() const {
    return std::count_if(campaign_.channels.begin(), campaign_.channels.end(),
                         [](const Channel& channel) { return channel.role == ChannelRole::excitation; });
  }

  bool has_blows() const {
    const std::vector<bool> impacts = chosen_impacts(campaign_, request_.window);
    return tried_.model->excitations.size() > tried_.forces.size() && excitation_channels() > 0 &&
           std::find(impacts.begin(), impacts.end(), true) != impacts.end();
  }

  // Not where one time of all does as well, which is a cause, channel_skew, and no disturbance.
  bool are_late(const ModelAlone& late, const ModelAlone& plain) {
    if (late.late.records.size() < 2 || !lateness_takes_more_than_chance(plain, late)) return false;
    std::vector<double> late_s;
    for (const OwnLateness& record : late.late.records) late_s.push_back(record.late_s);
    return lateness_takes_more_than_chance(alone({}, upper_median(std::move(late_s))), late);
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
    const auto accounts = [](const OpenDiagnosis& d) {
      return std::pair(how_told(d.so_far()), -d.so_far().gap.after);
    };
    if (!best_ || accounts(fresh) > accounts(*best_) ||
        (suffices && how_told(fresh.so_far()) >= how_told(best_->so_far())))
      best_ = std::move(fresh);
    return suffices || how_told(best_->so_far()) == all_told;
  }

  // Keeps what follows the blows where it accounts for all of the gap and the blows themselves do not fit. Rows of
  // these are gone: less that is left of the others is no better answer by itself.
  bool blows_do_not_fit(const Allowance& allowance) {
    options_.knows_without_scatter = false;
    OpenDiagnosis fresh = diagnosed(allowance);
    doubt_what_may_be_of_records(fresh, true, true);
    if (how_told(fresh.so_far()) != all_told) return false;
    blows_ =
        fit_blows_alone({campaign_, read_, *tried_.model, tried_.own}, options_, {fresh.fit(), fresh.forces()});
    if (blows_->do_not_fit())
      best_ = std::move(fresh);
    else
      blows_.reset();
    return blows_.has_value();
  }

  const DiagnosisRequest& request_;
  const TriedModel& tried_;
  const Campaign& campaign_;
  const RecordReader& read_;
  DiagnosisOptions& options_;
  ForeignContent& foreign_;
  DecayScatter of_decays_;
  Eigen::VectorXd scatter_alone_;         // of frequencies about the model as it is
  std::set<bool> known_without_scatter_;  // late or not: what a diagnosis says whose frequencies are all the same
  std::optional<OpenDiagnosis> best_;
  std::optional<BlowsAlone> blows_;
};

}  // namespace

DiagnosisRun run_diagnosis(const DiagnosisRequest& request) {
  DiagnosisRun run;
  const ModelSource source(request.model, request.interpret, request.catalogue);
  run.campaign = read_campaign(request.campaign);
  DiagnosisOptions options = options_of(request);
  DisturbanceWatch watch(run.campaign);
  SelectedRecords reader(run.campaign, request.window, watch.look());
  const RecordReader read = [&](std::size_t r) { return reader.read(r); };
  std::vector<double> nominal = source.nominal_frequencies();
  nominal.resize(source.modes());
  for (std::size_t k = 0; k < nominal.size(); ++k)
    if (const auto given = options.given.values.find(source.frequency_names()[k]);
        given != options.given.values.end())
      nominal[k] = given->second;
  const FrequencyStarts starts = frequency_starts(source, run.campaign, read, nominal, {}, request.window);
  options.natural_frequency = starts.frequency;
  for (std::size_t k = 0; k < nominal.size(); ++k)
    if (std::isfinite(nominal[k]) && !starts.moved[k]) options.natural_frequency[k] = nominal[k];
  std::size_t chosen = 0;
  for (std::size_t r = 0; r < run.campaign.records.size(); ++r)
    if (request.window.takes(r, run.campaign.records[r].file)) {
      read(r);  // looked at before any is compared
      ++chosen;
    }
  // Clipping of a few records is beside the motion; of most of them, it is what they tell.
  ForeignContent foreign{watch.found(), {}, {}};
  if (2 * reader.clipped_records() < chosen) {
    reader.leave_clipped_out();
    list_clipped_as_left_out(foreign.found);
  }
  admit(foreign, run.campaign, options);
  const TriedModel tried = with_effects(source, request.catalogue);
  run.model = tried.model;
  options.forces = tried.forces;
  const std::string unused = unused_numbers(request.parameters, options.given.values, *run.model);
  const bool rough = only_rough_frequencies(options.given, source, *run.model, tried.own);
  if (rough) options.given = {};
  StepByStep steps(request, tried, run.campaign, read, options, foreign);
  run.diagnosis = steps.run();
  run.diagnosis.warnings.insert(run.diagnosis.warnings.begin(), starts.warnings.begin(), starts.warnings.end());
  if (rough)
    run.diagnosis.warnings.push_back(
        request.parameters +
        ": holds natural frequencies alone, which are taken as a start: all parameters are fitted");
  if (!unused.empty()) run.diagnosis.warnings.push_back(unused);
  if (!steps.warning().empty()) run.diagnosis.warnings.push_back(steps.warning());
  for (std::string& warning : reader.warnings()) run.diagnosis.warnings.push_back(std::move(warning));
  run.disturbances = std::move(foreign.found);
  for (Disturbance& d : run.disturbances)
    if (is_fitted(d, run, options)) d.treated = "fitted";
  for (Disturbance& d : fitted_offsets(run.diagnosis, run.campaign, run.disturbances))
    run.disturbances.push_back(std::move(d));
  for (Disturbance& d : late_records(run.diagnosis)) run.disturbances.push_back(std::move(d));
  for (Disturbance& d : own_frequencies(run.diagnosis, *run.model)) run.disturbances.push_back(std::move(d));
  if (steps.blows()) {
    run.diagnosis.warnings.emplace_back(
        "blows do not do what their excitation says, or an effect of the excitation acts that is not found: they "
        "are compared from where the structure swings freely on, and numbers by which excitations act are missing "
        "where no other record tells them");
    for (Disturbance& d : mismatches(*steps.blows(), run.diagnosis, *run.model))
      run.disturbances.push_back(std::move(d));
  }
  run.looked_at = watch.records();
  return run;
}

}  // namespace secular::app
