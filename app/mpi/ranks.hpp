#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "blind/campaign_work.hpp"

namespace secular::app {

/// The processes that mpirun has started. Rank 0 runs the command and hands out campaigns, one at a time to whoever
/// is free; all others do what they are given. Rank 0 alone locks, seals and counts, so that nothing depends on how
/// many they are or which is slow. Where one of them ends, MPI ends all; the same command goes on with the rest.
class Ranks {
 public:
  Ranks(int& argc, char**& argv);
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool is_first() const { return rank_ == 0; }
  int others() const { return size_ - 1; }

  /// Of rank 0: blind::Crew.
  std::vector<blind::Answer> hand_out(const blind::CampaignWork& work, std::size_t count,
                                      const blind::Progress& progress) const;
  /// Of rank 0, at the end: all others leave serve().
  void dismiss() const;
  /// Of all others.
  void serve() const;

 private:
  int rank_ = 0, size_ = 1;
  unsigned on_this_machine_ = 1;
};

}  // namespace secular::app
