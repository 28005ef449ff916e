#include "input/interruption.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace secular {
namespace {

constexpr const char* parent_variable = "SECULAR_PARENT";

std::atomic<bool> signals_are_handled{false};
std::atomic<double> all_stopped_s{0};  // written by one thread

void pause_ms(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

}  // namespace

Interruption& Interruption::instance() {
  static Interruption* const only = new Interruption;  // its thread may outlive static objects
  return *only;
}

bool Interruption::is_on() {
  return signals_are_handled;
}

Interruption::Interruption() {
  if (::pipe2(pipe_, O_CLOEXEC) != 0) return;
  wake_ = pipe_[1];
  std::thread([this] { wait(); }).detach();
  struct sigaction action = {}, before = {};
  action.sa_handler = [](int signal) {
    const int error = errno;
    const auto byte = static_cast<unsigned char>(signal);
    [[maybe_unused]] const ssize_t written = ::write(wake_, &byte, 1);
    errno = error;
  };
  ::sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGTSTP})
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
      ::sigaction(signal, &action, nullptr);
  signals_are_handled = true;
}

void Interruption::add(const void* owner, std::function<bool()> undo) {
  undos_.emplace_back(owner, std::move(undo));
}

void Interruption::take_out(const void* owner) {
  std::erase_if(undos_, [owner](const auto& entry) { return entry.first == owner; });
}

void Interruption::set_message(std::string text) {
  const std::lock_guard lock(guard_);
  message_ = std::move(text);
}

void Interruption::wait() {
  for (;;) {
    unsigned char signal = 0;
    const ssize_t count = ::read(pipe_[0], &signal, 1);
    if (count < 0 && errno == EINTR) continue;
    if (count != 1) return;
    // What is being put in place is; from here on nothing is, no program is started, and who waits for one does not
    // learn that it ended.
    const std::lock_guard lock(guard_);
    if (signal == SIGTSTP)
      stop();
    else
      end(signal);
  }
}

void Interruption::end(int signal) {
  for (const pid_t child : children_) ::kill(-child, SIGTERM);
  undo_all();
  end_children();
  if (!message_.empty()) {
    const std::string line =
        (::isatty(STDERR_FILENO) ? "\n" : "") + std::string("secular: interrupted: ") + message_ + "\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
  }
  struct sigaction usual = {};
  usual.sa_handler = SIG_DFL;
  ::sigaction(signal, &usual, nullptr);
  ::kill(::getpid(), signal);
  for (;;) ::pause();
}

void Interruption::stop() {
  // Those that are secular themselves stop what they have started likewise.
  for (const pid_t child : children_) ::kill(-child, SIGTSTP);
  const auto begun = std::chrono::steady_clock::now();
  ::raise(SIGSTOP);  // to this thread: it does not go on before SIGCONT
  const double stopped = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  all_stopped_s = all_stopped_s + stopped;
  for (const pid_t child : children_) ::kill(-child, SIGCONT);
}

void Interruption::undo_all() {
  for (const auto& [owner, undo] : undos_)
    for (int attempt = 0; attempt < 100 && !undo(); ++attempt) pause_ms(1);
}

void Interruption::end_children() const {
  const auto is_there = [](pid_t child) { return ::kill(-child, 0) == 0; };
  for (int attempt = 0; attempt < 50 && std::any_of(children_.begin(), children_.end(), is_there); ++attempt)
    pause_ms(10);
  for (const pid_t child : children_) ::kill(-child, SIGKILL);
}

void Interruption::end_with_parent() {
  const char* const parent = std::getenv(parent_variable);
  if (parent == nullptr) return;
  const std::string expected = parent;
  ::unsetenv(parent_variable);  // not for what this process starts
  if (expected != std::to_string(::getppid())) return;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (expected != std::to_string(::getppid())) ::raise(SIGTERM);  // it ended in between
}

double Interruption::stopped_s() {
  return all_stopped_s;
}

std::string Interruption::setting_for_children() {
  return std::string(parent_variable) + "=" + std::to_string(::getpid());
}

}  // namespace secular
