#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <map>

#include "app/commands.h"
#include "physics/motion/integrators.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

template <class Table>
auto id_of(const Table& table, const std::string& name) {
  for (const auto& choice : table) {
    if (choice.name == name) return choice.id;
  }
  return table.front().id;
}

// One option for each part of a method, with the names of its table.
class MethodArguments {
 public:
  explicit MethodArguments(CLI::App& command) {
    add(command, "--integrator", kIntegrators, integrator_, "how free motion is advanced");
    add(command, "--impacts", kImpacts, impacts_, "when impacts are resolved");
    add(command, "--contacts", kContacts, contacts_, "how lasting contacts are treated");
    command.add_option("--step", step_, "length of a step, s")->type_name("H");
    command.add_option("--tolerance", tolerance_, "of the adaptive integrator, m and m/s a step")
        ->type_name("TOL");
  }
  [[nodiscard]] MethodOptions options() const {
    MethodOptions m;
    if (!integrator_.empty()) m.integrator = id_of(kIntegrators, integrator_);
    if (!impacts_.empty()) m.impacts = id_of(kImpacts, impacts_);
    if (!contacts_.empty()) m.contacts = id_of(kContacts, contacts_);
    m.step = step_;
    m.tolerance = tolerance_;
    return m;
  }

 private:
  template <class Table>
  static void add(CLI::App& command, const std::string& option, const Table& table, std::string& to,
                  const std::string& what) {
    std::vector<std::string> names;
    for (const auto& choice : table) names.emplace_back(choice.name);
    command.add_option(option, to, what)->type_name("ID")->check(CLI::IsMember(names));
  }
  std::string integrator_;
  std::string impacts_;
  std::string contacts_;
  std::optional<double> step_;
  std::optional<double> tolerance_;
};

void print_error(const std::string& line) {
  std::string one = line;
  for (char& c : one) {
    if (c == '\n') c = ' ';
  }
  fmt::print(stderr, "carom: {}\n", one);
}

// A time that a user asks for.
const CLI::Validator kTime(
    [](const std::string& text) -> std::string {
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      const bool good = end != text.c_str() && *end == '\0' && value >= 0.0 && value <= 1e9;
      return good ? "" : text + " is not allowed; allowed: a time from 0 to 1e9 s";
    },
    "T", "time");

}  // namespace

int run_program(int argc, char** argv) {
  CLI::App program{
      "Carom: a lab for two-dimensional rigid-body collisions.\n"
      "Without a command it opens the lab; where there is no display it runs the experiment instead."};
  program.set_version_flag("--version", CAROM_VERSION);
  program.set_help_flag("-h,--help", "this text");
  std::string preset;
  program.add_option("preset", preset, "a preset file, or the name of a built-in experiment")
      ->type_name("FILE|NAME");

  CLI::App& list = *program.add_subcommand("list", "the built-in experiments");

  RunOptions run_options;
  CLI::App& run = *program.add_subcommand("run", "run an experiment and print what was before and after");
  run.add_option("preset", run_options.preset, "a preset file or the name of an experiment")
      ->required()
      ->type_name("FILE|NAME");
  run.add_option("--until", run_options.until, "end of the run, s (default: the preset's duration)")
      ->check(kTime)
      ->type_name("T");
  const MethodArguments run_method(run);
  run.add_flag("--json", run_options.json, "print one JSON object instead of tables");
  run.add_option("--csv", run_options.csv, "write sums and paths of every step")->type_name("F");
  run.add_option("--events", run_options.events, "write every impact")->type_name("F");
  run.add_option("--save", run_options.save, "write the state at the end as a preset")->type_name("F");

  CheckOptions check_options;
  CLI::App& check =
      *program.add_subcommand("check", "what experiments show beside what theory expects of them");
  check
      .add_option("preset", check_options.presets,
                  "preset files or names of experiments (default: all built-in)")
      ->type_name("FILE|NAME");
  check.add_option("--csv", check_options.csv, "write the table with all digits")->type_name("F");

  PictureOptions picture_options;
  CLI::App& picture = *program.add_subcommand("picture", "a picture of an experiment at one moment");
  picture.add_option("preset", picture_options.preset, "a preset file or the name of an experiment")
      ->required()
      ->type_name("FILE|NAME");
  picture.add_option("--at", picture_options.at, "moment, s (default: the preset's duration)")
      ->check(kTime)
      ->type_name("T");
  const MethodArguments picture_method(picture);
  picture.add_option("-o,--output", picture_options.output, "a .png, .svg or .pdf file")
      ->required()
      ->type_name("F");
  picture.add_flag("--window", picture_options.window, "the whole lab window (.png)");
  picture.add_flag("--dark", picture_options.dark, "in the dark colours");
  picture.add_option("--width", picture_options.width, "px, 200 to 8000")
      ->check(CLI::Range(200, 8000))
      ->type_name("W");
  picture.add_option("--height", picture_options.height, "px, 200 to 8000")
      ->check(CLI::Range(200, 8000))
      ->type_name("H");

  // A word that names a command is a command; any other first word is a preset.
  program.require_subcommand(0, 1);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return program.exit(error);
    print_error(std::string(error.what()) + "; see carom --help");
    return kBadInput;
  }

  try {
    if (list.parsed()) return list_command();
    if (run.parsed()) {
      run_options.method = run_method.options();
      return run_command(run_options);
    }
    if (check.parsed()) return check_command(check_options);
    if (picture.parsed()) {
      picture_options.method = picture_method.options();
      return picture_command(argc, argv, picture_options);
    }
    return lab_command(argc, argv, preset);
  } catch (const SceneError& error) {
    print_error(error.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    print_error("there is not enough memory for this");
    return kBadInput;
  }
}

}  // namespace carom
