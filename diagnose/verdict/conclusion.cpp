#include "diagnose/verdict/conclusion.hpp"

namespace secular {
namespace {

// What varies within dwells counts against an explanation of their means that is worth less.
bool is_restless(const Unsteadiness& unsteady, const ClosedShare& closing) {
  const auto squares = [](double rms) { return rms * rms; };
  return unsteady.detected && squares(unsteady.ratio) - 1 > squares(closing.before) - squares(closing.after);
}

}  // namespace

Conclusion conclude_without_gap(bool noise_misjudged, const Unsteadiness& unsteady) {
  if (noise_misjudged) return {"unknown", "", "the noise is misjudged: a gap could not be seen"};
  if (unsteady.detected)
    return {"unknown", "", "the mean motions agree with the model; what varies is not the excitation"};
  return {"no_gap", "", ""};
}

std::string what_speaks_against(const Contest& contest, bool noise_misjudged, const Unsteadiness& unsteady,
                                const ClosedShare& closing) {
  if (noise_misjudged) return "the noise is misjudged";
  if (contest.stalled) return "the fit that explains most did not converge";
  if (contest.best().open_law) return "a law outside of the catalogue explains better than all that are in it";
  if (is_restless(unsteady, closing))
    return "the motion varies within dwells by more than the best explanation removes";
  return "";
}

Conclusion conclude(const Naming& naming, const ResidualStructure& structure, const ClosedShare& closing,
                    const std::string& against) {
  if (!against.empty()) return {"unknown", "", against};
  switch (reach_of(structure, closing)) {
    case Reach::all:
      return naming.set.size() == 1 ? Conclusion{"cause", naming.set.front(), ""} : Conclusion{"set", "", ""};
    case Reach::approximate:
      return {"approximate", "", ""};
    case Reach::little:
      break;
  }
  return {"unknown", "", what_is_missing(structure, closing)};
}

}  // namespace secular
