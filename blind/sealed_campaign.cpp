#include "blind/sealed_campaign.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "blind/signature.hpp"
#include "input/numerical_failure.hpp"

namespace secular::blind {
namespace {

constexpr double weakest_sigma = 3, strongest_sigma = 100;
constexpr double largest_relative_change = 0.3;
// Norm, over the whole campaign, below which a difference is nothing that data could show: its chi-square would
// exceed the degrees of freedom of a comparison by 16 only.
constexpr double visible_norm = 4;
// A rival that still leaves this share of a change when its size has followed, or this one at first, does not come
// to explain it.
constexpr double hopeless = 0.8, hopeless_at_first = 0.95;
// One that leaves less is fitted to convergence, together with the model's own parameters.
constexpr double near = 0.5;
// A campaign whose motion grows beyond all bounds is drawn again, from a stream of its own.
constexpr std::uint64_t most_redraws = 8, redrawn = 10'000'000;
// Standard deviations of a chi-squared beyond which it is noticed, once in ten thousand, and by how many it has to
// exceed that in the mean to be noticed in 95 of 100 campaigns.
constexpr double alarm = 3.7, for_certain = 1.6;
// Stream of the search among the rest of the catalogue.
constexpr std::uint64_t rest_of_catalogue = 3'000'000;
// Stream of the disturbances, apart from that of structures and effects, which stay the same without them.
constexpr std::uint64_t of_disturbances = 5'000'000;
// Records of one more dwell, proposed or drawn by lot, come after those of the programme.
constexpr std::size_t further_records = 2;

bool changes_with_time(const std::string& effect) {
  return effect == "modulated_force";
}

std::vector<std::string> catalogued_effects(Programme programme) {
  std::set<std::string> names;
  for (const std::string& family : families_of(programme))
    for (const std::string& effect : effects_shown(family, programme)) names.insert(effect);
  return {names.begin(), names.end()};
}

std::string family_for(const std::vector<std::string>& effects, Programme programme, Random& random) {
  std::vector<std::string> fitting;
  for (const std::string& family : families_of(programme)) {
    const std::vector<std::string> shown = effects_shown(family, programme);
    if (std::all_of(effects.begin(), effects.end(), [&](const std::string& effect) {
          return std::find(shown.begin(), shown.end(), effect) != shown.end();
        }))
      fitting.push_back(family);
  }
  return fitting.empty() ? std::string() : fitting[random.below(fitting.size())];
}

// Scales the coefficient until the change that the model's own parameters cannot imitate is about `target`.
void set_strength(Truth& truth, const Specimen& specimen, const Signatures& signatures,
                  const std::vector<double>& peak, double target) {
  Withheld& w = truth.withheld;
  const bool all = changes_with_time(w.effect);
  const double cap = largest_relative_change;
  for (int attempt = 0; attempt < 6; ++attempt) {
    Reality reality = reality_of(specimen);
    switch_on(w, specimen, peak, reality);
    const Eigen::VectorXd change = signatures.change(reality, all);
    if (!change.allFinite()) {
      w.coefficient /= 5;
      continue;
    }
    truth.raw_sigma = signatures.strength(change, all);
    truth.relative = signatures.relative(reality, all);
    // The linear fit leads to the target, the converged one judges what was reached.
    const auto factor_to_target = [&](const Eigen::VectorXd& left) {
      truth.sigma = signatures.strength(left, all);
      const double wanted = truth.sigma > 0 ? target / truth.sigma : 100;
      return truth.relative > 0 ? std::min(wanted, cap / truth.relative) : wanted;
    };
    const bool last = attempt == 5;
    double factor = factor_to_target(signatures.linear_unexplained(change, all));
    if (last || std::abs(std::log(factor)) < 0.2) {
      factor = factor_to_target(signatures.unexplained(change, all));
      if (last || std::abs(std::log(factor)) < 0.4) break;
    }
    factor = std::clamp(factor, 0.02, 50.0);
    if (truth.raw_sigma == 0) factor = 3;
    w.coefficient *= factor;
  }
}

/// A rival as it may be shaped. Width of a slider's slip or of a dead band, relative to the motion; 0: it has none.
struct Shape {
  double width = 0;
  bool smooth = false;
};

// A slider that slips at once is dry friction; a dead band that only the largest motions leave hardens like a high
// power.
std::vector<Shape> shapes_of(const std::string& effect) {
  std::vector<Shape> shapes;
  if (effect == "hysteresis" || effect == "freeplay" || effect.ends_with("_stop"))
    for (const double width : {0.15, 0.4, 0.6, 0.75, 0.9}) shapes.push_back({width, false});
  if (effect == "hysteresis") {
    shapes.push_back({0.03, false});
    for (const double width : {0.15, 0.4}) shapes.push_back({width, true});
  }
  if (effect == "stribeck_friction")
    for (const double width : {0.1, 0.3, 0.6}) shapes.push_back({width, false});
  if (effect == "power_damping")
    for (const double exponent : {1.3, 2.0, 3.0}) shapes.push_back({exponent, false});
  if (effect == "saturating_stiffness")
    for (const double width : {0.2, 0.5, 1.0, 3.0}) shapes.push_back({width, false});
  if (shapes.empty()) shapes.emplace_back();
  return shapes;
}

// What is left of a change has to stand out of the spread of a chi-squared of all components where there is no
// rival of the right name to compare with: only the sum of all squares says then that something is missing.
double unnamed_norm(const Signatures& signatures) {
  const auto components = static_cast<double>(signatures.own_parameters(false).rows());
  return std::sqrt((alarm + for_certain) * std::sqrt(2 * components));
}

/// What a truth changes, seen by one set of amplitudes.
struct SeenChange {
  const Signatures& signatures;
  bool all_ensembles = false;
  Eigen::VectorXd whole, left;  ///< `left`: what the model's own parameters leave of it

