#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

// The commands of the program: each is a file with its options and its work, and one line of the table in
// command_line.cpp. Bad input is thrown as SceneError.
namespace carom {

inline constexpr int kGood = 0;
inline constexpr int kFellShort = 1;  // a check failed
inline constexpr int kBadInput = 2;   // one line on stderr
inline constexpr int kLost = 3;       // the run was lost; its results until then are printed and written

// Thrown after the results of a lost run are written: the reason of the loss.
class RunLostError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The arguments of main(), as an application takes them; they outlive every command.
struct Arguments {
  int& argc;
  char** argv;
};

struct Command {
  CLI::App* options;         // knows after parsing whether this command was given
  std::function<int()> run;  // runs the command with these options and returns the exit code
};

// Lists the experiments; reports unreadable ones on stderr.
[[nodiscard]] Command add_list_command(CLI::App& program, Arguments arguments);
// Checks each file and prints one line about it; or prints the schema of presets.
[[nodiscard]] Command add_validate_command(CLI::App& program, Arguments arguments);
[[nodiscard]] Command add_run_command(CLI::App& program, Arguments arguments);
// Compares every expectation of the presets with the results of their runs.
[[nodiscard]] Command add_check_command(CLI::App& program, Arguments arguments);
// Prints the parts of the model that an experiment needs, and why.
[[nodiscard]] Command add_needs_command(CLI::App& program, Arguments arguments);
[[nodiscard]] Command add_picture_command(CLI::App& program, Arguments arguments);
// Writes numbered pictures of a part of the run, for a film.
[[nodiscard]] Command add_film_command(CLI::App& program, Arguments arguments);
[[nodiscard]] Command add_study_command(CLI::App& program, Arguments arguments);
// The program without a command: opens the lab's window, or, without a display, runs the experiment and saves
// a picture of the window.
[[nodiscard]] Command add_lab_command(CLI::App& program, Arguments arguments);

// The work of `run PRESET` and `picture PRESET --window -o OUTPUT`.
int run_preset(const std::string& preset);
int save_window_picture(Arguments arguments, const std::string& preset, const std::string& output);

}  // namespace carom
