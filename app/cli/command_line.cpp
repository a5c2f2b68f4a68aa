#include "app/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>
#include <functional>
#include <memory>
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

void add_preset(CLI::App& command, std::string& to) {
  command.add_option("preset", to, "a preset file or the name of an experiment")
      ->required()
      ->type_name("FILE|NAME");
}
template <class Time>
void add_time(CLI::App& command, const char* option, Time& to, const char* what) {
  command.add_option(option, to, what)->check(kTime)->type_name("T");
}
CLI::Option* add_output(CLI::App& command, const char* option, std::string& to, const char* what) {
  return command.add_option(option, to, what)->check(kOutput)->type_name("F");
}
void add_count(CLI::App& command, const char* option, int& to, const char* what, int least, int most,
               const char* type = "N") {
  command.add_option(option, to, what)->check(CLI::Range(least, most))->type_name(type);
}

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
    add_time(command, "--until", options_.study.until, "the compared time, s (default: near the preset's end)");
    add_count(command, "--repeats", options_.study.repeats, "timed runs of each row, 1 to 1000 (default: 5)", 1,
              1000);
    add_count(command, "--threads", options_.study.threads, "for all but the timing (default: one a core)", 1,
              1024);
    add_output(command, "--csv", options_.csv, "write a line for each row");
    add_output(command, "--plot", options_.plot, "draw error against time and step, .svg, .pdf or .png");
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

// What the line asks for, once it is read.
using Action = std::function<int()>;

// Each of the following adds a command, which sets the action if the line names it.
void add_validate(CLI::App& program, Action& action) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App& validate = *program.add_subcommand("validate", "whether preset files are good, or what is wrong");
  validate.add_option("preset", options->presets, "preset files or names of experiments")
      ->type_name("FILE|NAME");
  validate.add_flag("--schema", options->schema, "print the JSON Schema of preset files");
  validate.callback([=, &action] { action = [=] { return validate_command(*options); }; });
}

void add_run(CLI::App& program, Action& action) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App& run = *program.add_subcommand("run", "run an experiment and print what was before and after");
  add_preset(run, options->preset);
  add_time(run, "--until", options->until, "end of the run, s (default: the preset's duration)");
  const auto method = std::make_shared<MethodArguments>(run);
  run.add_flag("--json", options->json, "print one JSON object instead of tables");
  add_output(run, "--csv", options->csv, "write sums and paths of every step");
  add_output(run, "--events", options->events, "write every impact");
  add_output(run, "--save", options->save,
             "write the run as it stands at the end, as a preset that goes on from there");
  run.callback([=, &action] {
    options->method = method->options();
    action = [=] { return run_command(*options); };
  });
}

void add_check(CLI::App& program, Action& action) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App& check =
      *program.add_subcommand("check", "what experiments show beside what theory expects of them");
  check.add_option("preset", options->presets, "preset files or names of experiments (default: all built-in)")
      ->type_name("FILE|NAME");
  const auto method = std::make_shared<MethodArguments>(check);
  add_count(check, "--finer", options->finer, "divide every step by N, 1 to 1000", 1, 1000);
  add_output(check, "--csv", options->csv, "write the table with all digits");
  check.callback([=, &action] {
    options->method = method->options();
    action = [=] { return check_command(*options); };
  });
}

void add_stress(CLI::App& program, Action& action) {
  const auto options = std::make_shared<StressOptions>();
  CLI::App& stress = *program.add_subcommand(
      "stress", "the hard cases: what each shows beside its limit, at a step and a quarter");
  stress.add_option("case", options->cases, "ids of cases (default: all)")->type_name("CASE");
  stress.add_flag("--long", options->longer, "1e6 impacts of the gas instead of 1e5");
  add_output(stress, "--csv", options->csv, "write the table with all digits");
  add_output(stress, "--page", options->page, "write the help's page of figures, Markdown");
  stress.callback([=, &action] { action = [=] { return stress_command(*options); }; });
}