  /// Standard deviations of what was compared are those of so many of all that was recorded.
  double ensembles() const { return std::sqrt(signatures.recorded_alike(all_ensembles)); }
};

// Norm of what a rival leaves of a change, with the coefficient that explains most. Its own change is computed
// again where that has moved: large changes are not proportional to it. Nor do large changes add up: a rival that
// comes near is fitted together with the model's own parameters.
double least_left_by(Withheld rival, double raw_sigma, double seen, const SeenChange& truth,
                     const SealedCampaign& c, const std::vector<double>& peak) {
  const Signatures& signatures = truth.signatures;
  const Eigen::VectorXd& left = truth.left;
  const bool all = truth.all_ensembles;
  const auto with_rival = [&](double coefficient) {
    Reality other = reality_of(c.specimen);
    rival.coefficient = coefficient;
    switch_on(rival, c.specimen, peak, other);
    return other;
  };
  const Eigen::MatrixXd& own = signatures.own_parameters(all);
  double least = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 4; ++attempt) {
    const Eigen::VectorXd change = signatures.change(with_rival(rival.coefficient), all);
    const double size = signatures.strength(change, all);
    if (!change.allFinite() || size == 0) break;
    if (attempt == 0) {
      rival.coefficient *= std::clamp(raw_sigma / size, 0.02, 50.0);
      continue;
    }
    const Eigen::VectorXd own_taken_off = signatures.unexplained(change, all);
    const double length = own_taken_off.norm();
    if (length == 0) break;
    Eigen::MatrixXd columns(own.rows(), own.cols() + 1);
    columns << own, own_taken_off / length;
    const Eigen::VectorXd fit = columns.colPivHouseholderQr().solve(left);
    const double unexplained = (left - columns * fit).norm();
    least = std::min(least, unexplained);
    if (unexplained * truth.ensembles() < seen) return unexplained;
    if (unexplained > (attempt > 1 ? hopeless : hopeless_at_first) * left.norm()) break;
    const double factor = fit(fit.size() - 1) / length;
    if (attempt > 1 && std::abs(factor - 1) < 0.02) break;
    rival.coefficient *= std::copysign(std::clamp(std::abs(factor), 0.02, 50.0), factor);
  }
  if (!(least < near * left.norm())) return least;
  return std::min(least, signatures.refitted_unexplained(truth.whole, all, with_rival, rival.coefficient).norm());
}

/// With what explanations of one campaign are compared.
struct Comparison {
  const SealedCampaign& c;
  const Signatures& signatures;
  const std::vector<double>& peak;
  double seen;  // norm below which a change is as good as explained
};

// Which of `rivals` explain the change as well.
void find_look_alikes(Truth& truth, const std::vector<std::string>& rivals, const Comparison& by, Random& random) {
  const auto& [c, signatures, peak, seen] = by;
  const bool all = changes_with_time(truth.withheld.effect);
  Reality reality = reality_of(c.specimen);
  switch_on(truth.withheld, c.specimen, peak, reality);
  SeenChange change{signatures, all, signatures.change(reality, all), {}};
  change.left = signatures.refitted_unexplained(change.whole, all);
  truth.sigma = signatures.strength(change.left, all);
  // One sensor alone has no sensitivity that the model's own parameters would not take up.
  const bool hidden = truth.withheld.effect == "sensor_gain" && c.specimen.measurement.names.size() == 2;
  if (hidden || change.left.norm() * change.ensembles() < visible_norm) {
    truth.same_as.emplace_back("no_gap");
    return;
  }
  for (const std::string& name : rivals) {
    for (const Shape& shape : shapes_of(name)) {
      Withheld rival = draw_withheld(name, c.specimen, random);
      rival.mode = truth.withheld.mode;
      if (shape.width > 0) {
        rival.detail = shape.width;
        rival.smooth = shape.smooth;
      }
      if (least_left_by(rival, truth.raw_sigma, seen, change, c, peak) * change.ensembles() < seen) {
        truth.same_as.push_back(name);
        break;
      }
    }
  }
}

// Moves one to three of the model's own numbers until the response is `target` standard deviations away.
void move_parameters(SealedCampaign& c, const Signatures& signatures, double target, Random& random) {
  struct Move {
    std::string effect, symbol;
    std::size_t mode;
    double relative;
  };
  std::vector<Move> possible;
  for (std::size_t k = 0; k < c.specimen.structure.modes; ++k)
    possible.push_back({"natural_frequency", c.specimen.frequency_symbols[k], k,
                        0.3 * c.specimen.decay_rate[k] / c.specimen.structure.mode[k].omega});
  for (const OwnTerm& term : c.specimen.own) possible.push_back({term.effect, term.symbol, term.mode, 0.1});
  random.shuffle(possible);
  possible.resize(1 + random.below(3));
  for (Move& move : possible) move.relative *= random.sign() * random.uniform(0.5, 1.5);
  Truth truth;
  truth.withheld.effect = "parameters";
  for (int attempt = 0; attempt < 5; ++attempt) {
    Reality moved = reality_of(c.specimen);
    for (const Move& move : possible) *coefficient(moved.structure, move.effect, move.mode) *= 1 + move.relative;
    const Eigen::VectorXd change = signatures.change(moved, false);
    double factor = 0.2;
    if (change.allFinite()) {
      truth.sigma = truth.raw_sigma = signatures.strength(change, false);
      truth.relative = signatures.relative(moved, false);
      factor = std::min(target / truth.sigma, largest_relative_change / truth.relative);
      if (attempt == 4 || std::abs(std::log(factor)) < 0.2) break;
    }
    for (Move& move : possible) move.relative = std::clamp(move.relative * factor, -0.6, 0.6);
  }
  c.parameters = numbers_of(c.specimen);
  for (const Move& move : possible) {
    c.parameters[move.symbol] *= 1 + move.relative;
    c.moved.push_back(move.symbol);
  }
  std::sort(c.moved.begin(), c.moved.end());
  truth.withheld.coefficient = possible.front().relative;
  c.truths.push_back(truth);
}

Disturbances disturbances_of(const Specimen& specimen, const Levels& levels, Random random) {
  DisturbedCampaign campaign{levels.median_rms, levels.peak, 1,
                             specimen.dwells.size() + specimen.stretches.size() + further_records};
  for (std::size_t k = 0; k < specimen.structure.modes; ++k)
    campaign.highest_natural_hz = std::max(campaign.highest_natural_hz, specimen.structure.mode[k].omega / two_pi);
  return draw_disturbances(campaign, random);
}

SealedCampaign draw_once(const CampaignPlan& plan, std::uint64_t seed, std::uint64_t stream) {
  Random random(seed, stream);
  SealedCampaign c;
  c.plan = plan;
  const std::set<std::string> withheld(plan.effects.begin(), plan.effects.end());
  do {
    c.specimen = draw_specimen(plan.family, withheld, plan.dwells, random, plan.programme);
  } while (plan.programme == Programme::dwells && c.specimen.dwells.size() < plan.dwells / 2);
  c.reality = reality_of(c.specimen);
  const Levels levels = levels_of(c.specimen, c.reality);
  for (const double rms : levels.median_rms) c.noise_sd.push_back(rms * std::pow(10, -plan.snr_db / 20));
  // A converter of twelve bits whose range is three times the largest signal.
  const bool coarse = random.chance(0.2);
  for (const double peak : levels.peak) c.quantum.push_back(coarse ? 6 * peak / 4096 : 0);
  if (plan.disturbed) c.disturbances = disturbances_of(c.specimen, levels, Random(seed, stream + of_disturbances));
  const Signatures signatures(c.specimen, c.noise_sd, c.disturbances);
  for (const std::string& effect : plan.effects) {
    Truth truth;
    truth.withheld = draw_withheld(effect, c.specimen, random);
    // The unit of a fault is what its channel reads.
    if (effect == "sensor_offset") truth.withheld.coefficient *= levels.median_rms[truth.withheld.channel];
    if (effect == "sensor_cross_axis")
      truth.withheld.coefficient *= levels.median_rms[truth.withheld.channel] / levels.median_rms[0];
    set_strength(truth, c.specimen, signatures, levels.peak, random.log_uniform(weakest_sigma, strongest_sigma));
    const double seen = plan.kind == "outside" ? unnamed_norm(signatures) : visible_norm;
    find_look_alikes(truth, look_alikes(effect, plan.family, plan.programme), {c, signatures, levels.peak, seen},
                     random);
    switch_on(truth.withheld, c.specimen, levels.peak, c.reality);
    c.truths.push_back(truth);
  }
  if (plan.kind == "parameters")
    move_parameters(c, signatures, random.log_uniform(weakest_sigma, strongest_sigma), random);
  if (plan.kind == "none" && random.chance(0.3)) c.parameters = numbers_of(c.specimen);
  return c;
}

bool is_bounded(const Motion& motion) {
  return std::all_of(motion.displacement.begin(), motion.displacement.end(),
                     [](const std::vector<double>& x) { return std::isfinite(x.back()); });
}

Structure structure_of_record(const SealedCampaign& c, std::size_t record) {
  Structure structure = c.reality.structure;
  for (ModeTerms& mode : structure.mode) mode.omega *= c.disturbances.of_record(record).frequency_factor;
  return structure;
}

// Dwells up to the first one that does not last: a softening force may let go only after the first seconds.
std::vector<Motion> lasting_motions(const SealedCampaign& c) {
  std::vector<Motion> motions;
  for (const Dwell& dwell : c.specimen.dwells) {
    Motion motion = dwell_motion(c, dwell, motions.size());
    if (!is_bounded(motion)) break;
    motions.push_back(std::move(motion));
  }
  return motions;
}

// Stretches up to the first one that does not last: decays begin beyond every dwell's amplitude, where a softening
// force may not hold.
std::vector<Motion> lasting_stretches(const SealedCampaign& c) {
  std::vector<Motion> motions;
  for (const Stretch& stretch : c.specimen.stretches) {
    Motion motion = recorded_motion(structure_of_record(c, c.specimen.dwells.size() + motions.size()),
                                    stretch.drive, stretch.state, stretch.samples, c.specimen.settling.substeps);
    if (!is_bounded(motion)) break;
    motions.push_back(std::move(motion));
  }
  return motions;
}

}  // namespace

