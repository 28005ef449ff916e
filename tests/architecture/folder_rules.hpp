#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// The rules of the layout, and what the sources include.
namespace secular::architecture {

/// Folder -> folders of the project that its own files (not those of folders in it) may include, besides itself.
/// Each arrow points to a row above.
using FolderTable = std::vector<std::pair<std::string, std::set<std::string>>>;
const FolderTable& folder_table();

std::string first_part(const std::string& path);

/// Of a file's path: without the file's name.
std::string folder_of(const std::string& path);

bool is_build_folder(const std::filesystem::path& folder);

std::string read(const std::filesystem::path& file);

/// Sources of the folder itself, not of folders in it; `folder` from `root` on.
std::vector<std::filesystem::path> sources_of(const std::filesystem::path& root, const std::string& folder);

/// Folders of the table, and those of tests.
std::vector<std::string> folders_of_sources(const std::filesystem::path& root);

struct Include {
  std::string target;
  std::size_t line = 0;
};
std::vector<Include> includes_in(const std::string& text);

/// Whether an included file is in a folder of the table.
bool is_of_project(const std::string& target);

/// Folder -> folders that its files include; the folders of the commands, app/..., are one.
using FolderGraph = std::map<std::string, std::set<std::string>>;
FolderGraph included_folders(const std::filesystem::path& root);

}  // namespace secular::architecture
