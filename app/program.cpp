#include "app/program.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/unknown_word.hpp"
#include "input/input_error.hpp"
#include "input/interruption.hpp"
#include "input/numerical_failure.hpp"

namespace secular::app {
namespace {

// What was printed may still be on its way to a full disk.
int with_all_printed(int status) {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  // Where an earlier piece failed, the reason is gone.
  fmt::print(stderr, "secular: standard output cannot be written{}\n",
             errno == 0 ? "" : std::string(": ") + std::strerror(errno));
  return status == 0 ? 2 : status;
}

}  // namespace

int run_program(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing, with its message
  Interruption::end_with_parent();
  Interruption::instance().set_message("what is not finished is removed; the same command begins anew");
  CLI::App root("Multiple-scales models that compile into parameter estimators for nonlinear vibration tests.",
                "secular");
  root.require_subcommand(1);
  root.footer("Example: secular derive two_mass_mode1 --case principal_parametric");
  Action chosen;
  for (const Command& command : all_commands)
    command.add(root.add_subcommand(command.name, command.purpose), chosen);
  add_common_flags(root);
  try {
    root.parse(argc, argv);
    return with_all_printed(chosen ? chosen() : 0);
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = error.get_exit_code() == 0;
    if (const std::string unknown = asked_for_help ? "" : unknown_word(root); !unknown.empty()) {
      fmt::print(stderr, "secular: {}\n", visible(unknown));
      return 2;
    }
    root.exit(error);
    return with_all_printed(asked_for_help ? 0 : 2);
  } catch (const InputError& error) {
    fmt::print(stderr, "secular: {}\n", visible(error.what()));
    return 2;
  } catch (const NumericalFailure& failure) {
    fmt::print(stderr, "secular: {}\n", visible(failure.what()));
    return 1;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr,
               "secular: this needs more memory than there is; shorter records, fewer of them or a lower order "
               "need less\n");
    return 1;
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return with_all_printed(2);
    fmt::print(stderr, "secular: internal error: {}\nPlease report this with the command that led to it.\n",
               error.what());
    return 3;
  }
}

}  // namespace secular::app
