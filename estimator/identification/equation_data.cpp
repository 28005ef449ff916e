#include "estimator/identification/equation_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Error of `step` along a measured complex number or across it: steps in the frame of the motion are the same at
// every instant, also where they are not small.
Complex step_from(Complex value, double step, bool across) {
  return (across ? Complex(0, step) : Complex(step, 0)) * std::polar(1.0, std::arg(value));
}

}  // namespace

bool is_zero_frequency(const RegressorBlock& block) {
  return block.kind == BlockKind::harmonic &&
         std::all_of(block.phase.begin(), block.phase.end(), [](int p) { return p == 0; });
}

Complex motion_frame(const RegressorBlock& block, const Observation& o) {
  if (block.kind == BlockKind::modulation)
    return std::polar(1.0, -std::arg(o.amplitude[static_cast<std::size_t>(block.mode)]));
  double angle = 0;
  const std::size_t modes = o.amplitude.size();
  for (std::size_t i = 0; i < block.phase.size(); ++i)
    if (block.phase[i] != 0) angle += block.phase[i] * std::arg(i < modes ? o.amplitude[i] : o.forcing[i - modes]);
  return std::polar(1.0, -angle);
}

EquationData::EquationData(const ObservationSet& set, const std::vector<std::size_t>& blocks)
    : set_(set), case_(*set.resonance), modes_(mode_frequencies(*set.model, *set.resonance)), blocks_(blocks) {
  const auto add = [&](Kind kind, std::size_t index, bool imaginary, bool columns_depend) {
    quantities_.push_back({kind, index, imaginary});
    column_variant_.push_back(columns_depend ? static_cast<int>(copies_++) : 0);
  };
  for (std::size_t k = 0; k < set.model->modes(); ++k) {
    if (!modes_.oscillates[k]) continue;
    add(Kind::amplitude, k, false, true);
    add(Kind::amplitude, k, true, true);
    add(Kind::growth, k, false, false);
    // Without excitation every mode's frequency is observed by itself, a resonance between them or not.
    if (!case_.excited) add(Kind::frequency, k, false, false);
  }
  for (std::size_t f = 0; f < modes_.free.size() && case_.excited; ++f) add(Kind::free_frequency, f, false, false);
  for (std::size_t j = 0; j < set.model->excitations.size() && case_.excited; ++j) {
    add(Kind::forcing, j, false, true);
    add(Kind::forcing, j, true, true);
    add(Kind::excitation_frequency, j, false, true);
  }
}

double EquationData::sd(const Quantity& q, const Observation& o) const {
  switch (q.kind) {
    case Kind::amplitude:
      return o.amplitude_sd[q.index];
    case Kind::growth:
      return std::max(0.0, o.growth_sd[q.index]);
    case Kind::frequency:
      return o.frequency_sd[q.index];
    case Kind::free_frequency:
      return o.free_frequency_sd[q.index];
    case Kind::forcing:
      return o.forcing_sd[q.index];
    case Kind::excitation_frequency:
      return o.excitation_frequency_sd[q.index];
  }
  return 0;
}

bool EquationData::present(std::size_t block, const Observation& o) const {
  const RegressorBlock& b = case_.blocks[block];
  const auto mode = static_cast<std::size_t>(b.mode);
  return b.kind == BlockKind::modulation ? modes_.oscillates[mode] && o.growth_sd[mode] >= 0
                                         : o.harmonic_sd[block] >= 0;
}

void EquationData::evaluate(const std::vector<double>& natural_frequency) {
  if (!evaluated_at_.empty()) {
    double moved = 0;
    for (std::size_t k = 0; k < natural_frequency.size(); ++k)
      moved = std::max(moved, std::abs(natural_frequency[k] / evaluated_at_[k] - 1));
    if (moved < 1e-12) return;
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
      const Observation& o = set_.observations[i];
      const double step = sd(quantity, o);
      const std::size_t at = copy * count + i, k = quantity.index;
      if (quantity.kind == Kind::amplitude) amplitude[k][at] += step_from(o.amplitude[k], step, quantity.imaginary);
      if (quantity.kind == Kind::forcing) forcing[k][at] += step_from(o.forcing[k], step, quantity.imaginary);
      if (quantity.kind == Kind::excitation_frequency) frequency[quantity.index][at] += step;
    }
  }
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

