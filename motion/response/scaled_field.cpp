#include "motion/response/scaled_field.hpp"

#include <utility>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

ScaledField::ScaledField(VectorField field, const ConstVector& parameters, std::vector<FreeParameter> free)
    : field_(std::move(field)), parameters_(parameters), free_(std::move(free)) {
  scale_.resize(unknowns());
  scale_.head(dimension()) = field_.typical_state();
  for (Index k = 0; k < free_count(); ++k) scale_(dimension() + k) = free_[static_cast<std::size_t>(k)].scale;
}

VectorXd ScaledField::unknowns_at(const ConstVector& state, const ConstVector& parameters) const {
  VectorXd y(unknowns());
  y.head(dimension()) = state.cwiseQuotient(field_.typical_state());
  for (Index k = 0; k < free_count(); ++k) {
    const FreeParameter& free = free_[static_cast<std::size_t>(k)];
    y(dimension() + k) = (parameters(free.index) - free.centre) / free.scale;
  }
  return y;
}

VectorXd ScaledField::state(const ConstVector& unknowns) const {
  return unknowns.head(dimension()).cwiseProduct(field_.typical_state());
}

VectorXd ScaledField::parameters(const ConstVector& unknowns) const {
  VectorXd p = parameters_;
  for (Index k = 0; k < free_count(); ++k) {
    const FreeParameter& free = free_[static_cast<std::size_t>(k)];
    p(free.index) = free.centre + free.scale * unknowns(dimension() + k);
  }
  return p;
}

VectorXd ScaledField::direction(const ConstVector& scaled) const {
  return scaled.cwiseProduct(scale_);
}

VectorXd ScaledField::scaled_direction(const ConstVector& direction) const {
  return direction.cwiseQuotient(scale_);
}

VectorXd ScaledField::rate(const ConstVector& unknowns) const {
  return field_.rate(state(unknowns), parameters(unknowns)).cwiseQuotient(field_.typical_state());
}

MatrixXd ScaledField::state_jacobian(const ConstVector& unknowns) const {
  const VectorXd& typical = field_.typical_state();
  return typical.cwiseInverse().asDiagonal() * field_.jacobian(state(unknowns), parameters(unknowns)) *
         typical.asDiagonal();
}

VectorXd ScaledField::parameter_derivative(const ConstVector& unknowns, Index which) const {
  const FreeParameter& free = free_[static_cast<std::size_t>(which)];
  return free.scale * field_.parameter_derivative(state(unknowns), parameters(unknowns), free.index)
                          .cwiseQuotient(field_.typical_state());
}

MatrixXd ScaledField::jacobian(const ConstVector& unknowns) const {
  MatrixXd jacobian(dimension(), this->unknowns());
  jacobian.leftCols(dimension()) = state_jacobian(unknowns);
  for (Index k = 0; k < free_count(); ++k) jacobian.col(dimension() + k) = parameter_derivative(unknowns, k);
  return jacobian;
}

}  // namespace secular
