// The rules of the layout as tests: which folder may include which, and what may not stand in a committed file.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = SECULAR_SOURCE_DIR;

/// Folder -> folders of the project that its files may include (besides itself). Dependencies point one way:
/// app -> {diagnose, simulate, codegen} -> {estimator, perturb} -> input.
const std::map<std::string, std::set<std::string>> allowed_folders = {
    {"input", {}},
    {"perturb", {"input"}},
    {"verify", {"input", "perturb"}},
    {"codegen", {"input", "perturb", "estimator"}},
    {"estimator", {"input"}},
    {"generated", {"estimator"}},
    {"simulate", {"input", "estimator"}},
    {"diagnose", {"input", "estimator", "simulate"}},
    {"report", {"input"}},
    {"blind", {"input"}},
    {"app", {"input", "perturb", "codegen", "estimator", "generated", "simulate", "diagnose", "report", "verify", "blind"}},
};

/// Folders that may see GiNaC and CLN: a compiled estimator links without them.
const std::set<std::string> symbolic_folders = {"perturb", "verify", "codegen"};

bool is_build_folder(const fs::path& folder) {
  return folder.filename() == "build" || fs::exists(folder / "CMakeCache.txt");
}

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool is_source(const fs::path& file) {
  static const std::set<std::string> extensions = {".cpp", ".hpp", ".h", ".cc", ".in"};
  return extensions.count(file.extension().string()) == 1;
}

std::vector<fs::path> sources_of(const std::string& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(root / folder)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
    if (entry.is_regular_file() && is_source(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

struct Include {
  std::string target;
  std::size_t line = 0;
};

std::vector<Include> includes_in(const std::string& text) {
  static const std::regex directive(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])");
  std::vector<Include> found;
  std::size_t line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    ++line_number;
    std::smatch match;
    const std::string line = text.substr(begin, end - begin);
    if (std::regex_search(line, match, directive)) found.push_back({match[1], line_number});
    begin = end + 1;
  }
  return found;
}

std::string first_part(const std::string& path) {
  return path.substr(0, path.find('/'));
}

bool is_symbolic_library(const std::string& target) {
  const std::string part = first_part(target);
  return part == "ginac" || part == "cln";
}

std::vector<std::string> violations(const std::string& folder, const std::string& name, const std::string& text) {
  std::vector<std::string> found;
  const std::set<std::string>& allowed = allowed_folders.at(folder);
  for (const Include& include : includes_in(text)) {
    const std::string where = name + ":" + std::to_string(include.line) + " includes " + include.target;
    const std::string target = first_part(include.target);
    const bool of_project = include.target != target && allowed_folders.count(target) == 1;
    if (of_project && target != folder && allowed.count(target) == 0) found.push_back(where);
    if (is_symbolic_library(include.target) && symbolic_folders.count(folder) == 0) found.push_back(where);
    if (include.target.find("..") != std::string::npos) found.push_back(where + " (write paths from the root)");
  }
  return found;
}

class FolderIncludes : public testing::TestWithParam<std::string> {};

TEST_P(FolderIncludes, OnlyWhatTheLayoutAllows) {
  const std::vector<fs::path> files = sources_of(GetParam());
  if (files.empty()) GTEST_SKIP() << GetParam() << " holds no source yet";
  for (const fs::path& file : files)
    for (const std::string& violation : violations(GetParam(), fs::relative(file, root).string(), read(file)))
      ADD_FAILURE() << violation;
}

std::vector<std::string> folder_names() {
  std::vector<std::string> names;
  for (const auto& [folder, allowed] : allowed_folders) names.push_back(folder);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Layout, FolderIncludes, testing::ValuesIn(folder_names()),
                         [](const auto& instance) { return instance.param; });

/// GiNaC also arrives through a header of perturb: where it may not be included it may not be reached either.
TEST(Layout, NumericFoldersDoNotReachGinac) {
  for (const auto& [folder, allowed] : allowed_folders) {
    if (symbolic_folders.count(folder) == 1 || folder == "app") continue;
    std::set<std::string> reached;
    std::vector<fs::path> pending = sources_of(folder);
    while (!pending.empty()) {
      const fs::path file = pending.back();
      pending.pop_back();
      for (const Include& include : includes_in(read(file))) {
        EXPECT_FALSE(is_symbolic_library(include.target))
            << folder << " reaches " << include.target << " in " << file;
        if (fs::is_regular_file(root / include.target) && reached.insert(include.target).second)
          pending.push_back(root / include.target);
      }
    }
  }
}

TEST(Layout, EveryFolderOfSourcesHasARule) {
  static const std::set<std::string> elsewhere = {"tests", "bench",  "build", "out",
                                                  "docs",  "models", "cmake", "examples"};
  for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory() || name.starts_with(".") || is_build_folder(entry.path()) ||
        elsewhere.count(name) == 1)
      continue;
    if (sources_of(name).empty()) continue;
    EXPECT_EQ(allowed_folders.count(name), 1u) << name << "/ is not in the table";
  }
}

