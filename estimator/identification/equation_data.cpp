#include "estimator/identification/equation_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimator/model/zero_frequency.hpp"

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Change of natural frequencies, relative, that columns do not notice.
constexpr double same_frequency = 1e-11;

// Radians that excitations are put ahead by to see what that does: columns are low powers of exp(i*phase).
constexpr double phase_step = 1e-5;

// Error of `step` along a measured complex number or across it: steps in the frame of the motion are the same at
// every instant, also where they are not small.
Complex step_from(Complex value, double step, bool across) {
  return (across ? Complex(0, step) : Complex(step, 0)) * std::polar(1.0, std::arg(value));
}

// docs/inference.md (52): a record's natural frequency is off alike in all of its repeats, so that their mean, of
// which noise is smaller by the root of their number, is off by all of it.
double own_frequency_sd(const ObservationSet& set, std::size_t mode, double repeats) {
  return set.frequency_scatter[mode] * std::sqrt(repeats);
}

// Columns by what they are the coefficients of; -1: known.
struct ColumnPlaces {
  std::vector<Index> lump, natural_frequency, sensor_offset;

  ColumnPlaces(const std::vector<CaseColumn>& columns, std::size_t lumps, std::size_t modes)
      : lump(lumps, -1), natural_frequency(modes, -1), sensor_offset(modes, -1) {
    for (std::size_t c = 0; c < columns.size(); ++c) of(columns[c].kind)[columns[c].index] = static_cast<Index>(c);
  }

 private:
  std::vector<Index>& of(CaseColumn::Kind kind) {
    if (kind == CaseColumn::Kind::lump) return lump;
    return kind == CaseColumn::Kind::natural_frequency ? natural_frequency : sensor_offset;
  }
};

}  // namespace

Complex motion_frame(const RegressorBlock& block, const Observation& o) {
  if (block.kind == BlockKind::modulation)
    return std::polar(1.0, -std::arg(o.amplitude[static_cast<std::size_t>(block.mode)]));
  double angle = 0;
  const std::size_t modes = o.amplitude.size();
  for (std::size_t i = 0; i < block.phase.size(); ++i)
    if (block.phase[i] != 0) angle += block.phase[i] * std::arg(i < modes ? o.amplitude[i] : o.forcing[i - modes]);
  return std::polar(1.0, -angle);
}

Complex put_ahead(const Observation& o, std::size_t excitation, double angle) {
  return std::polar(1.0, angle * o.excitation_frequency[excitation] / o.excitation_frequency.front());
}

EquationData::EquationData(const ObservationSet& set, const std::vector<std::size_t>& blocks, Errors errors)
    : set_(set), case_(*set.resonance), modes_(mode_frequencies(*set.model, *set.resonance)), blocks_(blocks) {
  const auto add = [&](Kind kind, std::size_t index, bool imaginary, bool columns_depend) {
    quantities_.push_back({kind, index, imaginary});
    column_variant_.push_back(columns_depend ? static_cast<int>(copies_++) : 0);
  };
  if (errors == Errors::of_measurement) {
    for (std::size_t k = 0; k < set.model->modes(); ++k) {
      if (!modes_.oscillates[k]) continue;
      add(Kind::amplitude, k, false, true);
      add(Kind::amplitude, k, true, true);
      add(Kind::growth, k, false, false);
      // Without excitation every mode's frequency is observed by itself, a resonance between them or not.
      if (!case_.excited) add(Kind::frequency, k, false, false);
      if (case_.excited && !set.frequency_scatter.empty()) add(Kind::own_frequency, k, false, false);
    }
    for (std::size_t f = 0; f < modes_.free.size() && case_.excited; ++f)
      add(Kind::free_frequency, f, false, false);
    for (std::size_t j = 0; j < set.model->excitations.size() && case_.excited; ++j) {
      add(Kind::forcing, j, false, true);
      add(Kind::forcing, j, true, true);
      add(Kind::excitation_frequency, j, false, true);
    }
  }
  for (const Observation& o : set.observations) repeats_[o.record] += 1;
  if (set.phase_unknown) phase_variant_ = static_cast<int>(copies_++);
  frame_.reserve(set.observations.size() * blocks.size());
  for (const Observation& o : set.observations) {
    for (const std::size_t b : blocks) frame_.push_back(motion_frame(case_.blocks[b], o));
    for (const Quantity& q : quantities_) {
      deviation_.push_back(sd(q, o));
      step_.push_back(step(q, o, deviation_.back()));
    }
  }
}

