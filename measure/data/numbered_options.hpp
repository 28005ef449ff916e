#pragma once

#include <string>
#include <vector>

#include "measure/data/import_channels.hpp"
#include "measure/data/import_files.hpp"

namespace secular {

/// The numbers that "*" stands for in the variables of the options: "run(*).tip" of run(1).tip, run(2).tip, ...:
/// "1", "2", ... One empty text without a "*". Throws InputError where the file has no such variable.
std::vector<std::string> numbers_in(const ImportOptions& options, const Variables& variables,
                                    const std::string& file);

/// The same options with that number for every "*".
ImportOptions numbered(ImportOptions options, const std::string& number);

}  // namespace secular
