#include "jobs/predict/prediction_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "estimator/model/locked_excitations.hpp"
#include "jobs/predict/uncertain_text.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Json = nlohmann::ordered_json;

Json modes_json(const Prediction& prediction, const ModeAmplitudes& modes) {
  Json result = Json::array();
  for (std::size_t k = 0; k < modes.amplitude.size(); ++k) {
    Json mode;
    mode["mode"] = prediction.model->coordinates[k];
    mode["amplitude"] = 2 * std::abs(modes.amplitude[k]);
    mode["phase"] = modes.amplitude[k] == 0.0 ? 0.0 : std::arg(modes.amplitude[k]);
    if (modes.frequency_shift[k] != 0) mode["frequency_shift"] = modes.frequency_shift[k];
    result.push_back(std::move(mode));
  }
  return result;
}

void put_parameter(Json& entry, const std::string& name, double value, const std::string& unit) {
  entry[name] = value;
  if (unit == "Hz") entry[name + "_hz"] = value / two_pi;
}

Json point_json(const Prediction& prediction, const ResponsePoint& point) {
  Json result;
  put_parameter(result, prediction.vary->name, point.parameter, prediction.axis_unit);
  result["modes"] = modes_json(prediction, point.modes);
  for (std::size_t k = 0; k < point.spread.size(); ++k) {
    const std::optional<double> sd = amplitude_sd(point, k);
    result["modes"][k]["amplitude_sd"] = sd ? Json(*sd) : Json(nullptr);
  }
  result["stable"] = point.unstable == 0;
  result["unstable_eigenvalues"] = point.unstable;
  result["outside_expansion"] = point.outside;
  result["eigenvalues"] = Json::array();
  for (const std::complex<double>& value : point.eigenvalues)
    result["eigenvalues"].push_back({value.real(), value.imag()});
  return result;
}

Json end_json(const TraceEnd& end) {
  return {{"status", name_of(end.status)}, {"reason", end.reason}};
}

Json curve_point_json(const Prediction& prediction, const ResponseCurvePoint& point) {
  Json result;
  put_parameter(result, prediction.vary->name, point.first, prediction.axis_unit);
  put_parameter(result, prediction.against->name, point.second, prediction.against_unit);
  result["modes"] = modes_json(prediction, point.modes);
  if (point.frequency != 0) result["frequency"] = point.frequency;
  result["outside_expansion"] = point.outside;
  return result;
}

// Of a special point, for programs.
std::string_view word_of(const ResponseSpecial& special) {
  return special.at.at_rest ? "threshold" : secular::name_of(special.kind);
}

// `old`: the word of version 0.1, kept for one version where it was another one.
void put_kind(Json& entry, const std::string& key, std::string_view word, std::string_view old) {
  entry[key] = word;
  if (old != word) entry["old_" + key] = old;
}

Json diagram_json(const Prediction& prediction) {
  Json result = Json::array();
  for (const ResponseBranch& branch : prediction.diagram.branches) {
    Json entry;
    entry["at_rest"] = branch.at_rest;
    entry["closed"] = branch.closed;
    entry["ends"] = {end_json(branch.first_end), end_json(branch.last_end)};
    entry["special_points"] = Json::array();
    for (const ResponseSpecial& special : branch.special) {
      Json at;
      put_kind(at, "kind", word_of(special), special_name(special));
      put_kind(at, "bifurcation", secular::name_of(special.kind), in_words(special.kind));
      at["polished"] = special.polished;
      if (special.frequency != 0) at["frequency"] = special.frequency;
      if (special.sd) put_parameter(at, prediction.vary->name + "_sd", *special.sd, prediction.axis_unit);
      at.update(point_json(prediction, special.at));
      entry["special_points"].push_back(std::move(at));
    }
    entry["points"] = Json::array();
    for (const ResponsePoint& point : branch.points) entry["points"].push_back(point_json(prediction, point));
    result.push_back(std::move(entry));
  }
  return result;
}