// An error of `size` as the change of the measured number; of a frequency, of the rate i*frequency.
Complex EquationData::step(const Quantity& q, const Observation& o, double size) const {
  switch (q.kind) {
    case Kind::amplitude:
      return step_from(o.amplitude[q.index], size, q.imaginary);
    case Kind::forcing:
      return step_from(o.forcing[q.index], size, q.imaginary);
    case Kind::growth:
      return size;
    case Kind::frequency:
    case Kind::own_frequency:
    case Kind::free_frequency:
    case Kind::excitation_frequency:
      return {0, size};
  }
  return 0;
}

double EquationData::sd(const Quantity& q, const Observation& o) const {
  switch (q.kind) {
    case Kind::amplitude:
      return o.amplitude_sd.at(q.index);
    case Kind::growth:
      return std::max(0.0, o.growth_sd.at(q.index));
    case Kind::frequency:
      return o.frequency_sd.at(q.index);
    case Kind::own_frequency:
      return own_frequency_sd(set_, q.index, repeats_.at(o.record));
    case Kind::free_frequency:
      return o.free_frequency_sd.at(q.index);
    case Kind::forcing:
      return o.forcing_sd.at(q.index);
    case Kind::excitation_frequency:
      return o.excitation_frequency_sd.at(q.index);
  }
  return 0;
}

bool EquationData::present(std::size_t block, const Observation& o) const {
  const RegressorBlock& b = case_.blocks[block];
  const auto mode = static_cast<std::size_t>(b.mode);
  return b.kind == BlockKind::modulation ? modes_.oscillates[mode] && o.growth_sd[mode] >= 0
                                         : o.harmonic_sd[block] >= 0;
}

void EquationData::evaluate(const std::vector<double>& found) {
  const std::vector<double>& natural_frequency = set_.column_frequency.empty() ? found : set_.column_frequency;
  if (!evaluated_at_.empty()) {
    double moved = 0;
    for (std::size_t k = 0; k < natural_frequency.size(); ++k)
      moved = std::max(moved, std::abs(natural_frequency[k] / evaluated_at_[k] - 1));
    if (moved < same_frequency) return;
  }
  evaluated_at_ = natural_frequency;
  const std::size_t count = set_.observations.size(), all = copies_ * count;
  const std::size_t modes = set_.model->modes(), excitations = set_.model->excitations.size();
  std::vector<std::vector<Complex>> amplitude(modes, std::vector<Complex>(all)),
      forcing(excitations, std::vector<Complex>(all));
  std::vector<std::vector<double>> frequency(excitations, std::vector<double>(all));
  for (std::size_t copy = 0; copy < copies_; ++copy)
    for (std::size_t i = 0; i < count; ++i) {
      const Observation& o = set_.observations[i];
      for (std::size_t k = 0; k < modes; ++k) amplitude[k][copy * count + i] = o.amplitude[k];
      for (std::size_t j = 0; j < excitations; ++j) {
        forcing[j][copy * count + i] = o.forcing[j];
        frequency[j][copy * count + i] = o.excitation_frequency[j];
      }
    }
  for (std::size_t q = 0; q < quantities_.size(); ++q) {
    if (column_variant_[q] == 0) continue;
    const auto copy = static_cast<std::size_t>(column_variant_[q]);
    const Quantity& quantity = quantities_[q];
    for (std::size_t i = 0; i < count; ++i) {
      const Complex step = step_[i * quantities_.size() + q];
      const std::size_t at = copy * count + i, k = quantity.index;
      if (quantity.kind == Kind::amplitude) amplitude[k][at] += step;
      if (quantity.kind == Kind::forcing) forcing[k][at] += step;
      if (quantity.kind == Kind::excitation_frequency) frequency[k][at] += step.imag();
    }
  }
  for (std::size_t j = 0; j < excitations && phase_variant_ > 0; ++j)
    for (std::size_t i = 0; i < count; ++i)
      forcing[j][static_cast<std::size_t>(phase_variant_) * count + i] *=
          put_ahead(set_.observations[i], j, phase_step);
  std::vector<const Complex*> amplitude_rows, forcing_rows;
  std::vector<const double*> frequency_rows;
  for (const auto& row : amplitude) amplitude_rows.push_back(row.data());
  for (const auto& row : forcing) forcing_rows.push_back(row.data());
  for (const auto& row : frequency) frequency_rows.push_back(row.data());
  const ObservationBatch batch{all, natural_frequency.data(), frequency_rows.data(), amplitude_rows.data(),
                               forcing_rows.data()};
  columns_.clear();
  for (const std::size_t b : blocks_) {
    const RegressorBlock& block = case_.blocks[b];
    std::vector<Eigen::VectorXcd> columns(block.lumps.size(), Eigen::VectorXcd(static_cast<Index>(all)));
    std::vector<Complex*> pointers;
    for (Eigen::VectorXcd& column : columns) pointers.push_back(column.data());
    block.columns(batch, pointers.data());
    columns_.push_back(std::move(columns));
  }
}

