#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "measure/observe/decay_window.hpp"
#include "measure/observe/natural_frequency_starts.hpp"
#include "measure/observe/observation_set.hpp"
#include "measure/observe/record_window.hpp"
#include "measure/signal/free_decay.hpp"
#include "measure/signal/slow_tones.hpp"
#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A window that leaves more than the quietest one on each side does is not used: more by this beside what chance
/// makes of noise; at the ends of a decay, where one side is missing, by the other factor.
constexpr auto& disturbed_noise = measure_thresholds().disturbed_noise;
constexpr auto& disturbed_end = measure_thresholds().disturbed_end;

/// A decay of which more is disturbed is cut into the shortest windows, of which more fit between disturbances.
constexpr auto& largest_disturbed_share = measure_thresholds().disturbed_share;

/// Windows in a stretch begin a quarter of their length apart.
constexpr auto& windows_in_a_stretch = measure_thresholds().windows_in_a_stretch;

/// Windows' length, of the decay's.
constexpr auto& windows_in_a_decay = measure_thresholds().windows_in_a_decay;

/// Shorter windows where an amplitude changes by more than this share within one, or is bent by more than that: the
/// bias of a rate is 1/40 of the square of the first.
constexpr auto& largest_fall = measure_thresholds().largest_fall;
constexpr auto& largest_bend = measure_thresholds().largest_bend;

/// Windows on either side of which the quietest counts: those of two stretches, as a disturbance at their border is
/// in all of them.
std::size_t neighbours() {
  return 2 * static_cast<std::size_t>(windows_in_a_stretch);
}

/// Windows of a decay that is used: more than one stretch has, which would be one condition alone.
std::size_t fewest_windows() {
  return static_cast<std::size_t>(windows_in_a_stretch) + 1;
}

/// Another mode counts as decayed where its part of the samples is below this share of the mode's own.
constexpr auto& decayed_share = measure_thresholds().decayed_share;

/// Probability that noise, which is the same in a window and where the decay has ended, makes one of as many
/// windows look disturbed, or another mode move in it.
double alarm_of(std::size_t windows) {
  return measure_thresholds().disturbance_false_alarm / static_cast<double>(windows);
}

// Root mean square about the mean of every column.
VectorXd spread(const MatrixXd& samples) {
  return (samples.rowwise() - samples.colwise().mean()).colwise().norm().transpose() /
         std::sqrt(static_cast<double>(std::max<Index>(1, samples.rows())));
}

// A stretch of samples in a record.
struct Part {
  Index first = 0, count = 0;
};

struct FoundWindow {
  Part part;
  int stretch = 0;
  DecayWindow window;
};

class DecayObserver {
 public:
  DecayObserver(const Campaign& campaign, const CompiledModel& model, const CompiledCase& resonance,
                const Window& window)
      : campaign_(campaign), model_(model), resonance_(resonance), windows_(campaign, model, resonance, window) {}

