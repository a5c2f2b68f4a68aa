#include "widgets/run/experiment_list.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "widgets/base/plain_text.h"

namespace carom {
namespace {

// kOpen: the experiment that is open; another row may be chosen with the arrows until Enter opens it.
enum Role { kName = Qt::UserRole, kTitle, kObserve, kPicture, kOpen };

constexpr int kRowHeight = 50;
constexpr int kTallRowHeight = 64;  // with a title of two lines
constexpr int kTopicHeight = 30;
constexpr int kTextLeft = 79;  // from the row's left side to its text
constexpr int kTextRight = 12;
constexpr int kPictureWidth = 52;
constexpr int kPictureHeight = 36;

// Words of the search, and what is written where they are meant.
struct Meaning {
  const char* word = nullptr;
  std::array<const char*, 2> written{};  // null: no other
};
constexpr std::array<Meaning, 6> kMeanings = {{
    {"restitution", {"e = ", "inelastic"}},
    {"inelastic", {"e = 0", nullptr}},
    {"bounce", {"bouncing", "restitution"}},
    {"collision", {"strikes", "meets"}},
    {"rotation", {"spin", nullptr}},
    {"gravity", {"is dropped", nullptr}},
}};

// Whether the text has the word, or another one for it.
bool speaks_of(const QString& text, const QString& word) {
  if (text.contains(word, Qt::CaseInsensitive)) return true;
  constexpr qsizetype kFromLetters = 5;  // fewer begin too many words
  return word.size() >= kFromLetters &&
         std::any_of(kMeanings.begin(), kMeanings.end(), [&](const Meaning& meaning) {
           return QLatin1String(meaning.word).startsWith(word, Qt::CaseInsensitive) &&
                  std::any_of(meaning.written.begin(), meaning.written.end(), [&](const char* written) {
                    return written != nullptr && text.contains(QLatin1String(written), Qt::CaseInsensitive);
                  });
         });
}

// Draws a topic's caption, or an experiment with picture, title and what to observe.
class ExperimentDelegate : public QStyledItemDelegate {
 public:
  ExperimentDelegate(const Theme* theme, QObject* parent) : QStyledItemDelegate(parent), theme_(theme) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    if (index.data(kName).toString().isEmpty()) return {100, kTopicHeight};
    const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
    const int width = view == nullptr ? 0 : view->viewport()->width() - kTextLeft - kTextRight;
    QFont bold = option.font;
    bold.setBold(true);
    return {100, QFontMetrics(bold).horizontalAdvance(index.data(kTitle).toString()) > width ? kTallRowHeight
                                                                                             : kRowHeight};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRect r = option.rect;
    QFont small = option.font;
    small.setPixelSize(11);
    if (index.data(kName).toString().isEmpty()) {
      painter->setFont(small);
      painter->setPen(theme_->muted);
      painter->drawText(r.adjusted(14, 0, -8, -6), Qt::AlignLeft | Qt::AlignBottom,
                        index.data(kTitle).toString());
      painter->restore();
      return;
    }
    const QRect row = r.adjusted(10, 1, -10, -1);
    const bool chosen = (option.state & QStyle::State_Selected) != 0;
    const bool is_open = index.data(kOpen).toBool();
    painter->setPen(Qt::NoPen);
    if (chosen || is_open || (option.state & QStyle::State_MouseOver) != 0) {
      QColor ground = theme_->accent_ground;
      if (!is_open) ground.setAlphaF(0.5F);
      painter->setBrush(ground);
      if (chosen && !is_open) painter->setPen(QPen(theme_->accent, 1.0));
      painter->drawRoundedRect(QRectF(row).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    }
    if (is_open) {
      painter->setPen(Qt::NoPen);
      painter->setBrush(theme_->accent);
      painter->drawRoundedRect(QRectF(row.left(), row.top() + 4, 3, row.height() - 8), 1.5, 1.5);
    }
    const QRect frame(row.left() + 7, row.center().y() - kPictureHeight / 2 + 1, kPictureWidth, kPictureHeight);
    const auto picture = index.data(kPicture).value<QPixmap>();
    if (!picture.isNull()) painter->drawPixmap(frame, picture);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(theme_->border);
    painter->drawRoundedRect(QRectF(frame).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);

    const QRect text(r.left() + kTextLeft, row.top() + 6, r.width() - kTextLeft - kTextRight,
                     row.height() - 12);
    QFont bold = option.font;
    bold.setBold(true);
    painter->setFont(bold);
    painter->setPen(theme_->text);
    painter->drawText(text, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, index.data(kTitle).toString());
    painter->setFont(small);
    painter->setPen(theme_->muted);
    const QFontMetrics small_metrics(small);
    painter->drawText(text, Qt::AlignLeft | Qt::AlignBottom,
                      small_metrics.elidedText(index.data(kObserve).toString(), Qt::ElideRight, text.width()));
    painter->restore();
  }

