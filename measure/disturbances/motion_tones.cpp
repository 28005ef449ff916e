#include "measure/disturbances/motion_tones.hpp"

#include <algorithm>
#include <cmath>

#include "measure/thresholds.hpp"

namespace secular {
namespace {

// Halves and thirds are the subharmonics of equations with quadratic and cubic terms that are driven.
constexpr int largest_divisor = 3;
// Of sums of two excitations' multiples: a cubic term makes sums of three tones, and of two tones and one of these
// sums, five; what it makes of those in turn is far below any line here.
constexpr int largest_order = 3 + 2;

const Line* strongest(const SearchedChannel& channel) {
  const auto found = std::max_element(channel.lines.begin(), channel.lines.end(),
                                      [](const Line& a, const Line& b) { return a.amplitude < b.amplitude; });
  return found == channel.lines.end() ? nullptr : &*found;
}

// A decay has no subharmonics, but a softening spring swings slower while it swings far: a pendulum at 160 degrees
// with half the frequency of small angles.
constexpr auto& softest = measure_thresholds().softest;

// A partner at one given place: by chance beside one foreign tone of a hundred, which is then taken for motion. To
// miss a tone in one record costs less than to call a mode's motion foreign.
constexpr auto& weak_partner = measure_thresholds().weak_partner;

bool same(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance;
}

}  // namespace

MotionTones::MotionTones(const SearchedRecord& record) : record_(record), rate_(record.rate) {
  std::size_t shortest = record.samples();  // that lines were looked for in
  for (const SearchedChannel& channel : record.channels)
    if (!channel.lines.empty()) shortest = std::min(shortest, channel.intact.size());
  tolerance_ = lobe_bins * record.rate / static_cast<double>(std::max<std::size_t>(1, shortest));
  const RecordEntry& entry = record.entry();
  const bool dwell = entry.kind == RecordKind::dwell;
  forced_ = dwell;
  decays_ = entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact;
  const bool tonal = dwell || entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact;
  double largest_share = 0, in_lines = 0, in_all = 0;  // of the excitation's power
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const SearchedChannel& channel = record.channels[c];
    const Line* line = strongest(channel);
    if (line == nullptr) continue;
    if (dwell && record.is_excitation(c)) generators_.push_back(line->frequency_hz);
    if (!tonal && record.is_excitation(c)) {
      in_all += channel.rms * channel.rms;
      for (const Line& excited : channel.lines) {
        excited_.push_back(excited.frequency_hz);
        in_lines += 0.5 * excited.amplitude * excited.amplitude;
      }
    }
    if (tonal && !dwell && !record.is_excitation(c) && line->amplitude > largest_share * channel.rms) {
      largest_share = line->amplitude / channel.rms;
      generators_ = {line->frequency_hz};
      change_ = change_between_halves(channel.intact);
    }
  }
  if (dwell && generators_.empty() && entry.excitation_frequency_hz)
    generators_.push_back(*entry.excitation_frequency_hz);
  if (2 * in_lines > in_all) take_sums_of_two();
}

void MotionTones::take_sums_of_two() {
  sums_of_two_.assign(static_cast<std::size_t>(0.5 * rate_ / tolerance_) + 2, false);
  for (const double a : excited_)
    for (const double b : excited_)
      for (const double sum : {a + b, a - b}) {
        const double place = folded(sum) / tolerance_;
        for (const double near : {std::floor(place), std::ceil(place)})
          sums_of_two_[static_cast<std::size_t>(near)] = true;
      }
}

bool MotionTones::is_sum_of_excited(double frequency_hz) const {
  if (sums_of_two_.empty()) return false;
  const auto is_of_two = [&](double f) {
    return sums_of_two_[static_cast<std::size_t>(std::lround(folded(f) / tolerance_))];
  };
  return is_of_two(frequency_hz) || std::any_of(excited_.begin(), excited_.end(), [&](double f) {
           return is_of_two(frequency_hz - f) || is_of_two(frequency_hz + f);
         });
}

