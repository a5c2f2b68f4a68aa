#include <QApplication>
#include <QFileInfo>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "app/cli/commands.h"
#include "app/cli/no_screen.h"
#include "app/cli/standard_output.h"
#include "app/lab/preset_library.h"
#include "physics/files/output_set.h"
#include "physics/preset/file_text.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/study/study_text.h"
#include "widgets/compare/study_plot.h"
#include "widgets/print/picture_file.h"

namespace carom {
namespace {

// A line on a terminal that says what a study is doing; nothing in a pipe.
class StudyProgressLine {
 public:
  void show(std::string_view stage, int done, int of) {
    if (!terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (stage == stage_ && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    stage_ = stage;
    if (of > 1) {
      write_err(fmt::format("\r\033[K{}: {} of {}", stage, done, of));
    } else {
      write_err(fmt::format("\r\033[K{} ...", stage));
    }
    shown_ = true;
  }
  ~StudyProgressLine() {
    if (shown_) write_err("\r\033[K");
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  bool shown_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point last_;
};

StudyTable merged(const std::vector<std::string>& files) {
  std::vector<StudyPart> parts;
  for (const std::string& name : files) {
    parts.push_back({name, read_study_csv(file_text(name, "a study's CSV file"), name)});
  }
  return merge_studies(parts);
}

}  // namespace

int study_command(int& argc, char** argv, const StudyCommandOptions& options) {
  const QString plot = QString::fromStdString(options.plot);
  if (!options.plot.empty()) {
    if (!is_picture_name(plot)) {
      throw SceneError(fmt::format("{}: not a kind of picture; allowed: .png, .svg, .pdf", options.plot));
    }
    if (options.study.shards > 1) {
      throw SceneError("--plot: not allowed with --shard; allowed: with --merge, when all rows are there");
    }
  }
  StudyTable table;
  const bool merge = !options.merge.empty();
  const std::filesystem::path file = merge ? std::filesystem::path() : find_preset(options.preset);
  // Opened before the work: hours of it must not end at a file that cannot be written.
  OutputSet outputs(merge ? std::vector<std::filesystem::path>(options.merge.begin(), options.merge.end())
                          : std::vector{file});
  OutputFile* csv = nullptr;
  OutputFile* picture = nullptr;
  const auto open_outputs = [&] {
    csv = outputs.open(options.csv);
    picture = outputs.open(options.plot);
  };
  if (merge) {
    table = merged(options.merge);
    open_outputs();
  } else {
    const Preset preset = read_preset(file);
    (void)plan_methods(preset, options.study);
    open_outputs();
    StudyProgressLine line;
    StudyWatch watch;
    watch.progress = [&line](std::string_view stage, int done, int of) { line.show(stage, done, of); };
    table = run_study(preset, file.stem().string(), options.study, watch);
  }
  if (csv != nullptr) {
    for (const std::string& line : study_csv(table)) csv->line(line);
  }
  if (picture != nullptr) {
    use_no_screen();
    const QApplication application(argc, argv);
    try {
      write_study_picture(*picture, table, light_theme());
    } catch (const SceneError& error) {
      picture->give_up(error.what());  // the figures are good
    }
  }
  const std::string failures = outputs.commit();
  write_out(study_text(table));
  if (!failures.empty()) throw SceneError(failures);
  return kGood;
}

}  // namespace carom
