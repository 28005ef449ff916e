#include "blind/estimate_set.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "blind/campaign_work.hpp"
#include "blind/sealed_files.hpp"
#include "input/input_error.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

// In a normal distribution one of 16,000 numbers is as far off.
constexpr double listed_off = 4;
// Beyond this nothing may be off unmarked.
constexpr double largest_off = 6;

fs::path estimate_file(const fs::path& place) {
  return place / "estimate" / "estimate.json";
}

std::optional<std::string> identify_sealed(const fs::path& place, const RunOptions& options) {
  const fs::path out = place / "estimate", log = place / "estimate.log";
  std::error_code ignored;
  fs::remove_all(out, ignored);
  const ProcessEnd ended =
      run_process({.arguments = {options.program.string(), "identify", (place / "campaign").string(), "--model",
                                 (place / "model.toml").string(), "-o", out.string(), "--threads",
                                 std::to_string(threads_of_each(options)), "--quiet"},
                   .log = log,
                   .limit_s = options.limit_s});
  return fault_of(ended, log, options.limit_s);
}

void add(const std::vector<JudgedNumber>& numbers, NumberShare& share) {
  ++share.campaigns;
  for (const JudgedNumber& n : numbers) {
    ++share.asked;
    if (!n.given) continue;
    ++share.given;
    if (n.doubtful) continue;
    ++share.unmarked;
    share.held += n.held;
    share.largest_off = std::max(share.largest_off, std::abs(n.off));
  }
}

Figure share_figure(const std::string& name, std::size_t hits, std::size_t trials, double target) {
  Figure f{.name = name, .value = 0, .ci95 = wilson(hits, trials), .trials = trials, .target = target};
  if (trials > 0) f.value = static_cast<double>(hits) / static_cast<double>(trials);
  return f;
}

std::vector<Figure> figures_of(const NumberShare& all, std::size_t beyond) {
  std::vector<Figure> figures = {
      share_figure("numbers that are given", all.given, all.asked, 0.9),
      share_figure("95 % intervals of unmarked numbers that hold the truth, at least", all.held, all.unmarked,
                   0.93),
      share_figure("95 % intervals of unmarked numbers that hold the truth, at most", all.held, all.unmarked, 0.97),
      share_figure("unmarked numbers off by more than 6 sd", beyond, all.unmarked, 0)};
  figures[2].at_most = figures[3].at_most = true;
  return figures;
}

}  // namespace

Performer identifying(const CampaignWork& work) {
  return [work](std::size_t i) {
    const fs::path place = sealed_folder(work.folder, i + 1);
    return fs::exists(estimate_file(place)) ? kept_before() : done_now(identify_sealed(place, work.how));
  };
}

RunSummary identify_set(const fs::path& folder, const RunOptions& options, const Progress& progress) {
  return run_campaigns(folder, options, "identify", progress);
}

std::vector<JudgedNumber> judged_numbers(std::size_t number, const std::map<std::string, double>& truth,
                                         const nlohmann::json& estimate) {
  std::vector<JudgedNumber> numbers;
  for (const auto& [symbol, value] : truth) {
    JudgedNumber& n = numbers.emplace_back();
    n.number = number;
    n.symbol = symbol;
    n.truth = value;
    if (!estimate.is_object()) continue;
    for (const nlohmann::json& found : estimate.at("estimates")) {
      if (found.at("name") != symbol || !found.contains("value") || !found["value"].is_number()) continue;
      if (!found.contains("sd") || !found["sd"].is_number() || !found.contains("ci95") || !found["ci95"].is_array())
        continue;
      n.given = true;
      n.doubtful = found.value("doubtful", false);
      n.off = (found["value"].get<double>() - value) / found.at("sd").get<double>();
      n.held = found.at("ci95")[0].get<double>() <= value && value <= found["ci95"][1].get<double>();
    }
  }
  return numbers;
}

EstimateScore score_estimates(const fs::path& folder) {
  const nlohmann::json labels = read_labels(folder);
  if (!labels.value("nothing_withheld", false))
    throw InputError(folder.string(), "", "withholds something from its models, so that numbers may be off",
                     "a set made by `secular blind generate --nothing-withheld`");
  EstimateScore score;
  NumberShare all;
  std::size_t beyond = 0;
  for (const nlohmann::json& label : labels.at("labels")) {
    const std::size_t number = label.at("case").get<std::size_t>();
    const fs::path file = estimate_file(sealed_folder(folder, number));
    nlohmann::json estimate;
    if (fs::exists(file))
      estimate = nlohmann::json::parse(read_text(file));
    else
      score.failed.push_back({number, "no estimate.json"});
    const std::vector<JudgedNumber> numbers =
        judged_numbers(number, label.at("numbers").get<std::map<std::string, double>>(), estimate);
    ++score.campaigns;
    add(numbers, all);
    add(numbers, score.by_family[label.at("family").get<std::string>()]);
    const nlohmann::json disturbances = label.value("disturbances", nlohmann::json::object());
    if (disturbances.empty()) add(numbers, score.by_disturbance["none"]);
    for (const auto& [kind, size] : disturbances.items()) add(numbers, score.by_disturbance[kind]);
    for (const JudgedNumber& n : numbers) {
      if (!n.given || n.doubtful || std::abs(n.off) < listed_off) continue;
      score.far_off.push_back(n);
      beyond += std::abs(n.off) > largest_off;
    }
  }
  score.figures = figures_of(all, beyond);
  std::stable_sort(score.far_off.begin(), score.far_off.end(),
                   [](const JudgedNumber& a, const JudgedNumber& b) { return std::abs(a.off) > std::abs(b.off); });
  return score;
}

}  // namespace secular::blind
