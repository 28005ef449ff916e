#include <fmt/format.h>

#include <CLI/App.hpp>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/selection_options.hpp"
#include "app/spectrum/spectrum_report.hpp"
#include "input/input_error.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/frequency_names.hpp"
#include "measure/data/number_range.hpp"
#include "measure/data/recorded_span.hpp"
#include "measure/data/time_axis.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/observe/observation_set.hpp"
#include "measure/observe/record_window.hpp"
#include "measure/signal/band_pass.hpp"
#include "measure/signal/modal_filter.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::MatrixXd;

struct SpectrumArguments {
  std::string source, time;
  OutputFolder output{{"spectrum.json", "report.html"}};
  SelectionOptions selection;
  Window window;
  std::vector<std::string> channels;
  double sample_rate_hz = 0;
  SpectralOptions spectral;
  bool json = false;
};

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

Columns columns_of_campaign(const SpectrumArguments& options) {
  const Campaign campaign = read_campaign(options.source);
  SelectedRecords reader(campaign, options.window);
  std::vector<std::size_t> chosen;
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    if (options.window.takes(r, campaign.records[r].file) && !campaign.records[r].row) chosen.push_back(r);
  if (chosen.empty())
    throw InputError(options.source, "", "has tables of lines alone, which have no samples to analyse",
                     "`secular identify` and `secular predict --measured` read tables");
  const std::string& file = campaign.records[chosen.front()].file;
  if (chosen.size() > 1)
    print_warning(
        fmt::format("{} is analysed, the first of {} records; --records chooses another", file, chosen.size()));
  Record record = reader.read(chosen.front());
  print_warnings(reader.warnings());
  if (!record.unusable.empty()) {
    const SampleRange usable = range_of(record, options.window);
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

Columns columns_of_file(const SpectrumArguments& options) {
  DataFile data = read_data_file(options.source);
  if (const std::size_t segments = count_segments(options.source); segments > 1)
    print_warning(fmt::format("{} holds {} segments: this is the first; `secular import` makes a record of each",
                              options.source, segments));
  convert_csv_units(data);
  Columns columns;
  columns.source = "file " + options.source;
  columns.sample_rate_hz = options.sample_rate_hz;
  std::string time = options.time;
  for (const DataVariable& variable : data.variables)
    if (time.empty() && options.sample_rate_hz == 0 && is_called_time(variable.name)) time = variable.name;
  if (!time.empty()) {
    convert_to_seconds(data.vector(time), data.file);
    const TimeAxis axis = even_time_axis(data.vector(time).values, data.file, data.place, {});
    columns.start_s = axis.start_s;
    columns.sample_rate_hz = axis.sample_rate_hz;
  } else if (!(options.sample_rate_hz > 0)) {
    throw InputError(options.source, "", "what its time is, is not known: its variables are " + data.names(),
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
  filter(columns, options.window);
  return columns;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

// Says what stands in the way of a survey, and what would help.
void require_no_obstacle(const SpectrumArguments& options, const RecordSpectrum& record) {
  const Index samples = record.channels.rows(), channels = record.channels.cols();
  const double seconds = static_cast<double>(samples) / record.sample_rate_hz;
  const auto length = [&] {
    const double asked = options.spectral.ensemble_s;
    return asked > 0 ? static_cast<Index>(std::lround(asked * record.sample_rate_hz)) : samples;
  };
  const auto refuse = [&](const std::string& wrong, const std::string& right) {
    throw InputError(options.source, (channels == 1 ? "channel " : "channels ") + joined(record.names), wrong,
                     right);
  };
  switch (obstacle_to_survey(record.channels, record.sample_rate_hz, options.spectral)) {
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
      refuse(fmt::format("an ensemble of {:g} s does not fit into {:.6g} s", options.spectral.ensemble_s, seconds),
             "one of at least a sample, and no longer than that");
      break;
    case SurveyObstacle::order:
      refuse(fmt::format("{} samples determine {} terms at most", length(),
                         std::max(0, most_terms(length(), options.spectral.offset))),
             "a lower --order or a longer --ensemble");
      break;
    case SurveyObstacle::ensemble_for_delays:
      refuse(fmt::format("an ensemble of {} samples is too short for delay coordinates", length()),
             fmt::format("give a longer --ensemble or fewer channels: {} samples are needed", 8 * channels));
      break;
  }
}

// Indices of the channels that are analysed, which are of one length.
std::vector<std::size_t> chosen_channels(const SpectrumArguments& options, const Columns& columns) {
  std::vector<std::size_t> chosen;
  if (options.channels.empty()) {
    for (std::size_t c = 0; c < columns.names.size(); ++c)
      if (!columns.excitation[c]) chosen.push_back(c);
  }
  for (const std::string& name : options.channels) {
    const auto found = std::find(columns.names.begin(), columns.names.end(), name);
    if (found == columns.names.end())
      throw InputError(options.source, "--channel " + name, "there is no such channel",
                       "the channels are " + joined(columns.names));
    chosen.push_back(static_cast<std::size_t>(found - columns.names.begin()));
  }
  if (chosen.empty()) throw InputError(options.source, "", "has no channel to analyse", "vectors of numbers");
  const std::size_t samples = columns.values[chosen.front()].size();
  for (const std::size_t c : chosen)
    if (columns.values[c].size() != samples)
      throw InputError(options.source, "channel " + columns.names[c],
                       fmt::format("has {} samples, {} has {}", columns.values[c].size(),
                                   columns.names[chosen.front()], samples),
                       "choose channels of one length with --channel");
  return chosen;
}

RecordSpectrum analysed(const SpectrumArguments& options, const Columns& columns) {
  const std::vector<std::size_t> chosen = chosen_channels(options, columns);
  const std::size_t samples = columns.values[chosen.front()].size();
  for (const std::size_t c : chosen)
    require_number_range(columns.values[c], options.source, "channel " + columns.names[c]);
  const auto [first, count] = range_of(columns.start_s, columns.sample_rate_hz, samples, options.window);
  const auto part = [&](std::size_t c) {
    return Eigen::Map<const Eigen::VectorXd>(columns.values[c].data(), static_cast<Index>(samples))
        .segment(first, count);
  };
  if (count < 16)
    throw InputError(options.source, "",
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
  require_no_obstacle(options, record);
  record.survey = spectral_survey(record.channels, record.sample_rate_hz, options.spectral);
  if (!record.survey.decomposition.determined)
    throw InputError(options.source, (record.names.size() == 1 ? "channel " : "channels ") + joined(record.names),
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
    if (count < fewest_for_relation(options.spectral.arma_order))
      print_warning(fmt::format("the linear relation to {} is left out: it needs {} samples, there are {}",
                                record.excitation_name, fewest_for_relation(options.spectral.arma_order), count));
    else
      for (Index c = 0; c < record.channels.cols(); ++c)
        record.relations.push_back(
            linear_relation(record.excitation, record.channels.col(c), options.spectral.arma_order));
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
ResponseTable response_table(const DataFile& data) {
  ResponseTable table;
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
    ResponseLevel level{
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

void print_table(const RecordSpectrum& record) {
  fmt::print("{}\n{} ensemble{} of {:.6g} s\n", record.source, record.survey.layout.count,
             record.survey.layout.count == 1 ? "" : "s",
             static_cast<double>(record.survey.layout.length) / record.sample_rate_hz);
  for (const std::string& text : record.conclusions) fmt::print("- {}\n", text);
  const bool rates = record.has_rates();
  const auto deviation = [](double sd) { return std::isfinite(sd) ? fmt::format("{:.2g}", sd) : std::string("-"); };
  for (std::size_t c = 0; c < record.names.size(); ++c) {
    fmt::print("\n{} ({})\n  {:<20} {:>14} {:>9} {:>13} {:>9}", record.names[c],
               record.units[c].empty() ? "unit not known" : record.units[c], "method", "frequency Hz", "sd",
               "amplitude", "sd");
    fmt::print("{}{:>9} {:>7}\n", rates ? fmt::format(" {:>10}", "rate 1/s") : "", "gamma^2", "dB");
    for (const MethodStatistics& method : record.survey.tables[c]) {
      if (!record.are_tones(c, method)) {
        fmt::print("  {:<20} {}\n", method.name, no_tones_text(method));
        continue;
      }
      for (std::size_t i = 0; i < method.terms.size(); ++i) {
        const TermStatistics& term = method.terms[i];
        const std::string name = i > 0 ? "" : method.name;
        fmt::print("  {:<20} {:>13.8g}{} {:>9} {:>13.6g} {:>9}", name, term.frequency_hz,
                   term.family == PoleFamily::circular ? " " : "*", deviation(term.frequency_sd), term.amplitude,
                   deviation(term.amplitude_sd));
        if (rates)
          fmt::print(" {:>10}", term.family == PoleFamily::circular ? "" : fmt::format("{:.5g}", term.rate));
        if (i == 0) fmt::print("{:>9.6f} {:>7.1f}", method.correlation, method.signal_to_noise_db);
        fmt::print("\n");
      }
    }
  }
  fmt::print("sd: {}\n",
             record.survey.layout.count > 1
                 ? "scatter of one ensemble"
                 : "maximum likelihood's own, from the noise it leaves; --ensemble gives scatter to all");
  if (rates)
    fmt::print("*: hyperbolic (a rate over 2 pi), or a product (frequency, and rate of growth or decay)\n");
}

int run(SpectrumArguments& options, const CLI::App& command) {
  options.window = options.selection.window();
  std::error_code ignored;
  if (!fs::exists(options.source, ignored))
    throw InputError(options.source, "", "does not exist",
                     fmt::format("a campaign folder or a {} file was expected", data_formats));
  options.output.check({{"the record", options.source, true}});
  const std::string line = command_line_of(command);
  if (!fs::is_directory(options.source, ignored)) options.selection.require_any_record(options.source);
  if (!fs::is_directory(options.source, ignored) && options.time.empty() && options.sample_rate_hz == 0) {
    const std::vector<DataVariable> variables = describe_data_file(options.source);
    const bool frequencies = std::any_of(variables.begin(), variables.end(), [](const DataVariable& v) {
      return v.name.ends_with(".frequency") || v.name.ends_with(".freq") || v.name.ends_with(".f");
    });
    const ResponseTable table = frequencies ? response_table(read_data_file(options.source)) : ResponseTable{};
    if (!table.series.empty()) {
      const std::string json = response_table_json(table);
      options.output.write({{"spectrum.json", json}, {"report.html", response_table_report(table, line)}});
      if (options.json) {
        fmt::print("{}", json);
        return 0;
      }
      for (const auto& [name, levels] : table.series)
        fmt::print("{}: steady responses at {} level{}\n", name, levels.size(), levels.size() == 1 ? "" : "s");
      fmt::print("written: {0}/spectrum.json, {0}/report.html\n", options.output.path());
      return 0;
    }
  }
  const Columns columns =
      fs::is_directory(options.source, ignored) ? columns_of_campaign(options) : columns_of_file(options);
  const RecordSpectrum record = analysed(options, columns);
  const std::string json = spectrum_json(record);
  options.output.write({{"spectrum.json", json}, {"report.html", spectrum_report(record, line)}});
  if (options.json) {
    fmt::print("{}", json);
  } else {
    print_table(record);
    fmt::print("written: {0}/spectrum.json, {0}/report.html\n", options.output.path());
  }
  return 0;
}

}  // namespace

void add_spectrum_command(CLI::App* command, Action& chosen) {
  auto options = std::make_shared<SpectrumArguments>();
  SpectralOptions& spectral = options->spectral;
  command
      ->add_option("CAMPAIGN_OR_FILE", options->source,
                   "campaign folder, or CSV, MAT, HDF5, UFF 58, LVM or WAV file")
      ->required();
  options->output.add_to(*command, "folder for spectrum.json and report.html");
  options->selection.add_to(*command);
  command->add_option("--channel", options->channels, "analyse these channels (default: every response)")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--order", spectral.order, "terms of the decomposition (default: the tones that a test finds)")
      ->check(CLI::Range(1, 40));
  command->add_option("--ensemble", spectral.ensemble_s, "cut the record into ensembles of this length, s")
      ->check(CLI::PositiveNumber);
  command->add_option("--overlap", spectral.overlap, "share of an ensemble that the next one sees again")
      ->check(CLI::Range(0.0, 0.95));
  command->add_option("--delays", spectral.delays, "delay coordinates of the principal components")
      ->check(CLI::Range(4, 400));
  command->add_flag("--offset", spectral.offset, "a constant in every channel beside the terms");
  command->add_option("--time", options->time, "file: the variable that holds the time in seconds");
  command->add_option("--sample-rate", options->sample_rate_hz, "file: samples a second, where none holds time")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "print spectrum.json instead of the summary");
  command->footer(
      "Circular-hyperbolic decomposition by four methods, over ensembles where --ensemble is given; singular "
      "values "
      "of\ndelay coordinates and of the channels; whether the record has settled; what of each response a linear "
      "relation to\nthe excitation explains. Of a file of steady responses (members frequency, amplitude, force) "
      "the "
      "curves of each level.\nExample: secular spectrum campaign --records '*0001*' --ensemble 4 --overlap 0.5 -o "
      "results");
  command->callback(
      [options, command, &chosen] { chosen = [options, command] { return run(*options, *command); }; });
}

}  // namespace secular::app
