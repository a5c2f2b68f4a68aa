#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

// The commands of the program: each is a file that owns its options and what it does, and one line of the table
// in command_line.cpp. Bad input is thrown as SceneError.
namespace carom {

inline constexpr int kGood = 0;
inline constexpr int kFellShort = 1;  // a check fell short
inline constexpr int kBadInput = 2;   // one clear line on stderr
inline constexpr int kLost = 3;       // the run could not go on; what it had until then is printed and written

// Thrown once all is written that there is of a run that is lost: why it is.
class RunLostError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Those of main(), as an application takes them; they outlive every command.
struct Arguments {
  int& argc;
  char** argv;
};

struct Command {
  CLI::App* options;         // knows after parsing whether this command was asked for
  std::function<int()> run;  // does it, as the options say, and returns the exit code
};

// The experiments; what can't be read is told on stderr.
[[nodiscard]] Command add_list_command(CLI::App& program, Arguments arguments);
// Each file is good or has a fault, said in one line; the schema of presets instead, if asked for.
[[nodiscard]] Command add_validate_command(CLI::App& program, Arguments arguments);
[[nodiscard]] Command add_run_command(CLI::App& program, Arguments arguments);
// Every expectation of the presets beside what their runs show.
[[nodiscard]] Command add_check_command(CLI::App& program, Arguments arguments);
// The hard cases: each figure beside its limit.
[[nodiscard]] Command add_stress_command(CLI::App& program, Arguments arguments);
// Which parts of the model an experiment needs, why, and what each costs a step.
[[nodiscard]] Command add_needs_command(CLI::App& program, Arguments arguments);
[[nodiscard]] Command add_picture_command(CLI::App& program, Arguments arguments);
// Numbered pictures of a part of the run, to make a film of.
[[nodiscard]] Command add_film_command(CLI::App& program, Arguments arguments);
[[nodiscard]] Command add_study_command(CLI::App& program, Arguments arguments);
// The program without a command: the lab's window; where there is no display, the run of the experiment and a
// picture of the window instead.
[[nodiscard]] Command add_lab_command(CLI::App& program, Arguments arguments);

// What `run PRESET` and `picture PRESET --window -o OUTPUT` do.
int run_preset(const std::string& preset);
int save_window_picture(Arguments arguments, const std::string& preset, const std::string& output);

}  // namespace carom
