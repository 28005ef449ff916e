#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jobs/spectrum/spectrum_report.hpp"
#include "measure/data/campaign.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

struct SpectrumRequest {
  std::string source;                 ///< campaign folder or file, or what messages call `campaign`
  std::optional<Campaign> campaign;   ///< in place of a folder
  Window window;                      ///< of a campaign the first record that it takes
  std::vector<std::string> channels;  ///< empty: every response
  std::string time;                   ///< of a file: the variable that holds it; empty: found by its name
  double sample_rate_hz = 0;          ///< of a file without time
  SpectralOptions spectral;
  std::function<void(const std::string&)> warn = {};  ///< gets warnings as they come
};

/// What was found: a record's spectrum, or the steady responses that a file holds.
struct SpectrumRun {
  std::optional<RecordSpectrum> record;
  SteadyTable table;
};

/// The job `spectrum`. Throws InputError.
SpectrumRun run_spectrum(const SpectrumRequest& request);

std::vector<report::NamedFigure> spectrum_figures(const SpectrumRun& run);
/// The text of spectrum.json and of report.html.
std::string spectrum_json(const SpectrumRun& run);
std::string spectrum_report(const SpectrumRun& run, const std::string& command);

}  // namespace secular
