#include "folder_rules.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>

namespace secular::architecture {

namespace fs = std::filesystem;

// A table: one row a folder, as long as there are folders.
const FolderTable& folder_table() {
  static const FolderTable table = {
      {"input", {}},
      {"numerics", {"input"}},
      {"effects", {}},
      {"report", {"input"}},
      {"perturb", {"effects", "input", "numerics"}},
      {"estimator/model", {"numerics"}},
      {"generated", {"estimator/model"}},
      {"codegen/canonical", {"input", "perturb"}},
      {"codegen/expression", {"codegen/canonical"}},
      {"codegen/document", {"input", "perturb", "codegen/canonical", "codegen/expression"}},
      {"codegen/cpp", {"input", "estimator/model", "codegen/canonical", "codegen/expression", "codegen/document"}},
      {"codegen/runtime",
       {"input", "perturb", "estimator/model", "codegen/canonical", "codegen/expression", "codegen/cpp"}},
      {"codegen", {"input", "perturb", "codegen/cpp"}},
      {"measure", {"numerics"}},
      {"estimator", {"numerics"}},
      {"measure/formats", {"input"}},
      {"measure/data", {"input", "numerics", "measure", "measure/formats"}},
      {"measure/signal", {"numerics", "measure"}},
      {"measure/disturbances", {"numerics", "measure", "measure/data", "measure/signal"}},
      {"estimator/regression", {"numerics", "estimator"}},
      {"measure/modal",
       {"input", "numerics", "measure", "measure/data", "measure/disturbances", "measure/signal",
        "estimator/regression"}},
      {"measure/observe",
       {"input", "numerics", "estimator", "estimator/model", "measure", "measure/data", "measure/signal"}},
      {"estimator/identification",
       {"input", "numerics", "estimator", "estimator/model", "measure/data", "measure/signal",
        "estimator/regression", "measure/observe"}},
      {"motion", {"numerics"}},
      {"motion/response", {"input", "numerics", "estimator/model"}},
      {"estimator/planning", {"numerics", "estimator/model", "motion/response"}},
      {"motion/balance", {"effects", "input", "numerics", "estimator/model"}},
      {"motion/integrate", {"input", "estimator/model", "motion/balance"}},
      {"motion/simulate", {"effects", "input", "numerics", "estimator/model", "measure/formats", "measure/data"}},
      {"motion/correction",
       {"input", "numerics", "estimator", "estimator/model", "measure/data", "measure/observe",
        "estimator/identification", "motion", "motion/balance", "motion/simulate"}},
      {"diagnose", {"numerics"}},
      {"diagnose/evidence",
       {"effects", "input", "numerics", "diagnose", "estimator/model", "measure/data", "measure/signal",
        "measure/observe", "motion/balance", "motion/integrate"}},
      {"diagnose/effects", {"diagnose", "diagnose/evidence"}},
      {"diagnose/inference", {"numerics", "diagnose", "diagnose/evidence", "diagnose/effects"}},
      {"diagnose/verdict",
       {"effects", "input", "numerics", "estimator/model", "measure", "measure/data", "measure/disturbances",
        "measure/observe", "estimator/identification", "motion/balance", "diagnose", "diagnose/evidence",
        "diagnose/effects", "diagnose/inference"}},
      {"thesis/verify", {"input", "perturb"}},
      {"thesis/procedures",
       {"input", "numerics", "estimator/model", "measure", "measure/signal", "estimator/regression",
        "measure/observe", "estimator/identification", "motion/response"}},
      {"blind", {"input"}},
      {"jobs/shared",
       {"input", "numerics", "report", "perturb", "estimator/model", "generated", "codegen/canonical",
        "codegen/runtime", "measure", "measure/data", "measure/signal", "measure/disturbances", "measure/observe",
        "estimator/identification", "diagnose/evidence", "diagnose/verdict"}},
      {"jobs/derive", {"perturb", "codegen/canonical", "codegen/document", "jobs/shared"}},
      {"jobs/import", {"measure/data"}},
      {"jobs/inspect",
       {"input", "report", "measure/formats", "measure/data", "measure/disturbances", "measure/observe",
        "jobs/shared"}},
      {"jobs/matlab", {"input"}},
      {"jobs/modal", {"input", "numerics", "report", "measure/modal", "measure/observe", "jobs/shared"}},
      {"jobs/plan",
       {"input", "numerics", "report", "measure/data", "measure/observe", "estimator/identification",
        "estimator/planning", "motion/response", "motion/simulate", "jobs/shared"}},
      {"jobs/predict",
       {"input", "numerics", "report", "codegen/runtime", "estimator/model", "measure/data", "measure/observe",
        "estimator/identification", "motion/response", "motion/simulate", "motion/correction", "jobs/shared"}},
      {"jobs/spectrum",
       {"input", "numerics", "report", "measure/formats", "measure/data", "measure/signal", "measure/observe",
        "jobs/shared"}},
      {"jobs/simulate", {"input", "estimator/model", "measure/data", "motion/simulate", "jobs/shared"}},
      {"jobs/identify",
       {"input", "numerics", "report", "estimator/model", "measure", "measure/data", "measure/disturbances",
        "measure/observe", "estimator/identification", "motion/response", "motion/correction", "diagnose/verdict",
        "jobs/shared"}},
      {"jobs/diagnose",
       {"numerics", "report", "estimator/model", "measure/data", "measure/disturbances", "measure/observe",
        "diagnose/verdict", "jobs/shared", "jobs/identify"}},
      {"python/module",
       {"input", "report", "measure/data", "measure/observe", "jobs/shared", "jobs/derive", "jobs/simulate",
        "jobs/identify", "jobs/diagnose", "jobs/import", "jobs/inspect", "jobs/modal", "jobs/plan", "jobs/predict",
        "jobs/spectrum"}},
      {"app/shared", {"input", "report", "measure/data", "measure/disturbances", "measure/observe", "jobs/matlab"}},
      {"app/blind", {"input", "blind", "app/shared"}},
      {"app/derive", {"jobs/derive", "app/shared"}},
      {"app/diagnose", {"input", "numerics", "report", "jobs/shared", "jobs/diagnose", "app/shared"}},
      {"app/evaluate", {"jobs/shared", "jobs/derive", "app/shared"}},
      {"app/generate", {"input", "perturb", "codegen/cpp", "jobs/shared", "app/shared"}},
      {"app/help", {"input", "jobs/shared", "app/shared"}},
      {"app/identify", {"input", "numerics", "report", "jobs/shared", "jobs/identify", "app/shared"}},
      {"app/import", {"measure/data", "jobs/import", "app/shared"}},
      {"app/inspect", {"jobs/inspect", "app/shared"}},
      {"app/modal", {"input", "numerics", "report", "measure/modal", "jobs/modal", "app/shared"}},
      {"app/plan", {"input", "report", "jobs/plan", "app/shared"}},
      {"app/predict", {"input", "numerics", "report", "jobs/predict", "app/shared"}},
      {"app/procedure",
       {"input", "numerics", "report", "estimator/model", "measure/data", "measure/signal", "measure/observe",
        "estimator/identification", "motion/simulate", "motion/correction", "thesis/procedures", "jobs/shared",
        "jobs/identify", "app/shared"}},
      {"app/simulate", {"input", "measure/data", "jobs/simulate", "jobs/inspect", "app/shared"}},
      {"app/spectrum", {"jobs/spectrum", "app/shared"}},
      {"app/to_matlab", {"input", "report", "jobs/matlab", "app/shared"}},
      {"app/verify", {"perturb", "thesis/verify", "jobs/shared", "app/shared"}},
      {"app", {"input", "app/shared"}},
      {"app/mpi", {"input", "blind", "app"}},
  };
  return table;
}

std::string first_part(const std::string& path) {
  return path.substr(0, path.find('/'));
}

std::string folder_of(const std::string& path) {
  return path.substr(0, std::min(path.rfind('/'), path.size()));
}

bool is_build_folder(const fs::path& folder) {
  return folder.filename() == "build" || fs::exists(folder / "CMakeCache.txt");
}

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> sources_of(const fs::path& root, const std::string& folder) {
  static const std::set<std::string> extensions = {".cpp", ".hpp", ".h", ".cc", ".in"};
  std::vector<fs::path> files;
  if (!fs::exists(root / folder)) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(root / folder))
    if (entry.is_regular_file() && extensions.count(entry.path().extension().string()) == 1)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> folders_of_sources(const fs::path& root) {
  std::vector<std::string> all;
  for (const auto& [folder, allowed] : folder_table()) all.push_back(folder);
  for (const fs::directory_entry& entry : fs::directory_iterator(root / "tests"))
    if (entry.is_directory()) all.push_back("tests/" + entry.path().filename().string());
  return all;
}

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

bool is_of_project(const std::string& target) {
  static const std::set<std::string> top_folders = [] {
    std::set<std::string> names;
    for (const auto& [folder, allowed] : folder_table()) names.insert(first_part(folder));
    return names;
  }();
  return target.find('/') != std::string::npos && top_folders.count(first_part(target)) == 1;
}

FolderGraph included_folders(const fs::path& root) {
  const auto shown = [](const std::string& folder) {
    const std::string first = first_part(folder);
    return first == "app" || first == "jobs" ? first : folder;
  };
  FolderGraph graph;
  for (const auto& [folder, allowed] : folder_table())
    for (const fs::path& file : sources_of(root, folder)) {
      std::set<std::string>& targets = graph[shown(folder)];
      for (const Include& include : includes_in(read(file))) {
        const std::string target = shown(folder_of(include.target));
        if (is_of_project(include.target) && target != shown(folder)) targets.insert(target);
      }
    }
  return graph;
}

}  // namespace secular::architecture
