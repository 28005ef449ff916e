#include "blind/sealed_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>
#include <system_error>

#include "blind/integrator.hpp"
#include "blind/signature.hpp"
#include "input/input_error.hpp"
#include "input/interruption.hpp"
#include "input/whole_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

// A term as the model file writes it: the mode's equation, its coordinate {v}, the other one {u}, the symbol {c}.
std::string term_text(const std::string& effect, const std::string& c, const std::string& v, const std::string& u) {
  if (effect == "viscous_damping") return fmt::format("- 2*{}*D({})", c, v);
  if (effect == "quadratic_damping") return fmt::format("- {}*abs(D({}))*D({})", c, v, v);
  if (effect == "cubic_damping") return fmt::format("- {}*D({})^3", c, v);
  if (effect == "quadratic_stiffness") return fmt::format("- {}*{}^2", c, v);
  if (effect == "cubic_stiffness") return fmt::format("- {}*{}^3", c, v);
  if (effect == "direct_excitation") return fmt::format("+ {}*F*cos(Omega*t)", c);
  if (effect == "parametric_excitation") return fmt::format("+ {}*{}*F*cos(Omega*t)", c, v);
  return fmt::format("- {}*{}*{}^2", c, v, u);  // cubic_coupling, in each of the two equations
}

// Powers of eps with which the terms enter, by resonance.
int order_of(const std::string& effect, bool parametric_resonance) {
  if (effect == "quadratic_stiffness") return 1;
  if (effect == "direct_excitation") return parametric_resonance ? 1 : 2;
  return 2;
}

std::string case_text(const Specimen& s, const std::string& name, const std::string& relation, bool excited,
                      const std::string& at_rest) {
  std::string orders;
  for (const OwnTerm& term : s.own)
    orders += fmt::format("{}{} = {}", orders.empty() ? "" : ", ", term.symbol,
                          order_of(term.effect, s.family == "principal_parametric"));
  std::string text = fmt::format("[[case]]\nname = \"{}\"\nrelations = [{}]\norder = {{ {} }}\nexpand_to = 2\n",
                                 name, relation.empty() ? "" : "\"" + relation + "\"", orders);
  if (!at_rest.empty()) text += fmt::format("modes_at_rest = [\"{}\"]\n", at_rest);
  if (!excited) text += "excitation = false\n";
  return text + "\n";
}

std::string record_text(const std::string& file, const std::string& kind, double started) {
  return fmt::format("\n[[record]]\nfile = \"{}\"\nkind = \"{}\"\nstarted_s = {:.1f}\n", file, kind, started);
}

std::string campaign_head(const Measurement& m, const std::vector<std::string>& coordinates,
                          const std::string& name) {
  std::string text = fmt::format("schema = 1\nname = \"{}\"\nsample_rate_hz = {:.1f}\n", name, sample_rate_hz);
  for (std::size_t c = 0; c < m.names.size(); ++c) {
    const bool length = c > 0 && m.of_displacement;
    text += fmt::format("\n[[channel]]\nname = \"{}\"\nrole = \"{}\"\nquantity = \"{}\"\nunit = \"{}\"\n",
                        m.names[c], c == 0 ? "excitation" : "response", length ? "displacement" : "acceleration",
                        length ? "m" : "m/s^2");
  }
  if (m.with_modal_basis) {
    std::string channels, modes, rows;
    for (std::size_t c = 1; c < m.names.size(); ++c) {
      channels += fmt::format("{}\"{}\"", c == 1 ? "" : ", ", m.names[c]);
      std::string row;
      for (const double shape : m.shapes[c - 1]) row += fmt::format("{}{:.4f}", row.empty() ? "" : ", ", shape);
      rows += fmt::format("{}[{}]", c == 1 ? "" : ", ", row);
    }
    for (const std::string& coordinate : coordinates)
      modes += fmt::format("{}\"{}\"", modes.empty() ? "" : ", ", coordinate);
    text += fmt::format("\n[modal_basis]\nchannels = [{}]\nmodes = [{}]\nmass_normalised_shapes = [{}]\n", channels,
                        modes, rows);
  }
  return text;
}

