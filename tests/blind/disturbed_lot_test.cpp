// Structures of the blind check with nothing withheld, their campaigns disturbed by lot: no number of `identify`
// may be far off unless it is marked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "blind/case_files.hpp"
#include "blind/motion.hpp"
#include "blind/random.hpp"
#include "blind/sealed_case.hpp"
#include "blind/sealed_set.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;
using Samples = std::vector<double>;

constexpr double sample_rate = 256;

/// What acts on all records of a campaign; 0: not there.
struct Lot {
  double hum = 0;        ///< of 50 Hz, rms over that of the signal
  double bits = 0;       ///< of a converter whose range is 1.1 times the largest sample
  double coloured = 0;   ///< rms over that of the signal
  double ring = 0;       ///< amplitude over the rms of the signal, of a decaying mode
  double spikes = 0;     ///< by record and channel
  double held = 0;       ///< share of samples that repeat the one before
  double late_s = 0;     ///< the most by which responses of a record are late
  double frequency = 0;  ///< relative standard deviation of natural frequencies between records
  double wander = 0;     ///< rms over that of the signal
};

// Each is there in half of the campaigns.
Lot drawn(Random& random) {
  Lot lot;
  const auto maybe = [&](double& size, double value) {
    if (random.chance(0.5)) size = value;
  };
  maybe(lot.hum, random.uniform(0, 0.05));
  maybe(lot.bits, std::floor(random.uniform(8, 15)));
  maybe(lot.coloured, random.log_uniform(0.002, 0.05));
  maybe(lot.ring, random.log_uniform(0.005, 0.2));
  maybe(lot.spikes, std::floor(random.uniform(1, 9)));
  maybe(lot.held, random.log_uniform(1e-4, 1e-2));
  maybe(lot.late_s, random.uniform(0, 0.02));
  maybe(lot.frequency, random.uniform(0, 0.005));
  maybe(lot.wander, random.log_uniform(0.005, 0.2));
  return lot;
}

// Natural frequencies of every record differ a little from those of the model.
void scatter_frequencies(SealedCase& c, double sd, Random& random) {
  const Structure nominal = c.reality.structure;
  const auto draw = [&] {
    const double factor = 1 + sd * random.gaussian();
    for (std::size_t k = 0; k < nominal.modes; ++k)
      c.reality.structure.mode[k].omega = nominal.mode[k].omega * factor;
  };
  for (std::size_t d = 0; d < c.motions.size(); ++d) {
    draw();
    c.motions[d] = dwell_motion(c, c.specimen.dwells[d]);
  }
  for (std::size_t d = 0; d < c.decays.size(); ++d) {
    draw();
    State start{};
    displacement(start, 0) = c.specimen.decay_starts[d];
    c.decays[d].motion = recorded_motion(c.reality.structure, c.decays[d].drive, start,
                                         c.decays[d].motion.samples(), c.specimen.settling.substeps);
  }
  c.reality.structure = nominal;
}

struct Tone {
  double amplitude = 0, frequency_hz = 0, rate = 0, phase = 0;
  double at(double t) const {
    return amplitude * std::exp(-rate * t) * std::cos(2 * std::numbers::pi * frequency_hz * t + phase);
  }
};

void disturb(Samples& x, const Lot& lot, bool response, double neighbour_hz, Random& random) {
  double square = 0, peak = 0;
  for (const double value : x) square += value * value, peak = std::max(peak, std::abs(value));
  const double rms = std::sqrt(square / static_cast<double>(x.size())), turn = 2 * std::numbers::pi;
  const Tone hum{std::sqrt(2.0) * lot.hum * rms, 50, 0, random.uniform(0, turn)};
  const Tone ring{response ? lot.ring * rms : 0, neighbour_hz, 0.01 * turn * neighbour_hz, random.uniform(0, turn)};
  const double length_s = static_cast<double>(x.size()) / sample_rate, kept = std::exp(-turn * 5 / sample_rate);
  double noise = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) / sample_rate;
    noise = kept * noise + std::sqrt(1 - kept * kept) * random.gaussian();
    x[i] += hum.at(t) + ring.at(t) + (response ? lot.coloured * rms * noise : 0) +
            lot.wander * rms * (1 + std::sin(0.7 * turn * t / length_s));
  }
  for (int s = 0; response && s < static_cast<int>(lot.spikes); ++s)
    x[random.below(x.size())] += random.sign() * random.uniform(2, 6) * rms;
  for (std::size_t i = 1; lot.held > 0 && i < x.size(); ++i)
    if (random.chance(lot.held)) x[i] = x[i - 1];
  if (lot.bits > 0) {
    const double step = 2.2 * peak / std::exp2(lot.bits);
    for (double& value : x) value = step * std::round(value / step);
  }
}