 private:
  const Theme* theme_;
};

}  // namespace

ExperimentList::ExperimentList(const Theme& theme, QWidget* parent)
    : QFrame(parent), theme_(theme), search_(new QLineEdit(this)), list_(new QListWidget(this)) {
  setObjectName("sidebar");
  search_->setPlaceholderText(tr("Search experiments"));
  search_->setAccessibleName(tr("Search experiments"));
  list_->setAccessibleName(tr("Experiments"));
  search_->setClearButtonEnabled(true);
  list_->setItemDelegate(new ExperimentDelegate(&theme_, list_));
  list_->setMouseTracking(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 10, 1, 1);
  column->setSpacing(4);
  auto* field = new QVBoxLayout;
  field->setContentsMargins(10, 0, 10, 0);
  field->addWidget(search_);
  column->addLayout(field);
  column->addWidget(list_, 1);
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(10, 4, 10, 8);
  const auto add_button = [&](const QString& text, void (ExperimentList::*asked)()) {
    auto* button = new QPushButton(text, this);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, asked);
    foot->addWidget(button);
  };
  add_button(tr("Empty scene"), &ExperimentList::newRequested);
  add_button(tr("Open..."), &ExperimentList::fileRequested);
  foot->addStretch(1);
  column->addLayout(foot);
  search_->installEventFilter(this);
  list_->installEventFilter(this);
  rest_.setSingleShot(true);
  constexpr int kRest = 200;  // ms
  rest_.setInterval(kRest);
  connect(&rest_, &QTimer::timeout, this, [this] {
    const QListWidgetItem* marked = list_->currentItem();
    const QString name = marked == nullptr ? QString() : marked->data(kName).toString();
    if (isAncestorOf(QApplication::focusWidget())) emit previewRequested(name);
  });
  connect(search_, &QLineEdit::textChanged, this, [this] {
    fill();
    rest_.start();
  });
  const auto open = [this](QListWidgetItem* item) {
    const QString name = item->data(kName).toString();
    if (name.isEmpty()) return;
    rest_.stop();
    emit openRequested(name);
    search_->clear();
    set_current(current_);  // the mark stays at the open experiment if this one was not opened
  };
  connect(list_, &QListWidget::itemClicked, this, open);
  connect(list_, &QListWidget::itemActivated, this, open);
}

void ExperimentList::set_theme(const Theme& theme) {
  theme_ = theme;
  list_->viewport()->update();
}

void ExperimentList::set_items(std::vector<ExperimentItem> items) {
  items_ = std::move(items);
  fill();
}

void ExperimentList::set_pictures(const std::vector<QPixmap>& pictures) {
  pictures_ = pictures;
  fill();
}

