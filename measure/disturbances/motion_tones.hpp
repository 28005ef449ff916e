#pragma once

#include <vector>

#include "measure/disturbances/searched_record.hpp"

namespace secular {

/// The frequencies that excitation and motion of a record make, as far as the record itself tells (it must live as
/// long):
/// - of a dwell: multiples of the excitation's frequencies, of their halves and thirds, and sums and differences of
///   several excitations, also those that sampling folds back;
/// - of a decay: multiples of the strongest line;
/// - a line that has a partner at its sum or difference with a multiple of the excitation: a mode that moves at a
///   frequency of its own is coupled to the excitation by what makes it move, and a foreign tone is not;
/// - elsewhere (sweeps, noise): whatever line the excitation has too; where lines make most of the excitation, sums
///   and differences of two or three of them, which quadratic and cubic terms make.
class MotionTones {
 public:
  explicit MotionTones(const SearchedRecord& record);

  /// A line at that frequency is a multiple or a sum of excitations, also folded, or excited itself.
  bool is_harmonic(double frequency_hz) const;
  /// That, or it has a partner among `others`; partners at the sum and the difference with the excitation itself
  /// count down to the noise.
  bool make(double frequency_hz, const std::vector<double>& others) const;
  /// A steady line, off the motion's own, that no product of a decay can be: these fall.
  bool is_outlasted_by(const Line& line) const;
  /// A line that dies away at that frequency, known to `error_hz`, is the motion's own start: at a multiple, or
  /// with a partner among `others`.
  bool start_at(double frequency_hz, const std::vector<double>& others, double error_hz) const;

  /// Hz; nothing is made below it but a mean.
  double lowest_hz() const;

 private:
  double folded(double frequency_hz) const;
  bool is_multiple(double frequency_hz, double of_hz, double tolerance) const;
  bool is_folded(double frequency_hz, double of_hz) const;
  bool has_partner(double frequency_hz, double of_hz, const std::vector<double>& others, double tolerance) const;
  bool has_weak_partner(double frequency_hz, double of_hz) const;
  void take_sums_of_two();
  bool is_sum_of_excited(double frequency_hz) const;

  const SearchedRecord& record_;
  double rate_ = 0, tolerance_ = 0;
  double change_ = 1;               // of a decay's size between halves
  bool forced_ = false;             // a dwell
  bool decays_ = false;             // swings freely: no subharmonics
  std::vector<double> generators_;  // excitation frequencies of a dwell, the strongest line of a decay
  std::vector<double> excited_;     // other records: lines of the excitation
  std::vector<bool> sums_of_two_;   // of these, by frequency in tolerances; empty: they are not what drives
};

}  // namespace secular