std::map<std::string, double> numbers_of(const Specimen& specimen) {
  std::map<std::string, double> numbers;
  Structure own = specimen.structure;
  for (std::size_t k = 0; k < own.modes; ++k) numbers[specimen.frequency_symbols[k]] = own.mode[k].omega;
  for (const OwnTerm& term : specimen.own) numbers[term.symbol] = *coefficient(own, term.effect, term.mode);
  return numbers;
}

std::vector<CampaignPlan> draw_plans(const SetOptions& set) {
  Random random(set.seed, 0);
  const std::vector<double> noise =
      set.size == SetSize::short_set ? std::vector<double>{40, 30} : std::vector<double>{40, 30, 20, 10};
  const std::vector<std::string> families = families_of(set.programme);
  std::vector<std::string> deck = catalogued_effects(set.programme), outside = uncatalogued_effects(set.programme),
                           pairable;
  for (const std::string& effect : catalogued_effects(set.programme))
    if (!is_measurement_fault(effect) && effect != "quadratic_inertia" && effect != "cubic_inertia")
      pairable.push_back(effect);
  random.shuffle(deck);
  random.shuffle(outside);
  // Of twenty campaigns eleven have one effect, three none, two are pairs, three lie outside, one has wrong
  // numbers.
  std::vector<std::string> kinds = {"single", "none",   "single",  "outside", "single",     "pair",  "single",
                                    "none",   "single", "single",  "outside", "single",     "pair",  "single",
                                    "none",   "single", "outside", "single",  "parameters", "single"};
  if (set.nothing_withheld) kinds = {"none"};
  std::vector<CampaignPlan> plans;
  std::size_t singles = 0, outsiders = 0;
  for (std::size_t i = 0; i < set.campaigns; ++i) {
    if (i % kinds.size() == 0) random.shuffle(kinds);
    CampaignPlan plan;
    plan.number = i + 1;
    plan.kind = kinds[i % kinds.size()];
    if (plan.kind == "single") plan.effects = {deck[singles++ % deck.size()]};
    if (plan.kind == "outside") plan.effects = {outside[outsiders++ % outside.size()]};
    plan.family = families[random.below(families.size())];
    if (plan.kind == "single") plan.family = family_for(plan.effects, set.programme, random);
    if (plan.kind == "pair") {
      do {
        const std::string first = pairable[random.below(pairable.size())];
        std::string second = first;
        while (second == first) second = pairable[random.below(pairable.size())];
        plan.effects = {first, second};
        plan.family = family_for(plan.effects, set.programme, random);
      } while (plan.family.empty());
    }
    plan.snr_db = noise[random.below(noise.size())];
    plan.dwells = set.size == SetSize::short_set ? 20 : 40;
    plan.disturbed = set.disturbed;
    plan.programme = set.programme;
    plans.push_back(plan);
  }
  return plans;
}

