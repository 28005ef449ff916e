#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <optional>

namespace secular {

/// A number; null where it is not finite.
nlohmann::ordered_json finite_json(double value);
/// The same, and null where there is none.
nlohmann::ordered_json optional_json(const std::optional<double>& value);
nlohmann::ordered_json list_json(const Eigen::Ref<const Eigen::VectorXd>& values);

}  // namespace secular
