#include "blind/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace secular::blind {
namespace {

using nlohmann::json;

constexpr double normal_975 = 1.959963984540054;
constexpr double strong_sigma = 3;

struct Label {
  std::size_t number = 0;
  std::string kind, family;
  double snr_db = 0;
  std::vector<std::string> effects, where;  // of an effect: its mode, or its channel
  std::vector<std::vector<std::string>> same_as;
  std::vector<std::string> disturbances;
  double sigma = 0;  // of the weakest effect
};

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

Label read_label(const json& text) {
  Label label;
  label.number = text.at("case").get<std::size_t>();
  label.kind = text.at("kind").get<std::string>();
  label.family = text.value("family", "");
  label.snr_db = text.at("snr_db").get<double>();
  for (const json& effect : text.at("effects")) {
    label.effects.push_back(effect.at("effect").get<std::string>());
    label.where.push_back(effect.value("mode", ""));
    label.same_as.push_back(effect.at("same_as").get<std::vector<std::string>>());
    const double sigma = effect.at("sigma").get<double>();
    label.sigma = label.effects.size() == 1 ? sigma : std::min(label.sigma, sigma);
  }
  if (text.contains("disturbances"))
    for (const auto& [kind, size] : text.at("disturbances").items()) label.disturbances.push_back(kind);
  return label;
}

// Effects that the data show, so that a diagnosis can be held to them.
bool visible(const Label& label) {
  return label.sigma >= strong_sigma && std::none_of(label.same_as.begin(), label.same_as.end(),
                                                     [](const auto& alike) { return contains(alike, "no_gap"); });
}

bool can_be_told(const Label& label) {
  return visible(label) &&
         std::all_of(label.same_as.begin(), label.same_as.end(), [](const auto& alike) { return alike.empty(); });
}

// An approximate explanation says that it is not all.
bool left_open(const Said& said) {
  return said.verdict == "unknown" || said.verdict == "approximate";
}

bool is_named(const Said& said) {
  return said.verdict == "cause" || said.verdict == "set" || said.verdict == "approximate";
}

// Two faults of a response stand in both lists: wherever they are found counts, unless something else is called the
// cause.
bool listed_as_disturbance(const Said& said, const std::string& effect, const std::string& channel) {
  const std::string kind = effect == "sensor_offset" ? "offset" : effect == "clipping" ? "clipping" : "";
  if (kind.empty() || (said.verdict == "cause" && said.cause != effect)) return false;
  return std::find(said.disturbances.begin(), said.disturbances.end(), std::pair(kind, channel)) !=
         said.disturbances.end();
}

bool names(const Said& said, const std::string& effect, const std::string& where = {}) {
  if (listed_as_disturbance(said, effect, where)) return true;
  return is_named(said) && (said.cause == effect || contains(said.set, effect));
}

double probability_of(const Said& said, const std::string& effect) {
  const auto found = said.probability.find(effect);
  return found == said.probability.end() ? 0 : found->second;
}

bool found_among(const Said& said, const std::string& effect, const std::string& where) {
  return names(said, effect, where) || probability_of(said, effect) >= 0.5;
}

std::string truth_text(const Label& label) {
  if (label.kind == "none") return "no_gap";
  if (label.kind == "outside") return "outside: " + label.effects.front();
  std::string text;
  for (const std::string& effect : label.effects) text += (text.empty() ? "" : " + ") + effect;
  return text;
}

std::string named_text(const Said& said) {
  if (!is_named(said)) return said.verdict;
  return said.cause;
}

// What a campaign's outcome should have been.
bool right(const Label& label, const Said& said) {
  if (said.verdict == "failed") return false;
  if (label.kind == "none") return said.verdict == "no_gap";
  if (!visible(label) && said.verdict == "no_gap") return true;
  if (label.kind == "outside")
    return left_open(said) || std::any_of(label.same_as[0].begin(), label.same_as[0].end(),
                                          [&](const auto& n) { return names(said, n); });
  for (std::size_t e = 0; e < label.effects.size(); ++e)
    if (!found_among(said, label.effects[e], label.where[e])) return false;
  return true;
}

// Counts of a yes-or-no figure.
struct Share {
  std::size_t hits = 0, trials = 0;
  void count(bool hit) {
    if (hit) ++hits;
    ++trials;
  }
  Figure figure(std::string name, std::optional<double> target, bool at_most = false) const {
    Figure f{std::move(name), 0, wilson(hits, trials), trials, target, at_most};
    if (trials > 0) f.value = static_cast<double>(hits) / static_cast<double>(trials);
    return f;
  }
};

// Mean with the 95 % interval of its standard error.
Figure mean_figure(std::string name, const std::vector<double>& values, std::optional<double> target,
                   bool at_most = false) {
  Figure f{std::move(name), 0, {}, values.size(), target, at_most};
  if (values.empty()) return f;
  const double n = static_cast<double>(values.size());
  double squares = 0;
  for (const double x : values) f.value += x / n;
  for (const double x : values) squares += (x - f.value) * (x - f.value);
  const double half = values.size() > 1 ? normal_975 * std::sqrt(squares / (n - 1) / n) : INFINITY;
  f.ci95 = {f.value - half, f.value + half};
  return f;
}

std::vector<CalibrationBin> calibration_of(const std::vector<Label>& labels, const std::vector<Said>& said) {
  std::vector<CalibrationBin> bins(10);
  for (std::size_t b = 0; b < bins.size(); ++b) {
    bins[b].low = static_cast<double>(b) / 10;
    bins[b].high = static_cast<double>(b + 1) / 10;
  }
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (const auto& [effect, probability] : said[i].probability) {
      CalibrationBin& bin = bins[std::min<std::size_t>(9, static_cast<std::size_t>(probability * 10))];
      ++bin.stated;
      bin.mean_stated += probability;
      if (contains(labels[i].effects, effect)) ++bin.right;
    }
  for (CalibrationBin& bin : bins)
    if (bin.stated > 0) bin.mean_stated /= static_cast<double>(bin.stated);
  return bins;
}

// Mean distance of stated probabilities from the shares that were right, weighted by how often they were stated.
Figure calibration_error(const std::vector<CalibrationBin>& bins) {
  double total = 0, error = 0;
  std::size_t stated = 0;
  for (const CalibrationBin& bin : bins) {
    stated += bin.stated;
    total += static_cast<double>(bin.stated);
    error += std::abs(bin.mean_stated * static_cast<double>(bin.stated) - static_cast<double>(bin.right));
  }
  return {"expected calibration error", total > 0 ? error / total : 0, {-INFINITY, INFINITY}, stated, 0.03, true};
}

// A verdict `cause` that is wrong: it names what is neither there nor the same thing to the data.
bool wrong_cause(const Label& label, const Said& said) {
  if (said.verdict != "cause") return false;
  const auto there = [&](const std::string& name) {
    if (label.kind != "outside" && contains(label.effects, name)) return true;
    return std::any_of(label.same_as.begin(), label.same_as.end(),
                       [&](const std::vector<std::string>& alike) { return contains(alike, name); });
  };
  std::vector<std::string> named = said.set;
  named.push_back(said.cause);
  return std::none_of(named.begin(), named.end(), there);
}

// What the figures count, case by case.
class Tally {
 public:
  void count(const Label& label, const Said& s) {
    if (s.seconds > 0) seconds_.push_back(s.seconds);
    if (s.verdict == "cause") wrong_cause_.count(wrong_cause(label, s));
    if (label.kind == "none") {
      false_alarm_.count(s.detected || s.verdict != "no_gap");
      return;
    }
    bool listed = false;
    for (std::size_t e = 0; e < label.effects.size(); ++e)
      listed = listed || listed_as_disturbance(s, label.effects[e], label.where[e]);
    if (visible(label)) detected_.count(s.detected || listed);
    if (label.kind == "outside") {
      if (!can_be_told(label)) return;
      unknown_.count(left_open(s));
      misnamed_.count(s.verdict == "cause" || s.verdict == "set");
    } else if (label.kind == "pair") {
      if (!visible(label)) return;
      const bool both =
          found_among(s, label.effects[0], label.where[0]) && found_among(s, label.effects[1], label.where[1]);
      pairs_.count(both);
      if (label.snr_db == 30) pairs30_.count(both);
    } else {
      count_single(label, s);
    }
  }

