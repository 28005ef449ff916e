#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/campaign_writer.hpp"

namespace secular {

/// What the user says about tables of lines; the comments name the options.
struct TableOptions {
  std::vector<std::string> columns;        ///< --column PART=VARIABLE
  std::string amplitudes;                  ///< --amplitudes; empty: peak
  std::string phases;                      ///< --phases; empty: as the files state
  std::string phase_sign;                  ///< --phase-sign; empty: lead
  std::optional<double> phase_offset_deg;  ///< --phase-offset
  bool per_excitation = false;             ///< --per-excitation
  std::string frequency_unit;              ///< --frequency-unit; empty: as the files state, else Hz

  bool any() const {
    return !columns.empty() || !amplitudes.empty() || !phases.empty() || !phase_sign.empty() || phase_offset_deg ||
           per_excitation || !frequency_unit.empty();
  }
};

/// What the user says about files of other origin; the comments name the options of `secular import`.
struct ImportOptions {
  std::vector<std::filesystem::path> files;  ///< one record each
  std::string kind;                          ///< --kind
  std::vector<std::string> channels;         ///< --channel NAME[=VARIABLE]:ROLE[:QUANTITY:UNIT]
  std::vector<std::string> absolute;         ///< names of channels that are absolute (Channel::frame)
  std::vector<std::string> delays;           ///< --delay NAME=S
  std::string time;                          ///< --time; empty: "t", or the one variable that is called time
  std::optional<double> sample_rate_hz;  ///< --sample-rate; checked against the time stamps where both are given
  std::string name;                      ///< --name; empty: the first file's name without extension
  std::string group;                     ///< --group
  std::vector<double> frequencies_hz;    ///< --frequency: none, one for all files or one a file
  std::vector<double> amplitudes;        ///< --amplitude: the same
  std::optional<double> ensemble_s;      ///< --ensemble
  std::filesystem::path geometry;        ///< --geometry: a universal file; empty: the first file, if it holds nodes
  TableOptions table;                    ///< of kind `lines` alone
  std::string decimal_mark;              ///< --decimal-mark: "." or ","; empty: as the dialect of a CSV has it
};

struct ConvertedChannel {
  std::string name, from_unit, to_unit;
};

struct ImportedCampaign {
  Campaign campaign;
  std::vector<std::string> left_out;        ///< variables that no --channel or --time names, each once
  std::vector<ConvertedChannel> converted;  ///< channels whose unit the first file spells in another way or scales
  std::vector<std::filesystem::path> sources{};  ///< of samples: by record, the file that it came from
  std::vector<std::string> warnings{};           ///< what was done to the samples, or is wrong with their time
};

/// Reads the files as records of one campaign, one each, or one for each of its segments (count_segments) and of
/// the numbers that "*" stands for in the variables (numbered_options.hpp); samples keep their bits, but for units
/// that a file states and that are not SI: those are converted. Throws InputError that names the option for
/// everything the files cannot say, and the file's variables where it helps. `sink` takes the records one after
/// another: together they need not fit into memory.
ImportedCampaign import_files(const ImportOptions& options, const RecordSink& sink);

}  // namespace secular