std::string_view word_of(LargestAt kind) {
  switch (kind) {
    case LargestAt::peak:
      return "peak";
    case LargestAt::range_end:
      return "range_end";
    case LargestAt::stability_end:
      return "stability_end";
    case LargestAt::search_end:
      return "search_end";
  }
  return "";
}

Json largest_json(const Prediction& prediction) {
  Json result = Json::array();
  for (const LargestResponse& largest : prediction.largest) {
    Json entry;
    entry["mode"] = prediction.model->coordinates[largest.mode];
    entry["kind"] = word_of(largest.kind);
    const std::string& name = prediction.vary->name;
    put_parameter(entry, name, largest.parameter, prediction.axis_unit);
    if (largest.parameter_sd) put_parameter(entry, name + "_sd", *largest.parameter_sd, prediction.axis_unit);
    entry["amplitude"] = largest.amplitude;
    if (largest.amplitude_sd) entry["amplitude_sd"] = *largest.amplitude_sd;
    result.push_back(std::move(entry));
  }
  return result;
}

Json sweeps_json(const Prediction& prediction) {
  Json result = Json::array();
  for (const PredictedSweep& sweep : prediction.sweeps) {
    Json entry;
    entry["direction"] = sweep.direction;
    entry["jumps"] = Json::array();
    for (const PredictedSweep::Jump& jump : sweep.jumps) {
      Json at;
      at["mode"] = prediction.model->coordinates[jump.mode];
      put_parameter(at, "from", jump.from, prediction.axis_unit);
      put_parameter(at, "to", jump.to, prediction.axis_unit);
      at["amplitude_before"] = jump.amplitude_before;
      at["amplitude_after"] = jump.amplitude_after;
      entry["jumps"].push_back(std::move(at));
    }
    entry["points"] = Json::array();
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
      Json at;
      put_parameter(at, prediction.vary->name, sweep.parameter[i], prediction.axis_unit);
      at["amplitude"] = sweep.points[i].amplitude;
      at["settled"] = sweep.points[i].settled;
      entry["points"].push_back(std::move(at));
    }
    result.push_back(std::move(entry));
  }
  return result;
}

// Values of what is not varied; frequencies that follow others as their relation.
void put_parameters(Json& result, const Prediction& prediction) {
  const LockedExcitations locked(*prediction.model, *prediction.resonance);
  for (std::size_t p = 0; p < prediction.names.size(); ++p) {
    const std::string& name = prediction.names[p];
    const bool varied = (prediction.vary && prediction.vary->name == name) ||
                        (prediction.against && prediction.against->name == name);
    const std::size_t frequency = p - prediction.model->symbols.size();
    if (p >= prediction.model->symbols.size() && frequency < prediction.model->excitations.size() &&
        locked.follows(frequency))
      result["follows"][name] = locked.text(frequency);
    else if (!varied)
      result["parameters"][name] = prediction.parameters(static_cast<Eigen::Index>(p));
  }
}

Json curves_json(const Prediction& prediction) {
  Json result = Json::array();
  for (const ResponseCurve& curve : prediction.curves) {
    Json entry;
    entry["kind"] = name_of(curve.kind);
    entry["closed"] = curve.closed;
    entry["ends"] = {end_json(curve.first_end), end_json(curve.last_end)};
    entry["special_points"] = Json::array();
    for (const auto& [kind, at] : curve.special) {
      Json special = curve_point_json(prediction, at);
      special["kind"] = kind == CodimensionTwo::cusp ? "cusp" : "bogdanov_takens";
      entry["special_points"].push_back(std::move(special));
    }
    entry["points"] = Json::array();
    for (const ResponseCurvePoint& at : curve.points) entry["points"].push_back(curve_point_json(prediction, at));
    result.push_back(std::move(entry));
  }
  return result;
}

