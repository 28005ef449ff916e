#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "blind/score.hpp"

namespace secular::blind {
namespace {

using nlohmann::ordered_json;

std::string number_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.3f}", value) : "";
}

std::string verdict_of(const Figure& f) {
  if (!f.target || f.trials == 0) return "";
  if (f.at_most ? f.value <= *f.target : f.value >= *f.target) return "met";
  const bool within = f.at_most ? f.ci95.low <= *f.target : f.ci95.high >= *f.target;
  return within ? "missed, target within the interval" : "missed";
}

ordered_json finite_or_null(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

std::string disturbances_markdown(const Score& score) {
  if (score.by_disturbance.empty()) return "";
  std::string text =
      "\n## Disturbances\n\nA campaign bears up to three; it counts for each of them.\n\n"
      "| disturbance | campaigns | as they should be | 95 % interval |\n|---|---|---|---|\n";
  for (const auto& [kind, share] : score.by_disturbance) {
    const Interval ci = wilson(share.right, share.campaigns);
    text +=
        fmt::format("| {} | {} | {} | {:.3f} to {:.3f} |\n", kind, share.campaigns, share.right, ci.low, ci.high);
  }
  return text;
}

std::string wrong_markdown(const Score& score) {
  std::string text =
      "\n## Campaigns that went wrong\n\n| campaign | family | truth | sigma | SNR, dB | disturbances | named "
      "|\n|---|---|---|---|---|---|---|\n";
  for (const WrongCampaign& w : score.wrong)
    text += fmt::format("| {} | {} | {} | {:.1f} | {:.0f} | {} | {} |\n", w.number, w.family, w.truth, w.sigma,
                        w.snr_db, fmt::join(w.disturbances, ", "), w.named);
  return text;
}

}  // namespace

ordered_json figures_json(const std::vector<Figure>& figures) {
  ordered_json all = ordered_json::array();
  for (const Figure& f : figures)
    all.push_back({{"name", f.name},
                   {"value", f.trials > 0 ? finite_or_null(f.value) : ordered_json(nullptr)},
                   {"ci95", {finite_or_null(f.ci95.low), finite_or_null(f.ci95.high)}},
                   {"trials", f.trials},
                   {"target", f.target ? ordered_json(*f.target) : ordered_json(nullptr)},
                   {"at_most", f.at_most}});
  return all;
}

std::string figures_markdown(const std::vector<Figure>& figures, const std::string& trials) {
  std::string text =
      fmt::format("| figure | value | 95 % interval | {} | target | |\n|---|---|---|---|---|---|\n", trials);
  for (const Figure& f : figures) {
    const std::string interval = std::isfinite(f.ci95.low) && std::isfinite(f.ci95.high) && f.trials > 0
                                     ? fmt::format("{:.3f} to {:.3f}", f.ci95.low, f.ci95.high)
                                     : "";
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} |\n", f.name, f.trials > 0 ? number_text(f.value) : "", interval, f.trials,
        f.target ? fmt::format("{} {}", f.at_most ? "at most" : "at least", *f.target) : "", verdict_of(f));
  }
  return text;
}

ordered_json score_json(const Score& score) {
  ordered_json bins = ordered_json::array(), wrong = ordered_json::array();
  for (const CalibrationBin& b : score.calibration)
    bins.push_back({{"low", b.low},
                    {"high", b.high},
                    {"mean_stated", b.mean_stated},
                    {"stated", b.stated},
                    {"right", b.right}});
  for (const WrongCampaign& w : score.wrong)
    wrong.push_back({{"case", w.number},
                     {"truth", w.truth},
                     {"named", w.named},
                     {"family", w.family},
                     {"disturbances", w.disturbances},
                     {"sigma", w.sigma},
                     {"snr_db", w.snr_db}});
  ordered_json disturbed = ordered_json::object();
  for (const auto& [kind, share] : score.by_disturbance)
    disturbed[kind] = {{"cases", share.campaigns}, {"right", share.right}};
  return {{"schema", 1},
          {"cases", score.campaigns},
          {"failed", score.failed},
          {"figures", figures_json(score.figures)},
          {"confusion", score.confusion},
          {"calibration", bins},
          {"disturbances", disturbed},
          {"wrong", wrong}};
}

std::string score_markdown(const Score& score, const std::string& set_name) {
  std::string text = fmt::format("# Blind check: {}\n\n{} campaigns, {} without a diagnosis.\n\n## Figures\n\n",
                                 set_name, score.campaigns, score.failed);
  text += figures_markdown(score.figures, "campaigns");
  text += "\n## Truth and what was named\n\nThe named cause is the one of the largest probability.\n\n";
  text += "| truth | campaigns | named (campaigns) |\n|---|---|---|\n";
  for (const auto& [truth, row] : score.confusion) {
    std::vector<std::pair<std::string, std::size_t>> named(row.begin(), row.end());
    std::stable_sort(named.begin(), named.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::size_t total = 0;
    std::string list;
    for (const auto& [name, count] : named) {
      total += count;
      list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", name, count);
    }
    text += fmt::format("| {} | {} | {} |\n", truth, total, list);
  }
  text += "\n## Calibration\n\n![stated probability against the share that was right](calibration.svg)\n\n";
  text += "| stated | times | mean stated | right | 95 % interval |\n|---|---|---|---|---|\n";
  for (const CalibrationBin& b : score.calibration) {
    if (b.stated == 0) continue;
    const Interval ci = wilson(b.right, b.stated);
    text +=
        fmt::format("| {:.1f} to {:.1f} | {} | {:.3f} | {:.3f} | {:.3f} to {:.3f} |\n", b.low, b.high, b.stated,
                    b.mean_stated, static_cast<double>(b.right) / static_cast<double>(b.stated), ci.low, ci.high);
  }
  return text + disturbances_markdown(score) + wrong_markdown(score);
}

std::string calibration_svg(const std::vector<CalibrationBin>& bins) {
  constexpr double side = 320, left = 56, top = 16;
  const auto x = [&](double p) { return left + side * p; };
  const auto y = [&](double p) { return top + side * (1 - p); };
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"12\" role=\"img\">\n<title>Stated probability against the share that "
      "was "
      "right</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      left + side + 24, top + side + 56);
  for (int tick = 0; tick <= 5; ++tick) {
    const double p = tick / 5.0;
    svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {4:.1f}H{5:.1f}\" stroke=\"#ddd\"/>\n", x(p),
                       y(0), y(1), x(0), y(p), x(1));
    svg +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.1f}</text>\n", x(p), y(0) + 18, p);
    svg +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.1f}</text>\n", x(0) - 6, y(p) + 4, p);
  }
  svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#888\" stroke-dasharray=\"4 4\"/>\n", x(0),
                     y(0), x(1), y(1));
  for (const CalibrationBin& b : bins) {
    if (b.stated == 0) continue;
    const Interval ci = wilson(b.right, b.stated);
    const double share = static_cast<double>(b.right) / static_cast<double>(b.stated);
    svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#0072b2\" stroke-width=\"1.5\"/>\n",
                       x(b.mean_stated), y(ci.low), y(ci.high));
    svg +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#0072b2\"/>\n", x(b.mean_stated), y(share));
  }
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">stated probability</text>\n", x(0.5),
                     y(0) + 40);
  svg += fmt::format(
      "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" text-anchor=\"middle\">share that was "
      "right</text>\n",
      x(0) - 40, y(0.5));
  return svg + "</svg>\n";
}

}  // namespace secular::blind
