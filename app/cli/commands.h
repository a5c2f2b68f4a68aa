#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

// The commands of the program: each is a file with its options and its work, and one line of the list below.
// Bad input is thrown as SceneError.
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

// The commands in the order of --help, as COMMAND(name): add_NAME_command() is in command_NAME.cpp.
#define CAROM_COMMANDS(COMMAND)                                                       \
  COMMAND(list)     /* the experiments; reports unreadable ones on stderr */          \
  COMMAND(validate) /* a line about each file; or the schema of presets */            \
  COMMAND(run)      /* one experiment, to its end or a stop */                        \
  COMMAND(check)    /* every expectation of presets beside the results of the runs */ \
  COMMAND(needs)    /* the parts of the model that an experiment needs, and why */    \
  COMMAND(picture)  /* of the scene or of the window */                               \
  COMMAND(film)     /* numbered pictures of a part of the run */                      \
  COMMAND(study)    /* one experiment under every method */                           \
  COMMAND(lab)      /* no command: the window; without a display the run and a picture of it */

#define CAROM_DECLARE(name) [[nodiscard]] Command add_##name##_command(CLI::App& program, Arguments arguments);
CAROM_COMMANDS(CAROM_DECLARE)
#undef CAROM_DECLARE

// The work of `run PRESET` and `picture PRESET --window -o OUTPUT`.
int run_preset(const std::string& preset);
int save_window_picture(Arguments arguments, const std::string& preset, const std::string& output);

}  // namespace carom
