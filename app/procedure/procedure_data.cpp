#include "app/procedure/procedure_data.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

#include "thesis/procedures/thesis_tables.hpp"

namespace secular::app {

std::vector<DwellMean> dwell_means(const Campaign& campaign, const ObservationSet& measured) {
  std::vector<DwellMean> means;
  std::map<std::size_t, std::vector<const Observation*>> members;
  for (const Observation& o : measured.observations) members[o.record].push_back(&o);
  for (const auto& [record, ensembles] : members) {
    DwellMean c;
    c.record = record;
    c.group = campaign.records[record].group;
    const auto n = static_cast<double>(ensembles.size());
    double square = 0;
    for (const Observation* o : ensembles) {
      const double a = 2 * std::abs(o->amplitude[0]);
      c.frequency += o->excitation_frequency[0] / n;
      c.forcing += std::abs(o->forcing[0]) / n;
      c.amplitude += a / n;
      square += a * a / n;
    }
    c.amplitude_sd = std::sqrt(std::max(0.0, square - c.amplitude * c.amplitude));
    means.push_back(c);
  }
  return means;
}

bool ProcedureData::wants(const std::string& method) const {
  return request.methods.empty() ||
         std::find(request.methods.begin(), request.methods.end(), method) != request.methods.end();
}

ProcedureRow procedure_row(const std::string& name, const std::string& unit, const std::string& equation,
                           const RecoveredValue& recovered) {
  ProcedureRow r;
  r.name = name;
  r.unit = unit;
  r.equation = equation;
  r.recovered = recovered.value;
  r.sd = recovered.sd;
  r.as_printed = recovered.as_printed;
  r.truth = recovered.truth;
  if (const auto printed = printed_value(equation, name)) {
    r.source = printed->value;
    r.source_sd = printed->sd;
    r.table = printed->table;
  }
  return r;
}

}  // namespace secular::app
