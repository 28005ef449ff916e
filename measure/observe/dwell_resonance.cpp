#include "measure/observe/dwell_resonance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include "measure/observe/record_window.hpp"
#include "measure/signal/tone_fit.hpp"
#include "measure/signal/tone_separation.hpp"
#include "measure/thresholds.hpp"
#include "numerics/hertz.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;

/// Samples of a dwell that are looked at: enough to tell a line from noise (a size: half and twice as
/// many move nothing).
constexpr Index most_samples = 4096;

// Of the modes whose frequency the relations tie to the excitation's alone, one after the other.
std::vector<Subharmonic> subharmonics_of(const Resonance& resonance) {
  std::vector<Subharmonic> found;
  if (!resonance.excited || resonance.relations.empty()) return found;
  const std::size_t modes = resonance.relations.front().size() - 1;
  std::vector<std::optional<Subharmonic>> tied(modes);  // any part or multiple of the excitation frequency
  for (bool more = true; more;) {
    more = false;
    for (const std::vector<int>& relation : resonance.relations) {
      std::vector<std::size_t> open;
      int numerator = -relation.back(), denominator = 1;
      for (std::size_t k = 0; k < modes; ++k) {
        if (relation[k] == 0) continue;
        if (!tied[k]) {
          open.push_back(k);
          continue;
        }
        numerator = numerator * tied[k]->denominator - relation[k] * tied[k]->numerator * denominator;
        denominator *= tied[k]->denominator;
      }
      if (open.size() != 1) continue;
      denominator *= relation[open.front()];
      const int common = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
      tied[open.front()] = {numerator / common, denominator / common};
      more = true;
    }
  }
  for (const std::optional<Subharmonic>& part : tied)
    if (part && part->numerator > 0 && part->numerator < part->denominator) found.push_back(*part);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Lines of a table that stand out of their noise; where that is not known, those that are there.
std::vector<Subharmonic> tabled_subharmonics(const LineRow& row, const std::vector<std::size_t>& responses,
                                             const std::vector<Subharmonic>& looked_for) {
  std::vector<Subharmonic> seen;
  for (const Subharmonic& s : looked_for) {
    const bool there = std::any_of(responses.begin(), responses.end(), [&](std::size_t channel) {
      const LineNumber number{s.numerator, s.denominator};
      const TableLine* line = row.find(channel, number);
      return line != nullptr &&
             std::abs(line->amplitude) > least_amplitude_sd() * row.sd_of(channel, number).value_or(0);
    });
    if (there) seen.push_back(s);
  }
  return seen;
}

std::vector<Subharmonic> seen_subharmonics(const Campaign& campaign, const Record& record, double excitation,
                                           const std::vector<Subharmonic>& looked_for, const Window& window) {
  const std::vector<std::size_t> responses = channels_of(campaign, ChannelRole::response);
  if (record.row) return tabled_subharmonics(*record.row, responses, looked_for);
  const SampleRange range = range_of(record, window);
  const Index count = std::min(range.count, most_samples);
  const double resolution = two_pi * record.sample_rate_hz / static_cast<double>(std::max<Index>(1, count));
  std::vector<double> frequencies;
  for (const Subharmonic& s : looked_for) frequencies.push_back(excitation * s.numerator / s.denominator);
  for (const int n : {1, 2, 3})
    if (n * excitation < 0.5 * two_pi * record.sample_rate_hz - bins_between_tones * resolution)
      frequencies.push_back(n * excitation);
  std::vector<double> sorted = frequencies;
  std::sort(sorted.begin(), sorted.end());
  double apart = sorted.front();
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) apart = std::min(apart, sorted[i + 1] - sorted[i]);
  if (responses.empty() || apart < bins_between_tones * resolution) return {};
  const KnownFrequencyFit fit = known_frequency_components(samples_of(record, responses, range.first, count),
                                                           record.sample_rate_hz, frequencies, true);
  std::vector<Subharmonic> seen;
  for (std::size_t s = 0; s < looked_for.size(); ++s) {
    const auto row = static_cast<Index>(s);
    if ((fit.amplitude.row(row).array().abs() > least_amplitude_sd() * fit.amplitude_sd.row(row).array()).any())
      seen.push_back(looked_for[s]);
  }
  return seen;
}

}  // namespace

double mismatch(const Resonance& resonance, const std::vector<double>& natural, double excitation) {
  if (resonance.relations.empty()) return INFINITY;
  double worst = 0;
  for (const std::vector<int>& relation : resonance.relations) {
    if (relation.size() != natural.size() + 1) return INFINITY;  // there are further excitations
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < relation.size(); ++i) {
      if (relation[i] == 0) continue;
      const double term = relation[i] * (i < natural.size() ? natural[i] : excitation);
      sum += term;
      size = std::max(size, std::abs(term));
    }
    if (!std::isfinite(sum)) return INFINITY;
    worst = std::max(worst, std::abs(sum) / size);
  }
  return worst;
}

std::vector<DwellTones> dwell_tones(const Campaign& campaign, const RecordReader& read,
                                    const std::vector<Resonance>& cases, const Window& window) {
  std::vector<DwellTones> dwells;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (is_steady(entry.kind) && entry.excitation_frequency_hz && window.takes(r, entry.file))
      dwells.push_back({r, two_pi * *entry.excitation_frequency_hz, {}});
  }
  std::vector<Subharmonic> all;
  bool differ = false;
  const Resonance* first = nullptr;
  for (const Resonance& resonance : cases) {
    if (!resonance.excited) continue;
    const std::vector<Subharmonic> own = subharmonics_of(resonance);
    if (first && own != subharmonics_of(*first)) differ = true;
    if (!first) first = &resonance;
    all.insert(all.end(), own.begin(), own.end());
  }
  if (!differ) return dwells;
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  in_parallel(dwells.size(), window.threads, [&](std::size_t i) {
    dwells[i].subharmonics = seen_subharmonics(campaign, read(dwells[i].record), dwells[i].excitation, all, window);
  });
  return dwells;
}

DwellCase case_of_dwell(const DwellTones& dwell, const std::vector<Resonance>& cases,
                        const std::vector<double>& natural) {
  using Response = DwellCase::Response;
  DwellCase best{cases.size(), Response::contradicts};
  double least = INFINITY;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    if (!cases[c].excited) continue;
    const double off = mismatch(cases[c], natural, dwell.excitation);
    if (!(off < measure_thresholds().largest_detuning)) continue;
    const std::vector<Subharmonic> own = subharmonics_of(cases[c]);
    const bool has_all =
        std::includes(own.begin(), own.end(), dwell.subharmonics.begin(), dwell.subharmonics.end());
    const Response response = !has_all                                 ? Response::contradicts
                              : own.size() > dwell.subharmonics.size() ? Response::at_rest
                                                                       : Response::agrees;
    if (std::tie(response, off) >= std::tie(best.response, least)) continue;
    least = off;
    best = {c, response};
  }
  return best;
}

}  // namespace secular