  std::vector<Figure> figures() const;

 private:
  void count_single(const Label& label, const Said& s) {
    const std::string& truth = label.effects.front();
    if (s.verdict == "set" && contains(s.set, truth) && s.named_after.contains("proposed") &&
        s.named_after.contains("random")) {
      resolved_.count(s.named_after.at("proposed") == truth);
      resolved_by_chance_.count(s.named_after.at("random") == truth);
    }
    const bool listed = listed_as_disturbance(s, truth, label.where.front());
    (visible(label) ? contained_ : weak_).count(listed || names(s, truth));
    if (visible(label) && !s.verdict_without.empty() && s.explained_by_rest.empty()) {
      unknown_without_.count(s.verdict_without == "unknown" || s.verdict_without == "approximate");
      misnamed_without_.count(s.verdict_without == "cause" || s.verdict_without == "set");
    }
    if (!can_be_told(label)) return;
    const bool first = is_named(s) && s.cause == truth;
    top_[label.snr_db].count(first || listed);
    if (!listed) probability_.push_back(probability_of(s, truth));
    if (!first) return;
    if (s.closed) {
      closed_.push_back(*s.closed);
      if (label.snr_db == 30) closed30_.push_back(*s.closed);
    }
    if (s.placebo_closed) {
      placebo_.push_back(*s.placebo_closed);
      if (label.snr_db == 30) placebo30_.push_back(*s.placebo_closed);
    }
  }

