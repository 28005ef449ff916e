#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/data/line_row.hpp"
#include "measure/data/table_request.hpp"

namespace secular {

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

}  // namespace secular
