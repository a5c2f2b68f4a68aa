#include <QApplication>
#include <QFileInfo>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <memory>
#include <unistd.h>

#include "app/commands.h"
#include "app/no_screen.h"
#include "app/preset_library.h"
#include "app/run_files.h"
#include "physics/measure/study_text.h"
#include "physics/preset/preset.h"
#include "widgets/picture_file.h"
#include "widgets/study_plot.h"

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
      fmt::print(stderr, "\r\033[K{}: {} of {}", stage, done, of);
    } else {
      fmt::print(stderr, "\r\033[K{} ...", stage);
    }
    shown_ = true;
  }
  ~StudyProgressLine() {
    if (shown_) fmt::print(stderr, "\r\033[K");
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
    // Reading a folder throws in libstdc++.
    std::ifstream in;
    if (!std::filesystem::is_directory(name)) in.open(name, std::ios::binary);
    if (!in.is_open()) {
      throw SceneError(fmt::format("{}: the file cannot be read; allowed: a study's CSV file", name));
    }
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    parts.push_back({name, read_study_csv(text, name)});
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
  // Opened first: hours of work must not end at a file that cannot be written.
  std::unique_ptr<TextFile> csv;
  if (!options.merge.empty()) {
    table = merged(options.merge);
  } else {
    const std::filesystem::path file = find_preset(options.preset);
    const Scene scene = read_preset(file);
    (void)plan_methods(scene, options.study);
    if (!options.csv.empty()) csv = std::make_unique<TextFile>(options.csv);
    StudyProgressLine line;
    StudyWatch watch;
    watch.progress = [&line](std::string_view stage, int done, int of) { line.show(stage, done, of); };
    table = run_study(scene, file.stem().string(), options.study, watch);
  }
  if (!options.csv.empty()) {
    if (csv == nullptr) csv = std::make_unique<TextFile>(options.csv);
    for (const std::string& line : study_csv(table)) csv->line(line);
    csv->finish();
  }
  if (!options.plot.empty()) {
    use_no_screen();
    const QApplication application(argc, argv);
    QString error;
    if (!save_study_picture(table, light_theme(), plot, &error)) throw SceneError(error.toStdString());
  }
  fmt::print("{}", study_text(table));
  return kGood;
}

}  // namespace carom