  // Adds the record's windows as conditions from `condition` on; the number of conditions.
  int observe(std::size_t r, const Record& record, SampleRange range, int condition, ObservationSet& set) const {
    const std::string& file = campaign_.records[r].file;
    const double rate = record.sample_rate_hz;
    const MatrixXd all = windows_.modal_samples(record, range.first, range.count);
    const auto leave_out = [&](const std::string& why) {
      set.warnings.push_back(fmt::format("{}: {}, left out", file, why));
      return 0;
    };
    std::optional<DecayStart> start;
    const std::size_t leading = strongest(all);
    if (all.rows() > 0) start = find_decay_start(all.col(static_cast<Index>(leading)), rate);
    if (!start) return leave_out("no free decay is found in it");
    const MatrixXd modal = all.bottomRows(all.rows() - start->sample);
    VectorXd frequency = start_frequencies(modal, rate, *start, leading);
    const double shortest = windows_.shortest_s(frequency, rate);
    const std::vector<Scanned> scan = scanned(modal, rate, shortest, frequency);
    const double duration = shortest * static_cast<double>(scan.size());
    if (scan.size() < 3) return leave_out(too_short(duration, shortest));
    std::vector<FoundWindow> found =
        cut(modal, rate, shortest, std::max(shortest, duration / windows_in_a_decay), duration, scan);
    std::vector<bool> bad = disturbed(found);
    const auto disturbances = [&] { return std::count(bad.begin(), bad.end(), true); };
    if (static_cast<double>(disturbances()) > largest_disturbed_share * static_cast<double>(found.size())) {
      found = cut(modal, rate, shortest, shortest, duration, scan);
      bad = disturbed(found);
    }
    const auto time_of = [&](const Part& part) {
      return record.start_s + (static_cast<double>(range.first + start->sample + part.first) +
                               0.5 * static_cast<double>(part.count - 1)) /
                                  rate;
    };
    if (disturbances() > 0) {
      const auto first = static_cast<std::size_t>(std::find(bad.begin(), bad.end(), true) - bad.begin());
      set.warnings.push_back(fmt::format(
          "{}: {} of {} windows are disturbed (they leave clearly more than quiet ones before and after them: a "
          "knock, lost samples or a step of the clock; the first at {:.1f} s), left out",
          file, disturbances(), found.size(), time_of(found[first].part)));
      std::vector<FoundWindow> quiet;
      for (std::size_t i = 0; i < found.size(); ++i)
        if (!bad[i]) quiet.push_back(std::move(found[i]));
      found = std::move(quiet);
    }
    drop_visited(found, modal, file, set);
    if (found.size() < fewest_windows()) {
      std::string names;
      for (const std::size_t k : windows_.oscillating())
        names += (names.empty() ? "" : " and ") + std::string(model_.coordinates[k]);
      return leave_out(fmt::format("fewer than {} windows of free decay of {} alone", fewest_windows(), names));
    }
    // Conditions are numbered without gaps.
    int stretches = 0, before = -1;
    std::shared_ptr<const std::vector<WindowPair>> overlap;
    for (FoundWindow& w : found) {
      if (w.stretch != before) {
        ++stretches;
        VectorXd here(modal.cols());
        for (Index k = 0; k < here.size(); ++k)
          here(k) = w.window.observation.rate[static_cast<std::size_t>(k)].imag();
        overlap = std::make_shared<const std::vector<WindowPair>>(
            windows_.overlaps(w.part.count, rate, here, static_cast<int>(windows_in_a_stretch) - 1));
      }
      before = w.stretch;
      Observation& o = w.window.observation;
      o.condition = condition + stretches - 1;
      o.record = r;
      o.centre_s = time_of(w.part);
      o.overlap = overlap;
      set.observations.push_back(std::move(o));
    }
    return stretches;
  }

 private:
  // `heard`: for how long the decay stands out; `window`: the length of the shortest, s.
  std::string too_short(double heard, double window) const {
    const bool several = windows_.oscillating().size() > 1;
    const std::string windows =
        fmt::format("windows that separate {} are {:.3g} s long",
                    several ? "the modes and their combinations" : "the oscillation's harmonics", window);
    if (heard > 0) return fmt::format("{}, and its free decay lasts {:.3g} s: three are needed", windows, heard);
    return fmt::format(
        "{}, and in none of them {} beside what else the record holds (noise, other modes: --band takes their part "
        "of the spectrum away)",
        windows, several ? "the modes stand out" : "the oscillation stands out");
  }

  // By time along the decay.
  struct Scanned {
    VectorXd frequency;
    double fall = 0;
  };

  // The oscillating mode whose coordinate moves most, each over its own quiet end's unit: acceleration and
  // displacement campaigns alike compare coordinates of one quantity.
  std::size_t strongest(const MatrixXd& all) const {
    std::size_t best = windows_.oscillating().front();
    const VectorXd size = spread(all);
    for (const std::size_t k : windows_.oscillating())
      if (size(static_cast<Index>(k)) > size(static_cast<Index>(best))) best = k;
    return best;
  }