// Disturbances and noise, then saturation, then the converter.
void disturb(const SealedCampaign& c, Random& noise, Random& lot, std::vector<std::vector<double>>& channels) {
  disturb_samples(c.disturbances, lot, channels);
  for (std::size_t i = 0; i < channels.size(); ++i)
    for (double& x : channels[i]) x += c.noise_sd[i] * noise.gaussian();
  clip(c.reality.measurement, channels);
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (c.quantum[i] > 0 && c.disturbances.step.empty())  // a channel has one converter
      for (double& x : channels[i]) x = c.quantum[i] * std::round(x / c.quantum[i]);
  convert_samples(c.disturbances, lot, channels);
}

std::string csv_text(const std::vector<std::string>& names, const std::vector<std::vector<double>>& channels,
                     const std::vector<std::size_t>& lost) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "t");
  for (const std::string& name : names) fmt::format_to(std::back_inserter(text), ",{}", name);
  for (std::size_t i = 0; i < channels.front().size(); ++i) {
    if (std::binary_search(lost.begin(), lost.end(), i)) continue;
    fmt::format_to(std::back_inserter(text), "\n{:.8f}", static_cast<double>(i) / sample_rate_hz);
    for (const std::vector<double>& channel : channels)
      fmt::format_to(std::back_inserter(text), ",{:.7g}", channel[i]);
  }
  text.push_back('\n');
  return fmt::to_string(text);
}

// Where the files of a campaign go, and what their noise is drawn from.
struct RecordWriter {
  const SealedCampaign& sealed;
  fs::path campaign;
  Random noise;
  std::uint64_t seed;

  // The file of record number `record`; returns its name.
  std::string write(std::size_t record, const Drive& drive, const Motion& motion) {
    constexpr std::uint64_t streams_of_records = 6'000'000'000;
    Random lot(seed, streams_of_records + 1000 * sealed.plan.number + record);
    Measurement sensors = sealed.reality.measurement;
    // Responses that are late by tau are those that came before, seen beside an excitation read tau ahead.
    sensors.fault[0].late -= sealed.disturbances.of_record(record).late_s;
    std::vector<std::vector<double>> channels = measured(sensors, drive, motion, false);
    disturb(sealed, noise, lot, channels);
    const std::vector<std::size_t> lost = lost_rows(sealed.disturbances, channels.front().size(), lot);
    std::string file = dwell_file(record);
    write_text(campaign / file, csv_text(sealed.specimen.measurement.names, channels, lost));
    return file;
  }
};

std::string dwell_text(const std::string& file, const Drive& drive, const std::string& group) {
  return record_text(file, "dwell", drive.started) + fmt::format(
                                                         "excitation_frequency_hz = {:.4f}\nexcitation_amplitude = "
                                                         "{:.10g}\nensemble_s = {:.1f}\ngroup = \"{}\"\n",
                                                         drive.frequency / two_pi, drive.amplitude,
                                                         static_cast<double>(ensemble_samples) / sample_rate_hz,
                                                         group);
}

}  // namespace

std::string dwell_file(std::size_t index) {
  return fmt::format("records/{:04}.csv", index + 1);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InputError(folder.string(), "", "cannot be made: " + error.message(),
                     "name a folder that you may write to");
}

