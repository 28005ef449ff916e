#include "jobs/identify/estimate_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "numerics/confidence.hpp"
#include "numerics/hertz.hpp"
#include "report/number_format.hpp"
#include "report/pairs_plot.hpp"

namespace secular {

using report::Column;
using report::Table;
using report::Tone;

namespace {

// Two digits of a number beside the value, however small it is.
std::string share_of(const EstimatedValue& value, double part) {
  return report::format_number(100 * part / std::abs(*value.value), 2) + " %";
}

// Of a natural frequency.
std::string in_hertz(const EstimatedValue& value) {
  return report::format_quantity(*value.value * to_hz, value.sd * to_hz, "Hz");
}

// Of an error bar that is known and belongs to the joint covariance.
bool has_error(const Estimate& estimate, std::size_t p) {
  const EstimatedValue& v = estimate.parameters[p];
  const auto i = static_cast<Eigen::Index>(p);
  return v.value && !v.fixed && v.sd > 0 && std::isfinite(v.sd) && i < estimate.covariance.rows() &&
         estimate.covariance(i, i) > 0 && std::isfinite(estimate.covariance(i, i));
}

}  // namespace

std::set<std::string> natural_frequencies(const CompiledModel& model) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < model.modes(); ++k) names.emplace(model.symbols[k].name);
  return names;
}

void add_cards(report::HtmlReport& page, const Estimate& estimate, const std::set<std::string>& frequencies) {
  int cards = 0;
  for (const EstimatedValue& v : estimate.parameters)
    if (v.value && !v.fixed && v.significant && !v.doubtful && cards < 6) {
      const bool frequency = frequencies.contains(v.name);
      page.card({v.name, report::format_quantity(*v.value, v.sd, frequency ? "rad/s" : v.unit),
                 (frequency ? in_hertz(v) + ", " : "") + "sd " + share_of(v, v.sd), Tone::neutral});
      ++cards;
    }
}

void add_values(report::HtmlReport& page, const Estimate& estimate, bool lumps,
                const std::set<std::string>& frequencies) {
  Table table;
  table.columns = {{lumps ? "Lump" : "Parameter", Column::Kind::text, ""},
                   {"Estimate", Column::Kind::number, ""},
                   {"Unit", Column::Kind::text, ""},
                   {"95 % interval", Column::Kind::number, ""},
                   {"sd / value", Column::Kind::number, ""},
                   {"by noise", Column::Kind::number, ""},
                   {"left open", Column::Kind::number, ""},
                   {"Truncation corrected", Column::Kind::number, ""},
                   {lumps ? "Definition" : "Remarks", Column::Kind::text, ""}};
  for (const EstimatedValue& v : lumps ? estimate.lumps : estimate.parameters) {
    if (lumps && v.from == "not used") continue;
    std::vector<std::string> row{lumps && estimate.cases.size() > 1 ? v.resonance + ":" + v.name : v.name};
    const bool frequency = frequencies.contains(v.name);
    std::string remark = lumps ? v.definition : v.from;
    const std::string unit = frequency ? "rad/s" : report::pretty_unit(v.unit);
    if (v.fixed) {
      row.insert(row.end(), {report::format_number(*v.value, 6), unit, "given", "", "", "", ""});
    } else if (v.value) {
      const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
      row.insert(row.end(), {report::format_uncertain(*v.value, v.sd) + (v.doubtful ? " doubtful" : ""), unit,
                             report::format_interval(interval.low, interval.high), share_of(v, v.sd),
                             share_of(v, v.noise_sd), share_of(v, v.open_sd), share_of(v, -v.truncation)});
    } else {
      std::string with;
      for (const std::string& other : v.entangled_with) with += (with.empty() ? "" : ", ") + other;
      row.insert(row.end(), {"not identifiable", unit, "", "", "", "", ""});
      if (!with.empty()) remark = "entangled with " + with;
    }
    if (v.value && frequency) remark = in_hertz(v) + "; " + remark;
    row.push_back(remark);
    table.rows.push_back(std::move(row));
    table.row_tones.push_back(
        !v.value ? Tone::caution : (!v.doubtful && (v.fixed || v.significant) ? Tone::neutral : Tone::caution));
  }
  page.table(table);
}

void add_refinement(report::HtmlReport& page, const DecayRefinement& refinement) {
  if (refinement.by_full_equations.size() != refinement.by_modulation.size()) return;
  Table table;
  table.columns = {{"Parameter", Column::Kind::text, ""},
                   {"By the modulation equations", Column::Kind::number, ""},
                   {"By the full equations", Column::Kind::number, ""}};
  const auto text = [](const EstimatedValue& v) {
    return v.value ? report::format_uncertain(*v.value, v.sd) : std::string("not identifiable");
  };
  for (std::size_t p = 0; p < refinement.by_modulation.size(); ++p)
    if (!refinement.by_modulation[p].fixed)
      table.rows.push_back({refinement.by_modulation[p].name, text(refinement.by_modulation[p]),
                            text(refinement.by_full_equations[p])});
  page.details("Both equations side by side", [&] { page.table(table); });
}

void add_following(report::HtmlReport& page, const Identification& id) {
  if (id.following.empty()) return;
  Table table;
  table.columns = {{"Follows from the rest position", Column::Kind::text, ""},
                   {"Estimate", Column::Kind::number, ""}};
  for (const FollowingEstimate& f : id.following) {
    table.rows.push_back({f.name, report::format_uncertain(f.value, f.sd) + (f.doubtful ? " doubtful" : "")});
    table.row_tones.push_back(f.doubtful ? Tone::caution : Tone::neutral);
  }
  page.table(table);
}

void add_pairs(report::HtmlReport& page, const Estimate& estimate, const std::set<std::string>& frequencies) {
  constexpr std::size_t most = 6;
  std::vector<std::size_t> chosen;
  for (std::size_t p = 0; p < estimate.parameters.size() && chosen.size() < most; ++p)
    if (has_error(estimate, p)) chosen.push_back(p);
  if (chosen.size() < 2) return;
  report::JointValues joint;
  double largest = 0;
  std::string closest;
  for (const std::size_t p : chosen) {
    const EstimatedValue& v = estimate.parameters[p];
    joint.names.push_back(v.name);
    joint.units.push_back(frequencies.contains(v.name) ? "rad/s" : v.unit);
    joint.values.push_back(*v.value);
    joint.sd.push_back(v.sd);
    joint.correlation.emplace_back();
    for (const std::size_t q : chosen) {
      const auto i = static_cast<Eigen::Index>(p), j = static_cast<Eigen::Index>(q);
      const double r = estimate.covariance(i, j) / std::sqrt(estimate.covariance(i, i) * estimate.covariance(j, j));
      joint.correlation.back().push_back(r);
      if (p < q && std::abs(r) > std::abs(largest)) {
        largest = r;
        closest = v.name + " and " + estimate.parameters[q].name;
      }
    }
  }
  const std::string title = "Parameters in pairs";
  page.drawing(
      report::pairs_plot(joint, title), title,
      fmt::format("Ellipses hold 68 % and 95 % of each pair, three standard deviations to either side; numbers "
                  "are correlations{}. Widths are the table's standard deviations, with what doubts add to "
                  "them; correlations are those without doubts.",
                  closest.empty()
                      ? ""
                      : fmt::format(", strongest between {}: {}", closest, report::format_fixed(largest, 2))));
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
