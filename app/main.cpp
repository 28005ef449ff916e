#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "app/shared/commands.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"

int main(int argc, char** argv) {
  using namespace secular::app;
  CLI::App root("Multiple-scales models that compile into parameter estimators for nonlinear vibration tests.",
                "secular");
  root.require_subcommand(1);
  root.footer("Example: secular derive two_mass_mode1 --case principal_parametric");
  Action chosen;
  add_derive_command(root, chosen);
  add_evaluate_command(root, chosen);
  add_generate_command(root, chosen);
  add_verify_command(root, chosen);
  add_simulate_command(root, chosen);
  add_identify_command(root, chosen);
  add_predict_command(root, chosen);
  add_import_command(root, chosen);
  add_inspect_command(root, chosen);
  add_modal_command(root, chosen);
  add_diagnose_command(root, chosen);
  add_spectrum_command(root, chosen);
  add_procedure_command(root, chosen);
  add_plan_command(root, chosen);
  add_blind_command(root, chosen);
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
  } catch (const std::exception& error) {
    fmt::print(stderr, "secular: internal error: {}\nPlease report this with the command that led to it.\n",
               error.what());
    return 3;
  }
}
