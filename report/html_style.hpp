#pragma once

#include <string_view>

namespace secular::report {

/// What the style sheet of a report page holds beside page_style.
inline constexpr std::string_view html_style = R"css(
main { max-width: 1120px; margin: 0 auto; padding: 40px 24px 56px; overflow-wrap: anywhere; }
h1 { font-size: 28px; line-height: 1.2; margin: 0; letter-spacing: -0.01em; }
h2 { font-size: 20px; line-height: 1.3; margin: 44px 0 12px; padding-bottom: 6px; border-bottom: 1px solid var(--rule); }
h3 { font-size: 16px; margin: 28px 0 8px; }
p, ul { margin: 10px 0; max-width: 72ch; }
ul { padding-left: 22px; }
.subtitle { color: var(--soft); margin: 6px 0 0; }
nav { margin: 18px 0 0; font-size: 14px; }
nav a { display: inline-block; max-width: 100%; color: var(--accent); text-decoration: none; margin-right: 18px; }
.verdict { font-size: 19px; line-height: 1.45; max-width: 64ch; margin: 24px 0 0; padding-left: 14px;
  border-left: 4px solid var(--rule); }
.verdict.good { border-left-color: var(--good); } .verdict.caution { border-left-color: var(--caution); }
.verdict.bad { border-left-color: var(--bad); }
.cards { display: flex; flex-wrap: wrap; gap: 12px; margin: 26px 0 8px; }
.card { flex: 1 1 auto; min-width: min(100%, 190px); max-width: 100%; border: 1px solid var(--rule); border-left: 4px solid var(--rule); border-radius: 4px; padding: 11px 14px 12px;
  background: var(--panel); break-inside: avoid; }
.card .label { font-size: 13px; color: var(--soft); }
.card .value { overflow-wrap: anywhere; font-size: min(21px, 4.4vw); font-weight: 600; line-height: 1.35; font-variant-numeric: tabular-nums; }
.card .headline { white-space: nowrap; }
.card .note { font-size: 13px; color: var(--soft); }
.card.good { border-left-color: var(--good); } .card.caution { border-left-color: var(--caution); }
.card.bad { border-left-color: var(--bad); }
.warnings { border: 1px solid var(--caution); border-left-width: 4px; border-radius: 4px; padding: 10px 16px;
  margin: 22px 0 8px; }
.warnings strong { color: var(--caution); }
.warnings ul { margin: 4px 0; max-width: none; }
.warnings details { border: 0; padding: 0; margin: 0; } .warnings summary { font-weight: 400; }
.scroll { overflow-x: auto; margin: 16px 0; }
.scroll:focus-visible, summary:focus-visible, a:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
table { border-collapse: collapse; font-size: 14.5px; line-height: 1.4; }
caption { text-align: left; color: var(--soft); font-size: 14px; padding-bottom: 6px; }
th, td { padding: 6px 14px 6px 0; text-align: left; vertical-align: baseline; }
th { font-weight: 600; border-bottom: 1.5px solid var(--ink); vertical-align: bottom; }
th .unit { display: block; font-weight: 400; color: var(--soft); font-size: 13px; }
td { border-bottom: 1px solid var(--rule); }
th.number, td.number { text-align: right; padding: 6px 22px 6px 10px; }
td { min-width: 5ch; } th { overflow-wrap: normal; }
td.number, td.short { white-space: nowrap; }
td.number { font-variant-numeric: tabular-nums; }
td.name { min-width: 11ch; overflow-wrap: normal; } td wbr { white-space: normal; }
td:not(.number):not(.short):not(.name) { min-width: 24ch; max-width: 60ch; }
@media screen {
  .wide { font-size: 13px; } .wide th, .wide td { padding-right: 10px; }
  .wide th.number, .wide td.number { padding: 6px 10px 6px 2px; }
  .wide td:not(.number):not(.short):not(.name) { min-width: 16ch; }
}
@media screen and (max-width: 640px) {
  table.stacked, .stacked caption, .stacked tbody, .stacked tr, .stacked td { display: block; }
  .stacked thead { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  td:not(.number):not(.short):not(.name) { min-width: 12ch; }
  .stacked tr { border-bottom: 1.5px solid var(--rule); padding: 6px 0; }
  .stacked td[data-label] { display: flow-root; text-align: right; border: 0; padding: 2px 0; min-width: 0; max-width: none;
    white-space: normal; }
  .stacked td[data-label]::before { content: attr(data-label); color: var(--soft); float: left; text-align: left;
    max-width: 40%; margin-right: 14px; }
  .stacked td:empty { display: none; }
}
tr.good td:first-child { color: var(--good); } tr.caution td:first-child { color: var(--caution); }
tr.bad td:first-child { color: var(--bad); }
figure { margin: 22px 0; break-inside: avoid; }
figure .scroll { margin: 0; max-width: 900px; }
figure svg { display: block; width: 100%; height: auto; max-width: var(--width); min-width: min(560px, var(--width)); }
figure svg.fine { min-width: calc(0.9*var(--width)); }
.size { display: none; }
@media screen and (max-width: 640px) {
  main { padding: 28px 16px 44px; }
  figure .scroll:not(:target) svg, figure .scroll:not(:target) svg.fine { min-width: 0; }
  .size { display: inline; white-space: nowrap; } .size a { color: var(--accent); text-decoration: none; }
  .size .whole, .scroll:target ~ figcaption .large { display: none; }
  .scroll:target ~ figcaption .whole { display: inline; }
}
.mark { fill: none; stroke: currentColor; stroke-width: 2; }
.values { display: block; min-height: 1.6em; font-size: 13.5px; color: var(--soft); font-variant-numeric: tabular-nums; }
figcaption { font-size: 14px; color: var(--soft); margin-top: 6px; max-width: 80ch; }
pre { background: var(--panel); border: 1px solid var(--rule); border-radius: 4px; padding: 10px 14px; overflow-x: auto;
  font: 13.5px/1.5 "DejaVu Sans Mono", Menlo, Consolas, monospace; }
details { border: 1px solid var(--rule); border-radius: 4px; padding: 8px 16px; margin: 16px 0; }
summary { cursor: pointer; font-weight: 600; }
footer { margin-top: 56px; padding-top: 12px; border-top: 1px solid var(--rule); font-size: 13.5px; color: var(--soft); }
footer pre { white-space: pre-wrap; overflow-wrap: anywhere; }
@media print {
  body { font-size: 10.5pt; } main { max-width: none; padding: 0; } nav { display: none; }
  h2, h3 { break-after: avoid; } tr { break-inside: avoid; } thead { display: table-header-group; }
  pre { white-space: pre-wrap; } .values { display: none; } .scroll { overflow: visible; }
  details::details-content { content-visibility: visible; block-size: auto; }
  table { font-size: 8pt; } th .unit, caption { font-size: 8pt; } th, td, th.number, td.number { padding: 3px 8px 3px 0; }
  table { width: 100%; } td:not(.number):not(.short):not(.name) { min-width: 0; }
  figure svg, figure svg.fine { min-width: 0; } h2 { margin-top: 24px; }
}
)css";

}  // namespace secular::report
