#include "widgets/base/ask.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

namespace carom {

void ask(QDialog* dialog, const std::function<void()>& then) {
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &QDialog::accepted, dialog, then);
  dialog->open();
}

void show_message(QWidget* parent, const QString& title, const QString& text, const QString& details,
                  const Offer& offer) {
  auto* box = new QMessageBox(parent);
  box->setWindowTitle(title);
  box->setTextFormat(Qt::PlainText);
  box->setText(details.isEmpty() ? text : text + "\n\n" + details);
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  if (!offer.text.isEmpty()) {
    const QPushButton* accept = box->addButton(offer.text, QMessageBox::ActionRole);
    QObject::connect(accept, &QPushButton::clicked, parent, offer.accept);
    box->addButton(QMessageBox::Cancel);
  }
  ask(box, [] {});
}

void ask_for_file(QWidget* parent, const QString& title, const QString& suggestion,
                  const std::vector<FileKind>& kinds, const std::function<void(const QString&)>& then) {
  auto* dialog = new QFileDialog(parent, title);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  QStringList filters;
  for (const FileKind& kind : kinds) filters << kind.filter;
  dialog->setNameFilters(filters);
  dialog->setDefaultSuffix(
      kinds.front().suffix);  // set in the dialog, so that it asks before it replaces a file
  QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, kinds](const QString& chosen) {
    for (const FileKind& kind : kinds) {
      if (kind.filter == chosen) dialog->setDefaultSuffix(kind.suffix);
    }
  });
  dialog->selectFile(suggestion);
  ask(dialog, [dialog, then] { then(dialog->selectedFiles().constFirst()); });
}

}  // namespace carom
