#pragma once

#include <string>

#include "measure/modal/modal_survey.hpp"

namespace secular {

/// modal.json of a survey, schema 1: units in the keys, shapes by channel, the same survey gives the same bytes.
std::string modal_json(const ModalSurvey& survey);

}  // namespace secular
