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
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = SECULAR_SOURCE_DIR;

std::string first_part(const std::string& path) {
  return path.substr(0, path.find('/'));
}

/// Folder -> folders of the project that its own files (not those of folders in it) may include, besides itself.
/// Each arrow points to a row above.
const std::vector<std::pair<std::string, std::set<std::string>>> folder_table = {
    {"input", {}},
    {"numerics", {}},
    {"report", {"input"}},
    {"perturb", {"input"}},
    {"estimator/model", {}},
    {"generated", {"estimator/model"}},
    {"codegen/canonical", {"input", "perturb"}},
    {"codegen/expression", {"codegen/canonical"}},
    {"codegen/document", {"perturb", "codegen/canonical", "codegen/expression"}},
    {"codegen/cpp", {"input", "estimator/model", "codegen/canonical", "codegen/expression", "codegen/document"}},
    {"codegen/runtime",
     {"input", "perturb", "estimator/model", "codegen/canonical", "codegen/expression", "codegen/cpp"}},
    {"codegen", {"input", "perturb", "codegen/cpp"}},
    {"measure/data", {"input", "numerics"}},
    {"measure/signal", {"numerics"}},
    {"estimator/regression", {"numerics"}},
    {"measure/modal", {"input", "numerics", "measure/data", "measure/signal", "estimator/regression"}},
    {"measure/observe", {"input", "numerics", "estimator/model", "measure/data", "measure/signal"}},
    {"estimator/identification",
     {"input", "numerics", "estimator/model", "measure/signal", "estimator/regression", "measure/observe"}},
    {"motion/response", {"estimator/model"}},
    {"estimator/planning", {"estimator/model", "motion/response"}},
    {"motion/balance", {"numerics", "estimator/model"}},
    {"motion/simulate", {"input", "numerics", "estimator/model", "measure/data"}},
    {"motion/correction",
     {"input", "numerics", "estimator/model", "measure/observe", "estimator/identification", "motion/balance",
      "motion/simulate"}},
    {"diagnose/evidence",
     {"input", "numerics", "estimator/model", "measure/data", "measure/signal", "measure/observe",
      "motion/balance"}},
    {"diagnose/effects", {"diagnose/evidence"}},
    {"diagnose/inference", {"numerics", "diagnose/evidence", "diagnose/effects"}},
    {"diagnose/verdict",
     {"input", "numerics", "estimator/model", "measure/observe", "estimator/identification", "motion/balance",
      "diagnose/evidence", "diagnose/effects", "diagnose/inference"}},
    {"thesis/verify", {"input", "perturb"}},
    {"thesis/procedures",
     {"input", "numerics", "estimator/model", "measure/signal", "estimator/regression", "measure/observe",
      "estimator/identification", "motion/response"}},
    {"blind", {"input"}},
    {"app/shared",
     {"input", "numerics", "report", "perturb", "estimator/model", "generated", "codegen/canonical",
      "codegen/runtime", "measure/data", "measure/signal", "measure/observe", "estimator/identification",
      "motion/correction"}},
    {"app/blind", {"blind", "app/shared"}},
    {"app/derive", {"report", "perturb", "codegen/document", "app/shared"}},
    {"app/diagnose",
     {"input", "numerics", "report", "estimator/model", "measure/data", "diagnose/verdict", "app/shared"}},
    {"app/evaluate", {"perturb", "codegen/canonical", "app/shared"}},
    {"app/generate", {"input", "perturb", "codegen/cpp", "app/shared"}},
    {"app/identify", {"input", "numerics", "report", "measure/observe", "estimator/identification", "app/shared"}},
    {"app/import", {"measure/data", "app/shared"}},
    {"app/inspect", {"input", "measure/data", "app/shared"}},
    {"app/modal", {"input", "numerics", "report", "measure/modal", "app/shared"}},
    {"app/plan",
     {"input", "numerics", "report", "measure/data", "measure/observe", "estimator/identification",
      "estimator/planning", "motion/simulate", "app/shared"}},
    {"app/predict",
     {"input", "numerics", "report", "measure/observe", "motion/response", "motion/simulate", "app/shared"}},
    {"app/procedure",
     {"input", "numerics", "report", "estimator/model", "measure/data", "measure/signal", "measure/observe",
      "estimator/identification", "motion/simulate", "motion/correction", "thesis/procedures", "app/shared"}},
    {"app/simulate", {"input", "estimator/model", "motion/simulate", "app/shared"}},
    {"app/spectrum",
     {"input", "numerics", "report", "measure/data", "measure/signal", "measure/observe", "app/shared"}},
    {"app/verify", {"report", "perturb", "thesis/verify", "app/shared"}},
    {"app", {"input", "app/shared"}},
};

