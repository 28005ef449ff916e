#pragma once

#include <sys/types.h>

#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace secular {

/// What this process does when it is told to end (SIGINT, SIGTERM, SIGHUP): programs that it has started are told
/// to end as well, what is being built is removed, and the process ends by the same signal. When it is told to stop
/// (SIGTSTP, Ctrl-Z), these programs stop and go on with it: they have groups of their own, which the terminal does
/// not reach. A handler may do none of this, so that it wakes a thread that does. A signal that was ignored or
/// handled before stays so.
class Interruption {
 public:
  /// From the first call on, signals are handled.
  static Interruption& instance();
  /// Whether there was one.
  static bool is_on();

  /// Held while a thing is put in place: no interruption comes between.
  std::mutex& guard() { return guard_; }

  /// With guard() held: `undo` is called at an interruption, from another thread and until it returns true (or a
  /// tenth of a second is over: others may still be writing), unless `owner` is taken out before.
  void add(const void* owner, std::function<bool()> undo);
  void take_out(const void* owner);

  /// With guard() held: a program that was started, with a process group of its own. Its group gets SIGTERM, and
  /// SIGKILL where it is still there after half a second.
  void add_child(pid_t child) { children_.push_back(child); }
  void take_out_child(pid_t child) { std::erase(children_, child); }

  /// The line that is printed then, after "secular: interrupted: "; empty: none.
  void set_message(std::string text);

  /// For a program that was started with setting_for_children(): it is told to end when the thread that has started
  /// it ends, however that comes about (SIGKILL too).
  static void end_with_parent();
  static std::string setting_for_children();

  /// Wall time for which this process has been stopped by SIGTSTP so far, s.
  static double stopped_s();

 private:
  Interruption();
  void wait();
  void end(int signal);
  void stop();
  void undo_all();
  void end_children() const;

  static inline int wake_ = -1;
  int pipe_[2] = {-1, -1};
  std::mutex guard_;
  std::vector<std::pair<const void*, std::function<bool()>>> undos_;
  std::vector<pid_t> children_;
  std::string message_;
};

}  // namespace secular
