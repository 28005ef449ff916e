#pragma once

#include <compare>
#include <complex>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace secular {

/// A line at numerator/divisor times the excitation's frequency, in lowest terms; 0/1: the mean.
struct LineNumber {
  int numerator = 1, divisor = 1;

  bool is_mean() const { return numerator == 0; }
  double of(double frequency) const { return frequency * numerator / divisor; }
  friend auto operator<=>(const LineNumber&, const LineNumber&) = default;
};

/// One line of one channel: x(t) = Re(amplitude exp(i n/d Omega t)), peak, in the unit of the channel; of a mean
/// the real part is all there is.
struct TableLine {
  std::size_t channel = 0;  ///< in Campaign::channels
  LineNumber number;
  std::complex<double> amplitude;
  /// Of its real and of its imaginary part, each. Nothing: the table does not say it; a level is exact then.
  std::optional<double> sd;
};

/// One row of a table of lines: what one settled dwell did.
struct LineRow {
  std::string table;  ///< its file, as campaign.toml names it
  std::string place;  ///< "line 12"
  double frequency_hz = 0;
  std::vector<TableLine> lines;
  /// Rows of a table with the same label are repeats of one condition. Nothing: a condition of its own.
  std::optional<long long> condition;

  const TableLine* find(std::size_t channel, LineNumber number) const {
    for (const TableLine& line : lines)
      if (line.channel == channel && line.number == number) return &line;
    return nullptr;
  }

  /// Standard deviation of a line: its own; else by that of its channel at Omega, of which a mean's is smaller by
  /// sqrt(2), since a sample's noise leaves sqrt(2/n) of a line's real part. Nothing: the row does not say it.
  std::optional<double> sd_of(std::size_t channel, LineNumber number) const {
    const TableLine *own = find(channel, number), *fundamental = find(channel, {});
    if (own != nullptr && own->sd) return own->sd;
    if (fundamental == nullptr || !fundamental->sd) return std::nullopt;
    return number.is_mean() ? *fundamental->sd / std::numbers::sqrt2 : *fundamental->sd;
  }
};

}  // namespace secular
