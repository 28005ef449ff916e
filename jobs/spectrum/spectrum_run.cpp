#include "jobs/spectrum/spectrum_run.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "input/input_error.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/data/frequency_names.hpp"
#include "measure/data/number_range.hpp"
#include "measure/data/recorded_span.hpp"
#include "measure/data/time_axis.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/observe/record_window.hpp"
#include "measure/signal/band_pass.hpp"
#include "measure/signal/modal_filter.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::MatrixXd;

void warn(const SpectrumRequest& request, const std::string& text) {
  if (request.warn) request.warn(text);
}

// The columns of a record, whatever it came from.
struct Columns {
  double start_s = 0, sample_rate_hz = 0;
  std::vector<std::string> names, units;
  std::vector<bool> excitation;
  std::vector<std::vector<double>> values;
  std::vector<std::string> modal_channels, modes;
  MatrixXd shapes;
  std::string source;
};

Columns columns_of_campaign(const SpectrumRequest& request) {
  const Campaign campaign = request.campaign ? *request.campaign : read_campaign(request.source);
  SelectedRecords reader(campaign, request.window);
  std::vector<std::size_t> chosen;
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    if (request.window.takes(r, campaign.records[r].file) && !campaign.records[r].row) chosen.push_back(r);
  if (chosen.empty())
    throw InputError(request.source, "", "has tables of lines alone, which have no samples to analyse",
                     "`secular identify` and `secular predict --measured` read tables");
  const std::string& file = campaign.records[chosen.front()].file;
  if (chosen.size() > 1)
    warn(request,
         fmt::format("{} is analysed, the first of {} records; --records chooses another", file, chosen.size()));
  Record record = reader.read(chosen.front());
  for (const std::string& warning : reader.warnings()) warn(request, warning);
  if (!record.unusable.empty()) {
    const SampleRange usable = range_of(record, request.window);
    cut_record(record, static_cast<std::size_t>(usable.first), static_cast<std::size_t>(usable.count));
  }
  Columns columns;
  columns.source = fmt::format("campaign {}, record {}", campaign.name, file);
  columns.start_s = record.start_s;
  columns.sample_rate_hz = record.sample_rate_hz;
  for (const Channel& channel : campaign.channels) {
    columns.names.push_back(channel.name);
    columns.units.push_back(channel.unit);
    columns.excitation.push_back(channel.role == ChannelRole::excitation);
  }
  columns.values = std::move(record.channels);
  if (campaign.modal_basis) {
    columns.modal_channels = campaign.modal_basis->channels;
    columns.modes = campaign.modal_basis->modes;
    const auto& shapes = campaign.modal_basis->mass_normalised_shapes;
    columns.shapes.resize(static_cast<Index>(shapes.size()), static_cast<Index>(columns.modes.size()));
    for (Index r = 0; r < columns.shapes.rows(); ++r)
      for (Index m = 0; m < columns.shapes.cols(); ++m)
        columns.shapes(r, m) = shapes[static_cast<std::size_t>(r)][static_cast<std::size_t>(m)];
    if (columns.shapes.rows() >= columns.shapes.cols() && !tells_modes_apart(columns.shapes))
      throw InputError((campaign.folder / "campaign.toml").string(), "[modal_basis]",
                       "its mode shapes are not independent", "use channels that tell the modes apart");
  }
  return columns;
}

// What --band leaves of a file's columns.
void filter(Columns& columns, const Window& window) {
  if (!window.band) return;
  require_sampled(window, columns.sample_rate_hz);
  for (std::vector<double>& values : columns.values) {
    const MatrixXd passed = band_pass(Eigen::VectorXd::Map(values.data(), static_cast<Index>(values.size())),
                                      columns.sample_rate_hz, *window.band);
    values.assign(passed.data(), passed.data() + passed.size());
  }
  columns.start_s +=
      static_cast<double>(band_pass_reach(*window.band, columns.sample_rate_hz)) / columns.sample_rate_hz;
}