EquationData::Rows EquationData::rows(std::size_t observation, const std::vector<CaseColumn>& columns,
                                      const std::vector<double>& lump, const std::vector<double>& natural_frequency,
                                      const std::vector<double>& reference_frequency) const {
  const Observation& o = set_.observations[observation];
  const auto count = static_cast<Index>(set_.observations.size());
  const auto at = static_cast<Index>(observation);
  Rows result;
  std::vector<std::size_t> used;  // positions in blocks_
  for (std::size_t p = 0; p < blocks_.size(); ++p)
    if (present(blocks_[p], o)) used.push_back(p);
  Index size = 0;
  for (const std::size_t p : used) size += is_zero_frequency(case_.blocks[blocks_[p]]) ? 1 : 2;
  const auto width = static_cast<Index>(columns.size());
  result.design = MatrixXd::Zero(size, width);
  result.response.resize(size);
  result.variants = MatrixXd::Zero(size, static_cast<Index>(quantities_.size()));
  result.own_variance.resize(size);
  Index r = 0;
  for (const std::size_t p : used) {
    const std::size_t b = blocks_[p];
    const RegressorBlock& block = case_.blocks[b];
    const auto mode = static_cast<std::size_t>(block.mode);
    const bool modulation = block.kind == BlockKind::modulation, zero = is_zero_frequency(block);
    const Complex a = o.amplitude[mode], rate = o.rate[mode], frame = motion_frame(block, o);
    const auto put = [&](auto&& store, Complex value) {
      value *= frame;
      store(r, value.real());
      if (!zero) store(r + 1, value.imag());
    };
    Complex target = modulation ? rate * a : o.harmonic[b];
    bool frequency_open = false;
    for (Index c = 0; c < width; ++c) {
      const CaseColumn& column = columns[static_cast<std::size_t>(c)];
      Complex value = 0;
      if (column.kind == CaseColumn::Kind::natural_frequency && modulation && column.index == mode) {
        value = Complex(0, 1) * a;
        frequency_open = true;
      } else if (column.kind == CaseColumn::Kind::sensor_offset && zero && column.index == mode) {
        value = 1;
      } else {
        continue;
      }
      put([&](Index row, double x) { result.design(row, c) = x; }, value);
    }
    if (modulation) target -= Complex(0, (frequency_open ? reference_frequency : natural_frequency)[mode]) * a;
    if (set_.truncation.size() > 0) target -= set_.truncation(at, static_cast<Index>(b)) * std::conj(frame);
    std::vector<bool> open(block.lumps.size(), false);
    for (Index c = 0; c < width; ++c) {
      const CaseColumn& column = columns[static_cast<std::size_t>(c)];
      if (column.kind != CaseColumn::Kind::lump) continue;
      for (std::size_t j = 0; j < block.lumps.size(); ++j)
        if (static_cast<std::size_t>(block.lumps[j]) == column.index) {
          open[j] = true;
          put([&](Index row, double x) { result.design(row, c) = x; }, columns_[p][j](at));
        }
    }
    for (std::size_t j = 0; j < block.lumps.size(); ++j)
      if (!open[j]) target -= lump[static_cast<std::size_t>(block.lumps[j])] * columns_[p][j](at);
    put([&](Index row, double x) { result.response(row) = x; }, target);
    // Left minus right side where one measured quantity is off.
    for (std::size_t q = 0; q < quantities_.size(); ++q) {
      const Quantity& quantity = quantities_[q];
      const double step = sd(quantity, o);
      if (!(step > 0)) continue;
      Complex change = 0;
      if (modulation) {
        const Complex detuned = rate - Complex(0, natural_frequency[mode]);
        switch (quantity.kind) {
          case Kind::amplitude:
            if (quantity.index == mode) change = detuned * step_from(a, step, quantity.imaginary);
            break;
          case Kind::growth:
            if (quantity.index == mode) change = step * a;
            break;
          case Kind::frequency:
            if (quantity.index == mode) change = Complex(0, step) * a;
            break;
          case Kind::free_frequency:
            change =
                Complex(0, step * modes_.coupling(static_cast<Index>(mode), static_cast<Index>(quantity.index))) *
                a;
            break;
          case Kind::excitation_frequency:
            change =
                Complex(0, step * modes_.forced(static_cast<Index>(mode), static_cast<Index>(quantity.index))) * a;
            break;
          case Kind::forcing:
            break;
        }
      }
      const Index copy = column_variant_[q];
      if (copy > 0)
        for (std::size_t j = 0; j < block.lumps.size(); ++j)
          change -= lump[static_cast<std::size_t>(block.lumps[j])] *
                    (columns_[p][j](copy * count + at) - columns_[p][j](at));
      put([&](Index row, double x) { result.variants(row, static_cast<Index>(q)) = x; }, change);
    }
    // Noise-free data: equal weights relative to the size of the equation.
    const double own = modulation ? 0 : o.harmonic_sd[b] * o.harmonic_sd[b];
    const double floor =
        std::norm(1e-12 * (modulation ? rate * a : o.harmonic[b])) + std::numeric_limits<double>::min();
    put([&](Index row, double) { result.own_variance(row) = own + floor; }, 0);
    for (Index i = 0; i < (zero ? 1 : 2); ++i) {
      result.block.push_back(b);
      result.part.push_back(i == 0 ? EquationPart::in_phase : EquationPart::in_quadrature);
    }
    r += zero ? 1 : 2;
  }
  return result;
}

