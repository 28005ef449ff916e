#include "input/markup.hpp"

#include <gtest/gtest.h>

namespace secular {
namespace {

TEST(Markup, TextIsEscaped) {
  EXPECT_EQ(escape_markup("<a href=\"x\">&'</a>\x01"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;&lt;/a&gt;\uFFFD");
  EXPECT_EQ(escape_markup("Gauß α\t\n"), "Gauß α\t\n");
  EXPECT_EQ(escape_markup_line("a\tb\nc"), "a b c");
  EXPECT_EQ(escape_markup("\xC3(\xFF"), "\uFFFD(\uFFFD");
  EXPECT_EQ(code_points("Gauß α"), 6U);
}

}  // namespace
}  // namespace secular
