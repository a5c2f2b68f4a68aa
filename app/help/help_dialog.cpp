#include "app/help/help_dialog.h"

#include <QDialog>
#include <QFile>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>
#include <QVBoxLayout>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "physics/preset/preset.h"

// Links the resources of a static library; must be called outside of any namespace.
static void load_help() { Q_INIT_RESOURCE(help); }

namespace carom {
namespace {

// Files of app/help and their titles, in the order of the list; the page of keys has no file.
constexpr auto kPages = std::to_array<std::pair<const char*, const char*>>({
    {"first-lesson", QT_TRANSLATE_NOOP("QObject", "A first lesson")},
    {"", QT_TRANSLATE_NOOP("QObject", "Keys")},
    {"hands", QT_TRANSLATE_NOOP("QObject", "Working by hand")},
    {"model", QT_TRANSLATE_NOOP("QObject", "The model")},
    {"presets", QT_TRANSLATE_NOOP("QObject", "Preset files")},
    {"plots", QT_TRANSLATE_NOOP("QObject", "Plots and comparison")},
    {"export", QT_TRANSLATE_NOOP("QObject", "Taking it away")},
    {"study", QT_TRANSLATE_NOOP("QObject", "Speed against error")},
});

constexpr int kKeysRow = 1;

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

struct Page {
  QString title;
  QString text;  // Markdown
};

std::vector<Page> pages_with(const QString& keys) {
  std::vector<Page> pages;
  for (const auto& [name, title] : kPages) {
    QFile file(QString(":/help/%1.md").arg(name));
    pages.push_back(
        {QObject::tr(title), file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : keys});
  }
  return pages;
}

void show_page(QTextBrowser& text, const Page& page) {
  text.setMarkdown(page.text);
  space_out(*text.document(), text.palette().color(QPalette::Mid));
  text.moveCursor(QTextCursor::Start);
}

// Pages without what is looked for are hidden; the first place of it on the shown page is selected.
void search(const QString& wanted, const std::vector<Page>& pages, QListWidget& list, QTextBrowser& text) {
  int first = -1;
  for (int row = 0; row < list.count(); ++row) {
    const bool has = pages[static_cast<std::size_t>(row)].text.contains(wanted, Qt::CaseInsensitive);
    list.item(row)->setHidden(!has);
    if (has && first < 0) first = row;
  }
  // Rendering a page takes longer than all the searches: it is done only where another page is shown.
  if (first < 0) {
    list.setCurrentRow(-1);
    return text.setPlainText(QObject::tr("No page has “%1”.").arg(wanted));
  }
  if (list.currentRow() < 0 || list.currentItem()->isHidden()) list.setCurrentRow(first);
  text.moveCursor(QTextCursor::Start);
  if (!wanted.isEmpty()) text.find(wanted);
}

// The next place on this page, else on the next page that has one.
void search_next(const QString& wanted, QListWidget& list, QTextBrowser& text) {
  if (wanted.isEmpty() || text.find(wanted)) return;
  for (int k = 1; k <= list.count(); ++k) {
    const int row = (list.currentRow() + k) % list.count();
    if (list.item(row)->isHidden()) continue;
    list.setCurrentRow(row);
    text.moveCursor(QTextCursor::Start);
    text.find(wanted);
    return;
  }
}

}  // namespace

void show_help(QWidget* parent, const QString& keys, HelpPage page) {
  load_help();
  const auto pages = std::make_shared<const std::vector<Page>>(pages_with(keys));
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Help – Carom"));
  dialog->resize(940, 640);
  auto* list = new QListWidget(dialog);
  list->setObjectName("help-pages");
  list->setSpacing(3);
  auto* wanted = new QLineEdit(dialog);
  wanted->setPlaceholderText(QObject::tr("Search the help"));
  wanted->setClearButtonEnabled(true);
  for (const Page& each : *pages) list->addItem(each.title);
  auto* text = new QTextBrowser(dialog);
  text->setOpenExternalLinks(true);
  text->document()->setDocumentMargin(18);
  QObject::connect(list, &QListWidget::currentRowChanged, text, [pages, text](int row) {
    if (row >= 0) show_page(*text, (*pages)[static_cast<std::size_t>(row)]);
  });
  list->setCurrentRow(page == HelpPage::kKeys ? kKeysRow : 0);
  QObject::connect(wanted, &QLineEdit::textChanged, text,
                   [pages, list, text](const QString& now) { search(now, *pages, *list, *text); });
  QObject::connect(wanted, &QLineEdit::returnPressed, text,
                   [wanted, list, text] { search_next(wanted->text(), *list, *text); });
  auto* side = new QWidget(dialog);
  side->setFixedWidth(190);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(8, 8, 8, 0);
  column->addWidget(wanted);
  column->addWidget(list, 1);
  auto* row = new QHBoxLayout(dialog);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(side);
  row->addWidget(text, 1);
  dialog->show();
}

}  // namespace carom
