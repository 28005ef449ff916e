#pragma once

#include <filesystem>
#include <string>

namespace secular::testing_support {

// These paths differ from clone to clone. They stand in one source file, so that a compiler's cache knows all
// others.

/// The folder that holds models/, tests/ and the rest.
std::filesystem::path source_folder();

/// The program `secular` of this build.
std::string program();

/// A folder of this build for caches of compiled models. Tests of many campaigns of one model share it; entries are
/// found by all that they depend on, the code of the model, headers, compiler and program.
std::filesystem::path shared_cache();

}  // namespace secular::testing_support
