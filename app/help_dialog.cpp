#include "app/help_dialog.h"

#include <QDialog>
#include <QFile>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextDocument>
#include <QVBoxLayout>

// Resources of a static library are linked only where this is called; it must stand outside of any namespace.
static void load_help() { Q_INIT_RESOURCE(help); }

namespace carom {
namespace {

// Room between paragraphs and before headings, which Markdown alone does not give.
void space_out(QTextDocument& document) {
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    QTextBlockFormat format = block.blockFormat();
    format.setTopMargin(format.headingLevel() > 0 ? 16 : 2);
    format.setBottomMargin(block.textList() != nullptr ? 2 : 6);
    QTextCursor(block).setBlockFormat(format);
  }
}

}  // namespace

void show_help(QWidget* parent) {
  load_help();
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("The model – Carom"));
  dialog->resize(760, 640);
  auto* text = new QTextBrowser(dialog);
  text->setOpenExternalLinks(true);
  text->document()->setDocumentMargin(18);
  QFile page(":/help/model.md");
  if (page.open(QIODevice::ReadOnly)) text->setMarkdown(QString::fromUtf8(page.readAll()));
  space_out(*text->document());
  auto* column = new QVBoxLayout(dialog);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(text);
  dialog->show();
}

}  // namespace carom