Columns columns_of_file(const SpectrumRequest& request) {
  DataFile data = read_data_file(request.source);
  if (const std::size_t segments = count_segments(request.source); segments > 1)
    warn(request, fmt::format("{} holds {} segments: this is the first; `secular import` makes a record of each",
                              request.source, segments));
  convert_csv_units(data);
  Columns columns;
  columns.source = "file " + request.source;
  columns.sample_rate_hz = request.sample_rate_hz;
  std::string time = request.time;
  for (const DataVariable& variable : data.variables)
    if (time.empty() && request.sample_rate_hz == 0 && is_called_time(variable.name)) time = variable.name;
  if (!time.empty()) {
    convert_to_seconds(data.vector(time), data.file);
    const TimeAxis axis = even_time_axis(data.vector(time).values, data.file, data.place, {});
    columns.start_s = axis.start_s;
    columns.sample_rate_hz = axis.sample_rate_hz;
  } else if (!(request.sample_rate_hz > 0)) {
    throw InputError(request.source, "", "what its time is, is not known: its variables are " + data.names(),
                     "name the variable with --time NAME, or give --sample-rate HZ");
  }
  const std::size_t length = time.empty() ? 0 : data.vector(time).values.size();
  for (DataVariable& variable : data.variables) {
    if (variable.name == time || !variable.fault.empty()) continue;
    if (length > 0 && variable.values.size() != length) continue;
    columns.names.push_back(variable.name);
    columns.units.push_back(variable.unit);
    columns.excitation.push_back(false);
    columns.values.push_back(std::move(variable.values));
  }
  filter(columns, request.window);
  return columns;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

// Says what stands in the way of a survey, and what would help.
void require_no_obstacle(const SpectrumRequest& request, const RecordSpectrum& record) {
  const Index samples = record.channels.rows(), channels = record.channels.cols();
  const double seconds = static_cast<double>(samples) / record.sample_rate_hz;
  const auto length = [&] {
    const double asked = request.spectral.ensemble_s;
    return asked > 0 ? static_cast<Index>(std::lround(asked * record.sample_rate_hz)) : samples;
  };
  const auto refuse = [&](const std::string& wrong, const std::string& right) {
    throw InputError(request.source, (channels == 1 ? "channel " : "channels ") + joined(record.names), wrong,
                     right);
  };
  switch (obstacle_to_survey(record.channels, record.sample_rate_hz, request.spectral)) {
    case SurveyObstacle::none:
      return;
    case SurveyObstacle::few_samples:
      refuse(fmt::format("{} samples are left", samples), "a spectrum needs 16 or more");
      break;
    case SurveyObstacle::not_finite:
      refuse("a sample is no finite number", "leave it out with --from and --to");
      break;
    case SurveyObstacle::silence:
      refuse("every sample is zero", "choose another --channel, --from or --to");
      break;
    case SurveyObstacle::ensemble:
      refuse(fmt::format("an ensemble of {:g} s does not fit into {:.6g} s", request.spectral.ensemble_s, seconds),
             "one of at least a sample, and no longer than that");
      break;
    case SurveyObstacle::order:
      refuse(fmt::format("{} samples determine {} terms at most", length(),
                         std::max(0, most_terms(length(), request.spectral.offset))),
             "a lower --order or a longer --ensemble");
      break;
    case SurveyObstacle::ensemble_for_delays:
      refuse(fmt::format("an ensemble of {} samples is too short for delay coordinates", length()),
             fmt::format("give a longer --ensemble or fewer channels: {} samples are needed", 8 * channels));
      break;
  }
}

// Indices of the channels that are analysed, which are of one length.
std::vector<std::size_t> chosen_channels(const SpectrumRequest& request, const Columns& columns) {
  std::vector<std::size_t> chosen;
  if (request.channels.empty()) {
    for (std::size_t c = 0; c < columns.names.size(); ++c)
      if (!columns.excitation[c]) chosen.push_back(c);
  }
  for (const std::string& name : request.channels) {
    const auto found = std::find(columns.names.begin(), columns.names.end(), name);
    if (found == columns.names.end())
      throw InputError(request.source, "--channel " + name, "there is no such channel",
                       "the channels are " + joined(columns.names));
    chosen.push_back(static_cast<std::size_t>(found - columns.names.begin()));
  }
  if (chosen.empty()) throw InputError(request.source, "", "has no channel to analyse", "vectors of numbers");
  const std::size_t samples = columns.values[chosen.front()].size();
  for (const std::size_t c : chosen)
    if (columns.values[c].size() != samples)
      throw InputError(request.source, "channel " + columns.names[c],
                       fmt::format("has {} samples, {} has {}", columns.values[c].size(),
                                   columns.names[chosen.front()], samples),
                       "choose channels of one length with --channel");
  return chosen;
}

RecordSpectrum analysed(const SpectrumRequest& request, const Columns& columns) {
  const std::vector<std::size_t> chosen = chosen_channels(request, columns);
  const std::size_t samples = columns.values[chosen.front()].size();
  for (const std::size_t c : chosen)
    require_number_range(columns.values[c], request.source, "channel " + columns.names[c]);
  const auto [first, count] = range_of(columns.start_s, columns.sample_rate_hz, samples, request.window);
  const auto part = [&](std::size_t c) {
    return Eigen::Map<const Eigen::VectorXd>(columns.values[c].data(), static_cast<Index>(samples))
        .segment(first, count);
  };
  if (count < 16)
    throw InputError(request.source, "",
                     fmt::format("has {} samples left of {:.6g} s to {:.6g} s", count, columns.start_s,
                                 columns.start_s + static_cast<double>(samples) / columns.sample_rate_hz),
                     "a spectrum needs 16 or more");
  RecordSpectrum record;
  record.source = columns.source;
  record.sample_rate_hz = columns.sample_rate_hz;
  record.start_s = columns.start_s + static_cast<double>(first) / columns.sample_rate_hz;
  record.channels.resize(count, static_cast<Index>(chosen.size()));
  for (std::size_t c = 0; c < chosen.size(); ++c) {
    record.names.push_back(columns.names[chosen[c]]);
    record.units.push_back(columns.units[chosen[c]]);
    record.channels.col(static_cast<Index>(c)) = part(chosen[c]);
  }
  require_no_obstacle(request, record);
  record.survey = spectral_survey(record.channels, record.sample_rate_hz, request.spectral);
  if (!record.survey.decomposition.determined)
    throw InputError(request.source, (record.names.size() == 1 ? "channel " : "channels ") + joined(record.names),
                     fmt::format("no finite sum of {} terms describes the first ensemble", record.survey.order),
                     "choose another --order, --ensemble, --from or --to");
  record.spectrum = amplitude_spectrum(record.channels, record.sample_rate_hz, record.survey.layout.length);
  const auto drive = std::find(columns.excitation.begin(), columns.excitation.end(), true);
  const auto driver = static_cast<std::size_t>(drive - columns.excitation.begin());
  if (drive != columns.excitation.end() && std::find(chosen.begin(), chosen.end(), driver) == chosen.end() &&
      part(driver).cwiseAbs().maxCoeff() > 0) {
    record.excitation_name = columns.names[driver];
    record.excitation_unit = columns.units[driver];
    record.excitation = part(driver);
    record.excitation_spectrum =
        amplitude_spectrum(record.excitation, record.sample_rate_hz, record.survey.layout.length);
    if (count < fewest_for_relation(request.spectral.arma_order))
      warn(request, fmt::format("the linear relation to {} is left out: it needs {} samples, there are {}",
                                record.excitation_name, fewest_for_relation(request.spectral.arma_order), count));
    else
      for (Index c = 0; c < record.channels.cols(); ++c)
        record.relations.push_back(
            linear_relation(record.excitation, record.channels.col(c), request.spectral.arma_order));
  }
  if (!columns.modes.empty() && columns.modal_channels.size() >= columns.modes.size()) {
    MatrixXd basis(count, static_cast<Index>(columns.modal_channels.size()));
    bool all = true;
    for (std::size_t c = 0; c < columns.modal_channels.size(); ++c) {
      const auto found = std::find(columns.names.begin(), columns.names.end(), columns.modal_channels[c]);
      all = all && found != columns.names.end();
      if (all) basis.col(static_cast<Index>(c)) = part(static_cast<std::size_t>(found - columns.names.begin()));
    }
    if (all) {
      record.modes = columns.modes;
      record.modal = amplitude_spectrum(basis * modal_filter(columns.shapes).transpose(), record.sample_rate_hz,
                                        record.survey.layout.length);
    }
  }
  conclude(record);
  return record;
}

/// Names of the other vectors of a group of steady responses.
constexpr std::string_view response_names[] = {"amplitude", "response", "acceleration", "displacement"};
constexpr std::string_view force_names[] = {"force", "excitation"};

// "FRdata.ForceControl(2).frequency" -> "FRdata.ForceControl", "(2)", "frequency".
struct Member {
  std::string series, level, name;
};
Member member_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos) return {};
  Member member{path.substr(0, dot), "", path.substr(dot + 1)};
  if (member.series.ends_with(')')) {
    const std::size_t open = member.series.rfind('(');
    member.level = member.series.substr(open + 1, member.series.size() - open - 2);
    member.series.resize(open);
  }
  return member;
}

