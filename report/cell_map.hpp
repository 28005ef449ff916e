#pragma once

#include <string>
#include <vector>

namespace secular::report {

/// Numbers of rows and columns as shaded cells.
struct CellMap {
  std::string title;
  std::string columns_are;  ///< axis below: "Peak amplitude of v (10^-3 m)"
  std::string values_are;   ///< key beside the title: "root mean square, sd"
  std::vector<std::string> rows, columns;
  std::vector<std::vector<double>> values;  ///< [row][column]; a cell that is not a number stays empty
};

/// One <svg> element. The shade begins at a value of one and is full at `full`, evenly in the logarithm; every cell
/// says its number, too. Colours follow the page. Throws std::invalid_argument where sizes differ.
std::string cell_map(const CellMap& map, double full = 30);

/// Bars of shares, each from 0 to 1, by row.
struct ShareBars {
  std::string title;
  std::vector<std::string> rows;
  std::vector<std::string> names;           ///< of the one or two bars that a row has
  std::vector<std::vector<double>> values;  ///< [row][bar]; below zero or not a number: no bar, the text says it
};

/// One <svg> element, bars with their numbers.
std::string share_bars(const ShareBars& bars);

}  // namespace secular::report
