#include "motion/response/response_field.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

/// Amplitude, in typical ones, that stands for zero in f/r.
constexpr double vanishing = 1e-150;

/// Largest amplitude ratio looked for where the trivial solution is blown up.
constexpr double largest_ratio = 12;

// Null space of the relations over the active modes' natural frequencies, as rows of entries of the order of one.
MatrixXd free_phases(const CompiledModel& model, const CompiledCase& resonance,
                     const std::vector<std::size_t>& active) {
  const std::size_t columns = model.modes() + model.excitations.size();
  const std::size_t rows = columns == 0 ? 0 : resonance.relations.size() / columns;
  const auto count = static_cast<Index>(active.size());
  if (rows == 0) return MatrixXd::Identity(count, count);
  MatrixXd weights(static_cast<Index>(rows), count);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t k = 0; k < active.size(); ++k)
      weights(static_cast<Index>(r), static_cast<Index>(k)) = resonance.relations[r * columns + active[k]];
  const Eigen::FullPivLU<MatrixXd> lu(weights);
  if (lu.dimensionOfKernel() == 0) return MatrixXd(0, count);
  MatrixXd rowsOut = lu.kernel().transpose();
  for (Index s = 0; s < rowsOut.rows(); ++s) {
    double least = 0;
    for (Index k = 0; k < count; ++k) {
      const double entry = std::abs(rowsOut(s, k));
      if (entry > 1e-9 && (least == 0 || entry < least)) least = entry;
    }
    rowsOut.row(s) /= least;
  }
  return rowsOut;
}

VectorXd typical_parameters(const ConstVector& parameters) {
  return parameters.unaryExpr([](double p) { return p != 0 && std::isfinite(p) ? std::abs(p) : 1.0; });
}

}  // namespace

ResponseField::ResponseField(const CompiledModel& model, const CompiledCase& resonance)
    : model_(&model), case_(&resonance), locked_(model, resonance) {
  for (std::size_t k = 0; k < model.modes(); ++k)
    if (!resonance.mode_at_rest[k]) active_.push_back(k);
  if (active_.empty()) throw std::invalid_argument("a case with every mode at rest has no response");
  const MatrixXd candidates = free_phases(model, resonance, active_);
  std::vector<Index> kept;
  for (Index s = 0; s < candidates.rows(); ++s)
    if (is_equivariant(candidates.row(s).transpose())) kept.push_back(s);
  symmetries_.resize(static_cast<Index>(kept.size()), candidates.cols());
  for (std::size_t s = 0; s < kept.size(); ++s) symmetries_.row(static_cast<Index>(s)) = candidates.row(kept[s]);

  // Pinned modes: columns that make the symmetries' square part regular.
  const auto count = static_cast<Index>(active_.size());
  MatrixXd rest = symmetries_;
  std::vector<char> is_pinned(active_.size(), 0);
  for (Index s = 0; s < rest.rows(); ++s) {
    Index column = 0;
    rest.row(s).cwiseAbs().maxCoeff(&column);
    pinned_.push_back(column);
    is_pinned[static_cast<std::size_t>(column)] = 1;
    for (Index other = s + 1; other < rest.rows(); ++other)
      rest.row(other) -= rest.row(s) * (rest(other, column) / rest(s, column));
  }
  for (Index k = 0; k < count; ++k) {
    if (is_pinned[static_cast<std::size_t>(k)]) continue;
    const bool moves = symmetries_.rows() == 1 && std::abs(symmetries_(0, k)) > 1e-9;
    (moves ? ratio_ : plain_).push_back(k);
  }
}

std::vector<std::string> ResponseField::parameter_names(const CompiledModel& model) {
  std::vector<std::string> names;
  for (const CompiledSymbol& symbol : model.symbols) names.emplace_back(symbol.name);
  for (const std::string_view name : model.excitation_frequencies) names.emplace_back(name);
  for (const std::string_view name : model.excitations) names.emplace_back(name);
  return names;
}

VectorXcd ResponseField::modulation(const ConstVector& parameters,
                                    const Eigen::Ref<const VectorXcd>& amplitude) const {
  VectorXcd result(amplitude.size());
  modulate(
      parameters, [&](Index k) { return amplitude(k); }, [&](Index k, Complex rate) { result(k) = rate; });
  return result;
}

