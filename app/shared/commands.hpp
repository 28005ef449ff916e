#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace secular::app {

/// What a subcommand does once its options are parsed; the return value is the exit status (0 or 1). Bad input
/// leaves as InputError and becomes status 2 in main.
using Action = std::function<int()>;

/// Each adds its subcommand to `root`; when the user picks it, `chosen` is set to its action.
void add_derive_command(CLI::App& root, Action& chosen);
void add_evaluate_command(CLI::App& root, Action& chosen);
void add_generate_command(CLI::App& root, Action& chosen);
void add_verify_command(CLI::App& root, Action& chosen);
void add_simulate_command(CLI::App& root, Action& chosen);
void add_identify_command(CLI::App& root, Action& chosen);
void add_predict_command(CLI::App& root, Action& chosen);
void add_import_command(CLI::App& root, Action& chosen);
void add_inspect_command(CLI::App& root, Action& chosen);
void add_modal_command(CLI::App& root, Action& chosen);
void add_diagnose_command(CLI::App& root, Action& chosen);
void add_spectrum_command(CLI::App& root, Action& chosen);
void add_procedure_command(CLI::App& root, Action& chosen);
void add_plan_command(CLI::App& root, Action& chosen);
void add_blind_command(CLI::App& root, Action& chosen);

}  // namespace secular::app