TEST(Layout, TheScanSeesWhatItForbids) {
  EXPECT_EQ(violations("estimator", "x.cpp", "#include \"perturb/model.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("report", "x.cpp", "int a;\n  #  include <ginac/ginac.h>\n").size(), 1u);
  EXPECT_EQ(violations("perturb", "x.cpp", "#include \"estimator/compiled_model.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("generated", "x.cpp", "#include \"input/input_error.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("app", "x.cpp", "#include <ginac/ginac.h>").size(), 1u);
  EXPECT_EQ(violations("app", "x.cpp", "#include \"perturb/model.hpp\"\n#include <map>\n").size(), 0u);
  EXPECT_EQ(violations("perturb", "x.cpp", "#include <ginac/ginac.h>\n#include \"perturb/a.hpp\"\n").size(), 0u);
}

/// Text files of the tree that are, or will be, committed: everything outside of build and output folders.
std::vector<fs::path> committed_files() {
  static const std::set<std::string> text_types = {".cpp",  ".hpp", ".h",  ".in", ".txt", ".cmake", ".toml", ".md",
                                                   ".json", ".svg", ".sh", ".py", ".csv", ".tex",   ".html", ""};
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string name = entry->path().filename().string();
    const bool at_top = entry.depth() == 0;
    const bool made_by_a_build = at_top && (name == ".git" || name == ".cache" || name == "out" ||
                                            name == "CMakeUserPresets.json" || is_build_folder(entry->path()));
    if (entry->is_directory() && made_by_a_build) entry.disable_recursion_pending();
    if (entry->is_regular_file() && !made_by_a_build && text_types.count(entry->path().extension().string()) == 1)
      files.push_back(entry->path());
  }
  return files;
}

TEST(CommittedFiles, NamePlacesOfNoMachine) {
  // Put together here, so that this file does not contain them.
  const std::string slash = "/";
  const std::vector<std::string> machine_paths = {slash + "work/", slash + "tmp/build", slash + "home/",
                                                  slash + "root/", slash + "Users/"};
  const std::vector<fs::path> files = committed_files();
  ASSERT_GT(files.size(), 10u);
  for (const fs::path& file : files) {
    const std::string text = read(file);
    for (const std::string& path : machine_paths) {
      // "frame/work/" is no path of a machine: something before the slash makes it relative.
      bool absolute = false;
      for (std::size_t at = text.find(path); at != std::string::npos && !absolute; at = text.find(path, at + 1))
        absolute = at == 0 || std::string_view(" \t\n\"'`(=:,;<>I").find(text[at - 1]) != std::string_view::npos;
      EXPECT_FALSE(absolute) << fs::relative(file, root) << " contains " << path;
    }
  }
}

}  // namespace