Index EquationData::row_count(std::size_t observation) const {
  Index size = 0;
  for (const std::size_t b : blocks_)
    if (present(b, set_.observations[observation])) size += is_zero_frequency(case_.blocks[b]) ? 1 : 2;
  return size;
}

EquationData::Rows EquationData::rows(std::size_t observation, const std::vector<CaseColumn>& columns,
                                      const EquationPoint& point,
                                      const std::vector<double>& reference_frequency) const {
  const Observation& o = set_.observations[observation];
  const auto count = static_cast<Index>(set_.observations.size());
  const auto at = static_cast<Index>(observation);
  const std::size_t quantities = quantities_.size();
  Rows result;
  const Index size = row_count(observation);
  const ColumnPlaces place(columns, case_.lumps.size(), o.rate.size());
  result.design = MatrixXd::Zero(size, static_cast<Index>(columns.size()));
  result.response.resize(size);
  result.variants = MatrixXd::Zero(size, static_cast<Index>(quantities));
  result.own_variance.resize(size);
  if (phase_variant_ > 0) result.phase.resize(size);
  result.block.reserve(static_cast<std::size_t>(size));
  result.part.reserve(static_cast<std::size_t>(size));
  Index r = 0;
  for (std::size_t p = 0; p < blocks_.size(); ++p) {
    const std::size_t b = blocks_[p];
    if (!present(b, o)) continue;
    const RegressorBlock& block = case_.blocks[b];
    const auto mode = static_cast<std::size_t>(block.mode);
    const bool modulation = block.kind == BlockKind::modulation, zero = is_zero_frequency(block);
    const Complex a = o.amplitude[mode], rate = o.rate[mode], frame = frame_[observation * blocks_.size() + p];
    const auto put = [&](auto& matrix, Index column, Complex value) {
      value *= frame;
      matrix(r, column) = value.real();
      if (!zero) matrix(r + 1, column) = value.imag();
    };
    // By the right side: sum of lumps times how their columns change in one of the copies.
    const auto change_in = [&](int copy) {
      Complex change = 0;
      for (std::size_t j = 0; j < block.lumps.size(); ++j)
        change += point.lump[static_cast<std::size_t>(block.lumps[j])] *
                  (columns_[p][j](copy * count + at) - columns_[p][j](at));
      return change;
    };
    Complex target = modulation ? rate * a : o.harmonic[b];
    const bool frequency_open = modulation && place.natural_frequency[mode] >= 0;
    if (frequency_open) put(result.design, place.natural_frequency[mode], Complex(0, 1) * a);
    if (zero && place.sensor_offset[mode] >= 0) put(result.design, place.sensor_offset[mode], 1);
    if (modulation)
      target -= Complex(0, (frequency_open ? reference_frequency : point.natural_frequency)[mode]) * a;
    if (set_.truncation.size() > 0) target -= set_.truncation(at, static_cast<Index>(b)) * std::conj(frame);
    for (std::size_t j = 0; j < block.lumps.size(); ++j) {
      const auto l = static_cast<std::size_t>(block.lumps[j]);
      if (place.lump[l] >= 0)
        put(result.design, place.lump[l], columns_[p][j](at));
      else
        target -= point.lump[l] * columns_[p][j](at);
    }
    put(result.response, 0, target);
    // Left minus right side where one measured quantity is off.
    for (std::size_t q = 0; q < quantities; ++q) {
      if (!(deviation_[observation * quantities + q] > 0)) continue;
      const Complex step = step_[observation * quantities + q];
      Complex change =
          modulation ? modulation_change(quantities_[q], step, o, mode, point.natural_frequency[mode]) : 0.0;
      if (column_variant_[q] > 0) change -= change_in(column_variant_[q]);
      put(result.variants, static_cast<Index>(q), change);
    }
    if (phase_variant_ > 0) put(result.phase, 0, -change_in(phase_variant_) / phase_step);
    // Noise-free data: equal weights relative to the size of the equation.
    const double own = modulation ? 0 : o.harmonic_sd[b] * o.harmonic_sd[b];
    const double floor =
        std::norm(1e-12 * (modulation ? rate * a : o.harmonic[b])) + std::numeric_limits<double>::min();
    for (Index i = 0; i < (zero ? 1 : 2); ++i) {
      result.own_variance(r + i) = own + floor;
      result.block.push_back(b);
      result.part.push_back(i == 0 ? EquationPart::in_phase : EquationPart::in_quadrature);
    }
    r += zero ? 1 : 2;
  }
  return result;
}

