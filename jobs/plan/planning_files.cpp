#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "jobs/plan/planning.hpp"
#include "jobs/shared/json_numbers.hpp"
#include "numerics/hertz.hpp"
#include "report/html_report.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using Json = nlohmann::ordered_json;
using report::Column;
using report::Figure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;
using report::Table;
using report::Tone;

// What the plan aims at, for people.
std::string aim_of(const PlanRequest& request) {
  const std::string names = fmt::format("{}", fmt::join(request.wanted, ", "));
  if (!request.budget_s) return "shortest time for the error bars of " + request.against + ": " + names;
  const char* criterion = request.criterion == DesignCriterion::d   ? "D"
                          : request.criterion == DesignCriterion::a ? "A"
                                                                    : "c";
  return fmt::format("{}-optimal for {} in {:g} s", criterion, names, *request.budget_s);
}

const char* criterion_name(DesignCriterion criterion) {
  return criterion == DesignCriterion::d ? "D" : criterion == DesignCriterion::a ? "A" : "c";
}

Json programme_json(const Programme& programme, const PlanResult& plan) {
  Json dwells = Json::array();
  for (const PlannedDwell& dwell : programme.dwells) {
    Json entry = {{"frequency_hz", dwell.frequency_hz},
                  {"amplitude", dwell.amplitude},
                  {"ensembles", dwell.ensembles},
                  {"settle_s", dwell.settle_s},
                  {"needed_s", finite_json(dwell.needed_s)},
                  {"responds", dwell.responds}};
    Json response = Json::object();
    if (dwell.responds)
      for (std::size_t k = 0; k < plan.model->modes(); ++k)
        response[std::string(plan.model->coordinates[k])] = 2 * std::abs(dwell.candidate.state.amplitude[k]);
    entry["response"] = response;
    dwells.push_back(std::move(entry));
  }
  Json sd = Json::object();
  for (std::size_t u = 0; u < plan.unknowns.names.size(); ++u)
    sd[plan.unknowns.names[u]] = finite_json(programme.sd(static_cast<Eigen::Index>(u)));
  return {{"time_s", programme.time_s},
          {"settled_time_s", finite_json(programme.settled_time_s)},
          {"sd", sd},
          {"dwells", dwells}};
}

std::string minutes(double seconds) {
  return seconds < 600 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.1f} min", seconds / 60);
}

// What drives the dwells: as in the experiment or campaign in use, else the acceleration of a base.
Channel excitation_of(const PlanResult& plan) {
  if (plan.channels)
    for (const Channel& channel : plan.channels->channels)
      if (channel.role == ChannelRole::excitation) return channel;
  return {"base", ChannelRole::excitation, Quantity::acceleration, "m/s^2"};
}

std::string excitation_unit(const PlanResult& plan) {
  return excitation_of(plan).unit;
}

Table dwell_table(const Programme& programme, const PlanResult& plan) {
  Table table;
  table.columns = {{"Frequency", Column::Kind::number, "Hz"},
                   {"Level", Column::Kind::number, excitation_unit(plan)},
                   {"Ensembles", Column::Kind::number, ""},
                   {"Settle", Column::Kind::number, "s"},
                   {"Slowest decay", Column::Kind::number, "1/s"}};
  for (std::size_t k = 0; k < plan.model->modes(); ++k)
    if (!plan.resonance->mode_at_rest[k])
      table.columns.push_back(
          {fmt::format("Peak {}", plan.model->coordinates[k]), Column::Kind::number, plan.coordinate_unit});
  for (const PlannedDwell& dwell : programme.dwells) {
    std::vector<std::string> row = {
        report::format_fixed(dwell.frequency_hz, 4), report::format_number(dwell.amplitude, 4),
        std::to_string(dwell.ensembles), report::format_number(dwell.settle_s, 3),
        dwell.responds ? report::format_number(-dwell.candidate.slowest, 3) : "at rest"};
    for (std::size_t k = 0; k < plan.model->modes(); ++k)
      if (!plan.resonance->mode_at_rest[k])
        row.push_back(dwell.responds ? report::format_number(2 * std::abs(dwell.candidate.state.amplitude[k]), 3)
                                     : "");
    table.rows.push_back(std::move(row));
  }
  return table;
}

