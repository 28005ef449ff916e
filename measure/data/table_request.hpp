#pragma once

#include <map>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/table_convention.hpp"

namespace secular {

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

}  // namespace secular