// By the left side of a mode's modulation equation, (rate - i*omega) * amplitude.
Complex EquationData::modulation_change(const Quantity& quantity, Complex step, const Observation& o,
                                        std::size_t mode, double natural_frequency) const {
  const auto row = static_cast<Index>(mode), share = static_cast<Index>(quantity.index);
  switch (quantity.kind) {
    case Kind::amplitude:
      return quantity.index == mode ? (o.rate[mode] - Complex(0, natural_frequency)) * step : 0;
    case Kind::growth:
    case Kind::frequency:
    case Kind::own_frequency:
      return quantity.index == mode ? step * o.amplitude[mode] : 0;
    case Kind::free_frequency:
      return step * modes_.coupling(row, share) * o.amplitude[mode];
    case Kind::excitation_frequency:
      return step * modes_.forced(row, share) * o.amplitude[mode];
    case Kind::forcing:
      break;
  }
  return 0;
}

std::vector<Index> EquationData::motion_quantities() const {
  std::vector<Index> result;
  for (std::size_t q = 0; q < quantities_.size(); ++q)
    if (quantities_[q].kind == Kind::amplitude || quantities_[q].kind == Kind::free_frequency)
      result.push_back(static_cast<Index>(q));
  return result;
}

MatrixXd EquationData::correlation(const WindowPair& pair) const {
  const auto count = static_cast<Index>(quantities_.size());
  MatrixXd result = MatrixXd::Zero(count, count);
  for (Index a = 0; a < count; ++a)
    for (Index b = 0; b < count; ++b) {
      const Quantity& here = quantities_[static_cast<std::size_t>(a)];
      const Quantity& later = quantities_[static_cast<std::size_t>(b)];
      if (here.index != later.index) continue;
      const ToneOverlap& of = pair.mode[here.index];
      if (a == b)
        result(a, b) = here.kind == Kind::amplitude ? of.amplitudes : of.slopes;
      else if (is_slope_of(here, later))
        result(a, b) = of.slope_later;
      else if (is_slope_of(later, here))
        result(a, b) = of.slope_earlier;
    }
  return result;
}

