#include "app/lab/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
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
QString source_of(const QString& file) { return file + ".source"; }

void remove_files(const QString& file) {
  for (const QString& each : {file, starts_of(file), source_of(file)}) QFile::remove(each);
}

// When the file was written last; empty if there is none.
QString time_of(const QString& file) { return QFileInfo(file).lastModified().toString(Qt::ISODateWithMs); }

QJsonObject read_source(const QString& work) {
  QFile file(source_of(work));
  return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

QByteArray written(const WorkSource& source) {
  const QJsonObject all{{"name", source.name}, {"file", source.file}, {"time", time_of(source.file)}};
  return QJsonDocument(all).toJson();
}

void write_beside(const QString& name, const QByteArray& text) {
  QSaveFile file(name);
  if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit()) return;
  throw SceneError(fmt::format("{}: a part of unsaved work cannot be written: {}", name.toStdString(),
                               file.errorString().toStdString()));
}

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

WorkSource KeptWork::source() const {
  const QJsonObject read = read_source(file_);
  return {read["name"].toString(), read["file"].toString()};
}

bool KeptWork::file_changed() const {
  const QJsonObject read = read_source(file_);
  const QString now = time_of(read["file"].toString());
  return !now.isEmpty() && now != read["time"].toString();
}

void KeptWork::remove() {
  remove_files(file_);
  lock_.reset();
}

void KeptWork::set_aside() {
  QFile::remove(file_ + ".damaged");
  QFile::rename(file_, file_ + ".damaged");
  remove_files(file_);
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

void Autosave::keep(const Preset& preset, const KeptStarts& starts, const WorkSource& source) {
  if (file_.isEmpty()) choose_file();
  if (std::string text = write_preset(preset); text != written_) {
    save_preset(preset, file_.toStdString());
    written_ = std::move(text);
  }
  if (QByteArray text = carom::written_starts(starts); text != written_starts_) {
    write_beside(starts_of(file_), text);
    written_starts_ = std::move(text);
  }
  if (QByteArray text = written(source); text != written_source_) {
    write_beside(source_of(file_), text);
    written_source_ = std::move(text);
  }
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
  if (!file_.isEmpty()) remove_files(file_);
  file_.clear();
  written_.clear();
  written_starts_.clear();
  written_source_.clear();
  lock_.reset();
}

}  // namespace carom