void write_text(const fs::path& path, const std::string& text) {
  const std::lock_guard lock(Interruption::instance().guard());  // which waits for a whole file
  const fs::path partial = path.string() + ".partial";
  {
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream << text;
    stream.flush();
    if (!stream) {
      std::error_code ignored;
      fs::remove(partial, ignored);
      throw InputError(path.string(), "", "cannot be written", "check the permissions and the free space");
    }
  }
  std::error_code error;
  fs::rename(partial, path, error);
  if (error) throw InputError(path.string(), "", "cannot be written: " + error.message());
}

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string(), "", "cannot be read", "a folder made by `secular blind generate`");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string model_text(const Specimen& s, std::uint64_t nominal_seed) {
  Random random(nominal_seed, 1);
  const std::size_t modes = s.structure.modes;
  std::string text =
      fmt::format("# A structure of the blind check: what is known of it.\nschema = 1\nname = \"{}\"\n", s.family);
  text += "source = \"drawn\"\n\n";
  for (std::size_t k = 0; k < modes; ++k) {
    const std::string& v = s.coordinates[k];
    const std::string u = modes == 2 ? s.coordinates[1 - k] : "";
    std::string right;
    for (const OwnTerm& term : s.own)
      if (term.mode == k || term.effect == "cubic_coupling")
        right += (right.empty() ? "" : " ") + term_text(term.effect, term.symbol, v, u);
    if (right.starts_with("+ ")) right.erase(0, 2);
    text += fmt::format(
        "[[mode]]\ncoordinate = \"{0}\"\nfrequency = \"{1}\"\nequation = \"D2({0}) + {1}^2*{0} = {2}\"\n\n", v,
        s.frequency_symbols[k], right);
  }
  if (s.family == "principal_parametric") {
    text += case_text(s, "principal_parametric", "Omega = 2*omega0 + eps^2*sigma", true, "");
  } else if (modes == 1) {
    text += case_text(s, "primary", "Omega = omega0 + eps^2*sigma", true, "");
  } else {
    text += case_text(s, "primary_1", "Omega = omega1 + eps^2*sigma", true, "v2");
    text += case_text(s, "primary_2", "Omega = omega2 + eps^2*sigma", true, "v1");
  }
  if (modes == 1) text += case_text(s, "free", "", false, "");
  text += "[nominal]\n";
  for (std::size_t k = 0; k < modes; ++k)
    text += fmt::format("{} = {:.4g}\n", s.frequency_symbols[k],
                        s.structure.mode[k].omega * (1 + random.uniform(-0.01, 0.01)));
  return text;
}

void write_sealed(const SealedCampaign& c, std::uint64_t seed, const fs::path& folder) {
  WholeFolder whole(folder, WholeFolder::ParentLock::with_caller);
  const fs::path& partial = whole.path();
  make_folder(partial / "campaign" / "records");
  const Specimen& s = c.specimen;
  write_text(partial / "model.toml", model_text(s, seed + c.plan.number));
  if (!c.parameters.empty()) {
    nlohmann::ordered_json numbers;
    for (const auto& [symbol, value] : c.parameters) numbers[symbol] = std::stod(fmt::format("{:.10g}", value));
    write_text(partial / "parameters.json", numbers.dump(1) + "\n");
  }
  std::string text = campaign_head(s.measurement, s.coordinates, fmt::format("case {}", c.plan.number));
  RecordWriter writer{c, partial / "campaign", Random(seed, 1'000'000 + c.plan.number), seed};
  std::size_t record = 0;
  for (const Dwell& dwell : s.dwells) {
    const Drive drive = drive_of(dwell, c.reality);
    const std::string file = writer.write(record, drive, c.motions.at(record));
    text += dwell_text(file, drive, dwell.group);
    ++record;
  }
  for (std::size_t i = 0; i < s.stretches.size(); ++i) {
    const Stretch& stretch = s.stretches[i];
    text += record_text(writer.write(record++, stretch.drive, c.of_stretches.at(i)), stretch.kind,
                        stretch.drive.started);
    if (stretch.kind == "free_decay") text += "group = \"free decays\"\n";
  }
  write_text(partial / "campaign" / "campaign.toml", text);
  whole.finish(true);
}

