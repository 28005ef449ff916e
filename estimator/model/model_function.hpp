#pragma once

namespace secular {

template <class Signature>
class ModelFunction;

/// A function of a compiled model: either plain generated code, or code bound to data of its own (the interpreted
/// model). Called like a function; constant-initialised from a function pointer, so that tables of generated code
/// stay constants; of fixed layout, so that a shared object can hand it over.
template <class... Arguments>
class ModelFunction<void(Arguments...)> {
 public:
  using Plain = void (*)(Arguments...);
  using Bound = void (*)(const void* data, Arguments...);

  constexpr ModelFunction() = default;
  constexpr ModelFunction(Plain plain) : plain_(plain) {}  // NOLINT: generated tables name the function itself
  constexpr ModelFunction(Bound bound, const void* data) : bound_(bound), data_(data) {}

  void operator()(Arguments... arguments) const {
    if (bound_)
      bound_(data_, arguments...);
    else
      plain_(arguments...);
  }
  constexpr explicit operator bool() const { return plain_ != nullptr || bound_ != nullptr; }

 private:
  Plain plain_ = nullptr;
  Bound bound_ = nullptr;
  const void* data_ = nullptr;
};

}  // namespace secular
