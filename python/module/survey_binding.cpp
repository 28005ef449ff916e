// What is asked of records without a model: modal, spectrum, inspect, import.
#include <pybind11/stl.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "jobs/import/import_run.hpp"
#include "jobs/inspect/inspection_report.hpp"
#include "jobs/inspect/inspection_run.hpp"
#include "jobs/modal/modal_json.hpp"
#include "jobs/modal/modal_report.hpp"
#include "jobs/modal/modal_run.hpp"
#include "jobs/simulate/simulation.hpp"
#include "jobs/spectrum/spectrum_run.hpp"
#include "python/module/bindings.hpp"
#include "python/module/outcome.hpp"
#include "python/module/running.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace secular::python {
namespace {

ModalSurveyOptions survey_options(const py::dict& options) {
  ModalSurveyOptions survey;
  survey.largest_order = options["order"].cast<int>();
  survey.modes = options["modes"].cast<int>();
  survey.window_s = options["window_s"].cast<double>();
  survey.overlap = options["overlap"].cast<double>();
  survey.fit_below = options["fit_below"].cast<double>();
  survey.force_window_s = options["force_window_s"].cast<double>();
  survey.response_decay = options["exponential_window"].cast<std::optional<double>>();
  for (const auto& [group, channel] : options["driving_points"].cast<std::map<std::string, std::string>>())
    survey.driving_points[group] = driving_point_of(channel);
  survey.modal_masses = options["modal_masses"].cast<std::vector<double>>();
  return survey;
}

std::shared_ptr<JobOutcome> surveyed(const Campaign& campaign, const py::dict& options) {
  auto outcome = std::make_shared<JobOutcome>();
  auto found = std::make_shared<ModalSurvey>();
  const ModalSurveyOptions survey = survey_options(options);
  const Window window = window_of(options);
  run_without_lock([&] {
    *found = run_modal(campaign, window, survey);
    outcome->json = modal_json(*found);
    outcome->figures = modal_figures(*found);
  });
  outcome->report = [found](const std::string& command) { return modal_report(*found, command); };
  outcome->notices = found->warnings;
  return outcome;
}

// `campaign`: None where `source` is a file.
std::shared_ptr<JobOutcome> decomposed(const std::string& source, const Campaign* campaign,
                                       const py::dict& options) {
  auto outcome = std::make_shared<JobOutcome>();
  SpectrumRequest request;
  request.source = source;
  if (campaign) request.campaign = *campaign;
  request.window = window_of(options);
  request.channels = options["channels"].cast<std::vector<std::string>>();
  request.time = options["time"].cast<std::string>();
  request.sample_rate_hz = options["sample_rate_hz"].cast<double>();
  request.spectral.order = options["order"].cast<int>();
  request.spectral.ensemble_s = options["ensemble_s"].cast<double>();
  request.spectral.overlap = options["overlap"].cast<double>();
  request.spectral.delays = options["delays"].cast<int>();
  request.spectral.offset = options["offset"].cast<bool>();
  request.warn = [&](const std::string& warning) { outcome->notices.push_back(warning); };
  auto found = std::make_shared<SpectrumRun>();
  run_without_lock([&] {
    *found = run_spectrum(request);
    outcome->json = spectrum_json(*found);
    outcome->figures = spectrum_figures(*found);
  });
  outcome->report = [found](const std::string& command) { return spectrum_report(*found, command); };
  return outcome;
}

std::shared_ptr<JobOutcome> inspected(const std::string& path, const Campaign* campaign, const py::dict& options) {
  auto outcome = std::make_shared<JobOutcome>();
  InspectionRequest request;
  request.path = path;
  if (campaign) request.campaign = *campaign;
  request.window = window_of(options);
  request.whole = options["whole"].cast<bool>();
  run_without_lock([&] { outcome->json = inspection_json(inspect(request)); });
  // Pictures of every record are large: they are made for who wants them.
  request.pictures = true;
  outcome->report = [request](const std::string& command) { return inspection_report(inspect(request), command); };
  outcome->draw = [request] { return inspection_figures(inspect(request)); };
  return outcome;
}

// What `simulate --report` writes of a campaign that was simulated.
std::string simulation_report(const Campaign& campaign, const std::string& experiment, std::uint64_t seed) {
  std::string report;
  run_without_lock([&] {
    InspectionRequest request;
    request.path = campaign.name;
    request.campaign = campaign;
    request.pictures = true;
    const auto [model, text] = experiment_text(experiment);
    const SimulatedFrom from{model, experiment, text, seed};
    report = inspection_report(inspect(request), "Python", &from);
  });
  return report;
}

ImportOptions import_options(const py::dict& options) {
  ImportOptions import;
  for (const std::string& file : options["files"].cast<std::vector<std::string>>()) import.files.emplace_back(file);
  const auto text = [&](const char* name) { return options[name].cast<std::string>(); };
  import.kind = text("kind");
  import.channels = options["channels"].cast<std::vector<std::string>>();
  import.absolute = options["absolute"].cast<std::vector<std::string>>();
  import.delays = options["delays"].cast<std::vector<std::string>>();
  import.time = text("time");
  import.sample_rate_hz = options["sample_rate_hz"].cast<std::optional<double>>();
  import.name = text("name");
  import.group = text("group");
  import.geometry = text("geometry");
  import.frequencies_hz = options["frequency_hz"].cast<std::vector<double>>();
  import.amplitudes = options["amplitude"].cast<std::vector<double>>();
  import.ensemble_s = options["ensemble_s"].cast<std::optional<double>>();
  import.decimal_mark = text("decimal_mark");
  import.table.columns = options["columns"].cast<std::vector<std::string>>();
  import.table.amplitudes = text("amplitudes");
  import.table.phases = text("phases");
  import.table.phase_sign = text("phase_sign");
  import.table.phase_offset_deg = options["phase_offset_deg"].cast<std::optional<double>>();
  import.table.per_excitation = options["per_excitation"].cast<bool>();
  import.table.frequency_unit = text("frequency_unit");
  return import;
}

std::shared_ptr<JobOutcome> imported(const py::dict& options, const std::string& folder, bool replace) {
  auto outcome = std::make_shared<JobOutcome>();
  const ImportOptions import = import_options(options);
  run_without_lock([&] {
    const ImportRun run = run_import(import, folder, replace);
    outcome->json = import_json(run, folder);
    outcome->notices = run.imported.warnings;
  });
  return outcome;
}

}  // namespace

void add_surveys(py::module_& module) {
  module.def("modal", &surveyed, "campaign"_a, "options"_a);
  module.def("spectrum", &decomposed, "source"_a, "campaign"_a, "options"_a);
  module.def("inspect", &inspected, "path"_a, "campaign"_a, "options"_a);
  module.def("simulation_report", &simulation_report, "campaign"_a, "experiment"_a, "seed"_a);
  module.def("import_files", &imported, "options"_a, "folder"_a, "replace"_a);
}

}  // namespace secular::python