Json backbone_json(const Prediction& prediction, std::size_t k) {
  const auto& [mode, points] = prediction.backbones[k];
  const auto place = [](const BackbonePoint& at) {
    return Json{{"amplitude", 2 * at.amplitude},
                {"frequency", at.frequency},
                {"frequency_hz", at.frequency / two_pi},
                {"outside_expansion", at.outside}};
  };
  Json entry;
  entry["mode"] = mode;
  entry["limit_cycles"] = Json::array();
  const bool spread = k < prediction.backbone_spread.size();
  for (std::size_t c = 0; c < prediction.limit_cycles[k].size(); ++c) {
    const LimitCycle& cycle = prediction.limit_cycles[k][c];
    Json at = place(cycle.at);
    at["stable"] = cycle.stable;
    if (spread && prediction.limit_cycle_spread[k][c]) {
      at["amplitude_sd"] = 2 * prediction.limit_cycle_spread[k][c]->amplitude;
      at["frequency_sd"] = prediction.limit_cycle_spread[k][c]->frequency;
    }
    entry["limit_cycles"].push_back(std::move(at));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    Json at = place(points[i]);
    at["growth"] = points[i].growth;
    if (spread) {
      at["frequency_sd"] = prediction.backbone_spread[k][i].frequency;
      at["growth_sd"] = prediction.backbone_spread[k][i].growth;
    }
    entry["points"].push_back(std::move(at));
  }
  return entry;
}

Json measured_json(const Prediction& prediction) {
  Json result = Json::array();
  for (const MeasuredPoint& point : prediction.measured) {
    Json at;
    at["record"] = point.record;
    at["group"] = point.group;
    put_parameter(at, prediction.vary->name, point.parameter, prediction.axis_unit);
    at["amplitude"] = point.amplitude;
    at["sd_between_ensembles"] = point.spread;
    result.push_back(std::move(at));
  }
  return result;
}

}  // namespace

std::string name_of(TraceStatus status) {
  switch (status) {
    case TraceStatus::parameter_bound:
      return "parameter_bound";
    case TraceStatus::state_bound:
      return "state_bound";
    case TraceStatus::closed_loop:
      return "closed_loop";
    case TraceStatus::special_end:
      return "special_end";
    case TraceStatus::not_persistent:
      return "not_persistent";
    case TraceStatus::point_limit:
      return "point_limit";
    case TraceStatus::step_too_small:
      return "step_too_small";
    case TraceStatus::no_start:
      return "no_start";
  }
  return "";
}

std::string name_of(CurveKind kind) {
  switch (kind) {
    case CurveKind::saddle_node:
      return "saddle_node";
    case CurveKind::threshold:
      return "threshold";
    case CurveKind::hopf:
      return "hopf";
    case CurveKind::peak:
      return "peak";
  }
  return "";
}

std::string in_words(CurveKind kind) {
  switch (kind) {
    case CurveKind::saddle_node:
      return "saddle-nodes";
    case CurveKind::threshold:
      return "threshold of the state of rest";
    case CurveKind::hopf:
      return "Hopf points";
    case CurveKind::peak:
      return "peaks of the response";
  }
  return "";
}

std::string special_name(const ResponseSpecial& special) {
  return special.at.at_rest ? "threshold" : std::string(in_words(special.kind));
}

std::string prediction_json(const Prediction& prediction) {
  Json result;
  result["schema"] = 1;
  result["model"] = prediction.model->name;
  result["case"] = prediction.resonance->name;
  put_parameters(result, prediction);
  for (std::size_t p = 0; p < prediction.names.size(); ++p)
    if (!prediction.units[p].empty()) result["units"][prediction.names[p]] = prediction.units[p];
  if (!prediction.coordinate_unit.empty()) result["coordinate_unit"] = prediction.coordinate_unit;
  for (const auto* varied : {&prediction.vary, &prediction.against})
    if (*varied)
      result["varied"].push_back({{"name", (*varied)->name}, {"from", (*varied)->from}, {"to", (*varied)->to}});
  if (!prediction.uncertain.empty()) result["error_bars_of"] = prediction.uncertain;
  if (!prediction.no_spread_because.empty()) result["no_error_bars_because"] = prediction.no_spread_because;
  result["notes"] = prediction.diagram.notes;
  result["warnings"] = prediction.warnings;
  if (prediction.vary && !prediction.against) {
    result["complete"] = prediction.diagram.status == DiagramStatus::complete;
    result["reason"] = prediction.diagram.reason;
    result["largest"] = largest_json(prediction);
    result["branches"] = diagram_json(prediction);
  }
  if (prediction.against) result["curves"] = curves_json(prediction);
  for (std::size_t k = 0; k < prediction.backbones.size(); ++k)
    result["backbones"].push_back(backbone_json(prediction, k));
  if (!prediction.sweeps.empty()) result["simulated_sweeps"] = sweeps_json(prediction);
  if (!prediction.measured.empty()) result["measured"] = measured_json(prediction);
  return result.dump(1) + "\n";
}

