#pragma once

#include <string_view>

namespace secular {

/// What the style sheets of all HTML pages begin with: colours by day, by night and on paper, and the letters.
inline constexpr std::string_view page_style = R"css(
:root { color-scheme: light dark; --ink: #1b1f24; --soft: #57606a; --rule: #d5dae0; --page: #ffffff; --panel: #f5f7f9;
  --good: #00795a; --caution: #9a6700; --bad: #b3261e; --accent: #0072b2; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e7eb; --soft: #9aa4af; --rule: #3a424b; --page: #15181c;
  --panel: #1e2329; --good: #3fc79a; --caution: #e3b341; --bad: #ff8a80; --accent: #56b4e9; } }
@media print { :root { color-scheme: light; --ink: #000000; --soft: #444444; --rule: #bbbbbb; --page: #ffffff;
  --panel: #ffffff; --good: #00795a; --caution: #7a5200; --bad: #9b1c15; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink); font: 16px/1.55 Helvetica, Arial, "Liberation Sans",
  sans-serif; }
)css";

}  // namespace secular
