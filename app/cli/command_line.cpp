#include "app/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>
#include <map>
#include <sstream>

#include "app/cli/commands.h"
#include "app/cli/standard_output.h"
#include "physics/dynamics/integrators/integrators.h"
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

// A time that a user asks for.
const CLI::Validator kTime(
    [](const std::string& text) -> std::string {
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      const bool good = end != text.c_str() && *end == '\0' && value >= 0.0 && value <= 1e9;
      return good ? "" : shortened(text) + " is not allowed; allowed: a time from 0 to 1e9 s";
    },
    "T", "time");

const CLI::Validator kOutput([](const std::string& text)
                                 -> std::string { return text.empty() ? "the name of a file is needed" : ""; },
                             "F", "output");

// What `carom study` takes: lists with commas, checked item by item.
class StudyArguments {
 public:
  explicit StudyArguments(CLI::App& command) {
    command.add_option("preset", options_.preset, "a preset file or the name of an experiment")
        ->type_name("FILE|NAME");
    list(command, "--integrators", integrators_, "integrators to compare (default: all that the scene allows)")
        ->check(CLI::IsMember(names_of(kIntegrators)));
    list(command, "--impacts", impacts_, "choices of impacts to compare (default: all)")
        ->check(CLI::IsMember(names_of(kImpacts)));
    list(command, "--steps", steps_, "steps, s (default: 10, from 16 times the preset's own down, each half)");
    list(command, "--tolerances", tolerances_, "of the adaptive integrator, m (default: 1e-3 to 1e-12)");
    command
        .add_option("--until", options_.study.until, "the compared time, s (default: near the preset's end)")
        ->check(kTime)
        ->type_name("T");
    command.add_option("--repeats", options_.study.repeats, "timed runs of each row, 1 to 1000 (default: 5)")
        ->check(CLI::Range(1, 1000))
        ->type_name("N");
    command.add_option("--threads", options_.study.threads, "for all but the timing (default: one a core)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command.add_option("--csv", options_.csv, "write a line for each row")->check(kOutput)->type_name("F");
    command.add_option("--plot", options_.plot, "draw error against time and step, .svg, .pdf or .png")
        ->check(kOutput)
        ->type_name("F");
    command.add_option("--shard", shard_, "do only the i-th of n parts of the rows")->type_name("I/N");
    command.add_option("--merge", options_.merge, "put the CSV files of all shards together")->type_name("F");
  }
  // Throws SceneError.
  [[nodiscard]] StudyCommandOptions options() const {
    StudyCommandOptions o = options_;
    for (const std::string& name : integrators_) o.study.integrators.push_back(id_of(kIntegrators, name));
    for (const std::string& name : impacts_) o.study.impacts.push_back(id_of(kImpacts, name));
    o.study.steps = numbers("--steps", steps_, kLeastStep, kLargestStep, "s");
    o.study.tolerances = numbers("--tolerances", tolerances_, kLeastTolerance, kLargestTolerance, "m");
    if (!shard_.empty()) read_shard(o.study);
    if (o.study.until && !(*o.study.until > 0.0)) {
      throw SceneError(
          "--until: 0 is not allowed; allowed: a time above 0, there is nothing to compare at the start");
    }
    if (o.preset.empty() == o.merge.empty()) {
      throw SceneError("study: one thing to do is needed; allowed: FILE|NAME, or --merge FILE...");
    }
    if (!o.merge.empty() && !shard_.empty()) {
      throw SceneError("--shard: not allowed with --merge; allowed: with FILE|NAME");
    }
    return o;
  }

 private:
  template <class Table>
  static std::vector<std::string> names_of(const Table& table) {
    std::vector<std::string> names;
    for (const auto& choice : table) names.emplace_back(choice.name);
    return names;
  }
  static CLI::Option* list(CLI::App& command, const std::string& option, std::vector<std::string>& to,
                           const std::string& what) {
    return command.add_option(option, to, what)->delimiter(',')->type_name("A,B,...")->allow_extra_args(false);
  }
  static std::vector<double> numbers(const char* option, const std::vector<std::string>& texts, double least,
                                     double most, const char* unit) {
    std::vector<double> values;
    for (const std::string& text : texts) {
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      if (end == text.c_str() || *end != '\0' || !(value >= least && value <= most)) {
        throw SceneError(fmt::format("{}: {} is not allowed; allowed: from {} to {} {}", option,
                                     shortened(text), least, most, unit));
      }
      if (std::find(values.begin(), values.end(), value) != values.end()) {
        throw SceneError(fmt::format("{}: {} comes twice; allowed: each once", option, shortened(text)));
      }
      values.push_back(value);
    }
    return values;
  }
  void read_shard(StudyOptions& study) const {
    int used = 0;
    const bool good = std::sscanf(shard_.c_str(), "%5d/%5d%n", &study.shard, &study.shards, &used) == 2 &&
                      used == static_cast<int>(shard_.size()) && study.shard >= 1 &&
                      study.shard <= study.shards;
    if (!good) {
      throw SceneError(fmt::format("--shard: {} is not allowed; allowed: i/n with i from 1 to n, such as 1/4",
                                   shortened(shard_)));
    }
  }

  StudyCommandOptions options_;
  std::vector<std::string> integrators_;
  std::vector<std::string> impacts_;
  std::vector<std::string> steps_;
  std::vector<std::string> tolerances_;
  std::string shard_;
};

}  // namespace

