#pragma once

#include "measure/formats/uff_lines.hpp"

namespace secular {

/// The line below the delimiter that begins a data set of a universal file.
struct UffDataSetHead {
  long long number = 0;
  bool binary = false;
  long long byte_order = 0, float_format = 0, header_lines = 0, bytes = 0;  ///< of binary ones
};

/// Goes to the next data set and takes its head; false at the end of the file. Throws InputError for what stands
/// between data sets.
bool next_data_set(UffLines& lines, UffDataSetHead& head);

/// Goes behind the delimiter that ends the data set. Throws InputError where there is none.
void skip_data_set(const UffDataSetHead& head, UffLines& lines);

}  // namespace secular