std::string prediction_csv(const Prediction& prediction) {
  std::string text;
  const bool spread = !prediction.uncertain.empty();
  const auto modes_heading = [&] {
    for (const std::string_view name : prediction.model->coordinates)
      text += fmt::format(",amplitude_{0},phase_{0},frequency_shift_{0}", name);
  };
  const auto put_modes = [&](const ModeAmplitudes& modes) {
    for (std::size_t k = 0; k < modes.amplitude.size(); ++k)
      text += fmt::format(",{:.12g},{:.12g},{:.12g}", 2 * std::abs(modes.amplitude[k]),
                          modes.amplitude[k] == 0.0 ? 0.0 : std::arg(modes.amplitude[k]), modes.frequency_shift[k]);
  };
  if (!prediction.backbones.empty()) {
    text = "mode,amplitude,frequency_rad_s,growth_1_s,outside_expansion";
    text += spread ? ",frequency_sd_rad_s,growth_sd_1_s\n" : "\n";
    for (std::size_t k = 0; k < prediction.backbones.size(); ++k) {
      const auto& [mode, points] = prediction.backbones[k];
      for (std::size_t i = 0; i < points.size(); ++i) {
        const BackbonePoint& at = points[i];
        text += fmt::format("{},{:.12g},{:.12g},{:.12g},{}", mode, 2 * at.amplitude, at.frequency, at.growth,
                            at.outside ? 1 : 0);
        if (spread) {
          const BackboneSpread& sd = prediction.backbone_spread[k][i];
          text += fmt::format(",{:.6g},{:.6g}", sd.frequency, sd.growth);
        }
        text += '\n';
      }
    }
  } else if (prediction.against) {
    text = fmt::format("curve,kind,{},{}", prediction.vary->name, prediction.against->name);
    modes_heading();
    text += ",outside_expansion\n";
    for (std::size_t c = 0; c < prediction.curves.size(); ++c)
      for (const ResponseCurvePoint& at : prediction.curves[c].points) {
        const ResponseCurve& curve = prediction.curves[c];
        text += fmt::format("{},{},{:.12g},{:.12g}", c + 1, name_of(curve.kind), at.first, at.second);
        put_modes(at.modes);
        text += at.outside ? ",1\n" : ",0\n";
      }
  } else {
    text = fmt::format("branch,kind,{},stable", prediction.vary->name);
    modes_heading();
    text += ",outside_expansion";
    if (spread)
      for (const std::string_view name : prediction.model->coordinates)
        text += fmt::format(",amplitude_sd_{}", name);
    text += '\n';
    const auto put = [&](std::size_t b, const std::string& kind, const ResponsePoint& at) {
      text += fmt::format("{},{},{:.12g},{}", b + 1, kind, at.parameter, at.unstable == 0 ? 1 : 0);
      put_modes(at.modes);
      text += at.outside ? ",1" : ",0";
      for (std::size_t k = 0; spread && k < at.modes.amplitude.size(); ++k) {
        const std::optional<double> sd = amplitude_sd(at, k);
        text += sd ? fmt::format(",{:.6g}", *sd) : ",";
      }
      text += '\n';
    };
    for (std::size_t b = 0; b < prediction.diagram.branches.size(); ++b) {
      const ResponseBranch& branch = prediction.diagram.branches[b];
      for (const ResponsePoint& at : branch.points) put(b, "point", at);
      for (const ResponseSpecial& special : branch.special) put(b, std::string(word_of(special)), special.at);
    }
  }
  return text;
}

}  // namespace secular
