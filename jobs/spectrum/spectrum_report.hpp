#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/signal/spectral_survey.hpp"
#include "report/figure.hpp"

namespace secular {

/// One record as `secular spectrum` hands it to its report: what was read, and what was found.
struct RecordSpectrum {
  std::string source;  ///< campaign and record, or file
  double start_s = 0, sample_rate_hz = 0;
  std::vector<std::string> names, units;  ///< of the channels that were analysed
  Eigen::MatrixXd channels;               ///< samples x names
  SpectralSurvey survey;
  AmplitudeSpectrum spectrum;  ///< of the channels

  std::string excitation_name, excitation_unit;  ///< empty without an excitation channel beside them
  Eigen::VectorXd excitation;
  AmplitudeSpectrum excitation_spectrum;
  std::vector<LinearRelation> relations;  ///< by channel; empty without excitation

  std::vector<std::string> modes;  ///< of the modal basis; empty without
  AmplitudeSpectrum modal;         ///< spectra of the modal coordinates' derivative that the channels measure

  std::vector<std::string> conclusions;  ///< what the numbers say, in words

  bool tables_empty() const;  ///< no decomposition of the first channel
  bool has_rates() const;     ///< some term of some table grows or decays

  /// Whether the terms of a method are tones of the channel: they explain nine tenths of it, or of what tones can
  /// explain where the rest is white noise by the test; and their power is not more than twice the channel's, as
  /// that of terms is which cancel one another.
  bool are_tones(std::size_t channel, const MethodStatistics& method) const;
  /// Whether those of the last method (maximum likelihood) of the first channel are, so that a count means
  /// something.
  bool tones_count() const;
};

/// In the place of terms that are no tones of a channel.
std::string no_tones_text(const MethodStatistics& method);

/// Fills `conclusions`.
void conclude(RecordSpectrum& record);

/// The figures of the report: history, spectrum, modes, delays, covariance, channels, relation_CHANNEL.
std::vector<report::NamedFigure> spectrum_figures(const RecordSpectrum& record);

/// report.html, with `command` at its foot, and spectrum.json.
std::string spectrum_report(const RecordSpectrum& record, const std::string& command);
std::string spectrum_json(const RecordSpectrum& record);

/// Steady responses in a file: at each level the amplitude at every frequency, as a stepped sine gives them.
struct SteadyLevel {
  std::string name;
  std::vector<double> frequency_hz, response, force;  ///< force is empty where the file has none
};
struct SteadyTable {
  std::string source;
  std::vector<std::pair<std::string, std::vector<SteadyLevel>>> series;  ///< by name
};

/// The same three of a table of steady responses; the figures by the names of its series.
std::vector<report::NamedFigure> steady_figures(const SteadyTable& table);
std::string steady_table_report(const SteadyTable& table, const std::string& command);
std::string steady_table_json(const SteadyTable& table);

}  // namespace secular
