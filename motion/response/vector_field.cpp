#include "motion/response/vector_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "motion/response/differences.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

VectorField::VectorField(Index dimension, std::vector<std::string> parameter_names, RightSide right_side,
                         Jacobian jacobian)
    : dimension_(dimension),
      names_(std::move(parameter_names)),
      right_side_(std::move(right_side)),
      jacobian_(std::move(jacobian)) {
  if (dimension_ < 1) throw std::invalid_argument("a vector field of dimension below 1");
  if (!right_side_) throw std::invalid_argument("a vector field without a right side");
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (names_[i].empty()) throw std::invalid_argument("a parameter of a vector field has no name");
    if (std::find(names_.begin(), names_.begin() + static_cast<std::ptrdiff_t>(i), names_[i]) !=
        names_.begin() + static_cast<std::ptrdiff_t>(i))
      throw std::invalid_argument("two parameters of a vector field are called " + names_[i]);
  }
  typical_state_ = VectorXd::Ones(dimension_);
  typical_parameters_ = VectorXd::Ones(parameter_count());
}

void VectorField::set_typical(const ConstVector& state, const ConstVector& parameters) {
  const auto usable = [](const ConstVector& v) { return v.allFinite() && (v.array() > 0).all(); };
  if (state.size() != dimension_ || parameters.size() != parameter_count() || !usable(state) || !usable(parameters))
    throw std::invalid_argument("typical magnitudes of a vector field: one positive number for each");
  typical_state_ = state;
  typical_parameters_ = parameters;
}

void VectorField::check(const ConstVector& state, const ConstVector& parameters) const {
  if (state.size() != dimension_ || parameters.size() != parameter_count())
    throw std::invalid_argument("a state or parameters that do not have the vector field's size");
  if (!state.allFinite() || !parameters.allFinite())
    throw std::invalid_argument("a state or parameters that are not finite");
}

VectorXd VectorField::rate(const ConstVector& state, const ConstVector& parameters) const {
  if (state.size() != dimension_ || parameters.size() != parameter_count())
    throw std::invalid_argument("a state or parameters that do not have the vector field's size");
  VectorXd rate = VectorXd::Zero(dimension_);
  right_side_(state, parameters, rate);
  return rate;
}

MatrixXd VectorField::jacobian(const ConstVector& state, const ConstVector& parameters) const {
  if (state.size() != dimension_ || parameters.size() != parameter_count())
    throw std::invalid_argument("a state or parameters that do not have the vector field's size");
  if (!jacobian_) {
    VectorXd rate(dimension_);
    const auto rate_at = [&](const VectorXd& x) -> const VectorXd& {
      rate.setZero();
      right_side_(x, parameters, rate);
      return rate;
    };
    return difference_jacobian(rate_at, state, typical_state_, dimension_);
  }
  MatrixXd jacobian = MatrixXd::Zero(dimension_, dimension_);
  jacobian_(state, parameters, jacobian);
  return jacobian;
}

VectorXd VectorField::parameter_derivative(const ConstVector& state, const ConstVector& parameters,
                                           Index parameter) const {
  if (parameter < 0 || parameter >= parameter_count())
    throw std::invalid_argument("the vector field has no parameter of this index");
  VectorXd p = parameters;
  const auto along = [&](const VectorXd& value) {
    p(parameter) = value(0);
    return rate(state, p);
  };
  return difference_jacobian(along, parameters.segment(parameter, 1), typical_parameters_.segment(parameter, 1),
                             dimension_);
}

}  // namespace secular
