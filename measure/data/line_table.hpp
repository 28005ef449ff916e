#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/line_row.hpp"
#include "measure/formats/data_file.hpp"

namespace secular {

/// What the numbers of a table mean. Where a file states a unit itself that is the one.
struct TableConvention {
  enum class Amplitude { peak, rms, peak_to_peak };

  Amplitude amplitude = Amplitude::peak;  ///< of a level, too
  std::optional<bool> degrees;            ///< of phases; nothing: not known
  bool lags = false;             ///< a positive phase is one of a response that comes later: cos(Omega t - phase)
  double phase_offset_rad = 0;   ///< comes on top of the phases of responses
  bool per_excitation = false;   ///< responses are frequency response functions: over the excitation's amplitude
  std::optional<double> level;   ///< of the excitation in all rows, in its SI unit, where no column holds it
  std::string frequency_unit{};  ///< Hz, kHz, rad/s or 1/min
};

/// The same as a person says it; an empty text says nothing.
struct ConventionWords {
  std::string amplitudes{}, phases{}, phase_sign{}, frequency_unit{};
  double phase_offset_deg = 0;
  bool per_excitation = false;
};
/// Ends with an error of its own: which word ("phase_sign"), what it is, what is wrong with it, what was expected.
using RefuseWord = std::function<void(const std::string& word, const std::string& is, const std::string& wrong,
                                      const std::string& expected)>;
/// Without a level.
TableConvention convention_of(const ConventionWords& words, const RefuseWord& refuse);

inline constexpr const char* frequency_unit_list = "Hz, kHz, rad/s or 1/min";
/// Hz in a unit of frequency; nothing for another unit.
std::optional<double> hertz_in(const std::string& unit);

/// A channel of a table.
struct TableChannel {
  std::string name;
  ChannelRole role = ChannelRole::response;
  std::string variable;  ///< what its columns' names begin with
  Quantity quantity = Quantity::displacement;
  double si_factor = 1;  ///< of numbers whose unit the file does not state
};

/// How one says what a table does not, in the words of whoever asks.
struct TableWords {
  std::string phases, column, level, frequency_unit;  ///< of `column` {} is the part that has none
};

struct TableRequest {
  std::vector<TableChannel> channels;
  /// Parts of a table that are called otherwise: "f", "condition", "tip", "tip.phase", "tip@3.sd" to variables.
  std::map<std::string, std::string> columns;
  TableConvention convention;
  TableWords words;
};

struct LineTable {
  std::vector<LineRow> rows;
  std::vector<std::string> damaged;  ///< "line 7: tip is no number"; these rows are not among the others
  std::vector<std::string> unused;   ///< variables of the file
};

/// Reads a table of lines from any file that read_data_file reads. By channel c, at Omega or behind c@N at N times
/// Omega (c@3, c@1/2; c@0: the mean), it has amplitude and phase (c, c.phase) or real and imaginary part (c.re,
/// c.im), and perhaps standard deviations (c.sd, c.phase_sd); an excitation without a phase has phase 0. `_` or a
/// blank may stand for the point. A line that is no number in some row is not measured there; a row without a
/// frequency or without the channels at Omega is damaged. Throws InputError with file and place.
LineTable read_line_table(const std::filesystem::path& path, const TableRequest& request);

/// A table as a campaign keeps it: names and columns, f in Hz, every line c.re, c.im and c.sd (where one row has
/// it).
struct TableColumns {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
};
TableColumns columns_of(const std::vector<LineRow>& rows, const std::vector<Channel>& channels);

/// "@1/2"; nothing for the line at Omega.
std::string line_suffix(LineNumber number);

/// The row with the base's acceleration taken out of the responses that are absolute (Channel::frame).
LineRow relative_to_base(const Campaign& campaign, LineRow row);

}  // namespace secular