// The two that draw need what the line had.
void add_picture(CLI::App& program, Action& action, int& argc, char** argv) {
  const auto options = std::make_shared<PictureOptions>();
  CLI::App& picture = *program.add_subcommand("picture", "a picture of an experiment at one moment");
  add_preset(picture, options->preset);
  add_time(picture, "--at", options->at, "moment, s (default: the preset's duration)");
  const auto method = std::make_shared<MethodArguments>(picture);
  add_output(picture, "-o,--output", options->output, "a .png, .svg or .pdf file")->required();
  picture.add_flag("--window", options->window, "the whole lab window (.png)");
  picture.add_flag("--dark", options->dark, "in the dark colours");
  add_count(picture, "--width", options->width, "px, 200 to 8000", 200, 8000, "W");
  add_count(picture, "--height", options->height, "px, 200 to 8000", 200, 8000, "H");
  picture.callback([=, &action, &argc] {
    options->method = method->options();
    action = [=, &argc] { return picture_command(argc, argv, *options); };
  });
}

void add_film(CLI::App& program, Action& action, int& argc, char** argv) {
  const auto options = std::make_shared<FilmOptions>();
  CLI::App& film = *program.add_subcommand("film", "numbered pictures of a run, to make a film of");
  add_preset(film, options->preset);
  add_time(film, "--from", options->from, "first moment, s (default: 0)");
  add_time(film, "--to", options->to, "end, s (default: the preset's duration)");
  const auto method = std::make_shared<MethodArguments>(film);
  film.add_option("--rate", options->rate, "frames a second of the film (default: 25)")->type_name("N");
  film.add_option("--speed", options->speed,
                  "seconds of the run in one of the film, below 1 for slow motion (default: 1)")
      ->type_name("X");
  add_output(film, "-o,--output", options->output, "a folder for frame-0001.png, frame-0002.png ...")
      ->required()
      ->type_name("DIR");
  film.add_flag("--replace", options->replace, "frames that the folder has already");
  film.add_flag("--dark", options->dark, "in the dark colours");
  add_count(film, "--width", options->width, "px, even, 200 to 8000 (default: 1280)", 200, 8000, "W");
  add_count(film, "--height", options->height, "px, even, 200 to 8000 (default: 720)", 200, 8000, "H");
  film.callback([=, &action, &argc] {
    options->method = method->options();
    action = [=, &argc] { return film_command(argc, argv, *options); };
  });
}

// Its exit code; what goes wrong is said in one line.
int carry_out(const Action& action) {
  try {
    return action();
  } catch (const RunLostError& error) {
    print_error(error.what());
    return kLost;
  } catch (const std::bad_alloc&) {
    print_error("there is not enough memory for this");
  } catch (const std::exception& error) {
    print_error(error.what());
  }
  return kBadInput;
}

int run_command_line(int argc, char** argv) {
  CLI::App program{
      "Carom: a lab for two-dimensional rigid-body collisions.\n"
      "Without a command it opens the lab; where there is no display it runs the experiment instead."};
  program.set_version_flag("--version", CAROM_VERSION);
  program.set_help_flag("-h,--help", "this text");
  std::string preset;
  program.add_option("preset", preset, "a preset file, or the name of a built-in experiment")
      ->type_name("FILE|NAME");
  Action action = [&] { return lab_command(argc, argv, preset); };
  program.add_subcommand("list", "the built-in experiments")->callback([&] { action = list_command; });
  add_validate(program, action);
  add_run(program, action);
  add_check(program, action);
  add_stress(program, action);
  add_picture(program, action, argc, argv);
  add_film(program, action, argc, argv);
  CLI::App& study = *program.add_subcommand("study", "one experiment under every method: speed against error");
  const StudyArguments study_arguments(study);
  study.callback([&] { action = [&] { return study_command(argc, argv, study_arguments.options()); }; });

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
  return carry_out(action);
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
