// The rules of the layout as tests: which folder may include which, and what may not stand in a committed file.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "folder_rules.hpp"
#include "layout_figure.hpp"
#include "tests/places.hpp"

namespace secular::architecture {
namespace {

namespace fs = std::filesystem;

const fs::path root = secular::testing_support::source_folder();

const std::map<std::string, std::set<std::string>> allowed_folders(folder_table().begin(), folder_table().end());

/// Folders that may see GiNaC and CLN: a compiled estimator links without them.
const std::set<std::string> symbolic_folders = {"perturb", "thesis/verify", "codegen/canonical"};

/// Folders that may see them through others.
bool may_reach_symbolic(const std::string& folder) {
  static const std::set<std::string> above = {"codegen", "jobs", "python", "app"};
  return symbolic_folders.count(folder) == 1 || above.count(first_part(folder)) == 1;
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
    const std::string target = folder_of(include.target);
    if (is_of_project(include.target) && target != folder && allowed.count(target) == 0) found.push_back(where);
    if (is_symbolic_library(include.target) && symbolic_folders.count(folder) == 0) found.push_back(where);
    if (include.target.find("..") != std::string::npos) found.push_back(where + " (write paths from the root)");
  }
  return found;
}

class FolderIncludes : public testing::TestWithParam<std::string> {};

TEST_P(FolderIncludes, OnlyWhatTheLayoutAllows) {
  const std::vector<fs::path> files = sources_of(root, GetParam());
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

INSTANTIATE_TEST_SUITE_P(Layout, FolderIncludes, testing::ValuesIn(folder_names()), [](const auto& instance) {
  std::string name = instance.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
});

TEST(Layout, ArrowsPointUpTheTable) {
  std::set<std::string> above;
  for (const auto& [folder, allowed] : folder_table()) {
    for (const std::string& target : allowed) EXPECT_EQ(above.count(target), 1u) << folder << " -> " << target;
    above.insert(folder);
  }
}

/// The list of a folder is the shortest one.
TEST(Layout, EveryArrowIsUsedByAnInclude) {
  for (const auto& [folder, allowed] : folder_table()) {
    std::set<std::string> used;
    for (const fs::path& file : sources_of(root, folder))
      for (const Include& include : includes_in(read(file))) used.insert(folder_of(include.target));
    for (const std::string& target : allowed)
      EXPECT_EQ(used.count(target), 1u) << folder << " may include " << target << " and does not";
  }
}

/// GiNaC also arrives through a header of perturb: where it may not be included it may not be reached either.
TEST(Layout, NumericFoldersDoNotReachGinac) {
  for (const auto& [folder, allowed] : allowed_folders) {
    if (may_reach_symbolic(folder)) continue;
    std::set<std::string> reached;
    std::vector<fs::path> pending = sources_of(root, folder);
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

/// docs/architecture.md says how to draw it again.
TEST(Layout, FigureOfTheDocumentationIsThatOfTheIncludes) {
  EXPECT_TRUE(read(root / "docs/figures/layout.svg") == layout_figure(included_folders(root)))
      << "draw it again as docs/architecture.md says";
}

TEST(Layout, EveryFolderOfSourcesHasARule) {
  static const std::set<std::string> elsewhere = {"tests", "bench",  "build", "out",
                                                  "docs",  "models", "cmake", "examples"};
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
    if (!entry->is_directory()) continue;
    const std::string name = fs::relative(entry->path(), root).generic_string();
    if (entry.depth() == 0 &&
        (name.starts_with(".") || is_build_folder(entry->path()) || elsewhere.count(name) == 1)) {
      entry.disable_recursion_pending();
      continue;
    }
    if (sources_of(root, name).empty()) continue;
    EXPECT_EQ(allowed_folders.count(name), 1u) << name << "/ is not in the table";
  }
}

/// A library is its folder's: in `app`, `app/mpi` and `codegen` themselves stand what programs alone consist of,
/// and python/module is loaded by Python.
TEST(Layout, EveryFolderOfSourcesIsOneLibrary) {
  std::multiset<std::string> libraries;
  const auto take = [&](const std::string& file, const std::regex& call, const std::string& before) {
    const std::string text = read(root / file);
    for (std::sregex_iterator at(text.begin(), text.end(), call); at != std::sregex_iterator(); ++at)
      libraries.insert(before + (*at)[1].str());
  };
  take("CMakeLists.txt", std::regex(R"(\nsecular_library\(([a-z_/]+))"), "");
  take("jobs/CMakeLists.txt", std::regex(R"(\nsecular_library\(([a-z_/]+))"), "");
  take("app/CMakeLists.txt", std::regex(R"(\nsecular_app_folder\(([a-z_]+))"), "app/");
  for (const auto& [folder, allowed] : folder_table()) {
    if (folder == "app" || folder == "app/mpi" || folder == "codegen" || folder == "python/module") continue;
    const std::vector<fs::path> files = sources_of(root, folder);
    const bool compiled =
        std::any_of(files.begin(), files.end(), [](const fs::path& file) { return file.extension() == ".cpp"; });
    EXPECT_EQ(libraries.count(folder), compiled ? 1u : 0u) << folder;
  }
  for (const std::string& library : libraries) EXPECT_EQ(allowed_folders.count(library), 1u) << library;
}

TEST(Layout, TheScanSeesWhatItForbids) {
  EXPECT_EQ(violations("estimator/model", "x.cpp", "#include \"perturb/model.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("report", "x.cpp", "int a;\n  #  include <ginac/ginac.h>\n").size(), 1u);
  EXPECT_EQ(violations("perturb", "x.cpp", "#include \"estimator/model/compiled_model.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("generated", "x.cpp", "#include \"input/input_error.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("measure/data", "x.cpp", "#include \"measure/signal/pole.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("measure/data", "x.cpp", "#include \"motion/pole.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("app/derive", "x.cpp", "#include \"app/verify/a.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("app/derive", "x.cpp", "#include <ginac/ginac.h>").size(), 1u);
  EXPECT_EQ(violations("app/generate", "x.cpp", "#include \"perturb/model.hpp\"\n#include <map>\n").size(), 0u);
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

// Of a tree that git knows; elsewhere nothing is committed.
TEST(CommittedFiles, AreNoByteCode) {
  if (!fs::exists(root / ".git")) GTEST_SKIP() << "no tree of git";
  const auto listed = [](const std::string& pattern) {
    const std::string command = "git -C '" + root.string() + "' ls-files '" + pattern + "'";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string names;
    for (int c = pipe ? std::fgetc(pipe.get()) : EOF; c != EOF; c = std::fgetc(pipe.get()))
      names += static_cast<char>(c);
    return names;
  };
  if (listed("CMakeLists.txt").empty()) GTEST_SKIP() << "git is not there";
  EXPECT_EQ(listed("*.pyc"), "");
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
}  // namespace secular::architecture
