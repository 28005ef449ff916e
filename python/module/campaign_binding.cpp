#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "input/input_error.hpp"
#include "jobs/simulate/simulation.hpp"
#include "measure/data/campaign_target.hpp"
#include "measure/data/campaign_text.hpp"
#include "measure/data/held_campaign.hpp"
#include "python/module/bindings.hpp"
#include "python/module/running.hpp"

namespace py = pybind11;

namespace secular::python {
namespace {

using Samples = py::array_t<double, py::array::c_style | py::array::forcecast>;

MeasuredSamples measured_samples(const std::pair<double, Samples>& given) {
  const auto& [start_s, array] = given;
  MeasuredSamples record{start_s, {}};
  if (array.ndim() != 2)
    throw InputError("samples", "", "are no array of channels x samples", "give two dimensions");
  for (py::ssize_t c = 0; c < array.shape(0); ++c)
    record.channels.emplace_back(array.data(c, 0), array.data(c, 0) + array.shape(1));
  return record;
}

std::shared_ptr<Campaign> hold(const std::string& text, const std::vector<std::pair<double, Samples>>& given) {
  std::vector<MeasuredSamples> records;
  for (const auto& record : given) records.push_back(measured_samples(record));
  return std::make_shared<Campaign>(computed([&] { return held_campaign(text, std::move(records)); }));
}

// The same with all samples in memory: its folder may go.
Campaign in_memory(Campaign campaign) {
  for (RecordEntry& entry : campaign.records)
    if (!entry.row) entry.held = std::make_shared<const Record>(read_record(campaign, entry));
  campaign.folder = campaign.name;
  return campaign;
}

// (start_s, array of channels x samples), NaN where the file holds no sample.
py::tuple samples_of(const Campaign& campaign, std::size_t index) {
  const RecordEntry& entry = campaign.records.at(index);
  const Record record = computed([&] { return read_record(campaign, entry); });
  py::array_t<double> array({record.channels.size(), record.samples()});
  auto values = array.mutable_unchecked<2>();
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const auto row = static_cast<py::ssize_t>(c);
    for (std::size_t i = 0; i < record.samples(); ++i)
      values(row, static_cast<py::ssize_t>(i)) = record.channels[c][i];
    for (const std::size_t i : filled_samples(record, c))
      values(row, static_cast<py::ssize_t>(i)) = std::numeric_limits<double>::quiet_NaN();
  }
  return py::make_tuple(record.start_s, array);
}

py::list channels_of_campaign(const Campaign& campaign) {
  using namespace py::literals;
  py::list channels;
  for (const Channel& channel : campaign.channels)
    channels.append(py::dict("name"_a = channel.name, "role"_a = to_string(channel.role),
                             "quantity"_a = to_string(channel.quantity), "unit"_a = channel.unit,
                             "frame"_a = channel.frame == Frame::absolute ? "absolute" : "relative",
                             "delay_s"_a = channel.delay_s));
  return channels;
}

py::list records_of_campaign(const Campaign& campaign) {
  using namespace py::literals;
  py::list records;
  for (const RecordEntry& entry : campaign.records)
    records.append(py::dict("file"_a = entry.file, "kind"_a = to_string(entry.kind),
                            "excitation_frequency_hz"_a = entry.excitation_frequency_hz,
                            "excitation_amplitude"_a = entry.excitation_amplitude,
                            "ensemble_s"_a = entry.ensemble_s, "started_s"_a = entry.started_s,
                            "group"_a = entry.group));
  return records;
}

std::shared_ptr<Campaign> simulated(const std::string& experiment, std::uint64_t seed, unsigned threads,
                                    bool interpret) {
  return std::make_shared<Campaign>(computed([&] {
    SimulationRequest request;
    request.experiment = experiment;
    request.seed = seed;
    request.threads = threads;
    request.interpret = interpret;
    std::mutex guard;
    std::map<std::string, MeasuredSamples> made;
    const Campaign campaign = simulate(request, [&](const Campaign&, const RecordEntry& entry, Record&& record) {
      const std::lock_guard lock(guard);
      made[entry.file] = {record.start_s, std::move(record.channels)};
    });
    std::vector<MeasuredSamples> records;
    for (const RecordEntry& entry : campaign.records) records.push_back(std::move(made.at(entry.file)));
    return held_campaign(campaign_text(campaign), std::move(records));
  }));
}

// As the commands do: never over what is read.
void save(const Campaign& campaign, const std::string& folder, bool replace) {
  const auto is_in_memory = [](const RecordEntry& entry) { return entry.held || entry.row; };
  if (!std::all_of(campaign.records.begin(), campaign.records.end(), is_in_memory))
    check_apart(folder, campaign.folder, "the campaign");
  write_campaign(campaign, folder, replace);
}

}  // namespace

void add_campaign(py::module_& module) {
  using namespace py::literals;
  py::class_<Campaign, std::shared_ptr<Campaign>>(module, "Campaign")
      .def_static("read",
                  [](const std::string& folder) {
                    return std::make_shared<Campaign>(computed([&] { return read_campaign(folder); }));
                  })
      .def_static(
          "read_into_memory",
          [](const std::string& folder) {
            return std::make_shared<Campaign>(computed([&] { return in_memory(read_campaign(folder)); }));
          },
          "folder"_a)
      .def_static("hold", &hold, "text"_a, "records"_a)
      .def_readonly("name", &Campaign::name)
      .def_readonly("sample_rate_hz", &Campaign::sample_rate_hz)
      .def_property_readonly("channels", &channels_of_campaign)
      .def_property_readonly("records", &records_of_campaign)
      .def("text", &campaign_text)
      .def("samples", &samples_of, "record"_a)
      .def(
          "save",
          [](const Campaign& campaign, const std::string& folder, bool replace) {
            run_without_lock([&] { save(campaign, folder, replace); });
          },
          "folder"_a, "replace"_a);
  module.def("simulate", &simulated, "experiment"_a, "seed"_a, "threads"_a, "interpret"_a);
}

}  // namespace secular::python