void write_extended_campaign(const SealedCampaign& c, std::uint64_t seed, const FurtherDwell& further,
                             const fs::path& campaign, const fs::path& target) {
  WholeFolder whole(target);
  const fs::path& partial = whole.path();
  std::error_code error;
  fs::copy(campaign, partial, fs::copy_options::recursive, error);
  if (error)
    throw InputError(partial.string(), "", "cannot be written: " + error.message(),
                     "check the permissions and the free space");
  Dwell dwell = c.specimen.dwells.at(further.like);
  dwell.drive.amplitude *= further.level;
  dwell.drive.frequency = further.frequency;
  dwell.drive.started =
      c.specimen.dwells.back().drive.started + 90 * static_cast<double>(c.specimen.stretches.size() + 1);
  RecordWriter writer{c, partial, Random(seed, 3'000'000 + c.plan.number), seed};
  const std::size_t record = c.specimen.dwells.size() + c.specimen.stretches.size();
  const Drive drive = drive_of(dwell, c.reality);
  const std::string file = writer.write(record, drive, dwell_motion(c, dwell, record, further.length));
  write_text(partial / "campaign.toml",
             read_text(partial / "campaign.toml") + dwell_text(file, drive, dwell.group + ", further"));
  whole.finish(true);
}

namespace {

nlohmann::ordered_json disturbances_json(const Disturbances& d) {
  nlohmann::ordered_json sizes = nlohmann::ordered_json::object();
  for (const std::string& kind : d.kinds) {
    nlohmann::ordered_json& size = sizes[kind];
    if (kind == "foreign_tone") size = d.hum;
    if (kind == "converter_step") size = d.step;
    if (kind == "coloured_noise") size = {{"sd", d.coloured}, {"correlation_s", d.correlation_s}};
    if (kind == "neighbour_mode")
      size = {{"amplitude", d.ringing}, {"hz", d.ringing_hz}, {"decay_rate", d.ringing_rate}};
    if (kind == "spikes") size = {{"height", d.spike}, {"in_a_record", d.spikes_per_record}};
    if (kind == "lost_samples") size = d.lost_per_record;
    if (kind == "held_samples") size = d.held_share;
    if (kind == "late_record") size = d.latest_s;
    if (kind == "record_scatter") size = d.frequency_scatter;
    if (kind == "offset_wander") size = d.wander;
  }
  return sizes;
}

std::size_t decays_of(const Specimen& specimen) {
  return static_cast<std::size_t>(std::count_if(specimen.stretches.begin(), specimen.stretches.end(),
                                                [](const Stretch& s) { return s.kind == "free_decay"; }));
}

}  // namespace

nlohmann::ordered_json label_of(const SealedCampaign& c) {
  using nlohmann::ordered_json;
  ordered_json label = {{"case", c.plan.number},
                        {"family", c.specimen.family},
                        {"kind", c.plan.kind},
                        {"snr_db", c.plan.snr_db},
                        {"dwells", c.specimen.dwells.size()},
                        {"decays", decays_of(c.specimen)},
                        {"coarse_converter", c.quantum.front() > 0 && c.disturbances.step.empty()},
                        {"parameters_given", !c.parameters.empty()},
                        {"effects", ordered_json::array()}};
  if (c.plan.programme != Programme::dwells) label["records"] = name_of(c.plan.programme);
  if (c.plan.disturbed) label["disturbances"] = disturbances_json(c.disturbances);
  label["numbers"] = numbers_of(c.specimen);
  if (!c.moved.empty()) label["parameters_moved"] = c.moved;
  for (const Truth& truth : c.truths) {
    const Withheld& w = truth.withheld;
    std::string where = w.effect == "parameters" || w.effect == "shaker_harmonics" || w.effect == "extra_mode"
                            ? ""
                            : c.specimen.coordinates[w.mode];
    if (is_measurement_fault(w.effect) && w.effect != "mode_shape_error")
      where = c.specimen.measurement.names[w.channel];
    label["effects"].push_back({{"effect", w.effect},
                                {"mode", where},
                                {"coefficient", w.coefficient},
                                {"detail", w.detail},
                                {"sigma", truth.sigma},
                                {"raw_sigma", truth.raw_sigma},
                                {"relative", truth.relative},
                                {"same_as", truth.same_as}});
  }
  return label;
}

}  // namespace secular::blind
