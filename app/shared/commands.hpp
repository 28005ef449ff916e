#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace secular::app {

/// What a subcommand does once its options are parsed; the return value is the exit status (0 or 1). Bad input
/// leaves as InputError and becomes status 2 in main.
using Action = std::function<int()>;

/// Adds a subcommand to `root`; when the user picks it, `chosen` is set to its action.
using AddCommand = void(CLI::App& root, Action& chosen);

AddCommand add_derive_command, add_evaluate_command, add_generate_command, add_verify_command, add_simulate_command,
    add_identify_command, add_predict_command, add_import_command, add_inspect_command, add_modal_command,
    add_diagnose_command, add_spectrum_command, add_procedure_command, add_plan_command, add_blind_command;

/// All of them, in the order of the help.
inline constexpr AddCommand* all_commands[] = {
    add_derive_command,   add_evaluate_command, add_generate_command,  add_verify_command,  add_simulate_command,
    add_identify_command, add_predict_command,  add_import_command,    add_inspect_command, add_modal_command,
    add_diagnose_command, add_spectrum_command, add_procedure_command, add_plan_command,    add_blind_command};

}  // namespace secular::app
