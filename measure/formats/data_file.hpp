#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "measure/formats/number_table.hpp"
#include "measure/formats/quantity.hpp"
#include "measure/formats/row_place.hpp"

namespace secular {

/// Where a channel measures, and along which of the axes x, y, z (a unit vector).
struct SensorPlace {
  std::string node;
  std::array<double, 3> direction{};
};

/// A named variable of a data file: a column of a CSV, a numeric variable of a MAT or HDF5 file, a channel of a UFF
/// or WAV file.
struct DataVariable {
  std::string name;
  std::vector<std::size_t> shape;
  std::string type;                    ///< "double", "int16", ...; "text" for a CSV column without any number
  std::vector<double> values;          ///< NaN where no number stands (MissingNumbers)
  std::string fault;                   ///< why it has no values: "is complex", ...; empty if it has
  std::optional<Quantity> quantity{};  ///< what it measures, where the file says so in terms that are known
  std::string unit{};                  ///< of `values` where `quantity` is known: its SI unit
  std::string stated_unit{};   ///< as the file spells it; values were converted from it if `unit` is not empty
  bool of_full_scale = false;  ///< values are fractions of a converter's range, which mean no unit by themselves
  std::optional<SensorPlace> sensor{};  ///< of a translation, where the file says so
};

/// The stamps of a time variable become seconds: from the unit that its file states, or its name ("Time (ms)",
/// "time [us]", "t_min"), or else `given` (--time NAME:UNIT), which goes first. Throws InputError for a unit that
/// is not known.
void convert_to_seconds(DataVariable& time, const std::string& file, const std::string& given = {});

/// True for a variable without a name of its own (a nameless column, a line of a matrix) that is 0, 1, 2, ... or 1,
/// 2, 3, ...: it counts rows, and is no time in seconds.
bool counts_rows(const DataVariable& variable);

/// True for a variable that is called time: "t", "Time", "time_ms", "Time [s]", "run.t (us)".
bool is_called_time(const std::string& name);

/// True where it is a word among others: "Data1_time_Tip".
bool holds_word_time(const std::string& name);

/// True for one that may be a time beside others: these, and "t_tip", "time 2", "Time_B (ms)".
bool may_be_time(const std::string& name);

/// Why a variable is no channel of that quantity: its file says that it measures another one. Else empty.
std::string quantity_fault(const DataVariable& variable, Quantity quantity);

/// What a data file holds.
struct DataFile {
  std::string file;
  std::string format;  ///< "CSV", "MAT v5", "MAT v7.3", "HDF5", "UFF 58", "WAV"
  std::vector<DataVariable> variables;
  RowPlace place;
  std::size_t segment = 0;         ///< which of count_segments()
  bool partial = false;            ///< only the first values were read; the length of a CSV is estimated then
  std::vector<double> last_row{};  ///< of a CSV read in part: by variable, empty if its end is damaged

  /// The variable of that name, which must be a vector of numbers. Throws InputError that names the variables there
  /// are.
  const DataVariable& vector(const std::string& name) const;
  DataVariable& vector(const std::string& name);
  /// Its place in `variables`, by the same rules.
  std::size_t index_of(const std::string& name) const;
  /// Their names, as messages list them.
  std::string names() const;
};

/// Reads the variables (values of `wanted` only; empty: of all; at most `limit` of each, and then nothing is read
/// of the rest where the format lets it be skipped). The format is told by content, then by name. Throws InputError
/// for a file of another format, a damaged one, and (MissingNumbers::refuse) a value that is no finite number. The
/// decimal mark is that of a CSV. `segment`: of a file that holds several records (count_segments).
DataFile read_data_file(const std::filesystem::path& path, const std::vector<std::string>& wanted = {},
                        MissingNumbers missing = MissingNumbers::refuse, std::size_t limit = all_values,
                        DecimalMark mark = DecimalMark::by_dialect, std::size_t segment = 0);

/// How many records of the same channels the file holds, one behind the other: segments of an LVM file,
/// repeats of the same degrees of freedom in a UFF file; of all others 1.
std::size_t count_segments(const std::filesystem::path& path);

/// Takes the columns of a CSV whose header states a known unit of what a channel measures to SI, and says so in
/// `quantity` and `unit`, as readers of other formats do themselves: a campaign's own records are in SI, whatever
/// their columns are called.
void convert_csv_units(DataFile& data);

/// The formats, as messages name them.
inline constexpr const char* data_formats = "CSV, MAT, HDF5, UFF 58, LVM or WAV";

/// The variables that `read_data_file` would find, without their values.
std::vector<DataVariable> describe_data_file(const std::filesystem::path& path);

}  // namespace secular
