#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace secular::testing_support {

/// A folder of this process alone, removed at its end: test programs run side by side, one process a test.
inline const std::filesystem::path& process_folder() {
  struct Folder {
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("secular-tests-" + std::to_string(::getpid()));
  };
  static const Folder folder;
  return folder.path;
}

}  // namespace secular::testing_support
