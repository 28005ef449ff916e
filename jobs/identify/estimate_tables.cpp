#include "jobs/identify/estimate_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "numerics/confidence.hpp"
#include "report/number_format.hpp"

namespace secular {

using report::Column;
using report::Table;
using report::Tone;

namespace {

// Two digits of a number beside the value, however small it is.
std::string share_of(const EstimatedValue& value, double part) {
  return report::format_number(100 * part / std::abs(*value.value), 2) + " %";
}

}  // namespace

void add_cards(report::HtmlReport& page, const Estimate& estimate) {
  int cards = 0;
  for (const EstimatedValue& v : estimate.parameters)
    if (v.value && !v.fixed && v.significant && !v.doubtful && cards < 6) {
      page.card(
          {v.name, report::format_quantity(*v.value, v.sd, v.unit), "sd " + share_of(v, v.sd), Tone::neutral});
      ++cards;
    }
}

void add_values(report::HtmlReport& page, const Estimate& estimate, bool lumps) {
  Table table;
  table.columns = {{lumps ? "Lump" : "Parameter", Column::Kind::text, ""},
                   {"Estimate", Column::Kind::number, ""},
                   {"Unit", Column::Kind::text, ""},
                   {"95 % interval", Column::Kind::text, ""},
                   {"sd / value", Column::Kind::number, ""},
                   {"by noise", Column::Kind::number, ""},
                   {"left open", Column::Kind::number, ""},
                   {"Truncation corrected", Column::Kind::number, ""},
                   {lumps ? "Definition" : "From", Column::Kind::text, ""}};
  for (const EstimatedValue& v : lumps ? estimate.lumps : estimate.parameters) {
    if (lumps && v.from == "not used") continue;
    std::vector<std::string> row{lumps && estimate.cases.size() > 1 ? v.resonance + ":" + v.name : v.name};
    if (v.fixed) {
      row.insert(row.end(),
                 {report::format_number(*v.value, 6), report::pretty_unit(v.unit), "given", "", "", "", ""});
    } else if (v.value) {
      const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
      row.insert(row.end(),
                 {report::format_uncertain(*v.value, v.sd) + (v.doubtful ? " doubtful" : ""),
                  report::pretty_unit(v.unit), report::format_interval(interval.low, interval.high),
                  share_of(v, v.sd), share_of(v, v.noise_sd), share_of(v, v.open_sd), share_of(v, -v.truncation)});
    } else {
      std::string with;
      for (const std::string& other : v.entangled_with) with += (with.empty() ? "" : ", ") + other;
      row.insert(row.end(), {"not identifiable", report::pretty_unit(v.unit),
                             with.empty() ? "" : "entangled with " + with, "", "", "", ""});
    }
    row.push_back(lumps ? v.definition : v.from);
    table.rows.push_back(std::move(row));
    table.row_tones.push_back(
        !v.value ? Tone::caution : (!v.doubtful && (v.fixed || v.significant) ? Tone::neutral : Tone::caution));
  }
  page.table(table);
}

void add_null_directions(report::HtmlReport& page, const Estimate& estimate) {
  if (estimate.null_directions.empty()) return;
  page.section("What these tests leave open");
  Table table;
  table.columns = {{"Parameters", Column::Kind::text, ""},
                   {"What is not noticed", Column::Kind::text, ""},
                   {"What would part them", Column::Kind::text, ""}};
  for (const NullDirection& direction : estimate.null_directions)
    table.rows.push_back({fmt::format("{}", fmt::join(direction.parameters, ", ")), direction.text,
                          direction.parted_by.empty() ? "no case of this model"
                                                      : fmt::format("{}", fmt::join(direction.parted_by, "; "))});
  page.table(table);
}

}  // namespace secular
