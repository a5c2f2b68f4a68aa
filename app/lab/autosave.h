#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <memory>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom {

// Where unsaved work is kept: $CAROM_AUTOSAVE, else the user's folder for data of this program.
[[nodiscard]] QString autosave_folder();

// Work of a window that ended without saying whether it is to be saved. Nobody else is offered it while this
// lives.
class KeptWork {
 public:
  KeptWork(const QString& file, std::unique_ptr<QLockFile> lock);

  [[nodiscard]] const QDateTime& time() const { return time_; }  // when it was kept
  // Throws SceneError where the file cannot be read.
  [[nodiscard]] Preset preset() const;
  void remove();
  // It is not offered again, but stays for somebody to look at: as *.damaged in the same folder.
  void set_aside();

 private:
  QString file_;
  QDateTime time_;
  std::unique_ptr<QLockFile> lock_;
};

// What lies in the folder and belongs to no window that is open, the oldest first.
[[nodiscard]] std::vector<KeptWork> kept_work(const QString& folder);

// Keeps one window's unsaved work in a file of its own, which is a preset like any other. The file goes when
// the work is saved or given up, and at a clean end.
class Autosave {
 public:
  explicit Autosave(QString folder) : folder_(std::move(folder)) {}
  ~Autosave() { forget(); }
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  // Writes the scene unless it is there already. Throws SceneError if it cannot be written.
  void keep(const Preset& preset);
  void forget();
  [[nodiscard]] const QString& file() const { return file_; }  // empty while nothing is kept

 private:
  void choose_file();

  QString folder_;
  QString file_;
  std::unique_ptr<QLockFile> lock_;
  std::string written_;
};

}  // namespace carom
