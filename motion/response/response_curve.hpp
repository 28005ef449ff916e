#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "motion/response/bifurcation_curve.hpp"
#include "motion/response/bifurcation_diagram.hpp"
#include "motion/response/response_field.hpp"

namespace secular {

/// One standard deviation of a response curve, of one mode's amplitude |B| against the varied parameter. Where the
/// curve turns back in the parameter `amplitude` is infinite, where it turns in the amplitude `parameter` is.
struct CurveSpread {
  double amplitude = 0;  ///< of the amplitude, at the parameter's value
  double parameter = 0;  ///< of the parameter, at the amplitude
  /// Across the curve, in (parameter, amplitude): finite everywhere, and what a band is drawn with.
  double across_parameter = 0, across_amplitude = 0;
};

/// A mode whose amplitude is largest at a point along its branch: add_peaks().
struct ResponsePeak {
  std::size_t mode = 0;
  std::optional<double> place_sd = {};  ///< of the parameter there; set as ResponsePoint::spread is
};

/// A steady response.
struct ResponsePoint {
  double parameter = 0;
  ModeAmplitudes modes;
  Eigen::VectorXd state;                 ///< of ResponseField::reduced(); empty at rest where that is blown up
  Eigen::VectorXcd eigenvalues;          ///< 1/s, by falling real part; without the zero ones of free phases
  int unstable = 0;                      ///< eigenvalues with a positive real part
  bool at_rest = false;                  ///< no mode oscillates
  bool outside = false;                  ///< of the expansion's range; marked by whoever knows that range
  std::vector<ResponsePeak> peaks = {};  ///< one of every mode that has its largest amplitude here
  std::vector<CurveSpread> spread = {};  ///< [mode]; set by whoever knows the parameters' error bars, else empty
};

struct ResponseSpecial {
  SpecialKind kind = SpecialKind::saddle_node;
  ResponsePoint at;
  double frequency = 0;           ///< rad/s, of a Hopf point
  bool polished = false;          ///< SpecialPoint::polished
  SpecialPoint source;            ///< in the states of ResponseField::reduced()
  std::optional<double> sd = {};  ///< of the parameter there; set as ResponsePoint::spread is
};

struct ResponseBranch {
  bool at_rest = false;  ///< the trivial solution
  std::vector<ResponsePoint> points;
  std::vector<ResponseSpecial> special;
  TraceEnd first_end, last_end;
  bool closed = false;
};

struct ResponseRequest {
  Eigen::VectorXd parameters;  ///< as ResponseField::parameter_names
  Eigen::Index parameter = 0;  ///< the varied one
  double lower = 0, upper = 1;
  double largest = 0;  ///< amplitude |B| up to which responses are looked for; 0: 4 amplitude_scale
  /// Values of the varied parameter at which responses are searched for; empty: seven, evenly over the range.
  std::vector<double> search_at = {};
};

struct ResponseDiagram {
  Eigen::Index parameter = 0;
  double scale = 0, largest = 0;  ///< amplitudes |B|: typical one, and that of the search
  DiagramStatus status = DiagramStatus::complete;
  std::string reason;
  std::vector<ResponseBranch> branches;
  std::vector<std::string> notes;
};

/// All steady responses in one parameter: bifurcation_diagram of the case's modulation equations, symmetries
/// divided out (ResponseField), started from searches at several places of the range. Terms that are singular at
/// rest leave the trivial solution out, with a note.
ResponseDiagram response_diagram(const ResponseField& field, const ResponseRequest& request);

/// A curve of special points in two parameters.
struct ResponseCurvePoint {
  double first = 0, second = 0;
  ModeAmplitudes modes;
  double frequency = 0;  ///< rad/s, of Hopf points
  bool outside = false;  ///< as ResponsePoint::outside
};

enum class CurveKind {
  saddle_node,
  threshold,  ///< of the trivial solution, whether other solutions branch off it or it starts to oscillate
  hopf,
  peak  ///< no bifurcation: largest amplitude over the first parameter, second one fixed
};

struct ResponseCurve {
  CurveKind kind = CurveKind::saddle_node;
  std::vector<ResponseCurvePoint> points;
  std::vector<std::pair<CodimensionTwo, ResponseCurvePoint>> special;
  TraceEnd first_end, last_end;
  bool closed = false;
};

struct CurveRequest {
  ResponseRequest response;  ///< its parameter is the first one of the curve
  Eigen::Index second = 0;   ///< parameter
  double second_lower = 0, second_upper = 1;
  CurveKind kind = CurveKind::saddle_node;
  int diagrams = 5;  ///< response diagrams at so many values of the second parameter give the starts
};

/// Every curve of that kind through a special point of those diagrams (for peaks: a largest amplitude inside one of
/// their branches, of the mode that is largest there), each once.
std::vector<ResponseCurve> response_curves(const ResponseField& field, const CurveRequest& request);

/// Undriven motion of one mode alone at slowly falling amplitude.
struct BackbonePoint {
  double amplitude = 0;  ///< |B|
  double frequency = 0;  ///< rad/s
  double growth = 0;     ///< 1/s, of the amplitude; negative: decay
  bool outside = false;  ///< as ResponsePoint::outside
};

/// Frequency and decay of active mode `mode` (index into ResponseField::active) for amplitudes |B| to `largest`,
/// the other modes at rest and no excitation: observed frequency + Im(B'/B), Re(B'/B).
std::vector<BackbonePoint> backbone(const ResponseField& field, const Eigen::Ref<const Eigen::VectorXd>& parameters,
                                    std::size_t mode, double largest, int points);

}  // namespace secular
