#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "blind/estimate_set.hpp"
#include "blind/sealed_files.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

ordered_json shares_json(const std::map<std::string, NumberShare>& shares) {
  ordered_json all = ordered_json::object();
  for (const auto& [name, s] : shares)
    all[name] = {{"cases", s.campaigns},   {"numbers", s.asked}, {"given", s.given},
                 {"unmarked", s.unmarked}, {"held", s.held},     {"largest_off_sd", s.largest_off}};
  return all;
}

std::string shares_markdown(const std::string& what, const std::map<std::string, NumberShare>& shares) {
  std::string text = fmt::format(
      "\n| {} | campaigns | numbers | given | unmarked | intervals that hold | 95 % interval | furthest off, sd "
      "|\n|---|---|---|---|---|---|---|---|\n",
      what);
  for (const auto& [name, s] : shares) {
    const Interval ci = wilson(s.held, s.unmarked);
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {:.3f} to {:.3f} | {:.1f} |\n", name, s.campaigns, s.asked,
                        s.given, s.unmarked, s.held, ci.low, ci.high, s.largest_off);
  }
  return text;
}

}  // namespace

void write_estimate_score(const EstimateScore& score, const std::string& set_name, const fs::path& page) {
  ordered_json far = ordered_json::array(), failed = ordered_json::array();
  std::string text = fmt::format(
      "# Numbers of `identify`: {}\n\n{} campaigns, {} without an estimate. Numbers of one campaign go together: "
      "intervals "
      "of shares take them for independent and are too short.\n\n",
      set_name, score.campaigns, score.failed.size());
  text += figures_markdown(score.figures, "numbers");
  text += "\nA campaign bears up to three disturbances; it counts for each of them.\n";
  text += shares_markdown("disturbance", score.by_disturbance) + shares_markdown("family", score.by_family);
  text +=
      "\n## Unmarked numbers off by more than 4 sd\n\n| campaign | symbol | truth | off, sd |\n|---|---|---|---|\n";
  for (const JudgedNumber& n : score.far_off) {
    text += fmt::format("| {} | {} | {:.6g} | {:+.1f} |\n", n.number, n.symbol, n.truth, n.off);
    far.push_back({{"case", n.number}, {"symbol", n.symbol}, {"truth", n.truth}, {"off_sd", n.off}});
  }
  if (!score.failed.empty()) text += "\n## Campaigns without an estimate\n\n";
  for (const FailedCampaign& f : score.failed) {
    text += fmt::format("- {}: {}\n", f.number, f.reason);
    failed.push_back({{"case", f.number}, {"reason", f.reason}});
  }
  make_folder(page);
  write_text(page / "estimates.md", text);
  write_text(page / "estimates.json", ordered_json{{"schema", 1},
                                                   {"cases", score.campaigns},
                                                   {"failed", failed},
                                                   {"figures", figures_json(score.figures)},
                                                   {"disturbances", shares_json(score.by_disturbance)},
                                                   {"families", shares_json(score.by_family)},
                                                   {"far_off", far}}
                                              .dump(1) +
                                          "\n");
}

}  // namespace secular::blind