void EquationData::move(Observation& o, const VectorXd& deviations) const {
  for (std::size_t q = 0; q < quantities_.size(); ++q) {
    const Quantity& quantity = quantities_[q];
    const double change = -deviations(static_cast<Index>(q)) * sd(quantity, o);
    const auto turn = [&](const MatrixXd& share) {
      for (std::size_t k = 0; k < o.rate.size(); ++k)
        o.rate[k] += Complex(0, change * share(static_cast<Index>(k), static_cast<Index>(quantity.index)));
    };
    switch (quantity.kind) {
      case Kind::amplitude:
        o.amplitude[quantity.index] += step_from(o.amplitude[quantity.index], change, quantity.imaginary);
        break;
      case Kind::growth:
        o.rate[quantity.index] += change;
        break;
      case Kind::frequency:
        o.rate[quantity.index] += Complex(0, change);
        break;
      case Kind::free_frequency:
        turn(modes_.coupling);
        break;
      case Kind::forcing:
        o.forcing[quantity.index] += step_from(o.forcing[quantity.index], change, quantity.imaginary);
        break;
      case Kind::excitation_frequency:
        o.excitation_frequency[quantity.index] += change;
        turn(modes_.forced);
        break;
    }
  }
}

std::vector<MatrixXd> EquationData::column_errors(std::size_t observation,
                                                  const std::vector<CaseColumn>& columns) const {
  const Observation& o = set_.observations[observation];
  const auto count = static_cast<Index>(set_.observations.size());
  const auto at = static_cast<Index>(observation);
  Index size = 0;
  for (const std::size_t b : blocks_)
    if (present(b, o)) size += is_zero_frequency(case_.blocks[b]) ? 1 : 2;
  std::vector<MatrixXd> errors;
  for (std::size_t q = 0; q < quantities_.size(); ++q) {
    const Quantity& quantity = quantities_[q];
    const Index copy = column_variant_[q];
    const double step = sd(quantity, o);
    if (copy == 0 || !(step > 0)) continue;
    MatrixXd error = MatrixXd::Zero(size, static_cast<Index>(columns.size()));
    Index r = 0;
    for (std::size_t p = 0; p < blocks_.size(); ++p) {
      if (!present(blocks_[p], o)) continue;
      const RegressorBlock& block = case_.blocks[blocks_[p]];
      const bool zero = is_zero_frequency(block);
      const Complex frame = motion_frame(block, o);
      for (std::size_t c = 0; c < columns.size(); ++c) {
        Complex value = 0;
        if (columns[c].kind == CaseColumn::Kind::natural_frequency && block.kind == BlockKind::modulation &&
            static_cast<int>(columns[c].index) == block.mode && quantity.kind == Kind::amplitude &&
            quantity.index == columns[c].index)
          value = Complex(0, 1) * step_from(o.amplitude[quantity.index], step, quantity.imaginary);
        if (columns[c].kind == CaseColumn::Kind::lump)
          for (std::size_t j = 0; j < block.lumps.size(); ++j)
            if (static_cast<std::size_t>(block.lumps[j]) == columns[c].index)
              value = columns_[p][j](copy * count + at) - columns_[p][j](at);
        value *= frame;
        error(r, static_cast<Index>(c)) = value.real();
        if (!zero) error(r + 1, static_cast<Index>(c)) = value.imag();
      }
      r += zero ? 1 : 2;
    }
    errors.push_back(std::move(error));
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