// The first column is time, the second the excitation.
void disturb_file(const fs::path& file, const Lot& lot, double neighbour_hz, Random& random) {
  std::istringstream text(read_text(file));
  std::string header, line;
  std::getline(text, header);
  std::vector<Samples> columns(static_cast<std::size_t>(std::count(header.begin(), header.end(), ',') + 1));
  while (std::getline(text, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (Samples& column : columns) {
      std::getline(cells, cell, ',');
      column.push_back(std::stod(cell));
    }
  }
  const double late = random.uniform(0, lot.late_s);
  for (std::size_t c = 2; c < columns.size() && late > 0; ++c) columns[c] = delayed(columns[c], late);
  // What came before the record is not known.
  const auto unknown = static_cast<std::ptrdiff_t>(std::ceil(lot.late_s * sample_rate)) + (lot.late_s > 0 ? 4 : 0);
  for (Samples& column : columns) column.erase(column.begin(), column.begin() + unknown);
  for (std::size_t c = 1; c < columns.size(); ++c) disturb(columns[c], lot, c > 1, neighbour_hz, random);
  std::ofstream out(file);
  out.precision(10);
  out << header << '\n';
  for (std::size_t i = 0; i < columns.front().size(); ++i)
    for (std::size_t c = 0; c < columns.size(); ++c) out << columns[c][i] << (c + 1 < columns.size() ? ',' : '\n');
}

std::map<std::string, double> truth_of(const SealedCase& c) {
  std::map<std::string, double> truth;
  Structure own = c.specimen.structure;
  for (std::size_t k = 0; k < own.modes; ++k) truth[c.specimen.frequency_symbols[k]] = own.mode[k].omega;
  for (const OwnTerm& term : c.specimen.own) truth[term.symbol] = *coefficient(own, term.effect, term.mode);
  return truth;
}

struct Number {
  std::string name;
  bool given = false, doubtful = false, held = false;
  double off = 0;  ///< in standard deviations
};

// A campaign's numbers, as a user gets them.
std::vector<Number> identified(std::size_t number, std::uint64_t seed, const fs::path& folder) {
  CasePlan plan;
  plan.number = number + 1;
  plan.kind = "none";
  plan.family = families[number % families.size()];
  Random random(seed, number);
  plan.snr_db = random.chance(0.5) ? 40 : 30;
  const Lot lot = drawn(random);
  SealedCase sealed = draw_case(plan, seed);
  sealed.quantum.assign(sealed.quantum.size(), 0);
  sealed.parameters.clear();
  if (lot.frequency > 0) scatter_frequencies(sealed, lot.frequency, random);
  write_case(sealed, seed, folder);
  const double neighbour_hz = 1.37 * sealed.specimen.structure.mode[0].omega / (2 * std::numbers::pi);
  for (std::size_t r = 0; r < sealed.motions.size() + sealed.decays.size(); ++r)
    disturb_file(folder / "campaign" / dwell_file(r), lot, neighbour_hz, random);
  const std::string command = testing_support::program() + " identify " + (folder / "campaign").string() +
                              " --model " + (folder / "model.toml").string() + " -o " + (folder / "out").string() +
                              " --threads 1 >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  const auto estimate = nlohmann::json::parse(read_text(folder / "out/estimate.json"));
  std::vector<Number> numbers;
  for (const auto& [name, truth] : truth_of(sealed)) {
    Number& n = numbers.emplace_back();
    n.name = name;
    for (const auto& value : estimate.at("estimates")) {
      if (value.at("name") != name || !value.contains("value") || value["value"].is_null()) continue;
      n.given = true;
      n.doubtful = value.value("doubtful", false);
      n.off = (value["value"].get<double>() - truth) / value["sd"].get<double>();
      n.held = value["ci95"][0].get<double>() <= truth && truth <= value["ci95"][1].get<double>();
    }
  }
  return numbers;
}

TEST(SlowDisturbedLot, NoNumberIsFarOffUnmarked) {
  constexpr std::size_t campaigns = 12;
  constexpr std::uint64_t seed = 60606;
  const fs::path folder = testing_support::process_folder() / "disturbed_lot";
  std::vector<std::vector<Number>> lot(campaigns);
  in_parallel(campaigns, std::max(1U, std::thread::hardware_concurrency()), [&](std::size_t i) {
    lot[i] = identified(i, seed, case_folder(folder, i + 1));
    fs::remove_all(case_folder(folder, i + 1));
  });
  double asked = 0, given = 0, trusted = 0, held = 0, most = 0;
  for (std::size_t i = 0; i < campaigns; ++i) {
    most = std::max(most, static_cast<double>(lot[i].size()));
    for (const Number& n : lot[i]) {
      ++asked;
      if (!n.given) continue;
      ++given;
      if (n.doubtful) continue;
      ++trusted;
      held += n.held;
      EXPECT_LT(std::abs(n.off), 6) << "campaign " << i << ", " << n.name;
    }
  }
  // Three standard deviations of a binomial count whose numbers go together within a campaign.
  const double band = 3 * std::sqrt(0.05 * 0.95 * trusted * most);
  EXPECT_GE(held, 0.95 * trusted - band) << held << " of " << trusted;
  EXPECT_GE(given, 0.9 * asked) << given << " of " << asked;
  EXPECT_GT(trusted, 0.5 * given) << trusted << " of " << given;
}

}  // namespace
}  // namespace secular::blind
