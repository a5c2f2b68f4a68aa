#include "app/help/help_dialog.h"

#include <QDialog>
#include <QFile>
#include <QHBoxLayout>
#include <QListWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>
#include <array>
#include <utility>

#include "physics/preset/preset.h"

// Links the resources of a static library; must be called outside of any namespace.
static void load_help() { Q_INIT_RESOURCE(help); }

namespace carom {
namespace {

// Files of app/help and their titles, in the order of the list.
constexpr auto kPages = std::to_array<std::pair<const char*, const char*>>({
    {"hands", QT_TRANSLATE_NOOP("QObject", "Working by hand")},
    {"model", QT_TRANSLATE_NOOP("QObject", "The model")},
    {"presets", QT_TRANSLATE_NOOP("QObject", "Preset files")},
    {"plots", QT_TRANSLATE_NOOP("QObject", "Plots and comparison")},
    {"export", QT_TRANSLATE_NOOP("QObject", "Taking it away")},
    {"study", QT_TRANSLATE_NOOP("QObject", "Speed against error")},
    {"stress", QT_TRANSLATE_NOOP("QObject", "The hard cases")},
    {"stress-figures", QT_TRANSLATE_NOOP("QObject", "The hard cases: figures")},
});

// Adds space between paragraphs, before headings and in tables, which Markdown cannot specify.
void space_out(QTextDocument& document, const QColor& lines) {
  for (QTextFrame* frame : document.rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat format = table->format();
    format.setBorderCollapse(true);
    format.setBorder(1.0);
    format.setBorderBrush(lines);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setCellPadding(4.0);
    format.setTopMargin(6.0);
    format.setBottomMargin(10.0);
    table->setFormat(format);
  }
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    QTextBlockFormat format = block.blockFormat();
    format.setTopMargin(format.headingLevel() > 0 ? 16 : 2);
    format.setBottomMargin(block.textList() != nullptr ? 2 : 6);
    QTextCursor(block).setBlockFormat(format);
  }
}

void show_page(QTextBrowser& text, const char* name) {
  QFile page(QString(":/help/%1.md").arg(name));
  if (page.open(QIODevice::ReadOnly)) text.setMarkdown(QString::fromUtf8(page.readAll()));
  space_out(*text.document(), text.palette().color(QPalette::Mid));
  text.moveCursor(QTextCursor::Start);
}

}  // namespace

void show_help(QWidget* parent) {
  load_help();
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Help – Carom"));
  dialog->resize(940, 640);
  auto* list = new QListWidget(dialog);
  list->setObjectName("help-pages");
  list->setFixedWidth(190);
  list->setSpacing(3);
  for (const auto& [name, title] : kPages) list->addItem(QObject::tr(title));
  auto* text = new QTextBrowser(dialog);
  text->setOpenExternalLinks(true);
  text->document()->setDocumentMargin(18);
  QObject::connect(list, &QListWidget::currentRowChanged, text, [text](int row) {
    if (row >= 0) show_page(*text, kPages[static_cast<std::size_t>(row)].first);
  });
  list->setCurrentRow(0);
  auto* row = new QHBoxLayout(dialog);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(list);
  row->addWidget(text, 1);
  dialog->show();
}

}  // namespace carom