  // Where each mode rings: its coordinate's strongest line near the nominal frequency, if the model gives one.
  VectorXd start_frequencies(const MatrixXd& modal, double rate, const DecayStart& start,
                             std::size_t leading) const {
    VectorXd frequency = VectorXd::Zero(modal.cols());
    for (const std::size_t k : windows_.oscillating()) {
      const auto at = static_cast<Index>(k);
      const double nominal = model_.nominal[k];
      if (windows_.oscillating().size() == 1) {
        frequency(at) = start.frequency;
        continue;
      }
      const double slow = std::isfinite(nominal) ? nominal : model_.nominal[leading];
      const double expected = std::isfinite(slow) ? slow : start.frequency;
      const auto count = std::min<Index>(modal.rows(), static_cast<Index>(16 * two_pi / expected * rate));
      const VectorXd taper = (1 + (VectorXd::LinSpaced(count, -std::numbers::pi, std::numbers::pi)).array().cos());
      const VectorXd y = (modal.col(at).head(count).array() - modal.col(at).head(count).mean()) * taper.array();
      const double bin = two_pi * rate / static_cast<double>(count);
      const double low = std::isfinite(nominal) ? (1 - measure_thresholds().largest_detuning) * nominal : 3 * bin;
      const double high = std::isfinite(nominal) ? (1 + measure_thresholds().largest_detuning) * nominal
                                                 : std::numbers::pi * rate - 3 * bin;
      const VectorXd t = VectorXd::LinSpaced(count, 0, static_cast<double>(count - 1) / rate);
      double best = -1;
      for (double w = low; w <= high; w += 0.2 * bin) {
        const double power =
            std::hypot((w * t).array().cos().matrix().dot(y), (w * t).array().sin().matrix().dot(y));
        if (power <= best) continue;
        best = power;
        frequency(at) = w;
      }
    }
    return frequency;
  }

  // Shortest windows one after the other, to the end of the decay.
  std::vector<Scanned> scanned(const MatrixXd& modal, double rate, double seconds, VectorXd frequency) const {
    const auto count = static_cast<Index>(std::lround(seconds * rate));
    std::vector<Scanned> result;
    std::size_t heard = 0;
    for (Index first = 0; first + count <= modal.rows(); first += count) {
      const DecayWindow window = windows_.fit(modal.middleRows(first, count), rate, frequency);
      result.push_back({frequency, window.fall});
      if (anything_seen(window.observation)) heard = result.size();
      // One window may be disturbed, and a motion that grows out of the noise is not heard at first.
      if (heard > 0 && result.size() >= heard + 2) break;
    }
    result.resize(heard);
    return result;
  }

  bool anything_seen(const Observation& o) const {
    return std::any_of(windows_.oscillating().begin(), windows_.oscillating().end(),
                       [&](std::size_t k) { return o.growth_sd[k] >= 0; });
  }

  // Stretches of two windows, each cut into windows that overlap by three quarters.
  std::vector<FoundWindow> cut(const MatrixXd& modal, double rate, double shortest, double longest, double duration,
                               const std::vector<Scanned>& scan) const {
    std::vector<FoundWindow> found;
    const Index end = std::min<Index>(modal.rows(), static_cast<Index>(duration * rate));
    Index begin = 0;
    for (int stretch = 0; begin < end; ++stretch) {
      double seconds = longest;
      const auto near = [&](Index sample) -> const Scanned& {
        const auto i = static_cast<std::size_t>(static_cast<double>(sample) / rate / shortest);
        return scan[std::min(i, scan.size() - 1)];
      };
      // A window that is bent too much is made shorter; what is left of the decay may be too short for two.
      std::optional<DecayWindow> first;
      Index count = 0;
      for (;;) {
        count = static_cast<Index>(std::lround(seconds * rate));
        if (begin + count > modal.rows()) return found;
        VectorXd frequency = near(begin + count / 2).frequency;
        first = windows_.fit(modal.middleRows(begin, count), rate, frequency);
        const bool straight = first->fall <= largest_fall && first->bend <= largest_bend;
        if (straight || seconds <= shortest) break;
        seconds = std::max(shortest, 0.7 * seconds);
      }
      for (int step = 0; step < windows_in_a_stretch; ++step) {
        const Index at = begin + step * count / (windows_in_a_stretch - 1);
        if (at + count > end && !found.empty()) break;
        if (at + count > modal.rows()) break;
        if (step > 0) {
          VectorXd frequency = near(at + count / 2).frequency;
          first = windows_.fit(modal.middleRows(at, count), rate, frequency);
        }
        if (anything_seen(first->observation)) found.push_back({{at, count}, stretch, *first});
      }
      begin += 2 * count;
    }
    return found;
  }

