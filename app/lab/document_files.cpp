#include "app/lab/document_files.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>
#include <memory>

#include "app/lab/session.h"
#include "app/library/preset_library.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"
#include "widgets/base/ask.h"

namespace carom {

QString file_stem_of(const Session& session) {
  QString name = session.name();
  if (name.isEmpty()) {
    static const QRegularExpression other("[^\\p{L}\\p{N}]+");
    name = QString::fromStdString(session.document().title).toLower().replace(other, " ").trimmed();
    name.replace(' ', '-').truncate(60);
  }
  return name.isEmpty() ? QStringLiteral("experiment") : name;
}

DocumentFiles::DocumentFiles(QWidget* window, Session& session)
    : QObject(window), window_(window), session_(session) {}

bool DocumentFiles::open(const std::string& file_or_name) {
  try {
    const std::filesystem::path file = find_preset(file_or_name);
    const Preset preset = read_preset(file);
    const std::vector<LibraryEntry> library = preset_library();
    const bool built_in =
        std::any_of(library.begin(), library.end(), [&](const auto& e) { return e.file == file; });
    const auto name = QString::fromStdString(built_in ? file.stem().string() : "");
    const auto own = built_in ? QString() : QString::fromStdString(file.string());
    const auto done = std::make_shared<bool>(false);
    when_saved([=, this] {
      *done = true;
      remember(own);
      emit opened(preset, name, own);
    });
    return *done;
  } catch (const SceneError& error) {
    show_message(window_, tr("This preset cannot be opened"), tr("This preset cannot be opened."),
                 QString::fromStdString(error.what()));
    emit stayed();
    return false;
  }
}

void DocumentFiles::remember(const QString& file) {
  if (file.isEmpty()) return;
  constexpr qsizetype kMost = 8;
  const QString whole = QFileInfo(file).absoluteFilePath();
  recent_.removeAll(whole);
  recent_.prepend(whole);
  while (recent_.size() > kMost) recent_.removeLast();
}

// Begins in the folder of the present file, or of the last one.
void DocumentFiles::choose() {
  auto* dialog =
      new QFileDialog(window_, tr("Open a preset"),
                      QFileInfo(session_.file().isEmpty() ? recent_.value(0) : session_.file()).path(),
                      tr("Carom presets (*.json);;All files (*)"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  ask(dialog, [this, dialog] {
    open(QFileInfo(dialog->selectedFiles().constFirst()).absoluteFilePath().toStdString());
  });
}

// Where it cannot be written another name is offered.
bool DocumentFiles::write(const QString& file, const std::function<void()>& then) {
  try {
    session_.save(file);
  } catch (const SceneError& error) {
    show_message(window_, tr("This preset cannot be saved"), QString::fromStdString(error.what()), {},
                 {tr("Save as..."), [this, then] { save_as(then); }});
    return false;
  }
  remember(file);
  emit saved(file);
  then();
  return true;
}

bool DocumentFiles::save(const std::function<void()>& then) {
  if (!session_.file().isEmpty()) return write(session_.file(), then);
  save_as(then);
  return false;
}

void DocumentFiles::save_as(const std::function<void()>& then) {
  ask_for_file(window_, tr("Save the preset"),
               session_.file().isEmpty() ? file_stem_of(session_) + ".json" : session_.file(),
               {{tr("Carom presets (*.json)"), "json"}},
               [this, then](const QString& file) { write(file, then); });
}

void DocumentFiles::when_saved(const std::function<void()>& then) {
  if (!session_.modified()) return then();
  if (asking_ != nullptr) return;
  asking_ = new QMessageBox(QMessageBox::NoIcon, tr("Save the changes?"),
                            tr("This experiment was changed. Save it before it is closed?"),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  asking_->setDefaultButton(QMessageBox::Save);
  asking_->setAttribute(Qt::WA_DeleteOnClose);
  connect(asking_, &QMessageBox::finished, this, [this, then](int answer) {
    asking_ = nullptr;
    emit stayed();
    if (answer == QMessageBox::Save) save(then);
    if (answer == QMessageBox::Discard) then();
  });
  asking_->open();
}

}  // namespace carom