// "14 dwells in 597 s determine mu1 to 0.020 % and mu3 to 0.033 % (one standard deviation)."
std::string verdict_of(const PlanResult& plan) {
  std::string known;
  for (std::size_t i = 0; i < plan.wanted.size(); ++i) {
    const Eigen::Index w = plan.wanted[i];
    const double value = plan.unknowns.values(w), sd = plan.plan.sd(w);
    known += (i == 0                        ? ""
              : i + 1 == plan.wanted.size() ? " and "
                                            : ", ") +
             plan.unknowns.names[static_cast<std::size_t>(w)];
    known += !std::isfinite(sd) ? " not at all"
             : value == 0       ? " to " + report::format_number(sd, 2)
                                : " to " + report::format_number(100 * sd / std::abs(value), 2) + " %";
  }
  return fmt::format("{} dwell{} in {} determine {} (one standard deviation).", plan.plan.dwells.size(),
                     plan.plan.dwells.size() == 1 ? "" : "s", minutes(plan.plan.time_s), known);
}

std::string toml_list(const std::vector<double>& values) {
  std::string text;
  for (const double v : values) text += (text.empty() ? "" : ", ") + fmt::format("{}", v);
  return "[" + text + "]";
}

// A number as TOML reads it back as a float.
std::string toml_float(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string channel_toml(const SimulatedChannel& channel) {
  std::string text = fmt::format("name = \"{}\"\nquantity = \"{}\"\nunit = \"{}\"\n", channel.channel.name,
                                 to_string(channel.channel.quantity), channel.channel.unit);
  if (channel.noise_sd > 0) text += "noise_sd = " + toml_float(channel.noise_sd) + "\n";
  if (channel.quantisation > 0) text += "quantisation = " + toml_float(channel.quantisation) + "\n";
  return text;
}

}  // namespace

