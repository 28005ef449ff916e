#include "report/html_report.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <stdexcept>

#include "well_formed.hpp"

namespace secular::report {
namespace {

const std::string hostile = "</p><script>alert('x')</script> & \"q\" \x02";

Figure one_line() {
  Figure figure;
  figure.x = {"Time", "s", false, {}};
  Panel panel;
  Series line;
  line.x = {0, 1};
  line.y = {1, 2};
  panel.series = {line};
  figure.panels = {panel};
  return figure;
}

HtmlReport full_report(const std::string& text) {
  HtmlReport report(text, text);
  report.card({text, text, text, Tone::caution});
  report.warn(text);
  report.section(text);
  report.section("Second");
  report.section("Third");
  report.paragraph(text);
  report.bullets({text, text});
  report.preformatted(text);
  report.table({{{text, Column::Kind::text, text}, {"n", Column::Kind::number, "m/s^2"}},
                {{text, "1.5"}},
                {Tone::bad},
                text});
  report.figure(one_line(), text);
  report.details(text, [&] { report.paragraph(text); });
  report.provenance({text, text, {text}});
  return report;
}

TEST(HtmlReport, EveryTextIsEscaped) {
  const std::string page = full_report(hostile).html();
  EXPECT_EQ(test::first_markup_error(page), "");
  EXPECT_EQ(page.find("<script"), page.rfind("<script"));  // the page's own
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;q&quot; \uFFFD"),
            std::string::npos);
}

TEST(HtmlReport, FetchesNothing) {
  const std::string page = full_report("text").html();
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src\s*=|@import|url\(|<link|<iframe|<object))")));
  const std::regex link(R"re(href=['"]([^'"]*))re");
  for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at)
    EXPECT_TRUE((*at)[1].str().starts_with("#")) << (*at)[1];
}

TEST(HtmlReport, SameContentSameBytes) {
  EXPECT_EQ(full_report("a").html(), full_report("a").html());
}

TEST(HtmlReport, WarningsAreSaidOnceAndAboveTheBody) {
  HtmlReport report("title");
  report.paragraph("body text");
  report.warn("clipping");
  report.warn("clipping");
  EXPECT_EQ(report.warnings().size(), 1u);
  const std::string page = report.html();
  EXPECT_LT(page.find("clipping"), page.find("body text"));
}

// Long names part behind their own marks, a number before what is said of it; on a phone rows of wide tables are
// lists, each cell beside its heading.
TEST(HtmlReport, WideTablesFit) {
  HtmlReport report("title");
  report.table({{{"Lump", Column::Kind::text, ""},
                 {"Estimate", Column::Kind::number, "1/s"},
                 {"File", Column::Kind::text, ""},
                 {"Remark", Column::Kind::text, ""}},
                {{"harmonic_re_v1_A_v1_conjA_v1", "0.22(1) doubtful", "records/0001.csv", "as <it> is"}},
                {},
                ""});
  report.table({{{"n", Column::Kind::number, ""}, {"m", Column::Kind::number, ""}}, {{"1", "2"}}, {}, ""});
  const std::string page = report.html();
  EXPECT_EQ(test::first_markup_error(page), "");
  EXPECT_NE(page.find("harmonic_<wbr>re_<wbr>v1_<wbr>A_<wbr>v1_<wbr>conjA_<wbr>v1</td>"), std::string::npos);
  EXPECT_NE(page.find("data-label=\"Estimate (1/s)\">0.22(1) <wbr>doubtful</td>"), std::string::npos);
  EXPECT_NE(page.find("<td class=\"short\" data-label=\"File\">records/0001.csv</td>"), std::string::npos);
  EXPECT_NE(page.find("as &lt;it&gt; is</td>"), std::string::npos);
  EXPECT_NE(page.find("<td class=\"number\">1</td>"), std::string::npos);  // two columns fit a phone
}

TEST(HtmlReport, DecimalsStandBelowEachOther) {
  HtmlReport report("title");
  report.table({{{"x", Column::Kind::number, ""}}, {{"1.25"}, {"−12"}, {"3.5"}, {""}}, {}, ""});
  const std::string page = report.html();
  EXPECT_NE(page.find(">−12\u2008\u2007\u2007</td>"), std::string::npos);
  EXPECT_NE(page.find(">3.5\u2007</td>"), std::string::npos);
  EXPECT_NE(page.find(">1.25</td>"), std::string::npos);
}

TEST(HtmlReport, ATableRowOfTheWrongLengthThrows) {
  HtmlReport report("title");
  EXPECT_THROW(report.table({{{"x", Column::Kind::text, ""}}, {{"a", "b"}}, {}, ""}), std::invalid_argument);
}

TEST(HtmlReport, AFigureThatCannotBeDrawnBecomesAWarning) {
  ::setenv("SECULAR_GNUPLOT", "/nonexistent/gnuplot", 1);
  HtmlReport report("title");
  report.figure(one_line(), "caption");
  report.figure(one_line(), "caption");
  ::unsetenv("SECULAR_GNUPLOT");
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_NE(report.warnings()[0].find("not installed"), std::string::npos);
  EXPECT_NE(report.html().find("<strong>Figure 2.</strong> caption"), std::string::npos);
}

}  // namespace
}  // namespace secular::report
