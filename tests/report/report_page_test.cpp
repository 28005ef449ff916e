#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "page_structure.hpp"
#include "report/cell_map.hpp"
#include "report/html_report.hpp"
#include "report/pairs_plot.hpp"
#include "report/palette.hpp"
#include "report/warning_kinds.hpp"
#include "tests/process_folder.hpp"
#include "well_formed.hpp"

namespace secular::report {
namespace {

namespace fs = std::filesystem;

JointValues three_values() {
  return {{"omega0", "mu1", "alpha3"},
          {"1/s", "1/s", "1/(m^2 s^2)"},
          {231.6, 0.715, 4.9e11},
          {0.026, 0.039, 1.8e10},
          {{1, -0.2, 0.9}, {-0.2, 1, 0.1}, {0.9, 0.1, 1}}};
}

// With all that a page may hold, each as wide as it comes.
std::string page_with_everything() {
  HtmlReport page("Identification of a_model_with_a_long_name", "Campaign with_a_long_name_too, case free");
  page.verdict("The model holds within the scatter of repeats: 6 of 10 parameters have a number.", Tone::good);
  page.card({"alpha3", "4.90(18) × 10¹¹ 1/(m² s²)", "sd 3.8 %", Tone::neutral});
  page.card({"Verdict", "acts like cubic inertia or cubic stiffness, with quadratic stiffness", "", Tone::caution});
  for (int i = 0; i < 30; ++i) page.warn("mode " + std::to_string(i) + " is seen in one window only");
  page.section("Numbers");
  Table wide;
  for (int c = 0; c < 14; ++c) wide.columns.push_back({"Standard deviation", Column::Kind::number, "m/s^2"});
  wide.rows.assign(40, std::vector<std::string>(14, "1.23456(78) × 10⁻³"));
  page.table(wide);
  page.preformatted(std::string(300, 'x'));
  page.section("Figures");
  Figure figure;
  figure.title = "Measured minus computed";
  figure.x = {"Time", "s", false, {}};
  const Series left{"dwell <1>", SeriesStyle::error_bars, SeriesRole::data, {0, 1, 2}, {0.5, -0.5, 0.1}, {1, 1, 1},
                    {}};
  figure.panels = {{"", {"Difference", "m", false, {}}, {left}, true}};
  page.figure(figure, "What is left, with bars of two standard deviations.");
  page.drawing(pairs_plot(three_values(), "Pairs"), "Pairs", "Ellipses hold 68 % and 95 % of each pair.");
  const CellMap map{"Map", "Peak amplitude (m)", "sd", {"v, damping"}, {"1", "2"}, {{0.5, std::nan("")}}};
  page.drawing(cell_map(map), map.title, "Where model and measurement disagree.");
  page.drawing(share_bars({"Rank", {"a", "b"}, {"probability", "closed"}, {{0.9, -0.1}, {0.1, std::nan("")}}}),
               "Rank", "Candidates by falling probability.");
  page.provenance({"secular identify " + std::string(200, 'y'), program_version, {"campaign"}});
  return page.html();
}

TEST(ReportPage, HasAllItsParts) {
  const std::string page = page_with_everything();
  EXPECT_EQ(test::structure_faults(page), std::vector<std::string>());
  EXPECT_EQ(test::first_markup_error(page), "");
}

TEST(ReportPage, WarningsThatDifferInNumbersAloneAreFolded) {
  const std::string page = page_with_everything();
  EXPECT_NE(page.find("30 warnings"), std::string::npos);
  EXPECT_NE(page.find("<summary>30 of this kind, the first: mode 0 is seen"), std::string::npos);
  const auto kinds = warning_kinds({"mode 1 at 2.5e-3 Hz", "mode 12 at -3 Hz", "mode 1 at rest", "mode 7 at 1 Hz"});
  EXPECT_EQ(kinds, (std::vector<std::vector<std::size_t>>{{0, 1, 3}, {2}}));
  // A digit of a name tells things apart; that of a file does not.
  const auto names = warning_kinds({"mu1 moves by 2 %", "mu2 moves by 3 %", "records/dwell_01.csv: left out",
                                    "mu1 moves by 4 %", "records/dwell_02.csv: left out"});
  EXPECT_EQ(names, (std::vector<std::vector<std::size_t>>{{0, 3}, {1}, {2, 4}}));
}

TEST(ReportPage, EveryColourIsReadableInEveryTheme) {
  const auto themes = test::page_colors(page_with_everything());
  ASSERT_TRUE(themes.contains("dark") && themes.contains("print"));
  for (const auto& [theme, colors] : themes) {
    for (const char* text : {"ink", "soft", "good", "caution", "bad", "accent"})
      for (const char* ground : {"page", "panel"})
        EXPECT_GE(test::contrast(colors.at(text), colors.at(ground)), 4.5)
            << theme << ": " << text << " on " << ground;
    for (const PaletteColor& color : palette)
      EXPECT_GE(test::contrast(colors.at(std::string(color.name)), colors.at("page")), 4.5)
          << theme << ": " << color.name;
  }
}

TEST(ReportPage, SeriesTakeTheColoursOfTheTheme) {
  for (const std::string& figure : test::parts_between(page_with_everything(), "<figure>", "</figure>")) {
    EXPECT_EQ(figure.find("rgb("), std::string::npos);
    EXPECT_NE(figure.find("var(--"), std::string::npos);
  }
}

TEST(PairsPlot, AnEllipseHasTheCorrelationsAxes) {
  const std::string svg = pairs_plot(three_values(), "Pairs");
  const auto wide = test::parts_between(svg, "rx=\"", "\""), narrow = test::parts_between(svg, "ry=\"", "\"");
  ASSERT_EQ(wide.size(), 6u);  // two of each pair: 95 % and 68 %
  const auto ratio = [&](std::size_t i) { return std::pow(std::stod(wide[i]) / std::stod(narrow[i]), 2); };
  EXPECT_NEAR(ratio(0), 0.8 / 1.2, 1e-2);  // omega0 and mu1, -0.2: (1 + r)/(1 - r)
  EXPECT_NEAR(ratio(2), 1.9 / 0.1, 0.2);   // omega0 and alpha3, 0.9
  EXPECT_NEAR(std::stod(wide[0]) / std::stod(wide[1]), std::sqrt(std::log(0.05) / std::log(0.32)), 5e-3);
  JointValues wrong = three_values();
  wrong.correlation.pop_back();
  EXPECT_THROW(pairs_plot(wrong, "Pairs"), std::invalid_argument);
}

// What a browser makes of the page.
class ReportInChromium : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
      if (program_.empty() && std::system(("command -v " + std::string(name) + " > /dev/null").c_str()) == 0)
        program_ = name;
    if (program_.empty()) GTEST_SKIP() << "Chromium is not installed: no browser looks at the page";
    std::ofstream(folder_ / "report.html") << page_with_everything();
  }

