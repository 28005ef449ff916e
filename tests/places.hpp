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

}  // namespace secular::testing_support
