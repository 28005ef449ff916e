#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "measure/data/campaign.hpp"
#include "measure/data/inspection.hpp"
#include "measure/formats/data_file.hpp"

namespace secular {

/// What the fuzzers do with a file: reads it in every way that the program does. `format` "campaign" stands for a
/// campaign.toml, everything else for a data file.
inline void read_anything(const std::filesystem::path& path, const std::string& format) {
  if (format == "campaign") {
    const std::filesystem::path folder = path.parent_path() / "campaign_folder";
    std::filesystem::create_directories(folder / "records");
    if (!std::filesystem::exists(folder / "records/0001.csv")) std::ofstream(folder / "records/0001.csv") << "t\n";
    std::filesystem::copy_file(path, folder / "campaign.toml", std::filesystem::copy_options::overwrite_existing);
    read_campaign(folder);
    return;
  }
  const InspectionLimit begin{0, 0, 3};
  inspect_file(path);
  inspect_file(path, begin);
  describe_data_file(path);
  read_data_file(path);
}

}  // namespace secular