  // Standard output; standard error is in errors.txt.
  std::string run(const std::string& options) const {
    const std::string command =
        program_ + " --headless --hide-scrollbars --no-sandbox --disable-gpu --allow-file-access-from-files" +
        " --enable-logging=stderr --user-data-dir='" + (folder_ / "profile").string() + "' " + options + " 2> '" +
        (folder_ / "errors.txt").string() + "'";
    std::string output;
    FILE* pipe = ::popen(command.c_str(), "r");
    for (int c = 0; pipe && (c = std::fgetc(pipe)) != EOF;) output += static_cast<char>(c);
    if (pipe) ::pclose(pipe);
    return output;
  }

  std::string errors() const {
    std::ifstream file(folder_ / "errors.txt");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_ = testing_support::process_folder();
  std::string program_;
};

TEST_F(ReportInChromium, NothingOverflowsAndNoScriptFails) {
  std::ofstream(folder_ / "frame.html")
      << R"(<body><iframe src="report.html" style="width:390px;height:800px"></iframe>
<iframe src="report.html" style="width:1280px;height:800px"></iframe><script>onload = () => {
  document.title = [...document.querySelectorAll('iframe')].map((frame) => {
    const page = frame.contentDocument, box = page.querySelector('[data-plot]');
    box.dispatchEvent(new frame.contentWindow.KeyboardEvent('keydown', { key: 'ArrowRight' }));
    const headline = page.querySelector('.headline');
    return [page.documentElement.scrollWidth, headline.getClientRects().length, headline.scrollWidth > headline.clientWidth,
      page.querySelector('.values').textContent].join(' ');
  }).join('; '); };</script></body>)";
  const std::string page = run("--dump-dom 'file://" + (folder_ / "frame.html").string() + "'");
  const auto titles = test::parts_between(page, "<title>", "</title>");
  ASSERT_FALSE(titles.empty()) << page << errors();
  EXPECT_EQ(titles.front(),
            "390 1 false dwell &lt;1&gt;: Time 0 s, Difference 0.5 m; 1280 1 false dwell &lt;1&gt;: Time 0 s, "
            "Difference 0.5 m");
  EXPECT_EQ(errors().find("CONSOLE"), std::string::npos) << errors();
}

// On a phone a figure is seen whole; enlarged it is as wide as its letters need, and scrolls in its box.
TEST_F(ReportInChromium, FiguresFitAPhoneUntilTheyAreEnlarged) {
  std::ofstream(folder_ / "phone.html")
      << R"(<body><iframe src="report.html" style="width:390px;height:800px"></iframe><script>onload = () => {
  const page = document.querySelector('iframe').contentDocument;
  const cut = () => [...page.querySelectorAll('figure .scroll')].filter((box) => box.scrollWidth > box.clientWidth).length;
  const shown = (name) => page.querySelector(name).getClientRects().length;
  const before = [cut(), shown('.size .large'), shown('.size .whole')];
  page.querySelector('.size .large').click();
  setTimeout(() => {
    const after = [cut(), shown('.size .large'), shown('.size .whole'), page.documentElement.scrollWidth];
    document.title = [...before, ...after].join(' '); }, 200); };</script></body>)";
  const std::string page =
      run("--virtual-time-budget=5000 --dump-dom 'file://" + (folder_ / "phone.html").string() + "'");
  const auto titles = test::parts_between(page, "<title>", "</title>");
  ASSERT_FALSE(titles.empty()) << page << errors();
  EXPECT_EQ(titles.front(), "0 1 0 1 0 1 390");
}

TEST_F(ReportInChromium, AScreenshotShowsThePage) {
  const fs::path picture = folder_ / "page.png";
  run("--window-size=1280,900 --screenshot='" + picture.string() + "' 'file://" +
      (folder_ / "report.html").string() + "'");
  ASSERT_TRUE(fs::exists(picture)) << errors();
  EXPECT_GT(fs::file_size(picture), 20000u);  // an empty page has a few thousand
  EXPECT_EQ(errors().find("CONSOLE"), std::string::npos) << errors();
}

}  // namespace
}  // namespace secular::report