std::vector<std::string> rest_that_explains(const SealedCampaign& sealed, std::uint64_t seed) {
  Random random(seed, rest_of_catalogue + sealed.plan.number);
  Truth truth = sealed.truths.front();
  truth.same_as.clear();
  std::vector<std::string> rest = effects_shown(sealed.plan.family, sealed.plan.programme);
  std::erase(rest, truth.withheld.effect);
  const Signatures signatures(sealed.specimen, sealed.noise_sd, sealed.disturbances);
  const std::vector<double> peak = levels_of(sealed.specimen, reality_of(sealed.specimen)).peak;
  find_look_alikes(truth, rest, {sealed, signatures, peak, unnamed_norm(signatures)}, random);
  // A mode far beyond the band that one channel sees answers in proportion to the excitation.
  if (truth.withheld.effect == "sensor_cross_axis" &&
      std::find(truth.same_as.begin(), truth.same_as.end(), "extra_mode") == truth.same_as.end())
    truth.same_as.emplace_back("extra_mode");
  return truth.same_as;
}

Motion dwell_motion(const SealedCampaign& c, const Dwell& dwell, std::size_t record, std::size_t length) {
  const Drive drive = drive_of(dwell, c.reality);
  const Settling& settling = c.specimen.settling;
  const Structure structure = structure_of_record(c, record);
  const State settled = settled_state(structure, drive, dwell.state, settling);
  return recorded_motion(structure, drive, settled, length * ensembles_per_dwell * ensemble_samples,
                         settling.substeps);
}

SealedCampaign draw_campaign(const CampaignPlan& plan, std::uint64_t seed) {
  for (std::uint64_t attempt = 0; attempt <= most_redraws; ++attempt) {
    SealedCampaign c = draw_once(plan, seed, plan.number + redrawn * attempt);
    c.motions = lasting_motions(c);
    if (c.motions.size() < c.specimen.dwells.size()) continue;
    c.of_stretches = lasting_stretches(c);
    if (c.of_stretches.size() == c.specimen.stretches.size()) return c;
  }
  throw NumericalFailure(Ending::ran_away,
                         fmt::format("campaign {} of seed {}: none of its draws stays bounded", plan.number, seed));
}

}  // namespace secular::blind
