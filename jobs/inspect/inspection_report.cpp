#include "jobs/inspect/inspection_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "jobs/inspect/proposed_import.hpp"
#include "jobs/shared/disturbance_output.hpp"
#include "measure/data/names.hpp"
#include "report/html_report.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using report::Column;
using report::Table;
using report::Tone;

constexpr std::size_t most_drawn_records = 8, most_named_records = 3;

std::string plural(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// Records with the most to look at first; those that are drawn, in the campaign's order.
std::vector<const RecordPictures*> drawn(const std::vector<RecordPictures>& pictures,
                                         const std::vector<Disturbance>& disturbances) {
  const auto severity = [&](const RecordPictures& picture) {
    double worst = 0;
    for (const Disturbance& d : disturbances)
      if (d.record == picture.record) worst = std::max(worst, d.share);
    return worst;
  };
  std::vector<const RecordPictures*> order;
  for (const RecordPictures& picture : pictures)
    if (!picture.history.panels.empty()) order.push_back(&picture);
  std::stable_sort(order.begin(), order.end(),
                   [&](const RecordPictures* a, const RecordPictures* b) { return severity(*a) > severity(*b); });
  order.resize(std::min(order.size(), most_drawn_records));
  std::sort(order.begin(), order.end(),
            [](const RecordPictures* a, const RecordPictures* b) { return a->record < b->record; });
  return order;
}

void add_pictures(report::HtmlReport& page, const std::vector<RecordPictures>& pictures,
                  const std::vector<Disturbance>& disturbances, const Campaign& campaign) {
  const std::vector<const RecordPictures*> chosen = drawn(pictures, disturbances);
  if (chosen.empty()) return;
  page.section(chosen.size() == 1 ? "The record" : "Records");
  if (chosen.size() < pictures.size())
    page.paragraph(fmt::format("{} of {} records are drawn, those with the largest disturbances among them.",
                               chosen.size(), pictures.size()));
  if (campaign.channels.size() > most_pictured_channels)
    page.paragraph(
        fmt::format("The first {} of {} channels are drawn.", most_pictured_channels, campaign.channels.size()));
  for (const RecordPictures* picture : chosen) {
    std::string marked;
    for (const Disturbance& d : disturbances)
      if (d.record == picture->record && marked.size() < 300)
        marked +=
            fmt::format(" {}{}: {}.", d.channel ? campaign.channels[*d.channel].name + ", " : "", d.kind, d.text);
    page.figure(picture->history, "Every channel as the file holds it." +
                                      (marked.empty() ? " Nothing beside the motion was found." : marked));
    if (picture->spectrum.panels.empty()) continue;  // of constants
    page.figure(
        picture->spectrum,
        "Peak amplitudes under a window of Blackman and Harris: a tone shows its amplitude at the centre of a "
        "bin. The strongest line is named, the excitation's, and lines that do not belong to the motion.");
  }
}

Table faults_table(const std::vector<std::vector<std::string>>& rows) {
  Table table;
  table.columns = {{"Record", Column::Kind::text, ""},
                   {"Channel", Column::Kind::text, ""},
                   {"Fault", Column::Kind::text, ""},
                   {"What", Column::Kind::text, ""}};
  table.rows = rows;
  return table;
}

std::vector<std::vector<std::string>> fault_rows(const InspectedCampaign& inspected) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t r = 0; r < inspected.records.size(); ++r) {
    const std::string& file = inspected.campaign.records[r].file;
    for (const DataFault& fault : inspected.records[r].faults) rows.push_back({file, "", fault.kind, fault.text});
    for (std::size_t c = 0; c < inspected.records[r].channels.size(); ++c)
      for (const DataFault& fault : inspected.records[r].channels[c].faults)
        rows.push_back({file, inspected.campaign.channels[c].name, fault.kind, fault.text});
  }
  return rows;
}

void add_faults(report::HtmlReport& page, const std::vector<std::vector<std::string>>& rows) {
  page.section("Faults");
  if (rows.empty()) return page.paragraph("None was found.");
  page.paragraph("They are for you to judge; an estimate is not better than its records.");
  page.table(faults_table(rows));
}

