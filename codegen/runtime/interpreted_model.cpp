#include "codegen/runtime/interpreted_model.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <numbers>
#include <string>

#include "codegen/expression/cpp_expression.hpp"
#include "codegen/runtime/interpreted_case.hpp"
#include "codegen/runtime/interpreted_motion.hpp"
#include "codegen/runtime/rest_value_set.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

// Everything that the spans, views and bound functions of the CompiledModel point to.
class Interpreter {
 public:
  explicit Interpreter(CanonicalModel model) : source_(std::move(model)), rest_values_(source_), motion_(source_) {
    for (const std::string& name : source_.parameters)
      symbol_of_parameter_.push_back(static_cast<std::size_t>(
          std::find(source_.order.begin(), source_.order.end(), name) - source_.order.begin()));
    compiled_.name = source_.name;
    compiled_.source = source_.source;
    compiled_.fingerprint = source_.fingerprint;
    compiled_.coordinates = views(source_.coordinates);
    compiled_.excitations = views(source_.excitations);
    compiled_.excitation_frequencies = views(source_.excitation_frequencies);
    for (std::size_t p = 0; p < source_.parameters.size(); ++p) {
      symbols_.push_back({source_.parameters[p], ratios(source_.parameter_dimensions[p])});
      nominal_.push_back(source_.nominal[p].value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    compiled_.symbols = symbols_;
    compiled_.nominal = nominal_;
    for (const CanonicalCase& c : source_.cases) add_case(c);
    compiled_.cases = cases_;
    compiled_.mass_matrix = motion_function<&InterpretedMotion::mass_matrix>();
    compiled_.acceleration = motion_function<&InterpretedMotion::acceleration>();
    compiled_.acceleration_by_state = motion_function<&InterpretedMotion::acceleration_by_state>();
    compiled_.acceleration_by_parameters = motion_function<&InterpretedMotion::acceleration_by_parameters>();
  }
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  const CompiledModel& compiled() const { return compiled_; }

 private:
  struct BoundCase {
    const Interpreter& owner;
    InterpretedCase functions;
  };

  std::vector<double> symbol_values(const double* parameters) const {
    std::vector<double> values(source_.order.size(), 0.0);
    values.back() = std::numbers::pi;
    for (std::size_t p = 0; p < symbol_of_parameter_.size(); ++p) values[symbol_of_parameter_[p]] = parameters[p];
    rest_values_.fill(values.data());
    return values;
  }

  template <void (InterpretedMotion::*function)(const InterpretedMotion::Point&, double*) const>
  CompiledModel::MotionFunction motion_function() const {
    return {[](const void* data, const double* parameters, const ExcitationSample* excitation,
               const double* displacement, const double* velocity, double* result) {
              const auto& self = *static_cast<const Interpreter*>(data);
              const std::vector<double> symbols = self.symbol_values(parameters);
              (self.motion_.*function)({parameters, symbols.data(), excitation, displacement, velocity}, result);
            },
            this};
  }

  std::span<const std::string_view> views(const std::vector<std::string>& texts) {
    return views_.emplace_back(texts.begin(), texts.end());
  }
  std::string_view kept(std::string text) { return texts_.emplace_back(std::move(text)); }
  std::span<const int> kept(std::vector<int> values) { return integers_.emplace_back(std::move(values)); }
  std::span<const Ratio> ratios(const CanonicalDimension& dimension) {
    return dimension ? ratios(*dimension) : std::span<const Ratio>();
  }
  std::span<const Ratio> ratios(const std::vector<CanonicalRatio>& values) {
    std::vector<Ratio>& list = ratios_.emplace_back();
    for (const CanonicalRatio& r : values) list.push_back({r.numerator, r.denominator});
    return list;
  }

  void add_case(const CanonicalCase& c) {
    const BoundCase& bound = bound_.emplace_back(BoundCase{*this, InterpretedCase(source_, c)});
    CompiledCase result;
    result.name = c.name;
    result.excited = c.excited;
    std::vector<int> relations;
    for (const CanonicalRelation& relation : c.relations)
      relations.insert(relations.end(), relation.multiples.begin(), relation.multiples.end());
    result.relations = kept(std::move(relations));
    std::vector<CanonicalRatio> observed;
    for (const auto& row : c.observed_frequency) observed.insert(observed.end(), row.begin(), row.end());
    result.observed_frequency = ratios(observed);
    const std::size_t modes = c.mode_at_rest.size();
    at_rest_.push_back(std::make_unique<bool[]>(modes));
    std::copy(c.mode_at_rest.begin(), c.mode_at_rest.end(), at_rest_.back().get());
    result.mode_at_rest = {at_rest_.back().get(), modes};
    std::vector<CompiledLump>& lumps = lumps_.emplace_back();
    for (const CanonicalLump& lump : c.lumps)
      lumps.push_back({lump.name, kept(formula_text(lump.definition, source_.order)), ratios(lump.dimension)});
    result.lumps = lumps;
    result.blocks = blocks(c, bound.functions);
    result.evaluate_lumps = {[](const void* data, const double* parameters, double* values) {
                               const auto& [owner, functions] = *static_cast<const BoundCase*>(data);
                               functions.lumps(owner.symbol_values(parameters).data(), values);
                             },
                             &bound};
    result.evaluate_lumps_jacobian = {[](const void* data, const double* parameters, double* jacobian) {
                                        const auto& [owner, functions] = *static_cast<const BoundCase*>(data);
                                        functions.lumps_jacobian(owner.symbol_values(parameters).data(), jacobian);
                                      },
                                      &bound};
    result.modulation = {[](const void* data, const double* parameters, const double* excitation_frequency,
                            const Complex* amplitude, const Complex* forcing, Complex* derivative) {
                           const auto& [owner, functions] = *static_cast<const BoundCase*>(data);
                           functions.modulation(owner.symbol_values(parameters).data(), excitation_frequency,
                                                amplitude, forcing, derivative);
                         },
                         &bound};
    result.modulation_jacobian = {[](const void* data, const double* parameters, const double* excitation_frequency,
                                     const Complex* amplitude, const Complex* forcing, double* jacobian) {
                                    const auto& [owner, functions] = *static_cast<const BoundCase*>(data);
                                    functions.modulation_jacobian(owner.symbol_values(parameters).data(),
                                                                  excitation_frequency, amplitude, forcing,
                                                                  jacobian);
                                  },
                                  &bound};
    cases_.push_back(result);
  }

  std::span<const RegressorBlock> blocks(const CanonicalCase& c, const InterpretedCase& functions) {
    std::vector<RegressorBlock>& list = blocks_.emplace_back();
    for (std::size_t b = 0; b < c.blocks.size(); ++b) {
      const CanonicalBlock& block = c.blocks[b];
      std::vector<int> columns;
      for (const CanonicalBlock::Column& column : block.columns) columns.push_back(static_cast<int>(column.lump));
      RegressorBlock row;
      row.kind = block.modulation ? BlockKind::modulation : BlockKind::harmonic;
      row.name = block.name;
      row.mode = static_cast<int>(block.mode);
      row.order = block.order;
      if (!block.modulation) row.phase = kept(block.phase);
      row.lumps = kept(std::move(columns));
      row.columns = {[](const void* data, const ObservationBatch& batch, Complex* const* values) {
                       static_cast<const InterpretedBlock*>(data)->columns(batch, values);
                     },
                     &functions.block(b)};
      row.column_slopes = {
          [](const void* data, const ObservationBatch& batch, std::size_t mode, Complex* const* values) {
            static_cast<const InterpretedBlock*>(data)->column_slopes(batch, mode, values);
          },
          &functions.block(b)};
      list.push_back(row);
    }
    return list;
  }

  CanonicalModel source_;
  RestValueSet rest_values_;
  InterpretedMotion motion_;
  std::vector<std::size_t> symbol_of_parameter_;
  // Deques: what they hold stays where it is.
  std::deque<std::vector<std::string_view>> views_;
  std::deque<std::string> texts_;
  std::deque<std::vector<int>> integers_;
  std::deque<std::vector<Ratio>> ratios_;
  std::deque<std::vector<CompiledLump>> lumps_;
  std::deque<std::vector<RegressorBlock>> blocks_;
  std::deque<BoundCase> bound_;
  std::vector<std::unique_ptr<bool[]>> at_rest_;
  std::vector<CompiledSymbol> symbols_;
  std::vector<double> nominal_;
  std::vector<CompiledCase> cases_;
  CompiledModel compiled_;
};

}  // namespace

std::shared_ptr<const CompiledModel> interpreted_model(CanonicalModel model) {
  const auto interpreter = std::make_shared<const Interpreter>(std::move(model));
  return {interpreter, &interpreter->compiled()};
}

}  // namespace secular
