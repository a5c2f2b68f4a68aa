#include "widgets/edit/inspector.h"

#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "widgets/base/elided_label.h"
#include "widgets/edit/body_head.h"
#include "widgets/edit/value_row.h"

namespace carom {
namespace {

constexpr int kMargin = 12;       // px
constexpr int kLabelGap = 4;      // px, beside the spacing of the rows
constexpr int kLeastWidth = 260;  // px

void set_line(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
  label->setVisible(!text.isEmpty());
}

QLabel* small_label(const char* look, QWidget* parent) {
  auto* label = new PlainLabel(parent);
  label->setObjectName(look);
  label->setWordWrap(true);
  label->hide();
  return label;
}

// Which fields rows have: rows with the same layout are shown by the same widgets.
QStringList layout_of(const std::vector<InspectedRow>& rows) {
  QStringList layout;
  for (const InspectedRow& row : rows)
    layout << row.section + '\n' + row.label + '\n' + QString::number(row.values.size());
  return layout;
}

QString shape_word(const Body& body) {
  constexpr std::array kWords = {"disc", "box", "polygon", "wall"};
  return QString::fromUtf8(kWords[body.shape.index()]);
}

}  // namespace

Inspector::Inspector(QWidget* parent)
    : QWidget(parent),
      content_(new QWidget),
      column_(new QVBoxLayout(content_)),
      title_(new ElidedLabel(content_)),
      kind_(new PlainLabel(content_)),
      head_(new BodyHead(content_)),
      derived_(small_label("derived", content_)),
      hint_(small_label("muted", this)),
      sentence_(small_label("fault", this)) {
  setMinimumWidth(kLeastWidth);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(0);
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(content_);
  // The ground is that of what the inspector stands in.
  scroll->viewport()->setAutoFillBackground(false);
  content_->setAutoFillBackground(false);
  outer->addWidget(scroll, 1);
  for (QLabel* line : {hint_, sentence_}) {
    line->setContentsMargins(kMargin, 4, kMargin, 6);
    outer->addWidget(line);
  }

  title_->setObjectName("title");
  kind_->setObjectName("muted");
  auto* top = new QHBoxLayout;
  top->setSpacing(8);
  top->addWidget(title_);
  top->addWidget(kind_, 1);
  column_->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column_->setSpacing(6);
  column_->addLayout(top);
  column_->addWidget(head_);
  column_->addWidget(derived_);
  column_->addStretch(1);
  head_->hide();
  connect(head_, &BodyHead::edited, this, [this](const SceneEdits& edits, const QString& name) {
    say({});
    emit edited(edits, name, 0);
  });
  connect(head_, &BodyHead::dropped, this, &Inspector::say);
}

void Inspector::show_selection(std::shared_ptr<const Scene> scene, const std::vector<std::string>& names) {
  if (scene == nullptr) {
    set_frozen(true);
    return;
  }
  if (scene != scene_ || names != names_) {
    // What is typed belongs to the bodies that were selected.
    if (names != names_) restore();
    scene_ = std::move(scene);
    names_ = names;
    bodies_ = bodies_named(*scene_, names_);
    show_rows();
  }
  set_frozen(false);
}

void Inspector::show_rows() {
  rows_ = bodies_.empty() ? inspected_scene(*scene_) : inspected_bodies(bodies_);
  for (InspectedRow& row : inspected_surface(*scene_, bodies_)) rows_.push_back(std::move(row));
  show_title();
  head_->setVisible(!bodies_.empty());
  if (!bodies_.empty()) head_->show_bodies(scene_, bodies_);
  if (QStringList layout = layout_of(rows_); layout != layout_ || list_ == nullptr) {
    layout_ = std::move(layout);
    const QString focused = focused_field();
    build_rows();
    focus_field(focused);
  } else {
    for (std::size_t i = 0; i < rows_.size(); ++i) row_widgets_[i]->show_row(rows_[i]);
  }
  set_line(derived_, derived_texts(bodies_).join("   "));
}

void Inspector::show_title() {
  const QString title = bodies_.empty() ? tr("Scene") : subject_of(bodies_);
  auto* label = static_cast<ElidedLabel*>(title_);
  if (label->whole() != title) label->set_whole(title);
  if (label->toolTip() != title) label->setToolTip(plain_tip(title));
  set_line(kind_, bodies_.size() == 1 ? shape_word(bodies_[0]) : QString());
}

void Inspector::build_rows() {
  if (list_ != nullptr) {
    // A field of it may be waiting for its signal to return.
    list_->hide();
    column_->removeWidget(list_);
    list_->deleteLater();
  }
  list_ = new QWidget(content_);
  row_widgets_.clear();
  auto* column = new QVBoxLayout(list_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  QString section;
  int label_width = bodies_.empty() ? 0 : head_->label_width();
  for (const InspectedRow& row : rows_) {
    if (row.section != section) {
      section = row.section;
      auto* head = new ElidedLabel(list_);
      head->set_whole(section);
      head->setObjectName("caption");
      head->setContentsMargins(0, 6, 0, 0);
      column->addWidget(head);
    }
    auto* widget = new ValueRow(row, list_);
    const int index = static_cast<int>(row_widgets_.size());
    row_widgets_.push_back(widget);
    column->addWidget(widget);
    label_width = std::max(label_width, widget->label_width());
    connect(widget, &ValueRow::burst_began, this, [this, index](int field) {
      ++burst_;
      before_burst_ = rows_[static_cast<std::size_t>(index)].values[static_cast<std::size_t>(field)].values;
    });
    connect(widget, &ValueRow::changed, this,
            [this, index](int field, const std::vector<double>& values, bool in_burst) {
              accept(index, field, values, in_burst);
            });
    connect(widget, &ValueRow::dropped, this, &Inspector::say);
  }
  label_width += kLabelGap;
  for (ValueRow* widget : row_widgets_) widget->set_label_width(label_width);
  head_->set_label_width(label_width);
  column_->insertWidget(column_->indexOf(derived_), list_);
  list_->show();
}

QString Inspector::focused_field() const {
  const QWidget* field = list_ == nullptr ? nullptr : list_->focusWidget();
  return field != nullptr && field->hasFocus() ? field->accessibleName() : QString();
}

void Inspector::focus_field(const QString& name) {
  if (name.isEmpty()) return;
  for (QLineEdit* field : list_->findChildren<QLineEdit*>()) {
    if (field->accessibleName() == name) field->setFocus();
  }
}

void Inspector::set_frozen(bool frozen) {
  if (frozen && content_->isEnabled()) restore();
  content_->setEnabled(!frozen);
  set_line(hint_, frozen ? tr("Pause to edit") : QString());
}

void Inspector::restore() {
  for (ValueRow* row : row_widgets_) row->restore();
  head_->restore();
}

void Inspector::say(const QString& sentence) {
  if (!sentence.isEmpty()) restore();
  set_line(sentence_, sentence);
}

void Inspector::accept(int row, int field, const std::vector<double>& values, bool in_burst) {
  const Inspected& value = rows_[static_cast<std::size_t>(row)].values[static_cast<std::size_t>(field)];
  // The receiver may show the scene with these edits before it returns, which makes the rows anew.
  const SceneEdits edits = value.edits(values);
  const QString name = value.undo_name(in_burst ? before_burst_ : value.values, values);
  say({});
  emit edited(edits, name, in_burst ? burst_ : 0);
}

}  // namespace carom