Table levels_table(const InspectedCampaign& inspected) {
  Table table;
  table.columns = {{"Record", Column::Kind::text, ""},      {"Kind", Column::Kind::text, ""},
                   {"Duration", Column::Kind::number, "s"}, {"Channel", Column::Kind::text, ""},
                   {"Unit", Column::Kind::text, ""},        {"Mean", Column::Kind::number, ""},
                   {"RMS", Column::Kind::number, ""},       {"Peak", Column::Kind::number, ""},
                   {"Noise", Column::Kind::number, ""}};
  for (std::size_t r = 0; r < inspected.records.size(); ++r) {
    const RecordInspection& record = inspected.records[r];
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
      const ChannelQuality& q = record.channels[c];
      const bool first = c == 0;
      const double seconds = record.axis ? static_cast<double>(record.samples) / record.axis->sample_rate_hz : 0;
      table.rows.push_back({first ? inspected.campaign.records[r].file : "",
                            first ? to_string(inspected.campaign.records[r].kind) : "",
                            first ? report::format_number(seconds, 4) : "", inspected.campaign.channels[c].name,
                            inspected.campaign.channels[c].unit, report::format_number(q.mean, 3),
                            report::format_number(q.rms, 3), report::format_number(q.peak, 3),
                            q.noise ? report::format_number(*q.noise, 2) : ""});
    }
  }
  return table;
}

}  // namespace

std::string record_obstacle(const InspectedCampaign& inspected, std::size_t record) {
  if (inspected.campaign.records[record].row) return {};
  const RecordInspection& found = inspected.records[record];
  if (!found.axis || found.channels.empty())
    return found.faults.empty() ? "no even time" : found.faults.front().text;
  for (std::size_t c = 0; c < found.channels.size(); ++c)
    for (const DataFault& fault : found.channels[c].faults)
      if (fault.kind == "constant" || fault.kind == "range")
        return fmt::format("{}: {}", inspected.campaign.channels[c].name, fault.text);
  return {};
}

std::string usable_sentence(const InspectedCampaign& inspected) {
  std::size_t usable = 0, named = 0;
  std::string why;
  for (std::size_t r = 0; r < inspected.records.size(); ++r) {
    const std::string obstacle = record_obstacle(inspected, r);
    if (obstacle.empty()) ++usable;
    if (obstacle.empty() || ++named > most_named_records) continue;
    why += fmt::format("; {}: {}", inspected.campaign.records[r].file, obstacle);
  }
  if (named > most_named_records) why += fmt::format("; and {} more", named - most_named_records);
  return fmt::format("usable for identify: {} of {}{}", usable, plural(inspected.records.size(), "record"), why);
}