  // Windows that leave clearly more than quiet ones before and after them: a knock, lost samples, a step of the
  // clock. What the tones leave out falls with the amplitude, and does not stand out from both sides; how much of
  // it windows see depends on where in a turn they begin.
  std::vector<bool> disturbed(const std::vector<FoundWindow>& found) const {
    std::vector<bool> bad(found.size(), false);
    for (const std::size_t k : windows_.oscillating())
      for (std::size_t i = 0; i < found.size(); ++i) {
        const auto noise = [&](std::size_t j) { return found[j].window.noise_sd(static_cast<Index>(k)); };
        double before = INFINITY, after = INFINITY;
        for (std::size_t j = i > neighbours() ? i - neighbours() : 0; j < i; ++j)
          before = std::min(before, noise(j));
        for (std::size_t j = i + 1; j < std::min(found.size(), i + neighbours() + 1); ++j)
          after = std::min(after, noise(j));
        const double freedom = found[i].window.degrees_of_freedom;
        const double limit =
            disturbed_noise * std::sqrt(f_upper_quantile(alarm_of(found.size()), freedom, freedom));
        const bool both = std::isfinite(before) && std::isfinite(after);
        const double quiet = both ? limit * std::max(before, after) : disturbed_end * std::min(before, after);
        if (noise(i) > std::hypot(quiet, found[i].window.beyond_degree(static_cast<Index>(k)))) bad[i] = true;
      }
    return bad;
  }

  // Windows in which a mode moves visibly that the case has at rest: by more than its share of the others' motion
  // beside the most that chance makes of what it shows at the record's end.
  void drop_visited(std::vector<FoundWindow>& found, const MatrixXd& modal, const std::string& file,
                    ObservationSet& set) const {
    const std::vector<std::size_t>& own = windows_.oscillating();
    const std::size_t before = found.size();
    std::erase_if(found, [&](const FoundWindow& w) {
      const VectorXd here = spread(modal.middleRows(w.part.first, w.part.count));
      const VectorXd tail = spread(modal.bottomRows(w.part.count));
      const double freedom = static_cast<double>(w.part.count - 1);
      const double chance = f_upper_quantile(alarm_of(before), freedom, freedom);
      double mine = 0;
      for (const std::size_t k : own) mine = std::max(mine, here(static_cast<Index>(k)));
      for (Index k = 0; k < modal.cols(); ++k)
        if (std::find(own.begin(), own.end(), static_cast<std::size_t>(k)) == own.end() &&
            here(k) > std::hypot(decayed_share * mine, std::sqrt(chance) * tail(k)))
          return true;
      return false;
    });
    if (found.size() < before)
      set.warnings.push_back(fmt::format(
          "{}: {} of {} windows are left out because another mode moves too; a case without excitation in which "
          "that mode is not in modes_at_rest would use them",
          file, before - found.size(), before));
  }

  const Campaign& campaign_;
  const CompiledModel& model_;
  const CompiledCase& resonance_;
  DecayWindows windows_;
};

}  // namespace

ObservationSet observe_free_decays(const Campaign& campaign, const RecordReader& read_samples,
                                   const CompiledModel& model, const CompiledCase& resonance,
                                   const Window& window) {
  ObservationSet set;
  set.model = &model;
  set.resonance = &resonance;
  const DecayObserver observer(campaign, model, resonance, window);
  int condition = 0;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    const bool decays = entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact;
    if (!decays || !window.takes(r, entry.file)) continue;
    const Record record = read_samples(r);
    condition += observer.observe(r, record, range_of(record, window), condition, set);
  }
  return set;
}

}  // namespace secular