const std::map<std::string, std::set<std::string>> allowed_folders(folder_table.begin(), folder_table.end());

/// Folders that may see GiNaC and CLN: a compiled estimator links without them.
const std::set<std::string> symbolic_folders = {"perturb", "thesis/verify", "codegen/canonical"};

/// Folders that may see them through others.
bool may_reach_symbolic(const std::string& folder) {
  return symbolic_folders.count(folder) == 1 || first_part(folder) == "codegen" || first_part(folder) == "app";
}

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
  for (const fs::directory_entry& entry : fs::directory_iterator(root / folder))
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

std::string folder_of(const std::string& path) {
  return path.substr(0, std::min(path.rfind('/'), path.size()));
}

bool is_of_project(const std::string& target) {
  static const std::set<std::string> top_folders = [] {
    std::set<std::string> names;
    for (const auto& [folder, allowed] : folder_table) names.insert(first_part(folder));
    return names;
  }();
  return target.find('/') != std::string::npos && top_folders.count(first_part(target)) == 1;
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

INSTANTIATE_TEST_SUITE_P(Layout, FolderIncludes, testing::ValuesIn(folder_names()), [](const auto& instance) {
  std::string name = instance.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
});

TEST(Layout, ArrowsPointUpTheTable) {
  std::set<std::string> above;
  for (const auto& [folder, allowed] : folder_table) {
    for (const std::string& target : allowed) EXPECT_EQ(above.count(target), 1u) << folder << " -> " << target;
    above.insert(folder);
  }
}

/// GiNaC also arrives through a header of perturb: where it may not be included it may not be reached either.
TEST(Layout, NumericFoldersDoNotReachGinac) {
  for (const auto& [folder, allowed] : allowed_folders) {
    if (may_reach_symbolic(folder)) continue;
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
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
    if (!entry->is_directory()) continue;
    const std::string name = fs::relative(entry->path(), root).generic_string();
    if (entry.depth() == 0 &&
        (name.starts_with(".") || is_build_folder(entry->path()) || elsewhere.count(name) == 1)) {
      entry.disable_recursion_pending();
      continue;
    }
    if (sources_of(name).empty()) continue;
    EXPECT_EQ(allowed_folders.count(name), 1u) << name << "/ is not in the table";
  }
}

TEST(Layout, TheScanSeesWhatItForbids) {
  EXPECT_EQ(violations("estimator/model", "x.cpp", "#include \"perturb/model.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("report", "x.cpp", "int a;\n  #  include <ginac/ginac.h>\n").size(), 1u);
  EXPECT_EQ(violations("perturb", "x.cpp", "#include \"estimator/model/compiled_model.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("generated", "x.cpp", "#include \"input/input_error.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("measure/data", "x.cpp", "#include \"measure/signal/pole.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("measure/data", "x.cpp", "#include \"measure/pole.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("app/derive", "x.cpp", "#include \"app/verify/a.hpp\"\n").size(), 1u);
  EXPECT_EQ(violations("app/derive", "x.cpp", "#include <ginac/ginac.h>").size(), 1u);
  EXPECT_EQ(violations("app/derive", "x.cpp", "#include \"perturb/model.hpp\"\n#include <map>\n").size(), 0u);
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
