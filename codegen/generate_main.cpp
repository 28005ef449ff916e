// secular_generate MODEL.toml... -o FOLDER: writes the C++ of the given models. Links without generated code, so
// that a broken generated file can always be made anew.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "codegen/cpp/emit_cpp.hpp"
#include "input/input_error.hpp"
#include "perturb/model.hpp"

int main(int argc, char** argv) {
  std::vector<std::string> models;
  std::string folder;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "-o" && i + 1 < argc)
      folder = argv[++i];
    else
      models.push_back(argument);
  }
  if (folder.empty() || models.empty()) {
    std::fprintf(stderr, "usage: secular_generate MODEL.toml... -o FOLDER\n");
    return 2;
  }
  try {
    std::vector<secular::GeneratedFile> files;
    std::vector<std::string> names;
    for (const std::string& path : models) {
      const secular::CanonicalModel model = secular::canonical_model(secular::read_model(path));
      names.push_back(model.name);
      for (secular::GeneratedFile& file : secular::emit_cpp(model)) files.push_back(std::move(file));
    }
    for (secular::GeneratedFile& file : secular::emit_registry(names)) files.push_back(std::move(file));
    secular::write_generated(files, folder);
    return 0;
  } catch (const secular::InputError& error) {
    std::fprintf(stderr, "secular_generate: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "secular_generate: internal error: %s\n", error.what());
    return 3;
  }
}
