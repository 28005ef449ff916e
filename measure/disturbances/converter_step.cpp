#include <fmt/format.h>

#include "measure/disturbances/converter_lines.hpp"
#include "measure/disturbances/rows.hpp"

namespace secular {

void find_converter_steps(const SearchedRecord& record, std::vector<Disturbance>& found) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const std::optional<ConverterLattice> lattice = repeating_lattice(record.channels[c], record.level);
    if (!lattice) continue;
    Disturbance coarse = record.found("converter_step", c, lattice->step);
    coarse.text = fmt::format(
        "values are multiples of {:.3g} {}, {} the noise before the converter: lines of up to {:.2g} {} that "
        "repeat",
        lattice->step, coarse.unit,
        lattice->noise > 0.01 * lattice->step ? fmt::format("{:.2g} times", lattice->step / lattice->noise)
                                              : "more than 100 times",
        lattice->repeated_line(), coarse.unit);
    if (record.entry().kind == RecordKind::dwell) coarse.treated = "removed";
    found.push_back(std::move(coarse));
  }
}

}  // namespace secular
