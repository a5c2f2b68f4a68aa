#include "app/lab/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>
#include <fmt/format.h>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"

namespace carom {
namespace {

constexpr const char* kSuffix = ".json";

QString lock_of(const QString& file) { return file + ".lock"; }
QString starts_of(const QString& file) { return file + ".starts"; }

// Exclusive while this process holds it; released when the process ends.
std::unique_ptr<QLockFile> locked(const QString& file) {
  auto lock = std::make_unique<QLockFile>(lock_of(file));
  lock->setStaleLockTime(0);  // never stale by age: a window may be open for days
  if (!lock->tryLock(0)) return nullptr;
  return lock;
}

}  // namespace

QString autosave_folder() {
  const QString named = qEnvironmentVariable("CAROM_AUTOSAVE");
  return named.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/unsaved"
                         : named;
}

KeptWork::KeptWork(const QString& file, std::unique_ptr<QLockFile> lock)
    : file_(file), time_(QFileInfo(file).lastModified()), lock_(std::move(lock)) {}

Preset KeptWork::preset() const { return read_preset(file_.toStdString()); }

KeptStarts KeptWork::starts() const {
  QFile file(starts_of(file_));
  if (!file.open(QIODevice::ReadOnly)) return {};
  try {
    return read_starts(file.readAll());
  } catch (const SceneError&) {
    return {};
  }
}

void KeptWork::remove() {
  QFile::remove(file_);
  QFile::remove(starts_of(file_));
  lock_.reset();
}

void KeptWork::set_aside() {
  QFile::remove(starts_of(file_));
  QFile::remove(file_ + ".damaged");
  if (!QFile::rename(file_, file_ + ".damaged")) QFile::remove(file_);
  lock_.reset();
}

std::vector<KeptWork> kept_work(const QString& folder) {
  std::vector<KeptWork> all;
  const QDir dir(folder);
  for (const QFileInfo& entry :
       dir.entryInfoList({QString("work-*") + kSuffix}, QDir::Files, QDir::Time | QDir::Reversed)) {
    std::unique_ptr<QLockFile> lock = locked(entry.absoluteFilePath());
    // Its own window may have removed it meanwhile.
    if (lock != nullptr && QFileInfo::exists(entry.absoluteFilePath()))
      all.emplace_back(entry.absoluteFilePath(), std::move(lock));
  }
  return all;
}

void Autosave::keep(const Preset& preset, const KeptStarts& starts) {
  if (file_.isEmpty()) choose_file();
  if (std::string text = write_preset(preset); text != written_) {
    save_preset(preset, file_.toStdString());
    written_ = std::move(text);
  }
  if (QByteArray text = carom::written_starts(starts); text != written_starts_) {
    write_starts(text);
    written_starts_ = std::move(text);
  }
}

void Autosave::write_starts(const QByteArray& text) {
  QSaveFile file(starts_of(file_));
  if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit()) return;
  throw SceneError(fmt::format("{}: the starts of unsaved work cannot be written: {}",
                               file.fileName().toStdString(), file.errorString().toStdString()));
}

void Autosave::choose_file() {
  QDir().mkpath(folder_);
  const QString stem = QString("%1/work-%2-%3").arg(folder_).arg(QCoreApplication::applicationPid());
  for (int i = 0; i < 1000; ++i) {
    const QString file = stem.arg(i) + kSuffix;
    if (QFileInfo::exists(file)) continue;
    lock_ = locked(file);
    if (lock_ == nullptr) continue;
    file_ = file;
    return;
  }
  throw SceneError(
      fmt::format("{}: unsaved work cannot be kept there; allowed: a folder with the right to write",
                  folder_.toStdString()));
}

void Autosave::forget() {
  if (!file_.isEmpty()) {
    QFile::remove(file_);
    QFile::remove(starts_of(file_));
  }
  file_.clear();
  written_.clear();
  written_starts_.clear();
  lock_.reset();
}

}  // namespace carom
