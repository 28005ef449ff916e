#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace secular::blind {

struct RunOptions {
  std::filesystem::path program;  ///< the `secular` that is checked
  unsigned threads = 1;           ///< campaigns at once
  double limit_s = 300;           ///< wall time of a campaign
};

struct FailedCampaign {
  std::size_t number = 0;
  std::string reason;  ///< "exit status 2: message"
};

}  // namespace secular::blind
