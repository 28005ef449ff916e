#include "report/figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/gnuplot.hpp"
#include "report/series_look.hpp"
#include "tests/process_folder.hpp"
#include "well_formed.hpp"

namespace secular::report {
namespace {

bool gnuplot_is_installed() {
  return run_gnuplot("set terminal svg\nset output\nplot x\n").problem.empty();
}

#define REQUIRE_GNUPLOT() \
  if (!gnuplot_is_installed()) GTEST_SKIP() << "gnuplot is not installed"

/// Sets an environment variable for one test.
class WithEnvironment {
 public:
  WithEnvironment(const char* name, const std::string& value) : name_(name) { ::setenv(name, value.c_str(), 1); }
  WithEnvironment(const WithEnvironment&) = delete;
  WithEnvironment& operator=(const WithEnvironment&) = delete;
  ~WithEnvironment() { ::unsetenv(name_); }

 private:
  const char* name_;
};

Series series(SeriesStyle style, SeriesRole role, std::string name) {
  Series made;
  made.name = std::move(name);
  made.style = style;
  made.role = role;
  for (int i = 0; i < 20; ++i) {
    made.x.push_back(24 + 0.05 * i);
    made.y.push_back(1e-3 * std::sqrt(static_cast<double>(i + 1)));
    if (style == SeriesStyle::error_bars || style == SeriesStyle::band) made.y_error.push_back(5e-5);
  }
  return made;
}

Figure response_figure() {
  Figure figure;
  figure.title = "Frequency response";
  figure.x = {"Excitation frequency", "Hz", false, {}};
  Panel panel;
  panel.y = {"Response amplitude", "m/s^2", false, {}};
  panel.series = {series(SeriesStyle::band, SeriesRole::model, "95 %"),
                  series(SeriesStyle::error_bars, SeriesRole::data, "measured"),
                  series(SeriesStyle::points, SeriesRole::held_out, "held out"),
                  series(SeriesStyle::line, SeriesRole::model, "stable"),
                  series(SeriesStyle::line, SeriesRole::unstable, "unstable")};
  figure.panels = {panel};
  return figure;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// What the first group of the pattern matched, everywhere in the text.
std::vector<std::string> first_groups(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

TEST(Figure, IsWellFormedAndNamesItsAxes) {
  REQUIRE_GNUPLOT();
  const RenderedFigure drawn = render_figure(response_figure(), "fig-1");
  EXPECT_EQ(drawn.problem, "");
  EXPECT_EQ(test::first_markup_error(drawn.svg), "");
  for (const char* text : {"<title>Frequency response</title>", "Excitation frequency (Hz)",
                           "Response amplitude (10⁻³ m/s²)", ">measured<", ">held out<", ">unstable<"})
    EXPECT_NE(drawn.svg.find(text), std::string::npos) << text;
  EXPECT_EQ(drawn.svg.find(">text"), std::string::npos) << "a place holder was left in";
}

TEST(Figure, SameFigureSameBytes) {
  REQUIRE_GNUPLOT();
  const std::string once = render_figure(response_figure(), "fig-1").svg;
  const WithEnvironment locale("LC_ALL", "de_DE.UTF-8");
  EXPECT_EQ(render_figure(response_figure(), "fig-1").svg, once);
  EXPECT_EQ(once.find("GNUPLOT"), std::string::npos);
  EXPECT_EQ(once.find("gnuplot"), std::string::npos);
}

TEST(Figure, IdsCarryThePrefixAndReferencesResolve) {
  REQUIRE_GNUPLOT();
  const std::string svg = render_figure(response_figure(), "fig-7").svg;
  std::set<std::string> ids;
  for (const std::string& id : first_groups(svg, R"re(\bid=['"]([^'"]*)['"])re")) {
    EXPECT_TRUE(id.starts_with("fig-7-")) << id;
    EXPECT_TRUE(ids.insert(id).second) << id << " twice";
  }
  const std::vector<std::string> references = first_groups(svg, "href='#([^']*)'");
  for (const std::string& reference : references) EXPECT_EQ(ids.count(reference), 1u) << reference;
  EXPECT_GE(references.size(), 40u);  // 20 markers of two series
}

TEST(Figure, OneMarkerForEveryDrawablePoint) {
  REQUIRE_GNUPLOT();
  Figure figure = response_figure();
  Series points = series(SeriesStyle::points, SeriesRole::data, "");
  points.y[3] = std::numeric_limits<double>::quiet_NaN();
  points.x[4] = std::numeric_limits<double>::infinity();
  figure.panels[0].series = {points};
  EXPECT_EQ(occurrences(render_figure(figure, "f").svg, "href='#f-pt6' transform='translate"), points.x.size() - 2);
  figure.panels[0].y.logarithmic = true;
  figure.panels[0].series[0].y[5] = -1;
  figure.panels[0].series[0].y[6] = 0;
  EXPECT_EQ(occurrences(render_figure(figure, "f").svg, "href='#f-pt6' transform='translate"), points.x.size() - 4);
}

TEST(Figure, TextFromOutsideIsNeitherRunNorMarkup) {
  REQUIRE_GNUPLOT();
  const std::filesystem::path trap = testing_support::process_folder() / "figure-trap";
  std::filesystem::remove(trap);
  const std::string touch = "touch " + trap.string();
  const std::vector<std::string> attempts = {"\"; system(\"" + touch + "\"); \"",
                                             "'; system('" + touch + "'); '",
                                             "`" + touch + "`",
                                             "\n!" + touch + "\n",
                                             "x' \n system '" + touch + "'\n",
                                             "$(" + touch + ")",
                                             "END_OF_DATA\n!" + touch,
                                             "@GPVAL_TERM {/Symbol a}_1^2 %s \\n \\",
                                             "</text></svg><script>alert(1)</script>",
                                             "text0 text1",
                                             "\xff\xfe\x01 broken"};
  for (const std::string& hostile : attempts) {
    Figure figure = response_figure();
    figure.title = figure.x.label = figure.x.unit = figure.panels[0].title = hostile;
    figure.panels[0].y.label = figure.panels[0].y.unit = figure.panels[0].series[1].name = hostile;
    const RenderedFigure drawn = render_figure(figure, "f");
    EXPECT_EQ(drawn.problem, "") << hostile;
    EXPECT_EQ(test::first_markup_error(drawn.svg), "") << hostile;
    EXPECT_EQ(drawn.svg.find("<script"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(trap)) << hostile;
    std::filesystem::remove(trap);
  }
}

TEST(Figure, TextAppearsAsWritten) {
  REQUIRE_GNUPLOT();
  Figure figure = response_figure();
  figure.panels[0].series[1].name = "a`b' \"c\" <d> & x_1^2 {e} \\n text0";
  EXPECT_NE(render_figure(figure, "f")
                .svg.find("<text>a`b&#39; &quot;c&quot; &lt;d&gt; &amp; x_1^2 {e} \\n text0</text>"),
            std::string::npos);
}

TEST(Figure, StackedPanelsShareTheXAxis) {
  REQUIRE_GNUPLOT();
  Figure figure = response_figure();
  figure.panels.push_back(figure.panels[0]);
  figure.panels[1].y = {"Phase", "rad", false, {}};
  figure.panels.push_back(Panel{"Nothing here", {"Empty", "", false, {}}, {}});
  const RenderedFigure drawn = render_figure(figure, "f");
  EXPECT_EQ(drawn.problem, "");
  EXPECT_EQ(test::first_markup_error(drawn.svg), "");
  EXPECT_EQ(occurrences(drawn.svg, "Excitation frequency (Hz)"), 1u);
  EXPECT_EQ(occurrences(drawn.svg, ">no data<"), 1u);
}

TEST(Figure, DegenerateDataAreDrawn) {
  REQUIRE_GNUPLOT();
  for (const double value : {0.0, 1e-300, -5.0, 1e300})
    for (const bool logarithmic : {false, true}) {
      Figure figure;
      figure.x.logarithmic = logarithmic;
      Panel panel;
      panel.y.logarithmic = logarithmic;
      Series single;
      single.style = SeriesStyle::points;
      single.x = {value, value};
      single.y = {value, value};
      panel.series = {single};
      figure.panels = {panel};
      EXPECT_EQ(render_figure(figure, "f").problem, "") << value << (logarithmic ? " logarithmic" : "");
    }
}

TEST(Figure, LongLinesKeepTheirExtremes) {
  REQUIRE_GNUPLOT();
  Figure figure;
  Panel panel;
  Series line;
  for (int i = 0; i < 200000; ++i) {
    line.x.push_back(i);
    line.y.push_back(i == 123456 ? 100.0 : std::sin(0.1 * i));
  }
  panel.series = {line};
  panel.y.range = {{-5, 105}};
  figure.panels = {panel};
  const std::string svg = render_figure(figure, "f").svg;
  EXPECT_LT(svg.size(), 200000u);
  figure.panels[0].series[0].y[123456] = 0;
  const std::string without_peak = render_figure(figure, "f").svg;
  EXPECT_NE(svg, without_peak);
}

TEST(Figure, MissingGnuplotLeavesAMessage) {
  const WithEnvironment missing("SECULAR_GNUPLOT", "/nonexistent/gnuplot");
  const RenderedFigure drawn = render_figure(response_figure(), "f");
  EXPECT_NE(drawn.problem.find("not installed"), std::string::npos) << drawn.problem;
  EXPECT_NE(drawn.svg.find("could not be drawn"), std::string::npos);
  EXPECT_EQ(test::first_markup_error(drawn.svg), "");
}

TEST(Figure, FailingGnuplotLeavesAMessage) {
  const WithEnvironment failing("SECULAR_GNUPLOT", "/bin/false");
  EXPECT_NE(render_figure(response_figure(), "f").problem.find("failed"), std::string::npos);
}

TEST(Figure, MisuseThrows) {
  Figure figure = response_figure();
  EXPECT_THROW(render_figure(figure, "1f"), std::invalid_argument);
  EXPECT_THROW(render_figure(figure, "a\"b"), std::invalid_argument);
  EXPECT_THROW(render_figure(Figure{}, "f"), std::invalid_argument);
  figure.panels[0].series[0].y.pop_back();
  EXPECT_THROW(render_figure(figure, "f"), std::invalid_argument);
  figure = response_figure();
  figure.x.range = {{1, 1}};
  EXPECT_THROW(render_figure(figure, "f"), std::invalid_argument);
}

TEST(SeriesLooks, TellRolesApart) {
  const std::vector<SeriesLook> looks = series_looks(response_figure().panels[0].series);
  EXPECT_EQ(looks[0].color, looks[3].color) << "a band belongs to its line";
  EXPECT_EQ(looks[3].color, looks[4].color);
  EXPECT_NE(looks[3].dash, looks[4].dash) << "stable and unstable";
  EXPECT_NE(looks[1].color, looks[2].color) << "data and held-out data";
  EXPECT_NE(looks[1].point_type, looks[2].point_type);
}

TEST(SeriesLooks, AGroupSharesColourAndBranchPiecesLookAlike) {
  std::vector<Series> panel = {
      series(SeriesStyle::points, SeriesRole::data, "20"), series(SeriesStyle::points, SeriesRole::data, "25"),
      series(SeriesStyle::line, SeriesRole::model, "model"), series(SeriesStyle::line, SeriesRole::model, "model")};
  std::vector<SeriesLook> looks = series_looks(panel);
  EXPECT_NE(looks[0].color, looks[1].color);
  EXPECT_EQ(looks[2].color, looks[3].color);
  panel[1].group = panel[2].group = 2;
  looks = series_looks(panel);
  EXPECT_EQ(looks[1].color, looks[2].color);
}

}  // namespace
}  // namespace secular::report
