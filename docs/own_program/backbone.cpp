// Frequency and decay rate of the shipped model `duffing` against the amplitude of a free decay.
#include <cstdio>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "motion/response/response_curve.hpp"

int main() {
  const secular::CompiledModel& model = *secular::generated::find_compiled_model("duffing");
  const secular::ResponseField field(model, secular::case_named(model, "free"));
  const std::size_t count = secular::ResponseField::parameter_names(model).size();
  Eigen::VectorXd parameters = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
  const auto parameter = [&](const char* name) -> double& {
    return parameters(static_cast<Eigen::Index>(secular::symbol_named(model, name)));
  };
  parameter("omega0") = 100;  // rad/s
  parameter("mu") = 0.5;      // 1/s
  parameter("a3") = 4e5;      // 1/(m s)^2
  for (const secular::BackbonePoint& at : secular::backbone(field, parameters, 0, 0.01, 4))
    std::printf("peak amplitude %.3f m: %.4f rad/s, decays by %.4f 1/s\n", 2 * at.amplitude, at.frequency,
                -at.growth);
}
