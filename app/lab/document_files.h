#pragma once

#include <QMessageBox>
#include <QObject>
#include <QPointer>
#include <functional>
#include <string>

#include "physics/preset/preset.h"

namespace carom {

class Session;

// What a file of its document, or made from it, is called, without a suffix: the name of the built-in
// experiment, or from the title: "Two carts, e = 1" is two-carts-e-1.
[[nodiscard]] QString file_stem_of(const Session& session);

// Opens presets and saves the document of a session. Errors are shown in a message. Asks about unsaved changes
// before another document replaces the present one.
class DocumentFiles : public QObject {
  Q_OBJECT

 public:
  DocumentFiles(QWidget* window, Session& session);

  // A built-in experiment or a file. Returns true if it was opened at once; otherwise it may open later, once
  // the user has answered.
  bool open(const std::string& file_or_name);
  void choose();
  // Returns true if it is written; a document without a file asks for one, and calls `then` once it is saved.
  bool save(const std::function<void()>& then = [] {});
  void save_as(const std::function<void()>& then = [] {});
  // The files that were opened and saved of late, the newest first.
  [[nodiscard]] const QStringList& recent() const { return recent_; }
  void set_recent(const QStringList& files) { recent_ = files; }
  // Calls `then` when the work is saved or discarded, not if the user cancels.
  void when_saved(const std::function<void()>& then);

 signals:
  // `name` of a built-in experiment, else `file`.
  void opened(const carom::Preset& preset, const QString& name, const QString& file);
  void saved(const QString& file);
  void stayed();  // the requested document was not opened

 private:
  bool write(const QString& file, const std::function<void()>& then);
  void remember(const QString& file);

  QWidget* window_;
  Session& session_;
  QPointer<QMessageBox> asking_;
  QStringList recent_;
};

}  // namespace carom