namespace {

void add_experiment(report::HtmlReport& page, const SimulatedFrom& simulated, const Campaign& campaign) {
  page.section("What was simulated");
  Table table;
  table.columns = {{"Channel", Column::Kind::text, ""},
                   {"Role", Column::Kind::text, ""},
                   {"Quantity", Column::Kind::text, ""},
                   {"Unit", Column::Kind::text, ""}};
  for (const Channel& channel : campaign.channels)
    table.rows.push_back(
        {channel.name, to_string(channel.role), to_string(channel.quantity), report::pretty_unit(channel.unit)});
  page.table(table);
  page.paragraph(
      fmt::format("At {:.6g} Hz, with the measurement noise of seed {}. The experiment, {}, as its file has it: "
                  "numbers of the model in "
                  "SI units and radians, amplitudes of excitations and noise in the units of their channels.",
                  campaign.sample_rate_hz, simulated.seed, simulated.experiment));
  page.preformatted(simulated.text);
}

// "16 dwells, 3 free decays, 304 s in all"
std::string kinds_of(const InspectedCampaign& inspected) {
  std::map<std::string, std::size_t> kinds;
  double seconds = 0;
  for (std::size_t r = 0; r < inspected.records.size(); ++r) {
    std::string kind = to_string(inspected.campaign.records[r].kind);
    std::replace(kind.begin(), kind.end(), '_', ' ');
    ++kinds[kind];
    const RecordInspection& record = inspected.records[r];
    if (record.axis) seconds += recorded_s(*record.axis, record.samples);
  }
  std::string text;
  for (const auto& [kind, count] : kinds)
    text += (text.empty() ? "" : ", ") +
            (kind == "broadband" ? plural(count, "broadband record") : plural(count, kind.c_str()));
  return fmt::format("{}, {} s in all", text, report::format_number(seconds, 4));
}

std::string campaign_report(const InspectedCampaign& inspected, const std::string& source,
                            const std::string& command, const SimulatedFrom* simulated) {
  report::HtmlReport page(simulated ? "Simulation" : "Inspection",
                          fmt::format("campaign {}", inspected.campaign.name));
  std::string sentence = usable_sentence(inspected);
  sentence.front() = 'U';
  if (simulated)
    sentence = fmt::format("A virtual test on the full equations of motion of {}: {}. {}", simulated->model,
                           kinds_of(inspected), sentence);
  std::size_t usable = 0;
  for (std::size_t r = 0; r < inspected.records.size(); ++r)
    if (record_obstacle(inspected, r).empty()) ++usable;
  const Tone tone = usable == inspected.records.size() ? Tone::good : usable > 0 ? Tone::caution : Tone::bad;
  page.verdict(sentence + ".", tone);
  page.card({"Usable records", fmt::format("{} of {}", usable, inspected.records.size()), "", tone});
  const auto faults = fault_rows(inspected);
  page.card({"Faults to judge", std::to_string(faults.size()), "", faults.empty() ? Tone::good : Tone::caution});
  std::set<std::size_t> disturbed;
  for (const Disturbance& d : inspected.disturbances) disturbed.insert(d.record);
  page.card({"Records with disturbances", fmt::format("{} of {}", disturbed.size(), inspected.records.size()),
             "identify and diagnose look for the same", disturbed.empty() ? Tone::good : Tone::caution});
  if (simulated) add_experiment(page, *simulated, inspected.campaign);
  add_faults(page, faults);
  if (!inspected.disturbances.empty()) {
    page.section("Beside the motion");
    add_disturbances(page, inspected.disturbances, inspected.campaign);
  }
  add_pictures(page, inspected.pictures, inspected.disturbances, inspected.campaign);
  if (const Table levels = levels_table(inspected); !levels.rows.empty()) {
    page.section("Levels");
    page.paragraph(
        "RMS: about the mean. Noise: RMS of the white noise that the upper half of the spectrum would allow.");
    page.table(levels);
  }
  page.provenance({command, report::program_version, {source}});
  return page.html();
}

std::string file_report(const InspectedFile& inspected, const std::string& path, const std::string& command) {
  const std::string source = "file: " + path, import_command = proposed_import(path, inspected.file);
  report::HtmlReport page("Inspection", source);
  const FileInspection& file = inspected.file;
  std::vector<std::vector<std::string>> faults;
  for (const DataFault& fault : file.faults) faults.push_back({"", file.time, fault.kind, fault.text});
  Table table;
  table.columns = {{"Variable", Column::Kind::text, ""},
                   {"Unit", Column::Kind::text, ""},
                   {"Mean", Column::Kind::number, ""},
                   {"RMS", Column::Kind::number, ""},
                   {"Peak", Column::Kind::number, ""},
                   {"Noise", Column::Kind::number, ""},
                   {"No channel, because it", Column::Kind::text, ""}};
  for (const VariableInspection& variable : file.variables) {
    table.rows.push_back({variable.name, variable.unit.empty() ? variable.stated_unit : variable.unit, "", "", "",
                          "", variable.fault});
    if (!variable.quality) continue;
    const ChannelQuality& q = *variable.quality;
    std::vector<std::string>& row = table.rows.back();
    row[2] = report::format_number(q.mean, 3);
    row[3] = report::format_number(q.rms, 3);
    row[4] = report::format_number(q.peak, 3);
    row[5] = q.noise ? report::format_number(*q.noise, 2) : "";
    for (const DataFault& fault : q.faults) faults.push_back({"", variable.name, fault.kind, fault.text});
  }
  const bool ready = file.axis && !import_command.empty();
  page.verdict(ready ? fmt::format("It can be imported: {} beside the time, at {} Hz.",
                                   plural(inspected.campaign.channels.size(), "variable"),
                                   report::format_number(file.axis->sample_rate_hz, 6))
               : import_command.empty()
                   ? "Nothing in it can be a channel."
                   : "It can be imported once its sampling rate is known: it holds no even time.",
               ready ? Tone::good : Tone::caution);
  page.card({"Faults to judge", std::to_string(faults.size()), "", faults.empty() ? Tone::good : Tone::caution});
  page.card({"Disturbances", std::to_string(inspected.disturbances.size()), "",
             inspected.disturbances.empty() ? Tone::good : Tone::caution});
  if (!import_command.empty()) page.preformatted(import_command);
  add_faults(page, faults);
  if (!inspected.disturbances.empty()) {
    page.section("Beside the motion");
    add_disturbances(page, inspected.disturbances, inspected.campaign);
  }
  add_pictures(page, inspected.pictures, inspected.disturbances, inspected.campaign);
  page.section("Variables");
  page.table(table);
  page.provenance({command, report::program_version, {source}});
  return page.html();
}

}  // namespace

std::vector<report::NamedFigure> inspection_figures(const Inspection& inspected) {
  std::vector<report::NamedFigure> figures;
  for (const RecordPictures& pictures :
       inspected.campaign ? inspected.campaign->pictures : inspected.file->pictures) {
    const std::string number = std::to_string(pictures.record + 1);
    figures.push_back({"history_" + number, pictures.history, ""});
    if (!pictures.spectrum.panels.empty()) figures.push_back({"spectrum_" + number, pictures.spectrum, ""});
  }
  return figures;
}

std::string inspection_report(const Inspection& inspected, const std::string& command,
                              const SimulatedFrom* simulated) {
  return inspected.campaign
             ? campaign_report(*inspected.campaign, "campaign: " + inspected.path, command, simulated)
             : file_report(*inspected.file, inspected.path, command);
}

}  // namespace secular
