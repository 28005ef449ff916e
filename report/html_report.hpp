#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/figure.hpp"

/// One self-contained HTML page: styles, figures and one small script (values under the pointer) inside, nothing
/// fetched, complete without the script; readable on light and dark screens, on a phone and in print. Every text is
/// escaped here: hand over plain text.
namespace secular::report {

enum class Tone { neutral, good, caution, bad };

/// A result at a glance at the top of the report.
struct Card {
  std::string label;  ///< "Natural frequency"
  std::string value;  ///< "77.850(12) rad/s"
  std::string note;   ///< optional: "95 % interval [77.83, 77.87]"
  Tone tone = Tone::neutral;
};

struct Column {
  enum class Kind { text, number };
  std::string heading;
  Kind kind = Kind::text;  ///< number: right-aligned, plain decimals aligned at the point
  std::string unit;        ///< optional, printed below the heading
};

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  ///< each of columns.size() cells
  std::vector<Tone> row_tones;                 ///< empty, or one a row
  std::string caption;                         ///< optional
};

/// Of the program, for reports and --version.
inline constexpr const char* program_version = "secular 0.1.0";

/// How the report came about; printed at its foot. No date: the same input gives the same bytes.
struct Provenance {
  std::string command;              ///< "secular identify out/test --model two_mass_mode1 -o out/report"
  std::string version;              ///< program_version
  std::vector<std::string> inputs;  ///< "campaign: out/test, 24 records", ...
};

/// Rows of a table that stand open on the page.
inline constexpr std::size_t most_open_rows = 24;
/// Tables of so many columns have smaller letters and gaps, so that they fit 1280 px.
inline constexpr std::size_t least_wide_columns = 8;
/// Rows of tables of so many columns stand as lists of their cells, each beside its heading, where the screen is
/// narrower than 640 px.
inline constexpr std::size_t least_stacked_columns = 4;

class HtmlReport {
 public:
  HtmlReport(std::string title, std::string subtitle = {});

  // Above the body, whenever they are called:
  /// What the run found, in one sentence of plain English; the last call counts.
  void verdict(std::string_view sentence, Tone tone = Tone::neutral);
  void card(Card card);
  /// A line of the warnings box; the same text twice is said once, texts that differ in numbers alone are folded.
  void warn(std::string_view text);
  void provenance(Provenance provenance);

  // The body, in the order of the calls:
  void section(std::string_view heading);
  void paragraph(std::string_view text);
  void bullets(const std::vector<std::string>& items);
  /// Equations, commands, file contents: fixed pitch, line breaks kept.
  void preformatted(std::string_view text);
  /// A table of more than `most_open_rows` is a part that the reader unfolds. Throws std::invalid_argument where a
  /// row has not as many cells as there are columns.
  void table(const Table& table);
  /// Draws the figure; one that cannot be drawn leaves a box that says so, and a warning. `caption`: what is shown,
  /// and how to read it.
  void figure(const Figure& figure, std::string_view caption);
  /// A figure that is drawn already: one <svg> element.
  void drawing(std::string_view svg, std::string_view title, std::string_view caption);
  /// A part that the reader unfolds: what `content` adds to this report.
  void details(std::string_view summary, const std::function<void()>& content);

  /// The whole page, UTF-8.
  std::string html() const;
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void add_figure(const RenderedFigure& drawn, std::string_view title, std::string_view caption);

  std::string title_, subtitle_, verdict_, body_;
  Tone verdict_tone_ = Tone::neutral;
  std::vector<Card> cards_;
  std::vector<std::string> warnings_;
  Provenance provenance_;
  std::vector<std::pair<std::string, std::string>> sections_;  ///< id, heading
  int figures_ = 0;
};

}  // namespace secular::report