// Searches call this millions of times: nothing is asked of the heap where modes are few.
template <class Amplitude, class Put>
void ResponseField::modulate(const ConstVector& parameters, const Amplitude& amplitude, const Put& put) const {
  using Numbers = boost::container::small_vector<Complex, 6>;
  const std::size_t modes = model_->modes(), excitations = model_->excitations.size();
  Numbers all(modes), rate(modes), forcing(std::max<std::size_t>(1, excitations));
  for (std::size_t k = 0; k < active_.size(); ++k) all[active_[k]] = amplitude(static_cast<Index>(k));
  const double* const given = parameters.data() + model_->symbols.size();
  if (case_->excited)
    for (std::size_t j = 0; j < excitations; ++j) forcing[j] = given[excitations + j];
  boost::container::small_vector<double, 6> frequency(given, given + excitations);
  locked_.follow(frequency.data());
  case_->modulation(parameters.data(), frequency.data(), all.data(), forcing.data(), rate.data());
  for (std::size_t k = 0; k < active_.size(); ++k) put(static_cast<Index>(k), rate[active_[k]]);
}

bool ResponseField::is_equivariant(const ConstVector& direction) const {
  const auto count = static_cast<Index>(active_.size());
  VectorXd parameters(static_cast<Index>(model_->symbols.size() + 2 * model_->excitations.size()));
  for (Index p = 0; p < parameters.size(); ++p) parameters(p) = 1 + 0.37 * std::sin(1.7 * static_cast<double>(p));
  for (const double angle : {0.7, 2.1, 4.4}) {
    VectorXcd b(count), turn(count);
    for (Index k = 0; k < count; ++k) {
      b(k) = std::polar(0.4 + 0.3 * std::cos(angle + static_cast<double>(k)),
                        1.3 * angle * static_cast<double>(k + 1));
      turn(k) = std::polar(1.0, direction(k) * angle);
    }
    const VectorXcd turned = modulation(parameters, b.cwiseProduct(turn));
    const VectorXcd expected = modulation(parameters, b).cwiseProduct(turn);
    if ((turned - expected).norm() > 1e-9 * expected.norm()) return false;
  }
  return true;
}

std::string ResponseField::description() const {
  if (!is_reduced()) return "every phase is tied to the excitation";
  std::string text;
  for (Index s = 0; s < symmetries_.rows(); ++s) {
    std::string moved;
    for (Index k = 0; k < symmetries_.cols(); ++k)
      if (std::abs(symmetries_(s, k)) > 1e-9)
        moved +=
            (moved.empty() ? "" : " and ") + std::string(model_->coordinates[active_[static_cast<std::size_t>(k)]]);
    text +=
        (text.empty() ? "" : "; ") + ("the common phase of " + moved) + " is free: it is fixed by making " +
        std::string(model_->coordinates[active_[static_cast<std::size_t>(pinned_[static_cast<std::size_t>(s)])]]) +
        " real, and the frequency at which it drifts is computed";
  }
  return text;
}

ResponseField::Frame ResponseField::frame_at(const ConstVector& parameters, const ConstVector& state) const {
  const auto count = static_cast<Index>(active_.size());
  Frame frame{VectorXcd(count), VectorXcd(count), VectorXd::Zero(count), 1};
  const auto pins = static_cast<Index>(pinned_.size());
  const auto pair = [&](Index place) { return Complex(state(place), state(place + 1)); };
  if (is_blown_up()) frame.scale = std::abs(state(0)) < vanishing ? vanishing : state(0);
  Index place = 0;
  for (const Index k : pinned_) {
    const double r = state(place++);
    frame.amplitude(k) = std::abs(r) < vanishing ? vanishing : r;
  }
  for (const Index k : ratio_) {
    frame.amplitude(k) = frame.scale * pair(place);
    place += 2;
  }
  for (const Index k : plain_) {
    frame.amplitude(k) = pair(place);
    place += 2;
  }
  frame.rate = modulation(parameters, frame.amplitude);
  if (pins > 0) {
    MatrixXd square(pins, pins);
    VectorXd turning(pins);
    for (Index s = 0; s < pins; ++s) {
      const Index k = pinned_[static_cast<std::size_t>(s)];
      square.row(s) = symmetries_.col(k).transpose();
      turning(s) = (frame.rate(k) / frame.amplitude(k)).imag();
    }
    frame.shift = symmetries_.transpose() * VectorXd(square.partialPivLu().solve(turning));
    for (Index k = 0; k < count; ++k) frame.rate(k) -= Complex(0, frame.shift(k)) * frame.amplitude(k);
  }
  return frame;
}