void print_error(const std::string& line) {
  // A name at the front and what is wrong with it at the end are kept.
  constexpr std::size_t kFront = 600;
  constexpr std::size_t kEnd = 300;
  std::string one = shortened(line, kFront);
  if (line.size() > kFront + kEnd) {
    one += " " + printable(std::string_view(line).substr(line.size() - kEnd));
  } else {
    one = printable(line);
  }
  write_err(fmt::format("carom: {}\n", one));
}

namespace {

int run_command_line(int argc, char** argv) {
  CLI::App program{
      "Carom: a lab for two-dimensional rigid-body collisions.\n"
      "Without a command it opens the lab; where there is no display it runs the experiment instead."};
  program.set_version_flag("--version", CAROM_VERSION);
  program.set_help_flag("-h,--help", "this text");
  std::string preset;
  program.add_option("preset", preset, "a preset file, or the name of a built-in experiment")
      ->type_name("FILE|NAME");

  CLI::App& list = *program.add_subcommand("list", "the built-in experiments");

  ValidateOptions validate_options;
  CLI::App& validate = *program.add_subcommand("validate", "whether preset files are good, or what is wrong");
  validate.add_option("preset", validate_options.presets, "preset files or names of experiments")
      ->type_name("FILE|NAME");
  validate.add_flag("--schema", validate_options.schema, "print the JSON Schema of preset files");

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
  run.add_option("--csv", run_options.csv, "write sums and paths of every step")
      ->check(kOutput)
      ->type_name("F");
  run.add_option("--events", run_options.events, "write every impact")->check(kOutput)->type_name("F");
  run.add_option("--save", run_options.save,
                 "write the run as it stands at the end, as a preset that goes on from there")
      ->check(kOutput)
      ->type_name("F");

  CheckOptions check_options;
  CLI::App& check =
      *program.add_subcommand("check", "what experiments show beside what theory expects of them");
  check
      .add_option("preset", check_options.presets,
                  "preset files or names of experiments (default: all built-in)")
      ->type_name("FILE|NAME");
  const MethodArguments check_method(check);
  check.add_option("--finer", check_options.finer, "divide every step by N, 1 to 1000")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  check.add_option("--csv", check_options.csv, "write the table with all digits")
      ->check(kOutput)
      ->type_name("F");

  StressOptions stress_options;
  CLI::App& stress = *program.add_subcommand(
      "stress", "the hard cases: what each shows beside its limit, at a step and a quarter");
  stress.add_option("case", stress_options.cases, "ids of cases (default: all)")->type_name("CASE");
  stress.add_flag("--long", stress_options.longer, "1e6 impacts of the gas instead of 1e5");
  stress.add_option("--csv", stress_options.csv, "write the table with all digits")
      ->check(kOutput)
      ->type_name("F");
  stress.add_option("--page", stress_options.page, "write the help's page of figures, Markdown")
      ->check(kOutput)
      ->type_name("F");

  NeedsOptions needs_options;
  CLI::App& needs =
      *program.add_subcommand("needs", "which parts of the model an experiment needs, and what each costs");
  needs.add_option("preset", needs_options.preset, "a preset file or the name of an experiment")
      ->required()
      ->type_name("FILE|NAME");
  const MethodArguments needs_method(needs);
  needs.add_flag("--json", needs_options.json, "print one JSON object instead of a table");

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
      ->check(kOutput)
      ->type_name("F");
  picture.add_flag("--window", picture_options.window, "the whole lab window (.png)");
  picture.add_flag("--dark", picture_options.dark, "in the dark colours");
  picture.add_option("--width", picture_options.width, "px, 200 to 8000")
      ->check(CLI::Range(200, 8000))
      ->type_name("W");
  picture.add_option("--height", picture_options.height, "px, 200 to 8000")
      ->check(CLI::Range(200, 8000))
      ->type_name("H");

  FilmOptions film_options;
  CLI::App& film = *program.add_subcommand("film", "numbered pictures of a run, to make a film of");
  film.add_option("preset", film_options.preset, "a preset file or the name of an experiment")
      ->required()
      ->type_name("FILE|NAME");
  film.add_option("--from", film_options.from, "first moment, s (default: 0)")->check(kTime)->type_name("T");
  film.add_option("--to", film_options.to, "end, s (default: the preset's duration)")
      ->check(kTime)
      ->type_name("T");
  const MethodArguments film_method(film);
  film.add_option("--rate", film_options.rate, "frames a second of the film (default: 25)")->type_name("N");
  film.add_option("--speed", film_options.speed,
                  "seconds of the run in one of the film, below 1 for slow motion (default: 1)")
      ->type_name("X");
  film.add_option("-o,--output", film_options.output, "a folder for frame-0001.png, frame-0002.png ...")
      ->required()
      ->check(kOutput)
      ->type_name("DIR");
  film.add_flag("--replace", film_options.replace, "frames that the folder has already");
  film.add_flag("--dark", film_options.dark, "in the dark colours");
  film.add_option("--width", film_options.width, "px, even, 200 to 8000 (default: 1280)")
      ->check(CLI::Range(200, 8000))
      ->type_name("W");
  film.add_option("--height", film_options.height, "px, even, 200 to 8000 (default: 720)")
      ->check(CLI::Range(200, 8000))
      ->type_name("H");

  CLI::App& study = *program.add_subcommand("study", "one experiment under every method: speed against error");
  const StudyArguments study_arguments(study);

  // A word that names a command is a command; any other first word is a preset.
  program.require_subcommand(0, 1);
  try {
    program.parse(argc, argv);
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
    if (list.parsed()) return list_command();
    if (validate.parsed()) return validate_command(validate_options);
    if (run.parsed()) {
      run_options.method = run_method.options();
      return run_command(run_options);
    }
    if (study.parsed()) return study_command(argc, argv, study_arguments.options());
    if (check.parsed()) {
      check_options.method = check_method.options();
      return check_command(check_options);
    }
    if (stress.parsed()) return stress_command(stress_options);
    if (needs.parsed()) {
      needs_options.method = needs_method.options();
      return needs_command(needs_options);
    }
    if (picture.parsed()) {
      picture_options.method = picture_method.options();
      return picture_command(argc, argv, picture_options);
    }
    if (film.parsed()) {
      film_options.method = film_method.options();
      return film_command(argc, argv, film_options);
    }
    return lab_command(argc, argv, preset);
  } catch (const SceneError& error) {
    print_error(error.what());
    return kBadInput;
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
  const int code = run_command_line(argc, argv);
  const std::optional<std::string> failure = finish_stdout();
  if (!failure) return code;
  if (!failure->empty() && code != kBadInput) print_error(*failure);  // else a line is said already
  return kBadInput;
}

}  // namespace carom