void ExperimentList::set_current(const QString& name) {
  current_ = name;
  QListWidgetItem* found = nullptr;
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    const bool is_open = !name.isEmpty() && item->data(kName).toString() == name;
    item->setData(kOpen, is_open);
    if (is_open) found = item;
  }
  rest_.stop();
  const QStringList words = search_words();
  if (!words.isEmpty()) return mark_best(words);
  list_->setCurrentItem(found);
  if (found == nullptr) list_->clearSelection();
}

void ExperimentList::set_over(bool over) {
  if (property("over").toBool() == over) return;
  setProperty("over", over);
  style()->unpolish(this);
  style()->polish(this);
}

void ExperimentList::begin_search() {
  search_->setFocus(Qt::ShortcutFocusReason);
  search_->selectAll();
}

void ExperimentList::open_marked() {
  rest_.stop();
  if (QListWidgetItem* item = list_->currentItem()) emit list_->itemActivated(item);
}

bool ExperimentList::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Down:
      choose_next(1);
      return true;
    case Qt::Key_Up:
      choose_next(-1);
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (list_->currentItem() == nullptr) choose_next(1);
      open_marked();
      return true;
    case Qt::Key_Escape:
      rest_.stop();
      emit closeRequested();
      return true;
    default:
      return QFrame::eventFilter(watched, event);
  }
}

void ExperimentList::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QFrame::keyPressEvent(event);
  rest_.stop();
  emit closeRequested();
}

// Captions of topics are no experiments.
void ExperimentList::choose_next(int way) {
  int row = list_->currentRow();
  do {
    row += way;
    if (row < 0 || row >= list_->count()) return;
  } while (list_->item(row)->data(kName).toString().isEmpty());
  list_->setCurrentRow(row);
  rest_.start();
}

QStringList ExperimentList::search_words() const { return search_->text().split(' ', Qt::SkipEmptyParts); }

void ExperimentList::fill() {
  const QStringList words = search_words();
  rest_.stop();
  list_->clear();
  QString topic;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const ExperimentItem& item = items_[i];
    const QString all = QStringList{item.title, item.observe, item.topic, item.name, item.about}.join('\n');
    const bool match =
        std::all_of(words.begin(), words.end(), [&all](const QString& word) { return speaks_of(all, word); });
    if (!match) continue;
    if (item.topic != topic) {
      topic = item.topic;
      auto* caption = new QListWidgetItem(list_);
      caption->setData(kTitle, topic);
      caption->setData(Qt::AccessibleTextRole, topic);
      caption->setFlags(Qt::NoItemFlags);
    }
    auto* row = new QListWidgetItem(list_);
    row->setData(kName, item.name);
    row->setData(kTitle, item.title);
    row->setData(kObserve, item.observe);
    row->setToolTip(plain_tip(item.title + (item.observe.isEmpty() ? QString() : "\n" + item.observe)));
    row->setData(Qt::AccessibleTextRole, item.title);
    row->setData(Qt::AccessibleDescriptionRole, item.observe);
    if (i < pictures_.size()) row->setData(kPicture, pictures_[i]);
  }
  if (list_->count() == 0 && !items_.empty()) {
    auto* none = new QListWidgetItem(list_);
    const QString said = tr("No experiment speaks of “%1”.").arg(search_->text().trimmed());
    none->setData(kTitle, said);
    none->setData(Qt::AccessibleTextRole, said);
    none->setFlags(Qt::NoItemFlags);
  }
  set_current(current_);
}

// What Enter opens: of the experiments that are found, the first one whose title has all words, else the first.
void ExperimentList::mark_best(const QStringList& words) {
  QListWidgetItem* best = nullptr;
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    if (item->data(kName).toString().isEmpty()) continue;
    const QString title = item->data(kTitle).toString();
    const bool titled = std::all_of(words.begin(), words.end(), [&title](const QString& word) {
      return title.contains(word, Qt::CaseInsensitive);
    });
    if (best == nullptr || titled) best = item;
    if (titled) break;
  }
  list_->setCurrentItem(best);
}

}  // namespace carom
