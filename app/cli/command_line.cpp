#include "app/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <new>
#include <sstream>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/standard_output.h"

namespace carom {
namespace {

#define CAROM_ADD(name) add_##name##_command,
constexpr auto kCommands = {CAROM_COMMANDS(CAROM_ADD)};
#undef CAROM_ADD

int run_command_line(Arguments arguments) {
  CLI::App program{
      "Carom: a lab for two-dimensional rigid-body collisions.\n"
      "Without a command it opens the lab; where there is no display it runs the experiment instead."};
  program.set_version_flag("--version", CAROM_VERSION);
  program.set_help_flag("-h,--help", "this text");
  std::vector<Command> commands;
  for (const auto add : kCommands) commands.push_back(add(program, arguments));

  // A word that names a command is a command; any other first word is a preset.
  program.require_subcommand(0, 1);
  try {
    program.parse(arguments.argc, arguments.argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      std::ostringstream text;
      const int code = program.exit(error, text, text);
      write_out(text.str());
      return code;
    }
    print_error(std::string(error.what()) + "; see carom --help");
    return kBadInput;
  }

  try {
    for (const Command& command : commands) {
      if (command.options->parsed()) return command.run();
    }
    return kBadInput;  // unreachable: the program itself is always parsed
  } catch (const RunLostError& error) {
    print_error(error.what());
    return kLost;
  } catch (const std::bad_alloc&) {
    print_error("there is not enough memory for this");
    return kBadInput;
  } catch (const std::exception& error) {
    print_error(error.what());
    return kBadInput;
  }
}

}  // namespace

int run_program(int argc, char** argv) {
  const int code = run_command_line({argc, argv});
  const std::optional<std::string> failure = finish_stdout();
  if (!failure) return code;
  if (!failure->empty() && code != kBadInput) print_error(*failure);  // otherwise a line is printed already
  return kBadInput;
}

}  // namespace carom
