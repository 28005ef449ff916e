#include <fmt/format.h>

#include <CLI/App.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"

int main(int argc, char** argv) {
  using namespace secular::app;
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
    return chosen ? chosen() : 0;
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = error.get_exit_code() == 0;
    root.exit(error);
    return asked_for_help ? 0 : 2;
  } catch (const secular::InputError& error) {
    fmt::print(stderr, "secular: {}\n", error.what());
    return 2;
  } catch (const secular::NumericalFailure& failure) {
    fmt::print(stderr, "secular: {}\n", failure.what());
    return 1;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr,
               "secular: this needs more memory than there is; shorter records, fewer of them or a lower order "
               "need less\n");
    return 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "secular: internal error: {}\nPlease report this with the command that led to it.\n",
               error.what());
    return 3;
  }
}
