#pragma once

#include "measure/modal/modal_survey.hpp"

namespace secular {

/// Takes what is a harmonic or a combination of stronger modes out of the modes and their windows to the survey's
/// tones (find_combinations). A mode that lies at such a frequency and is none, or may be one, gets a remark.
void set_tones_aside(ModalSurvey& survey);

}  // namespace secular
