#pragma once

#include "codegen/document/derivation_document.hpp"

namespace secular::typeset {

/// Symbols that would be typeset alike ("omega0" and "omega_0") are written as they stand in the model, everywhere.
void tell_look_alikes_apart(Document& document);

}  // namespace secular::typeset