// Steady responses: groups of vectors of one length, one of which is a frequency. Empty if the file holds none.
SteadyTable steady_table(const DataFile& data) {
  SteadyTable table;
  table.source = "file " + data.file;
  std::map<std::string, std::map<std::string, const DataVariable*>> groups;
  std::vector<std::string> order;
  for (const DataVariable& variable : data.variables) {
    const Member member = member_of(variable.name);
    if (member.name.empty() || !variable.fault.empty()) continue;
    const std::string group = variable.name.substr(0, variable.name.rfind('.'));
    if (!groups.contains(group)) order.push_back(group);
    groups[group][member.name] = &variable;
  }
  for (const std::string& group : order) {
    const auto& members = groups[group];
    const auto find = [&](std::span<const std::string_view> names) -> const DataVariable* {
      for (const std::string_view name : names)
        if (const auto found = members.find(std::string(name)); found != members.end()) return found->second;
      return nullptr;
    };
    const DataVariable* frequency = find(frequency_names);
    const DataVariable* response = find(response_names);
    const DataVariable* force = find(force_names);
    if (!frequency || !response || frequency->values.size() < 2 ||
        response->values.size() != frequency->values.size())
      continue;
    const Member member = member_of(frequency->name);
    SteadyLevel level{
        member.level.empty() ? "response" : "level " + member.level, frequency->values, response->values, {}};
    const bool usable = force && force->values.size() == frequency->values.size() &&
                        std::all_of(force->values.begin(), force->values.end(), [](double f) { return f > 0; });
    if (usable) level.force = force->values;
    if (table.series.empty() || table.series.back().first != member.series)
      table.series.push_back({member.series, {}});
    table.series.back().second.push_back(std::move(level));
  }
  return table;
}