VectorField ResponseField::field(bool reduced, double amplitude_scale, const ConstVector& parameters) const {
  const auto count = static_cast<Index>(active_.size());
  const Index dimension = reduced ? 2 * count - symmetries_.rows() : 2 * count;
  const ResponseField self = *this;
  VectorField::RightSide right_side;
  if (reduced && is_reduced()) {
    right_side = [self](const ConstVector& x, const ConstVector& p, Eigen::Ref<VectorXd> rate) {
      const Frame frame = self.frame_at(p, x);
      Index place = 0;
      for (const Index k : self.pinned_) {
        rate(place) = std::abs(x(place)) < vanishing ? 0.0 : frame.rate(k).real();
        ++place;
      }
      const auto put = [&](Complex value) {
        rate(place++) = value.real();
        rate(place++) = value.imag();
      };
      for (const Index k : self.ratio_) {
        const Index first = self.pinned_.front();
        const Complex ratio = frame.amplitude(k) / frame.scale;
        put(frame.rate(k) / frame.scale - ratio * frame.rate(first) / frame.scale);
      }
      for (const Index k : self.plain_) put(frame.rate(k));
    };
  } else {
    right_side = [self](const ConstVector& x, const ConstVector& p, Eigen::Ref<VectorXd> rate) {
      const auto amplitude = [&](Index k) { return Complex(x(2 * k), x(2 * k + 1)); };
      const auto put = [&](Index k, Complex derivative) {
        rate(2 * k) = derivative.real();
        rate(2 * k + 1) = derivative.imag();
      };
      self.modulate(p, amplitude, put);
    };
  }
  VectorField result(dimension, parameter_names(*model_), std::move(right_side));
  VectorXd typical = VectorXd::Constant(dimension, amplitude_scale);
  if (reduced) typical.segment(static_cast<Index>(pinned_.size()), 2 * static_cast<Index>(ratio_.size())).setOnes();
  result.set_typical(typical, typical_parameters(parameters));
  return result;
}

VectorField ResponseField::full(double amplitude_scale, const ConstVector& parameters) const {
  return field(false, amplitude_scale, parameters);
}

VectorField ResponseField::reduced(double amplitude_scale, const ConstVector& parameters) const {
  return field(true, amplitude_scale, parameters);
}

VectorXd ResponseField::box(double largest) const {
  VectorXd half = VectorXd::Constant(2 * static_cast<Index>(active_.size()) - symmetries_.rows(), largest);
  half.segment(static_cast<Index>(pinned_.size()), 2 * static_cast<Index>(ratio_.size()))
      .setConstant(largest_ratio);
  return half;
}

ModeAmplitudes ResponseField::amplitudes(const ConstVector& parameters, const ConstVector& state) const {
  ModeAmplitudes result;
  result.amplitude.resize(model_->modes());
  result.frequency_shift.resize(model_->modes());
  const Frame frame = frame_at(parameters, state);
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const Complex b = frame.amplitude(static_cast<Index>(k));
    result.amplitude[active_[k]] = std::abs(b) <= 1e3 * vanishing ? Complex() : b;
    result.frequency_shift[active_[k]] = frame.shift(static_cast<Index>(k));
  }
  return result;
}

VectorXd ResponseField::pinned(const ConstVector& state) const {
  return state.head(static_cast<Index>(pinned_.size()));
}

double amplitude_scale(const ResponseField& field, const ConstVector& parameters, Index parameter, double lower,
                       double upper) {
  const auto count = static_cast<Index>(field.active().size());
  std::vector<VectorXd> settings;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    settings.emplace_back(parameters);
    settings.back()(parameter) = lower + share * (upper - lower);
  }
  std::vector<VectorXcd> directions;
  for (int d = 0; d < 8; ++d) {
    VectorXcd u(count);
    for (Index k = 0; k < count; ++k)
      u(k) = std::polar(1.0, std::numbers::pi * d / 8 + 2.399963 * static_cast<double>(k * (d + 1)));
    directions.push_back(std::move(u));
  }
  const VectorXcd zero = VectorXcd::Zero(count);
  double constant = 0;
  for (const VectorXd& p : settings) constant = std::max(constant, field.modulation(p, zero).norm());
  for (double a = 1e-9; a < 1e9; a *= 1.2) {
    double linear = 0, nonlinear = 0;
    for (const VectorXd& p : settings) {
      const VectorXcd offset = field.modulation(p, zero);
      for (const VectorXcd& u : directions) {
        const VectorXcd at = (field.modulation(p, a * u) - offset) / a;
        const VectorXcd near = (field.modulation(p, 1e-3 * a * u) - offset) / (1e-3 * a);
        linear = std::max(linear, near.norm());
        nonlinear = std::max(nonlinear, (at - near).norm());
      }
    }
    if (nonlinear >= linear + constant / a) return a;
  }
  if (constant == 0) return 1;
  double slowest = std::numeric_limits<double>::infinity();
  for (const VectorXd& p : settings) {
    const MatrixXd jacobian = field.full(1, p).jacobian(VectorXd::Zero(2 * count), p);
    slowest = std::min(slowest, Eigen::JacobiSVD<MatrixXd>(jacobian).singularValues().minCoeff());
  }
  return slowest > 0 ? constant / slowest : 1;
}

}  // namespace secular