  Share resolved_, resolved_by_chance_, contained_, weak_, false_alarm_, detected_, unknown_, misnamed_, pairs30_,
      pairs_, unknown_without_, misnamed_without_, wrong_cause_;
  std::map<double, Share, std::greater<>> top_;
  std::vector<double> probability_, closed30_, closed_, placebo30_, placebo_, seconds_;
};

std::vector<Figure> Tally::figures() const {
  const std::map<double, double> top_targets = {{40, 0.98}, {20, 0.97}, {10, 0.9}};
  std::vector<Figure> figures;
  figures.push_back(contained_.figure("named cause or its set contains the truth (at least 3 sigma)", 0.95));
  for (const auto& [snr, share] : top_) {
    const auto target = top_targets.find(snr);
    figures.push_back(share.figure(fmt::format("top cause right, where data can tell, {:.0f} dB", snr),
                                   target == top_targets.end() ? std::nullopt : std::optional(target->second)));
  }
  figures.push_back(mean_figure("mean probability put on the true cause, where data can tell", probability_, 0.8));
  figures.push_back(wrong_cause_.figure("verdict `cause` that is wrong, of all such verdicts", 0.02, true));
  figures.push_back(false_alarm_.figure("false alarm on campaigns without a gap", 0.01, true));
  figures.push_back(detected_.figure("gap detected (at least 3 sigma)", 0.99));
  figures.push_back(unknown_.figure("effect outside of the catalogue is called unknown or approximate", 0.9));
  figures.push_back(misnamed_.figure("effect outside of the catalogue is named as another one", 0.05, true));
  figures.push_back(
      unknown_without_.figure("effect left out of the catalogue in turn: called unknown or approximate", 0.9));
  figures.push_back(
      misnamed_without_.figure("effect left out of the catalogue in turn: another one is named", 0.05, true));
  figures.push_back(pairs30_.figure("two effects, both found, 30 dB", 0.7));
  figures.push_back(pairs_.figure("two effects, both found, all noise levels", std::nullopt));
  figures.push_back(mean_figure("of the reducible gap closed, right cause, 30 dB", closed30_, 0.9));
  figures.push_back(
      mean_figure("of the reducible gap closed, right cause, all noise levels", closed_, std::nullopt));
  figures.push_back(mean_figure("the same by a placebo regressor, 30 dB", placebo30_, 0.05, true));
  figures.push_back(mean_figure("the same by a placebo regressor, all noise levels", placebo_, std::nullopt));
  figures.push_back(resolved_.figure("set that holds the truth: one proposed dwell resolves it", 0.8));
  figures.push_back(resolved_by_chance_.figure("the same set: one random dwell resolves it", std::nullopt));
  figures.push_back(weak_.figure("named cause or its set contains the truth (less than 3 sigma)", std::nullopt));
  figures.push_back(mean_figure("wall time of a campaign, s", seconds_, 30, true));
  if (!seconds_.empty())
    figures.push_back({"longest wall time of a campaign, s",
                       *std::max_element(seconds_.begin(), seconds_.end()),
                       {-INFINITY, INFINITY},
                       seconds_.size(),
                       std::nullopt,
                       true});
  return figures;
}

}  // namespace

