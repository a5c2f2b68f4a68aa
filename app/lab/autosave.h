#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "app/lab/kept_starts.h"
#include "physics/preset/preset.h"

namespace carom {

// The folder of unsaved work: $CAROM_AUTOSAVE, or the program's data folder of the user.
[[nodiscard]] QString autosave_folder();

// Where work came from.
struct WorkSource {
  QString name;  // of the built-in experiment; empty: it is none
  QString file;  // where it is saved; empty: nowhere yet
};

// Work of a window that ended without an answer whether to save it. No other window is offered it while this
// object exists.
class KeptWork {
 public:
  KeptWork(const QString& file, std::unique_ptr<QLockFile> lock);

  [[nodiscard]] const QDateTime& time() const { return time_; }  // when it was kept
  // Throws SceneError where the file cannot be read.
  [[nodiscard]] Preset preset() const;
  // Of that work; none where they can't be read.
  [[nodiscard]] KeptStarts starts() const;
  // Of that work; none where it can't be read.
  [[nodiscard]] WorkSource source() const;
  // Whether another program wrote the file of the work since; not where it is gone.
  [[nodiscard]] bool file_changed() const;
  void remove();
  // Keeps the file for inspection, as *.damaged in the same folder; it is not offered again.
  void set_aside();

 private:
  QString file_;
  QDateTime time_;
  std::unique_ptr<QLockFile> lock_;
};

// Work in the folder that belongs to no open window, the oldest first.
[[nodiscard]] std::vector<KeptWork> kept_work(const QString& folder);

// Keeps one window's unsaved work in a file of its own, which is a preset like any other, its starts in a
// second one, and where it came from in a third. They are removed when the work is saved or discarded, and at a
// normal exit.
class Autosave {
 public:
  explicit Autosave(QString folder) : folder_(std::move(folder)) {}
  ~Autosave() { forget(); }
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  // Writes what the files do not have already. Throws SceneError if they cannot be written.
  void keep(const Preset& preset, const KeptStarts& starts, const WorkSource& source);
  void forget();
  [[nodiscard]] const QString& file() const { return file_; }  // empty while nothing is kept

 private:
  void choose_file();

  QString folder_;
  QString file_;
  std::unique_ptr<QLockFile> lock_;
  std::string written_;
  QByteArray written_starts_, written_source_;
};

}  // namespace carom
