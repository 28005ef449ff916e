#include "jobs/shared/record_figure.hpp"

#include <array>
#include <cmath>
#include <map>

namespace secular {

using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

report::Figure record_figure(const std::vector<RowLabel>& labels, const Eigen::VectorXd& before,
                             const Eigen::VectorXd* after) {
  report::Figure figure;
  figure.title = "Discrepancy by condition";
  figure.x = {"Record", "", false, {}};
  std::map<std::size_t, std::array<double, 3>> by_record;
  for (std::size_t r = 0; r < labels.size(); ++r) {
    const auto i = static_cast<Eigen::Index>(r);
    if (labels[r].fold < 0) continue;
    std::array<double, 3>& sums = by_record[labels[r].record];
    sums[0] += before(i) * before(i);
    if (after) sums[1] += (*after)(i) * (*after)(i);
    sums[2] += 1;
  }
  Series without, with, floor;
  without.name = "model as it is";
  without.role = SeriesRole::data;
  with.name = "best explanation added";
  with.role = SeriesRole::held_out;
  floor.name = "repeatability";
  floor.role = SeriesRole::reference;
  without.style = with.style = SeriesStyle::points;
  for (const auto& [record, sums] : by_record) {
    const auto x = static_cast<double>(record + 1);
    without.x.push_back(x);
    without.y.push_back(std::sqrt(sums[0] / sums[2]));
    with.x.push_back(x);
    with.y.push_back(std::sqrt(sums[1] / sums[2]));
    floor.x.push_back(x);
    floor.y.push_back(1);
  }
  std::vector<Series> series = {floor, without};
  if (after) series.push_back(with);
  figure.panels.push_back({"", {"Root mean square", "sd", true, {}}, series});
  return figure;
}

}  // namespace secular
