#pragma once

#include <string>
#include <vector>

#include "thesis/verify/verification.hpp"

namespace secular::app {

/// A page of errata in Markdown: every misprint with what is printed, what is right, why, and what decides it;
/// every number of a table that does not follow from the others; what differs in notation alone; what is
/// unresolved. `proofs`: the equations of motion were integrated.
std::string errata_page(const verify::PrintedSource& source, const std::vector<verify::Verdict>& verdicts,
                        bool proofs);

}  // namespace secular::app