// The steady responses of a file whose time is not named.
SteadyTable table_of_file(const SpectrumRequest& request) {
  if (!request.time.empty() || request.sample_rate_hz != 0) return {};
  const std::vector<DataVariable> variables = describe_data_file(request.source);
  const bool frequencies = std::any_of(variables.begin(), variables.end(), [](const DataVariable& v) {
    return v.name.ends_with(".frequency") || v.name.ends_with(".freq") || v.name.ends_with(".f");
  });
  return frequencies ? steady_table(read_data_file(request.source)) : SteadyTable{};
}

}  // namespace

SpectrumRun run_spectrum(const SpectrumRequest& request) {
  SpectrumRun run;
  std::error_code ignored;
  if (request.campaign || fs::is_directory(request.source, ignored)) {
    run.record = analysed(request, columns_of_campaign(request));
    return run;
  }
  if (!fs::exists(request.source, ignored))
    throw InputError(request.source, "", "does not exist",
                     fmt::format("a campaign folder or a {} file was expected", data_formats));
  require_any_record(request.source, request.window);
  run.table = table_of_file(request);
  if (run.table.series.empty()) run.record = analysed(request, columns_of_file(request));
  return run;
}

std::vector<report::NamedFigure> spectrum_figures(const SpectrumRun& run) {
  return run.record ? spectrum_figures(*run.record) : steady_figures(run.table);
}

std::string spectrum_json(const SpectrumRun& run) {
  return run.record ? spectrum_json(*run.record) : steady_table_json(run.table);
}

std::string spectrum_report(const SpectrumRun& run, const std::string& command) {
  return run.record ? spectrum_report(*run.record, command) : steady_table_report(run.table, command);
}

}  // namespace secular
