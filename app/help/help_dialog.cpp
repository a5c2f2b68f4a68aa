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
    {nullptr, QT_TRANSLATE_NOOP("QObject", "Keys")},
    {"hands", QT_TRANSLATE_NOOP("QObject", "Working by hand")},
    {"model", QT_TRANSLATE_NOOP("QObject", "The model")},
    {"presets", QT_TRANSLATE_NOOP("QObject", "Preset files")},
    {"plots", QT_TRANSLATE_NOOP("QObject", "Plots and comparison")},
    {"export", QT_TRANSLATE_NOOP("QObject", "Taking it away")},
    {"study", QT_TRANSLATE_NOOP("QObject", "Speed against error")},
});

constexpr int kKeysRow = 1;

// Whether the block is a line of code within a fence. Qt gives each such line a block of its own.
bool is_code(const QTextBlock& block) { return block.blockFormat().hasProperty(QTextFormat::BlockCodeFence); }

// Adds space between paragraphs, before headings and in tables, which Markdown cannot specify; and lets lines
// of code wrap, where a page is narrow.
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
    const bool code_goes_on = is_code(block) && is_code(block.next());
    format.setTopMargin(format.headingLevel() > 0 ? 16 : is_code(block) ? 0 : 2);
    format.setBottomMargin(code_goes_on ? 0 : block.textList() != nullptr ? 2 : 6);
    format.setNonBreakableLines(false);
    QTextCursor(block).setBlockFormat(format);
  }
}

QString page_text(const char* name) {
  QFile page(QString(":/help/%1.md").arg(name));
  return page.open(QIODevice::ReadOnly) ? QString::fromUtf8(page.readAll()) : QString();
}

// The pages in a list, the shown one, and the search through all of them. Each page is read and laid out once.
class HelpPages {
 public:
  HelpPages(QListWidget& list, QTextBrowser& text, const QString& keys) : list_(list), text_(text) {
    for (const auto& [name, title] : kPages) {
      list_.addItem(QObject::tr(title));
      pages_.push_back({name == nullptr ? keys : page_text(name), nullptr});
    }
    nothing_ = new_document();
  }

  void show(int row) {
    Page& page = pages_[static_cast<std::size_t>(row)];
    if (page.laid_out == nullptr) {
      page.laid_out = new_document();
      page.laid_out->setMarkdown(page.text);
      space_out(*page.laid_out, text_.palette().color(QPalette::Mid));
    }
    if (text_.document() != page.laid_out) text_.setDocument(page.laid_out);
    text_.moveCursor(QTextCursor::Start);
  }

  // Pages without what is looked for are hidden; the first place of it on the shown page is selected.
  void search(const QString& wanted) {
    int first = -1;
    for (int row = 0; row < list_.count(); ++row) {
      const bool has = pages_[static_cast<std::size_t>(row)].text.contains(wanted, Qt::CaseInsensitive);
      list_.item(row)->setHidden(!has);
      if (has && first < 0) first = row;
    }
    if (first < 0) {
      nothing_->setPlainText(QObject::tr("No page has “%1”.").arg(wanted));
      return text_.setDocument(nothing_);
    }
    if (list_.currentItem()->isHidden()) {
      list_.setCurrentRow(first);
    } else {
      show(list_.currentRow());
    }
    if (!wanted.isEmpty()) text_.find(wanted);
  }

  // The next place on this page, else on the next page that has one.
  void search_next(const QString& wanted) {
    if (wanted.isEmpty() || text_.find(wanted)) return;
    for (int k = 1; k <= list_.count(); ++k) {
      const int row = (list_.currentRow() + k) % list_.count();
      if (list_.item(row)->isHidden()) continue;
      list_.setCurrentRow(row);
      text_.moveCursor(QTextCursor::Start);
      text_.find(wanted);
      return;
    }
  }

 private:
  struct Page {
    QString text;
    QTextDocument* laid_out;
  };

  QTextDocument* new_document() {
    auto* document = new QTextDocument(&text_);
    constexpr int kMargin = 18;  // px
    document->setDocumentMargin(kMargin);
    document->setDefaultFont(text_.font());
    return document;
  }

  QListWidget& list_;
  QTextBrowser& text_;
  std::vector<Page> pages_;
  QTextDocument* nothing_;
};

}  // namespace

void show_help(QWidget* parent, const QString& keys, HelpPage page) {
  load_help();
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Help – Carom"));
  dialog->resize(940, 640);
  dialog->setMinimumWidth(760);  // narrower, tables are cut
  auto* list = new QListWidget(dialog);
  list->setObjectName("help-pages");
  list->setSpacing(3);
  auto* wanted = new QLineEdit(dialog);
  wanted->setPlaceholderText(QObject::tr("Search the help"));
  wanted->setClearButtonEnabled(true);
  auto* text = new QTextBrowser(dialog);
  text->setOpenExternalLinks(true);
  text->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // all wraps; Qt takes tables for wider at first
  const auto help = std::make_shared<HelpPages>(*list, *text, keys);
  QObject::connect(list, &QListWidget::currentRowChanged, text, [help](int row) {
    if (row >= 0) help->show(row);
  });
  list->setCurrentRow(page == HelpPage::kKeys ? kKeysRow : 0);
  QObject::connect(wanted, &QLineEdit::textChanged, text, [help](const QString& now) { help->search(now); });
  QObject::connect(wanted, &QLineEdit::returnPressed, text,
                   [wanted, help] { help->search_next(wanted->text()); });
  auto* pages = new QWidget(dialog);
  pages->setFixedWidth(190);
  auto* column = new QVBoxLayout(pages);
  column->setContentsMargins(8, 8, 8, 0);
  column->addWidget(wanted);
  column->addWidget(list, 1);
  auto* row = new QHBoxLayout(dialog);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(pages);
  row->addWidget(text, 1);
  dialog->show();
}

}  // namespace carom
