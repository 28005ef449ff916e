#pragma once

#include <string>

namespace secular {

/// True if `file` matches a shell pattern with * and ?.
bool matches_pattern(const std::string& pattern, const std::string& file);

/// The same for what a record is called: a row of a table, FILE:LINE, matches with its file, too.
bool matches_record(const std::string& pattern, const std::string& record);

}  // namespace secular
