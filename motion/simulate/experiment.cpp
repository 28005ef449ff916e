#include "motion/simulate/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "estimator/model/by_name.hpp"
#include "motion/simulate/experiment_parts.hpp"

namespace secular {
namespace {

Eigen::VectorXd read_parameters(const TomlTable& table, const Target& target, const StatedParameters& stated) {
  const CompiledModel& model = target.model;
  std::map<std::string_view, double> of_effects;
  each_motion_effect(target, [&](const ExperimentEffect& effect, const InstalledEffect& installed) {
    for (std::size_t i = 0; i < installed.parameters.size(); ++i)
      of_effects[installed.parameters[i]] = i == 0 ? effect.strength : effect.shape.at(i - 1);
  });
  std::vector<std::string_view> known;
  for (const CompiledSymbol& symbol : model.symbols)
    if (!of_effects.contains(symbol.name)) known.push_back(symbol.name);
  std::vector<std::string_view> keys = known;
  keys.insert(keys.end(), stated.names.begin(), stated.names.end());
  table.refuse_unknown_keys(keys);
  std::map<std::string, double> given;
  for (const std::string& key : table.keys()) given[key] = table.number(key);
  if (stated.take) stated.take(given, table.file() + ", [parameters]");
  Eigen::VectorXd values(static_cast<Eigen::Index>(model.symbols.size()));
  for (std::size_t p = 0; p < model.symbols.size(); ++p) {
    const auto index = static_cast<Eigen::Index>(p);
    const std::string_view name = model.symbols[p].name;
    if (const auto found = of_effects.find(name); found != of_effects.end()) {
      values(index) = found->second;
      continue;
    }
    const auto number = given.find(std::string(name));
    values(index) = number != given.end() ? number->second : model.nominal[p];
    if (std::isnan(values(index))) table.fail(name, "is missing", "this model's symbols are " + listed(known));
    if (p < model.modes() && values(index) <= 0)
      table.fail(name, "is not positive", "a natural frequency in rad/s");
  }
  for (const ExperimentEffect& effect : target.effects) {
    if (effect.kind != Effect::Kind::parameters) continue;
    const auto at = std::find(known.begin(), known.end(), effect.symbol);
    if (at == known.end())
      throw InputError(effect.file, "line " + std::to_string(effect.line) + ", key symbol",
                       "'" + effect.symbol + "' is no symbol of the model", "its symbols are " + listed(known));
    values(static_cast<Eigen::Index>(symbol_named(model, effect.symbol))) *= 1 + effect.strength;
  }
  return values;
}

// What an excited record needs.
void require_channels(const TomlTable& table, const char* key, const Experiment& experiment) {
  if (experiment.excitations.empty())
    table.fail(key, "an excited record needs an excitation channel", "describe it in [excitation]");
}

// One number for each excitation: a number where the model has one, a list where it has several.
std::vector<double> by_excitation(const TomlTable& table, std::string_view key, const Target& target) {
  std::vector<double> values;
  if (target.excitations == 1)
    values = {table.number(key)};
  else
    values = table.numbers(key);
  if (values.size() != target.excitations)
    table.fail(key, fmt::format("has {} numbers", values.size()),
               "one for every excitation: " + listed(target.excitation_names()));
  return values;
}

// At least one of them drives the model, none backwards.
void refuse_silence(const TomlTable& table, std::string_view key, const std::vector<double>& amplitudes) {
  if (*std::min_element(amplitudes.begin(), amplitudes.end()) < 0 ||
      *std::max_element(amplitudes.begin(), amplitudes.end()) <= 0)
    table.fail(key, "is not positive",
               amplitudes.size() == 1 ? "a positive number was expected"
                                      : "zero for an excitation that is silent, and a positive number for another");
}

void refuse_frequency(const TomlTable& table, std::string_view key, const std::vector<double>& frequencies,
                      double sample_rate_hz) {
  for (const double f : frequencies)
    if (f <= 0 || f >= 0.5 * sample_rate_hz)
      table.fail(key, "holds a frequency outside (0, half the sample rate)", "correct it");
}

SignalProgramme read_sweep(const TomlTable& table, const Target& target, double sample_rate_hz) {
  table.refuse_unknown_keys(
      {"from_hz", "to_hz", "rate_hz_per_s", "amplitude", "settle_s", "initial_displacement", "group"});
  SignalProgramme sweep;
  sweep.kind = SignalProgramme::Kind::sweep;
  sweep.from_hz = by_excitation(table, "from_hz", target);
  sweep.to_hz = by_excitation(table, "to_hz", target);
  refuse_frequency(table, "from_hz", sweep.from_hz, sample_rate_hz);
  refuse_frequency(table, "to_hz", sweep.to_hz, sample_rate_hz);
  double farthest = 0;
  for (std::size_t j = 0; j < sweep.from_hz.size(); ++j)
    farthest = std::max(farthest, std::abs(sweep.to_hz[j] - sweep.from_hz[j]));
  if (farthest == 0) table.fail("to_hz", "equals from_hz", "a sweep goes somewhere");
  sweep.duration_s = farthest / positive(table, "rate_hz_per_s");
  sweep.amplitude = by_excitation(table, "amplitude", target);
  refuse_silence(table, "amplitude", sweep.amplitude);
  sweep.settle_s = positive(table, "settle_s", 60.0);
  return sweep;
}

SignalProgramme read_impact(const TomlTable& table, const Target& target) {
  table.refuse_unknown_keys({"peak", "at_s", "width_s", "duration_s", "initial_displacement", "group"});
  SignalProgramme impact;
  impact.kind = SignalProgramme::Kind::impact;
  impact.amplitude = by_excitation(table, "peak", target);
  refuse_silence(table, "peak", impact.amplitude);
  impact.at_s = not_negative(table, "at_s");
  impact.width_s = positive(table, "width_s");
  impact.duration_s = positive(table, "duration_s");
  return impact;
}

SignalProgramme read_broadband(const TomlTable& table, const Target& target, double sample_rate_hz) {
  table.refuse_unknown_keys(
      {"low_hz", "high_hz", "lines", "rms", "seed", "settle_s", "duration_s", "initial_displacement", "group"});
  SignalProgramme broadband;
  broadband.kind = SignalProgramme::Kind::broadband;
  broadband.low_hz = frequency(table, "low_hz", sample_rate_hz);
  broadband.high_hz = frequency(table, "high_hz", sample_rate_hz);
  if (broadband.high_hz <= broadband.low_hz) table.fail("high_hz", "is not above low_hz", "a band was expected");
  const std::int64_t lines = table.has("lines") ? table.integer("lines") : 200;
  if (lines < 2 || lines > 10000) table.fail("lines", "is out of range", "2 to 10000 cosines");
  broadband.lines = static_cast<std::size_t>(lines);
  const std::int64_t seed = table.has("seed") ? table.integer("seed") : 1;
  if (seed < 0) table.fail("seed", "is negative", "zero or a positive integer");
  broadband.seed = static_cast<std::uint64_t>(seed);
  broadband.amplitude = by_excitation(table, "rms", target);
  refuse_silence(table, "rms", broadband.amplitude);
  broadband.settle_s = not_negative(table, "settle_s");
  broadband.duration_s = positive(table, "duration_s");
  return broadband;
}

void read_signals(const TomlTable& root, const Target& target, Experiment& experiment) {
  const auto add_all = [&](const char* kind, const auto& read) {
    for (const TomlTable& table : root.tables(kind)) {
      require_channels(table, "group", experiment);
      experiment.signals.push_back(read(table));
      experiment.signals.back().initial_displacement = by_mode(table, "initial_displacement", target);
      experiment.signals.back().group = table.string_or("group", "");
    }
  };
  const double rate = experiment.sample_rate_hz;
  add_all("sweep", [&](const TomlTable& table) { return read_sweep(table, target, rate); });
  add_all("impact", [&](const TomlTable& table) { return read_impact(table, target); });
  add_all("broadband", [&](const TomlTable& table) { return read_broadband(table, target, rate); });
}

// Rows of one number for each excitation; where there is one excitation, a list.
std::vector<std::vector<double>> settings_of(const TomlTable& table, const char* key, const Target& target) {
  std::vector<std::vector<double>> settings;
  if (target.excitations > 1) settings = table.number_rows(key);
  if (target.excitations == 1)
    for (const double value : table.numbers(key)) settings.push_back({value});
  for (const std::vector<double>& setting : settings)
    if (setting.size() != target.excitations)
      table.fail(key, fmt::format("has a row of {} numbers", setting.size()),
                 "one for every excitation: " + listed(target.excitation_names()));
  return settings;
}

DwellProgramme read_dwell(const TomlTable& table, const Target& target, const Experiment& experiment) {
  table.refuse_unknown_keys({"frequencies_hz", "amplitudes", "phases", "ensembles", "ensemble_s", "settle_s",
                             "carry_state", "initial_displacement", "group"});
  require_channels(table, "frequencies_hz", experiment);
  DwellProgramme dwell;
  dwell.frequencies_hz = settings_of(table, "frequencies_hz", target);
  dwell.amplitudes = settings_of(table, "amplitudes", target);
  for (const std::vector<double>& f : dwell.frequencies_hz)
    refuse_frequency(table, "frequencies_hz", f, experiment.sample_rate_hz);
  for (const std::vector<double>& a : dwell.amplitudes)
    if (*std::min_element(a.begin(), a.end()) <= 0)
      table.fail("amplitudes", "holds an amplitude that is not positive", "correct it");
  if (dwell.frequencies_hz.empty() || dwell.amplitudes.empty())
    table.fail("amplitudes", "nothing to run", "give at least one frequency and amplitude");
  if (table.has("phases")) dwell.phases = by_excitation(table, "phases", target);
  dwell.ensembles = static_cast<int>(table.has("ensembles") ? table.integer("ensembles") : 1);
  if (dwell.ensembles < 1 || dwell.ensembles > 10000) table.fail("ensembles", "is out of range", "1 to 10000");
  dwell.ensemble_s = positive(table, "ensemble_s", 4.0);
  dwell.settle_s = positive(table, "settle_s", 60.0);
  dwell.carry_state = table.boolean_or("carry_state", false);
  dwell.initial_displacement = by_mode(table, "initial_displacement", target);
  dwell.group = table.string_or("group", "");
  return dwell;
}

// [excitation], or one [[excitation]] for each of the model's, in its order.
void read_excitations(const TomlTable& root, const Target& target, Experiment& experiment) {
  if (!root.has("excitation")) return;
  if (target.excitations == 0) root.fail("excitation", "the model has no excitation", "remove this table");
  const std::vector<TomlTable> tables =
      target.excitations == 1 ? std::vector<TomlTable>{root.table("excitation")} : root.tables("excitation");
  if (tables.size() != target.excitations)
    root.fail("excitation",
              fmt::format("there are {} channels for {} excitations", tables.size(), target.excitations),
              "one [[excitation]] for every one, in this order: " + listed(target.excitation_names()));
  for (const TomlTable& table : tables) {
    table.refuse_unknown_keys({"name", "quantity", "unit", "noise_sd", "quantisation", "high_pass_hz"});
    experiment.excitations.push_back(read_channel(table, ChannelRole::excitation));
  }
}

void read_integrator(const TomlTable& root, Experiment& experiment) {
  if (!root.has("integrator")) return;
  static const std::map<std::string, Integrator> methods = {{"dormand_prince", Integrator::dormand_prince},
                                                            {"bulirsch_stoer", Integrator::bulirsch_stoer},
                                                            {"runge_kutta_4", Integrator::runge_kutta_4},
                                                            {"dormand_prince_87", Integrator::dormand_prince_87}};
  const TomlTable table = root.table("integrator");
  table.refuse_unknown_keys({"method", "relative_tolerance", "absolute_tolerance", "steps_per_sample"});
  const auto method = methods.find(table.string_or("method", "dormand_prince"));
  if (method == methods.end())
    table.fail("method", "is '" + table.string("method") + "'",
               "dormand_prince, bulirsch_stoer, dormand_prince_87 or runge_kutta_4 was expected");
  MotionSettings& motion = experiment.motion;
  motion.method = method->second;
  const bool fixed = motion.method == Integrator::runge_kutta_4;
  for (const char* const key : {"relative_tolerance", "absolute_tolerance"})
    if (fixed && table.has(key)) table.fail(key, "means nothing to a fixed step", "give steps_per_sample");
  if (!fixed && table.has("steps_per_sample"))
    table.fail("steps_per_sample", "is for runge_kutta_4", "give relative_tolerance");
  motion.relative_tolerance = positive(table, "relative_tolerance", motion.relative_tolerance);
  motion.absolute_tolerance = positive(table, "absolute_tolerance", motion.absolute_tolerance);
  motion.fixed_step = 1 / (experiment.sample_rate_hz * positive(table, "steps_per_sample", 16.0));
}

/// Of a record, or while it settles: eight gigabytes a channel, and hours of integration.
constexpr double most_samples = 1e9;

// A time that no computer comes to the end of, or a record that is over before it begins.
void refuse_length(const Experiment& experiment, const char* what, double seconds, bool recorded) {
  const double samples = seconds * experiment.sample_rate_hz;
  const std::string given = fmt::format("{} of {:g} s at {:g} Hz", what, seconds, experiment.sample_rate_hz);
  if (!(samples <= most_samples))
    throw InputError(experiment.file, "", fmt::format("{} is more than {:g} samples", given, most_samples),
                     "check the unit (s, Hz)");
  if (recorded && samples < 2)
    throw InputError(experiment.file, "", given + " is fewer than two samples", "check the unit (s, Hz)");
}

void refuse_lengths(const Experiment& experiment) {
  for (const DwellProgramme& dwell : experiment.dwells) {
    refuse_length(experiment, "a dwell's settle_s", dwell.settle_s, false);
    refuse_length(experiment, "a dwell", dwell.ensembles * dwell.ensemble_s, true);
  }
  for (const FreeDecayProgramme& decay : experiment.free_decays)
    refuse_length(experiment, "a free_decay", decay.duration_s, true);
  for (const SignalProgramme& signal : experiment.signals) {
    refuse_length(experiment, "a record's settle_s", signal.settle_s, false);
    refuse_length(experiment, "a sweep, impact or broadband record", signal.duration_s, true);
  }
}

}  // namespace

std::string experiment_model(const std::filesystem::path& path) {
  return TomlTable::from_file(path).string("model");
}

Experiment read_experiment(const std::filesystem::path& path, const CompiledModel& model,
                           std::span<const InstalledEffect> installed, const EffectCatalogue& catalogue,
                           const StatedParameters& stated) {
  const TomlTable root = TomlTable::from_file(path);
  root.refuse_unknown_keys({"schema",     "name",       "source",      "model", "parameters", "sample_rate_hz",
                            "excitation", "response",   "modal_basis", "dwell", "free_decay", "sweep",
                            "impact",     "broadband",  "shaker",      "fault", "effect",     "structure",
                            "body",       "integrator", "anti_alias"});
  if (root.integer("schema") != 1) root.fail("schema", "is not 1", "this program reads schema 1");
  const Target target = target_of(root, model, installed, catalogue);
  Experiment experiment;
  experiment.file = path.string();
  experiment.name = root.string("name");
  experiment.model = root.string("model");
  experiment.parameters = read_parameters(root.table("parameters"), target, stated);
  experiment.sample_rate_hz = positive(root, "sample_rate_hz");
  read_excitations(root, target, experiment);
  read_integrator(root, experiment);
  read_anti_alias(root, experiment);
  read_responses(root, target, experiment);
  for (const TomlTable& table : root.tables("dwell"))
    experiment.dwells.push_back(read_dwell(table, target, experiment));
  for (const TomlTable& table : root.tables("free_decay")) {
    table.refuse_unknown_keys({"initial_displacement", "initial_velocity", "duration_s", "group"});
    FreeDecayProgramme decay;
    decay.initial_displacement = by_mode(table, "initial_displacement", target);
    decay.initial_velocity = by_mode(table, "initial_velocity", target);
    decay.duration_s = positive(table, "duration_s");
    decay.group = table.string_or("group", "");
    experiment.free_decays.push_back(std::move(decay));
  }
  read_signals(root, target, experiment);
  read_shaker(root, target, experiment);
  read_faults_and_effects(root, target, catalogue, experiment);
  for (SimulatedChannel& response : experiment.responses) response.shape.resize(model.modes(), 0.0);
  if (experiment.dwells.empty() && experiment.free_decays.empty() && experiment.signals.empty())
    root.fail("dwell", "nothing to run", "add a [[dwell]], [[free_decay]], [[sweep]], [[impact]] or [[broadband]]");
  refuse_lengths(experiment);
  return experiment;
}

}  // namespace secular
