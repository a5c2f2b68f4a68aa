#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"
#include "physics/study/study.h"

// The commands of the program, each a function from its options to an exit code. Bad input is thrown as
// SceneError.
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

// What the command line says in place of the file's own method.
struct MethodOptions {
  std::optional<IntegratorId> integrator;
  std::optional<ImpactsId> impacts;
  std::optional<ContactsId> contacts;
  std::optional<double> step;       // s
  std::optional<double> tolerance;  // m and m/s a step
};

struct ValidateOptions {
  std::vector<std::string> presets;
  bool schema = false;
};

struct RunOptions {
  std::string preset;
  MethodOptions method;
  std::optional<double> until;  // s; without it the preset's duration
  bool json = false;
  std::string csv;     // file for the run's sums and paths, step by step
  std::string events;  // file for its impacts
  std::string save;    // preset file for the state at the end
};

struct CheckOptions {
  std::vector<std::string> presets;  // empty: all built-in experiments
  MethodOptions method;
  int finer = 1;    // divides every step, also where an expectation sets it
  std::string csv;  // file for the table, with all digits
};

struct StressOptions {
  std::vector<std::string> cases;  // ids of physics/stress/stress.h; empty: all
  bool longer = false;             // the long runs of cases that have one
  std::string csv;                 // file for the rows, with all digits
  std::string page;                // file for the help's page of figures, Markdown
};

struct NeedsOptions {
  std::string preset;
  MethodOptions method;
  bool json = false;
};

struct PictureOptions {
  std::string preset;
  MethodOptions method;
  std::optional<double> at;  // s; without it the preset's duration
  std::string output;        // .png, .svg or .pdf
  bool window = false;       // the whole lab, .png only
  bool dark = false;
  int width = 0;   // px; 0: 1280
  int height = 0;  // px; 0: 800
};

struct FilmOptions {
  std::string preset;
  MethodOptions method;
  double from = 0.0;         // s
  std::optional<double> to;  // s; without it the preset's duration
  double rate = 25.0;        // frames a second of the film
  double speed = 1.0;        // seconds of the run a second of the film
  std::string output;        // folder
  bool replace = false;      // frames that are there
  bool dark = false;
  int width = 1280;  // px
  int height = 720;
};

struct StudyCommandOptions {
  std::string preset;              // empty: merge
  std::vector<std::string> merge;  // CSV files of shards
  StudyOptions study;
  std::string csv;   // file for the rows
  std::string plot;  // .svg, .pdf or .png
};

// The scene of a preset with the chosen method, validated.
[[nodiscard]] Preset preset_with_method(const std::string& preset, const MethodOptions& method);

// One line on stderr, whatever it holds: what a terminal would not show is escaped, and the middle of a very
// long one is left out.
void print_error(const std::string& line);

// The experiments; what can't be read is told on stderr.
int list_command();
// Each file is good or has a fault, said in one line; the schema of presets instead, if asked for.
int validate_command(const ValidateOptions& options);
int run_command(const RunOptions& options);
// Every expectation of the presets beside what their runs show.
int check_command(const CheckOptions& options);
int study_command(int& argc, char** argv, const StudyCommandOptions& options);
// The hard cases: each figure beside its limit.
int stress_command(const StressOptions& options);
// Which parts of the model an experiment needs, why, and what each costs a step.
int needs_command(const NeedsOptions& options);
int picture_command(int& argc, char** argv, const PictureOptions& options);
// Numbered pictures of a part of the run, to make a film of.
int film_command(int& argc, char** argv, const FilmOptions& options);
// The lab's window; where there is no display, the run of the experiment and a picture of the window instead.
int lab_command(int& argc, char** argv, const std::string& preset);

}  // namespace carom
