#include "motion/response/equilibrium.hpp"

namespace secular {

std::string_view name_of(SpecialKind kind) {
  switch (kind) {
    case SpecialKind::saddle_node:
      return "saddle_node";
    case SpecialKind::pitchfork:
      return "pitchfork";
    case SpecialKind::transcritical:
      return "transcritical";
    case SpecialKind::branch_point:
      return "branch_point";
    case SpecialKind::hopf:
      return "hopf";
    case SpecialKind::double_zero:
      return "double_zero";
  }
  return "";
}

std::string_view in_words(SpecialKind kind) {
  switch (kind) {
    case SpecialKind::saddle_node:
      return "saddle-node";
    case SpecialKind::branch_point:
      return "branch point";
    case SpecialKind::hopf:
      return "Hopf";
    case SpecialKind::double_zero:
      return "double zero";
    default:
      return name_of(kind);
  }
}

bool is_crossing(SpecialKind kind) {
  return kind == SpecialKind::pitchfork || kind == SpecialKind::transcritical || kind == SpecialKind::branch_point;
}

}  // namespace secular