double MotionTones::folded(double frequency_hz) const {
  return std::abs(frequency_hz - rate_ * std::round(frequency_hz / rate_));
}

bool MotionTones::is_multiple(double frequency_hz, double of_hz, double tolerance) const {
  for (int q = 1; q <= (decays_ ? 1 : largest_divisor); ++q)
    if (same(frequency_hz * q, of_hz * std::round(frequency_hz * q / of_hz), tolerance)) return true;
  return false;
}

// Between half and twice the sample rate harmonics are folded back once or twice.
bool MotionTones::is_folded(double frequency_hz, double of_hz) const {
  for (double multiple = of_hz; multiple < 2 * rate_; multiple += of_hz)
    if (same(frequency_hz, folded(multiple), tolerance_)) return true;
  return false;
}

bool MotionTones::has_partner(double frequency_hz, double of_hz, const std::vector<double>& others,
                              double tolerance) const {
  for (double multiple = of_hz; multiple < rate_; multiple += of_hz)
    for (const double other : others)
      if (!same(other, frequency_hz, tolerance) && (same(other, folded(multiple - frequency_hz), tolerance) ||
                                                    same(other, folded(multiple + frequency_hz), tolerance)))
        return true;
  return false;
}

bool MotionTones::has_weak_partner(double frequency_hz, double of_hz) const {
  for (const SearchedChannel& channel : record_.channels)
    for (const double partner : {folded(of_hz - frequency_hz), folded(of_hz + frequency_hz)}) {
      const double bins = partner / (0.5 * rate_) * (static_cast<double>(channel.powers.size()) - 1);
      if (channel.powers.empty() || is_multiple(partner, of_hz, tolerance_)) continue;
      if (probability_of_no_line(channel.powers, static_cast<std::size_t>(std::lround(bins))) < weak_partner)
        return true;
    }
  return false;
}

bool MotionTones::is_harmonic(double frequency_hz) const {
  if (std::any_of(excited_.begin(), excited_.end(), [&](double f) { return same(f, frequency_hz, tolerance_); }))
    return true;
  if (is_sum_of_excited(frequency_hz)) return true;
  for (std::size_t a = 0; a < generators_.size(); ++a) {
    if (is_multiple(frequency_hz, generators_[a], tolerance_) || is_folded(frequency_hz, generators_[a]))
      return true;
    for (std::size_t b = a + 1; b < generators_.size(); ++b)
      for (int i = 0; i <= largest_order; ++i)
        for (int j = i - largest_order; j <= largest_order - i; ++j)
          if (same(frequency_hz, folded(i * generators_[a] + j * generators_[b]), tolerance_)) return true;
  }
  return false;
}

bool MotionTones::make(double frequency_hz, const std::vector<double>& others) const {
  return is_harmonic(frequency_hz) || std::any_of(generators_.begin(), generators_.end(), [&](double generator) {
           return has_partner(frequency_hz, generator, others, tolerance_) ||
                  (forced_ && has_weak_partner(frequency_hz, generator));
         });
}

bool MotionTones::is_outlasted_by(const Line& line) const {
  return decays_ && outlasts_products(line, change_, record_.level) &&
         std::none_of(generators_.begin(), generators_.end(),
                      [&](double generator) { return same(line.frequency_hz, generator, tolerance_); });
}

bool MotionTones::start_at(double frequency_hz, const std::vector<double>& others, double error_hz) const {
  return std::any_of(generators_.begin(), generators_.end(), [&](double generator) {
    return is_multiple(frequency_hz, generator, tolerance_ + error_hz) ||
           has_partner(frequency_hz, generator, others, tolerance_ + error_hz);
  });
}

double MotionTones::lowest_hz() const {
  const auto lowest = std::min_element(generators_.begin(), generators_.end());
  if (lowest == generators_.end()) return 0;
  return *lowest / static_cast<double>(forced_ ? largest_divisor : softest);
}

}  // namespace secular
