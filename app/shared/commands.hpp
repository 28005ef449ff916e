#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace secular::app {

/// What a subcommand does once its options are parsed; the return value is the exit status (0 or 1). Bad input
/// leaves as InputError and becomes status 2 in main.
using Action = std::function<int()>;

/// Gives `command` its options; when the user picks it, `chosen` is set to its action.
using AddCommand = void(CLI::App* command, Action& chosen);

AddCommand add_derive_command, add_evaluate_command, add_generate_command, add_verify_command, add_simulate_command,
    add_identify_command, add_predict_command, add_import_command, add_inspect_command, add_modal_command,
    add_diagnose_command, add_spectrum_command, add_procedure_command, add_plan_command, add_blind_command,
    add_to_matlab_command, add_help_command;

struct Command {
  const char* name;
  const char* purpose;
  AddCommand* add;
};

/// All of them, in the order of the help.
inline constexpr Command all_commands[] = {
    {"derive", "Expansion, solvability, modulation equations, frequency response, lumps and certificate of a model",
     add_derive_command},
    {"evaluate", "Numbers of a derivation: modulation terms and harmonics as JSON", add_evaluate_command},
    {"generate", "C++ of models: regressor rows, residuals, Jacobians, modulation equations, equations of motion",
     add_generate_command},
    {"verify", "Equation-by-equation verdict on a printed derivation: confirmed or misprint", add_verify_command},
    {"simulate", "Virtual test on the full equations of motion", add_simulate_command},
    {"identify", "Estimates of a model's parameters from a campaign", add_identify_command},
    {"predict", "Steady responses, their stability and bifurcations", add_predict_command},
    {"import", "CSV, MAT, HDF5, UFF 58, LVM and WAV files to a campaign folder, one record a file",
     add_import_command},
    {"inspect", "What a campaign or file holds: channels, units, records, levels, noise, faults found",
     add_inspect_command},
    {"modal", "Natural frequencies, damping and mode shapes from impacts or free decays", add_modal_command},
    {"diagnose", "Where model and measurement disagree, which unmodelled effect does it, how far the gap closes",
     add_diagnose_command},
    {"spectrum", "Tones, decays and their number in one record: decomposition, principal components, figures",
     add_spectrum_command},
    {"procedure", "The source's own estimation procedures, beside truth and printed tables", add_procedure_command},
    {"plan", "Levels and frequencies that best determine chosen parameters", add_plan_command},
    {"to-matlab", "MAT files beside the JSON files of a folder of results", add_to_matlab_command},
    {"blind", "Check of the diagnosis on campaigns whose cause it cannot know", add_blind_command},
    {"help", "What a command does and takes; the page of the manual; completion of command lines",
     add_help_command},
};

}  // namespace secular::app