report::Figure plan_figure(const PlanResult& plan) {
  Figure figure;
  figure.title = "Planned dwells on the predicted responses";
  figure.x = {"Excitation frequency", "Hz", false, {}};
  std::vector<std::size_t> modes;
  for (std::size_t k = 0; k < plan.model->modes(); ++k)
    if (!plan.resonance->mode_at_rest[k]) modes.push_back(k);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    report::Panel panel{
        "",
        {fmt::format("Peak amplitude of {}", plan.model->coordinates[modes[m]]), plan.coordinate_unit, false, {}},
        {}};
    std::map<double, Series> levels;
    for (const DwellCandidate& c : plan.candidates) {
      Series& line = levels[c.state.forcing];
      line.style = SeriesStyle::points;
      line.role = SeriesRole::reference;
      line.group = 0;  // one marker, that of the legend, for all levels
      line.x.push_back(c.state.frequency * to_hz);
      line.y.push_back(2 * std::abs(c.state.amplitude[modes[m]]));
    }
    bool first = true;
    for (auto& [level, line] : levels) {
      if (first && m == 0)
        line.name = fmt::format("stable responses, {:.4g} to {:.4g} {}", levels.begin()->first,
                                levels.rbegin()->first, report::pretty_unit(excitation_unit(plan)));
      first = false;
      panel.series.push_back(std::move(line));
    }
    const auto points = [&](const Programme& programme, SeriesRole role, const std::string& name) {
      Series series;
      series.style = SeriesStyle::points;
      series.role = role;
      series.name = m == 0 ? name : "";
      for (const PlannedDwell& dwell : programme.dwells) {
        if (!dwell.responds) continue;
        series.x.push_back(dwell.frequency_hz);
        series.y.push_back(2 * std::abs(dwell.candidate.state.amplitude[modes[m]]));
      }
      panel.series.push_back(std::move(series));
    };
    if (plan.against) points(*plan.against, SeriesRole::held_out, "in use");
    points(plan.plan, SeriesRole::data, "plan");
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

std::string plan_json(const PlanRequest& request, const PlanResult& plan) {
  Json document;
  document["schema"] = 1;
  document["model"] = plan.model->name;
  document["case"] = plan.resonance->name;
  document["criterion"] = request.budget_s ? Json(criterion_name(request.criterion)) : Json(nullptr);
  document["candidates"] = plan.candidates.size();
  document["wanted"] = Json::array();
  for (const Eigen::Index w : plan.wanted) {
    const auto u = static_cast<std::size_t>(w);
    document["wanted"].push_back({{"name", plan.unknowns.names[u]},
                                  {"value", plan.unknowns.values(w)},
                                  {"unit", plan.units[u]},
                                  {"sd", finite_json(plan.plan.sd(w))},
                                  {"sd_in_use", plan.against ? finite_json(plan.against->sd(w)) : Json(nullptr)}});
  }
  document["units"] = {{"amplitude", excitation_unit(plan)}, {"response", plan.coordinate_unit}};
  document["plan"] = programme_json(plan.plan, plan);
  document["in_use"] = plan.against ? programme_json(*plan.against, plan) : Json(nullptr);
  document["reaches_programme_in_use"] = plan.against ? Json(plan.meets_target) : Json(nullptr);
  document["warnings"] = plan.warnings;
  return document.dump(2) + "\n";
}

std::string plan_report(const PlanRequest& request, const PlanResult& plan, const std::string& command) {
  report::HtmlReport page(fmt::format("Test plan for {}", plan.model->name),
                          fmt::format("Case {}, {}", plan.resonance->name, aim_of(request)));
  for (const std::string& warning : plan.warnings) page.warn(warning);
  page.verdict(verdict_of(plan), plan.against && !plan.meets_target ? Tone::caution : Tone::good);
  page.card({"Laboratory time", minutes(plan.plan.time_s), fmt::format("{} dwells", plan.plan.dwells.size()),
             Tone::neutral});
  if (plan.against) {
    page.card({"In use", minutes(plan.against->time_s), fmt::format("{} dwells", plan.against->dwells.size()),
               Tone::neutral});
    page.card({"Share of its time", report::format_percent(plan.plan.time_s / plan.against->time_s),
               plan.meets_target ? "reaches its error bars" : "does not reach all of its error bars",
               plan.meets_target ? Tone::good : Tone::caution});
  }
  page.section("Predicted error bars");
  Table table;
  table.columns = {{"Parameter", Column::Kind::text, ""},
                   {"Rough value", Column::Kind::number, ""},
                   {"sd, plan", Column::Kind::number, ""},
                   {"sd / value", Column::Kind::number, ""}};
  if (plan.against) {
    table.columns.push_back({"sd, in use", Column::Kind::number, ""});
    table.columns.push_back({"Plan / in use", Column::Kind::number, ""});
  }
  table.columns.push_back({"Unit", Column::Kind::text, ""});
  const std::set<Eigen::Index> wanted(plan.wanted.begin(), plan.wanted.end());
  for (std::size_t i = 0; i < plan.unknowns.names.size(); ++i) {
    const auto u = static_cast<Eigen::Index>(i);
    const double value = plan.unknowns.values(u), sd = plan.plan.sd(u);
    std::vector<std::string> row = {
        plan.unknowns.names[i] + (wanted.count(u) == 1 ? " (wanted)" : ""), report::format_number(value, 5),
        std::isfinite(sd) ? report::format_number(sd, 3) : "not determined",
        std::isfinite(sd) && value != 0 ? report::format_number(100 * sd / std::abs(value), 2) + " %" : ""};
    if (plan.against) {
      const double other = plan.against->sd(u);
      row.push_back(std::isfinite(other) ? report::format_number(other, 3) : "not determined");
      row.push_back(std::isfinite(sd) && std::isfinite(other) ? report::format_number(sd / other, 3) : "");
    }
    row.push_back(report::pretty_unit(plan.units[i]));
    table.rows.push_back(std::move(row));
  }
  page.table(table);
  page.paragraph(
      "First order, from measurement noise and the scatter between dwells that was given: what the expansion's "
      "truncation and effects outside the model add is not in these numbers. All unknowns of the case are "
      "estimated together.");
  page.section("Dwells");
  page.table(dwell_table(plan.plan, plan));
  page.figure(plan_figure(plan), "Every stable response that was a candidate, and the dwells chosen among them.");
  if (plan.against)
    page.paragraph(fmt::format(
        "Time of the programme in use: {} as programmed; {} if every dwell of it settled by the plan's rule (a "
        "disturbance down to {:g} of itself). The plan takes {}.",
        minutes(plan.against->time_s), minutes(plan.against->settled_time_s), request.settled,
        minutes(plan.plan.time_s)));
  page.provenance({command,
                   report::program_version,
                   {"parameters: " + request.parameters,
                    fmt::format("{} candidates at {} frequencies and {} levels", plan.candidates.size(),
                                request.frequencies, request.levels)}});
  return page.html();
}

std::string plan_experiment(const PlanRequest& request, const PlanResult& plan) {
  const CompiledModel& model = *plan.model;
  std::string text = fmt::format(
      "# {}: {:.0f} s of laboratory time. Made by `secular plan`.\nschema = 1\nname = "
      "\"plan\"\nsource = "
      "\"planned from {}\"\nmodel = \"{}\"\nsample_rate_hz = {}\n\n[parameters]\n",
      aim_of(request), plan.plan.time_s, request.parameters, request.model, toml_float(plan.noise.sample_rate_hz));
  for (std::size_t s = 0; s < model.symbols.size(); ++s)
    text +=
        fmt::format("{} = {}\n", model.symbols[s].name, toml_float(plan.parameters(static_cast<Eigen::Index>(s))));
  SimulatedChannel base;
  base.channel = excitation_of(plan);
  base.noise_sd = request.excitation_noise;
  const bool known = plan.sensors && !plan.sensors->excitations.empty();
  text += "\n[excitation]\n" + channel_toml(known ? plan.sensors->excitations.front() : base);
  if (plan.sensors) {
    for (const SimulatedChannel& response : plan.sensors->responses)
      text += "\n[[response]]\n" + channel_toml(response);
    if (plan.sensors->modal_basis) {
      text += "\n[modal_basis]\nmass_normalised_shapes = [";
      bool first = true;
      for (const std::vector<double>& row : plan.sensors->modal_basis->mass_normalised_shapes) {
        text += (first ? "" : ", ") + toml_list(row);
        first = false;
      }
      text += "]\n";
    }
  } else {
    for (const std::string_view coordinate : model.coordinates) {
      SimulatedChannel response;
      response.channel = {std::string(coordinate), ChannelRole::response, Quantity::acceleration, "m/s^2"};
      response.noise_sd = request.noise;
      text += "\n[[response]]\n" + channel_toml(response);
    }
  }
  for (const PlannedDwell& dwell : plan.plan.dwells) {
    std::vector<double> start(dwell.candidate.start.data(),
                              dwell.candidate.start.data() + dwell.candidate.start.size());
    text += fmt::format(
        "\n[[dwell]]\nfrequencies_hz = [{}]\namplitudes = [{}]\nensembles = {}\nensemble_s = {}\nsettle_s = "
        "{}\ninitial_displacement = {}\ngroup = \"plan\"\n",
        toml_float(dwell.frequency_hz), toml_float(dwell.amplitude), dwell.ensembles,
        toml_float(plan.noise.ensemble_s), toml_float(dwell.settle_s), toml_list(start));
  }
  return text;
}

}  // namespace secular