Interval wilson(std::size_t hits, std::size_t trials) {
  if (trials == 0) return {};
  const double n = static_cast<double>(trials), p = static_cast<double>(hits) / n, z2 = normal_975 * normal_975;
  const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = normal_975 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

Said what_was_said(const json& diagnosis) {
  Said said;
  try {
    const json& gap = diagnosis.at("gap");
    said.detected = gap.at("detected").get<bool>();
    const auto number = [&](const char* key) {
      return gap.contains(key) && gap[key].is_number() ? std::optional(gap[key].get<double>()) : std::nullopt;
    };
    said.closed = number("closed");
    said.placebo_closed = number("placebo_closed");
    const std::string verdict = diagnosis.at("verdict").get<std::string>();
    if (diagnosis.contains("causes"))
      for (const json& cause : diagnosis["causes"]) {
        double& probability = said.probability[cause.at("effect").get<std::string>()];
        probability = std::min(1.0, probability + std::max(0.0, cause.at("probability").get<double>()));
      }
    if (diagnosis.contains("cause") && diagnosis["cause"].is_string())
      said.cause = diagnosis["cause"].get<std::string>();
    double best = -1;
    for (const auto& [effect, probability] : said.probability)
      if (probability > best) {
        best = probability;
        if (said.cause.empty() || verdict != "cause") said.cause = effect;
      }
    if (diagnosis.contains("disturbances"))
      for (const json& found : diagnosis["disturbances"]) {
        said.disturbances.emplace_back(found.at("kind").get<std::string>(), found.value("channel", ""));
      }
    for (const char* key : {"set", "together"})
      if (diagnosis.contains(key) && diagnosis[key].is_array())
        for (const json& name : diagnosis[key])
          said.set.push_back(name.is_string() ? name.get<std::string>() : name.at("effect").get<std::string>());
    static const std::vector<std::string> verdicts = {"no_gap", "cause", "set", "approximate", "unknown"};
    if (contains(verdicts, verdict)) said.verdict = verdict;
  } catch (const json::exception&) {
    said = Said{};
  }
  return said;
}

Score score_of(const json& sealed, const std::vector<Said>& said) {
  std::vector<Label> labels;
  for (const json& label : sealed.at("labels")) labels.push_back(read_label(label));
  Score score;
  score.campaigns = labels.size();
  Tally tally;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Label& label = labels[i];
    const Said& s = said.at(i);
    const bool as_it_should = right(label, s);
    tally.count(label, s);
    ++score.confusion[truth_text(label)][named_text(s)];
    if (s.verdict == "failed") ++score.failed;
    for (const std::string& kind : label.disturbances) {
      ++score.by_disturbance[kind].campaigns;
      if (as_it_should) ++score.by_disturbance[kind].right;
    }
    if (as_it_should) continue;
    std::string named = named_text(s);
    for (const std::string& other : s.set)
      if (s.verdict == "set" && other != s.cause) named += ", " + other;
    score.wrong.push_back(
        {label.number, truth_text(label), named, label.family, label.disturbances, label.sigma, label.snr_db});
  }
  score.figures = tally.figures();
  score.calibration = calibration_of(labels, said);
  score.figures.push_back(calibration_error(score.calibration));
  return score;
}

}  // namespace secular::blind
