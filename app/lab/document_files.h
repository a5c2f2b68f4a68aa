#pragma once

#include <QMessageBox>
#include <QObject>
#include <QPointer>
#include <functional>
#include <string>

#include "physics/preset/preset.h"

namespace carom {

class Session;

// Opens presets and saves the document of a session. What goes wrong is told in a message; what was changed is
// asked about before another document takes its place.
class DocumentFiles : public QObject {
  Q_OBJECT

 public:
  DocumentFiles(QWidget* window, Session& session);

  // A built-in experiment or a file. True if it was opened at once; it may be later, once the user has
  // answered.
  bool open(const std::string& file_or_name);
  void choose();
  // True if it is written; a document without a file asks for one, and calls `then` once it is saved.
  bool save(const std::function<void()>& then = [] {});
  void save_as(const std::function<void()>& then = [] {});
  // When nothing can be lost any more: saved, or given up. Not where the user cancels.
  void when_saved(const std::function<void()>& then);

 signals:
  // `name` of a built-in experiment, else `file`.
  void opened(const carom::Preset& preset, const QString& name, const QString& file);
  void stayed();  // what was asked for is not opened

 private:
  bool write(const QString& file);

  QWidget* window_;
  Session& session_;
  QPointer<QMessageBox> asking_;
};

}  // namespace carom
