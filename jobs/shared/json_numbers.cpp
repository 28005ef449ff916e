#include "jobs/shared/json_numbers.hpp"

#include <cmath>

namespace secular {

nlohmann::ordered_json finite_json(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json optional_json(const std::optional<double>& value) {
  return value ? finite_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json list_json(const Eigen::Ref<const Eigen::VectorXd>& values) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const double v : values) array.push_back(v);
  return array;
}

}  // namespace secular
