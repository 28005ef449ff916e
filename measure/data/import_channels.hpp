#pragma once

#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/import_files.hpp"
#include "measure/formats/data_file.hpp"

namespace secular {

/// A channel as --channel describes it.
struct DescribedChannel {
  Channel channel;
  std::string variable;          ///< of the files
  double si_factor = 1;          ///< SI value = si_factor * number of the file, where its unit is not stated there
  std::string given_unit{};      ///< what `si_factor` stands for: "g", "0.02 g"
  bool of_voltage = false;       ///< files state volts, of which `si_factor` makes the quantity
  bool stated_by_files = false;  ///< quantity and unit
};

/// How a channel is described in full, for messages.
inline constexpr const char* channel_form =
    "--channel NAME:ROLE:QUANTITY:UNIT, for example theta:response:angle:rad";
inline constexpr const char* factor_form =
    "--channel NAME:ROLE:QUANTITY:UNIT:FACTOR, where a number x of the file means x*FACTOR in UNIT";

using Variables = std::vector<DataVariable>;

/// The variable of that name, or null.
const DataVariable* find_variable(const Variables& variables, const std::string& name);

/// Their names, as messages list them.
std::string listed_names(const Variables& variables);

/// The channels that options.channels describe among the variables of the first file. Throws InputError that names
/// the option.
std::vector<DescribedChannel> describe_channels(const ImportOptions& options, const Variables& variables);

}  // namespace secular