// Growth is the slope along the amplitude, frequency that across it.
bool EquationData::is_slope_of(const Quantity& amplitude, const Quantity& slope) {
  return amplitude.kind == Kind::amplitude && slope.kind == (amplitude.imaginary ? Kind::frequency : Kind::growth);
}

void EquationData::move(Observation& o, const VectorXd& deviations) const {
  for (std::size_t q = 0; q < quantities_.size(); ++q) {
    const Quantity& quantity = quantities_[q];
    const Complex change = step(quantity, o, -deviations(static_cast<Index>(q)) * sd(quantity, o));
    const auto turn = [&](const MatrixXd& share) {
      for (std::size_t k = 0; k < o.rate.size(); ++k)
        o.rate[k] += change * share(static_cast<Index>(k), static_cast<Index>(quantity.index));
    };
    switch (quantity.kind) {
      case Kind::amplitude:
        o.amplitude[quantity.index] += change;
        break;
      case Kind::growth:
      case Kind::frequency:
      case Kind::own_frequency:
        o.rate[quantity.index] += change;
        break;
      case Kind::free_frequency:
        turn(modes_.coupling);
        break;
      case Kind::forcing:
        o.forcing[quantity.index] += change;
        break;
      case Kind::excitation_frequency:
        o.excitation_frequency[quantity.index] += change.imag();
        turn(modes_.forced);
        break;
    }
  }
}

std::vector<EquationData::ColumnError> EquationData::column_errors(std::size_t observation,
                                                                   const std::vector<CaseColumn>& columns) const {
  const Observation& o = set_.observations[observation];
  const auto count = static_cast<Index>(set_.observations.size());
  const auto at = static_cast<Index>(observation);
  const ColumnPlaces place(columns, case_.lumps.size(), o.rate.size());
  const Index size = row_count(observation);
  std::vector<ColumnError> errors;
  for (std::size_t q = 0; q < quantities_.size(); ++q) {
    const Quantity& quantity = quantities_[q];
    const Index copy = column_variant_[q];
    if (copy == 0 || !(deviation_[observation * quantities_.size() + q] > 0)) continue;
    MatrixXd error = MatrixXd::Zero(size, static_cast<Index>(columns.size()));
    Index r = 0;
    for (std::size_t p = 0; p < blocks_.size(); ++p) {
      if (!present(blocks_[p], o)) continue;
      const RegressorBlock& block = case_.blocks[blocks_[p]];
      const auto mode = static_cast<std::size_t>(block.mode);
      const bool zero = is_zero_frequency(block);
      const auto put = [&](Index column, Complex value) {
        if (column < 0) return;
        value *= frame_[observation * blocks_.size() + p];
        error(r, column) = value.real();
        if (!zero) error(r + 1, column) = value.imag();
      };
      if (block.kind == BlockKind::modulation && quantity.kind == Kind::amplitude && quantity.index == mode)
        put(place.natural_frequency[mode], Complex(0, 1) * step_[observation * quantities_.size() + q]);
      for (std::size_t j = 0; j < block.lumps.size(); ++j)
        put(place.lump[static_cast<std::size_t>(block.lumps[j])],
            columns_[p][j](copy * count + at) - columns_[p][j](at));
      r += zero ? 1 : 2;
    }
    errors.push_back({static_cast<Index>(q), std::move(error)});
  }
  return errors;
}

double EquationData::first_scale(std::size_t observation, std::size_t block) const {
  const Observation& o = set_.observations[observation];
  const RegressorBlock& b = case_.blocks[block];
  const double size = b.kind == BlockKind::modulation ? std::abs(o.amplitude[static_cast<std::size_t>(b.mode)])
                                                      : o.harmonic_sd[block];
  return size > 0 ? size : 1;
}

}  // namespace secular
