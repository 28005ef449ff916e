#include "jobs/modal/modal_run.hpp"

#include <cmath>
#include <utility>

#include "input/input_error.hpp"
#include "input/stop_request.hpp"
#include "jobs/shared/record_selection.hpp"

namespace secular {
namespace {

void require_meaning(const ModalSurveyOptions& options) {
  const auto not_negative = [](double value, const char* name) {
    if (!(value >= 0) || !std::isfinite(value)) throw InputError(name, "", "is not a positive number");
  };
  not_negative(options.window_s, "--window");
  not_negative(options.fit_below, "--fit-below");
  not_negative(options.force_window_s, "--force-window");
  not_negative(options.response_decay.value_or(0), "--exponential-window");
}

}  // namespace

ModalSurvey run_modal(const Campaign& campaign, const Window& window, ModalSurveyOptions options) {
  require_match(campaign, window);
  require_sampled(window, campaign.sample_rate_hz);
  options.records = window.records;
  options.span = span_of(window);
  const Band band = window.band.value_or(Band{});
  options.lowest_hz = band.low_hz;
  options.highest_hz = band.high_hz;
  require_meaning(options);
  options.progress = [told = std::move(options.progress)](std::size_t done, std::size_t total) {
    end_if_stopped();
    if (told) told(done, total);
  };
  return modal_survey(campaign, options);
}

DrivingPoint driving_point_of(const std::string& text) {
  const bool against = text.starts_with('-');
  return {text.substr(against ? 1 : 0), against ? -1 : 1};
}

}  // namespace secular
