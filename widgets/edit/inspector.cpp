#include "widgets/edit/inspector.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "widgets/base/elided_label.h"
#include "widgets/edit/driven.h"
#include "widgets/edit/inspected_corners.h"
#include "widgets/edit/inspector_row.h"
#include "widgets/edit/name_field.h"
#include "widgets/edit/typed_field.h"

namespace carom {
namespace {

constexpr int kMargin = 12;       // px
constexpr int kLabelGap = 4;      // px, beside the spacing of the rows
constexpr int kLeastWidth = 260;  // px
constexpr int kRowGap = 5;        // px
constexpr int kNameInsets = 16;   // px, of the name in its field
constexpr int kLeastName = 40;    // px
constexpr int kMostName = 180;    // px

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
  for (const InspectedRow& row : rows) {
    QStringList parts{row.section, row.label, QString::number(row.values.size())};
    if (row.choice) parts << "choice";
    if (row.named) parts << "name";
    parts << QString::number(row.actions.size());
    layout << parts.join('\n');
  }
  return layout;
}

QString shape_word(const Body& body) {
  if (const auto* compound = std::get_if<Compound>(&body.shape)) {
    const auto count = static_cast<int>(compound->shapes.size());
    return count == 1 ? Inspector::tr("1 shape") : Inspector::tr("%1 shapes").arg(count);
  }
  return QString::fromUtf8(kShapeWords[body.shape.index()]);
}

// What takes keys.
QList<QWidget*> fields_of(const QWidget& list) {
  QList<QWidget*> fields = list.findChildren<QWidget*>();
  fields.removeIf([](const QWidget* field) { return (field->focusPolicy() & Qt::TabFocus) == 0; });
  return fields;
}

}  // namespace

Inspector::Inspector(QWidget* parent)
    : QWidget(parent),
      content_(new QWidget),
      column_(new QVBoxLayout(content_)),
      bar_(new QWidget(this)),
      top_(new QHBoxLayout(bar_)),
      back_(new QToolButton(bar_)),
      name_(new NameField(bar_)),
      name_fault_(small_label("fault", this)),
      title_(new ElidedLabel(bar_)),
      kind_(new PlainLabel(bar_)),
      hint_(small_label("muted", this)),
      sentence_(small_label("fault", this)) {
  setMinimumWidth(kLeastWidth);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(0);
  auto* scroll = scroll_ = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(content_);
  // The ground is that of what the inspector stands in.
  scroll->viewport()->setAutoFillBackground(false);
  content_->setAutoFillBackground(false);
  outer->addWidget(bar_);
  outer->addWidget(scroll, 1);
  for (QLabel* line : {hint_, sentence_}) {
    line->setContentsMargins(kMargin, 4, kMargin, 6);
    outer->addWidget(line);
  }
  name_fault_->setContentsMargins(kMargin, 0, kMargin, 0);
  outer->insertWidget(1, name_fault_);
  column_->setContentsMargins(kMargin, 6, kMargin, kMargin);
  column_->setSpacing(kRowGap);
  column_->addStretch(1);
  build_bar();
}

void Inspector::build_bar() {
  bar_->setCursor(Qt::OpenHandCursor);
  back_->setCursor(Qt::ArrowCursor);
  title_->setObjectName("title");
  kind_->setObjectName("muted");
  top_->setSpacing(8);
  top_->setContentsMargins(kMargin, kMargin, kMargin, 0);
  back_->setText(QChar(0x2039));
  back_->setToolTip(tr("Back to the scene (Esc)"));
  back_->setAccessibleName(tr("Back to the scene"));
  back_->hide();
  connect(back_, &QToolButton::clicked, this, [this] { open(std::nullopt); });
  top_->addWidget(back_);
  top_->addWidget(name_);
  top_->addWidget(title_);
  top_->addWidget(kind_, 1);
  name_->setObjectName("title");
  name_->setAccessibleName(tr("Name"));
  name_->setToolTip(tr("A name of its own"));
  name_->hide();
  name_->set_fault([this](const QString& name) {
    if (bodies_.size() != 1) return QString();
    const std::string wanted = name.toStdString();
    const bool own = bodies_.front().name == wanted;
    return own || bodies_named(*scene_, {wanted}).empty() ? QString()
                                                          : tr("Another body is called %1.").arg(name);
  });
  connect(name_, &QLineEdit::textChanged, this, &Inspector::fit_name);
  connect(name_, &TypedField::dropped, this, [this](const QString& sentence) {
    say({});
    set_line(name_fault_, sentence);
  });
  connect(name_, &TypedField::refused, this,
          [this](const QString& sentence) { set_line(name_fault_, sentence); });
  connect(name_, &TypedField::entered, this, &Inspector::left);
  connect(name_, &NameField::named, this, [this](const QString& name) {
    if (bodies_.size() != 1) return;
    const NamedEdits renamed = renaming(bodies_.front(), name);
    say({});
    emit edited(renamed.edits, renamed.name, 0);
  });
}

// As wide as the name, so that what is said of the body follows it.
void Inspector::fit_name() {
  name_->ensurePolished();
  const int width = name_->fontMetrics().horizontalAdvance(name_->text()) + kNameInsets;
  name_->setFixedWidth(std::clamp(width, kLeastName, kMostName));
}

void Inspector::set_group_tools(QWidget* tools) {
  group_tools_ = tools;
  column_->insertWidget(0, tools);
  tools->setVisible(bodies_.size() > 1);
}

void Inspector::show_selection(std::shared_ptr<const Scene> scene, const std::vector<std::string>& names,
                               double time) {
  choose(std::move(scene), names, std::nullopt, time);
}

void Inspector::show_part(std::shared_ptr<const Scene> scene, PartId part) {
  choose(std::move(scene), {}, part, 0.0);
}

void Inspector::show_duration_and_stops(const DurationAndStops& shown) {
  if (duration_and_stops_ == shown) return;
  duration_and_stops_ = shown;
  if (scene_ != nullptr && bodies_.empty() && !part_) show_rows();
}

void Inspector::choose(std::shared_ptr<const Scene> scene, const std::vector<std::string>& names,
                       const std::optional<PartId>& part, double time) {
  if (scene == nullptr) {
    set_frozen(true);
    return;
  }
  const bool other = names != names_ || part != part_;
  if (scene != scene_ || other) {
    // What is typed belongs to what was selected.
    if (other) {
      restore();
      unfolded_.clear();
    }
    scene_ = std::move(scene);
    names_ = names;
    part_ = part;
    bodies_ = bodies_named(*scene_, names_);
    for (Body& body : bodies_) body = moved_by_drive(std::move(body), time);
    if (other) pulled_.reset();
    show_rows();
    if (std::exchange(played_, plays_) || plays_) follow_run();
    if (other) scroll_->verticalScrollBar()->setValue(0);
  }
  set_frozen(false);
}

void Inspector::open(const std::optional<PartId>& part) {
  restore();
  say({});
  part_ = part;
  show_rows();
  scroll_->verticalScrollBar()->setValue(0);
  emit partOpened();
  // Esc leads back from here.
  if (part_) back_->setFocus();
}

void Inspector::fold(const QString& list) {
  if (unfolded_.erase(list) == 0) unfolded_.insert(list);
  show_rows();
}

bool Inspector::event(QEvent* event) {
  // Esc is the inspector's before it is a shortcut of the window.
  const bool asks = event->type() == QEvent::ShortcutOverride;
  if (!asks || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape) return QWidget::event(event);
  event->accept();
  return true;
}

void Inspector::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
  if (shown_part_) return open(std::nullopt);
  emit left();
}

std::vector<InspectedRow> Inspector::rows() const {
  if (shown_part_) return shown_part_->rows;
  std::vector<InspectedRow> rows;
  const auto add = [&rows](std::vector<InspectedRow> more) {
    std::move(more.begin(), more.end(), std::back_inserter(rows));
  };
  if (bodies_.empty()) {
    add(inspected_scene(*scene_));
    if (duration_and_stops_) add(inspected_duration_and_stops(*duration_and_stops_));
    add(inspected_surfaces(*scene_));
    add(listed_parts(*scene_));
  } else {
    rows.push_back(inspected_kind(bodies_));
    add(inspected_bodies(bodies_, keeps_));
    add(inspected_surface(*scene_, bodies_));
    if (const QStringList derived = derived_texts(bodies_); !derived.isEmpty())
      rows.push_back({.text = derived.join("   "), .tip = derived_formulas(bodies_.size() > 1)});
    add(more_of_bodies(bodies_, keeps_));
    if (bodies_.size() == 1) {
      add(inspected_shapes(*scene_, bodies_[0], unfolded_, keeps_));
      if (!std::holds_alternative<Compound>(bodies_[0].shape))
        add(inspected_corners(*scene_, bodies_[0], std::nullopt, unfolded_, keeps_));
    }
    add(more_of_surface(*scene_, bodies_));
  }
  return rows;
}

void Inspector::edit_name() {
  if (bodies_.size() != 1) return;
  name_->setFocus();
  name_->selectAll();
}

void Inspector::watch_changes(bool watch) {
  for (TypedField* field : findChildren<TypedField*>()) field->watch_changes(watch);
}

void Inspector::show_rows() {
  shown_part_.reset();
  if (part_) shown_part_ = inspected_part(*scene_, *part_);
  if (!shown_part_) part_.reset();
  std::vector<InspectedRow> next = rows();
  QStringList layout = layout_of(next);
  const bool alike = list_ != nullptr && layout == layout_;
  // What is typed into a row that goes is not meant for the one that takes its place.
  for (InspectorRow* row : alike ? std::vector<InspectorRow*>() : row_widgets_) row->restore();
  rows_ = std::move(next);
  show_title();
  if (group_tools_ != nullptr) group_tools_->setVisible(bodies_.size() > 1);
  if (!alike) {
    layout_ = std::move(layout);
    const std::optional<Focused> focused = focused_field();
    build_rows();
    if (focused) focus_field(*focused);
  } else {
    for (std::size_t i = 0; i < rows_.size(); ++i) row_widgets_[i]->show_row(rows_[i]);
  }
}

void Inspector::show_title() {
  const QString title = shown_part_ ? shown_part_->title : bodies_.empty() ? tr("Scene") : subject_of(bodies_);
  auto* label = static_cast<ElidedLabel*>(title_);
  if (label->whole() != title) label->set_whole(title);
  if (label->toolTip() != title) label->setToolTip(plain_tip(title));
  const QString kind = shown_part_ ? shown_part_->kind : QString();
  set_line(kind_, bodies_.size() == 1 ? shape_word(bodies_[0]) : kind);
  const bool one = bodies_.size() == 1;
  if (one) {
    name_->show_text(QString::fromStdString(bodies_.front().name));
  } else {
    name_->restore();  // before it loses the focus, which would hand out what is typed
  }
  name_->setVisible(one);
  title_->setVisible(!one);
  back_->setVisible(shown_part_.has_value());
}

void Inspector::build_rows() {
  if (list_ != nullptr) {
    // A field of it may be waiting for its signal to return.
    list_->hide();
    column_->removeWidget(list_);
    list_->deleteLater();
  }
  list_ = new QWidget(content_);
  list_->setObjectName("rows");
  row_widgets_.clear();
  auto* column = new QVBoxLayout(list_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kRowGap);
  QString section;
  int label_width = 0;
  for (const InspectedRow& row : rows_) {
    if (row.section != section) {
      section = row.section;
      auto* head = new ElidedLabel(list_);
      head->set_whole(section);
      head->setObjectName("caption");
      head->setContentsMargins(0, 6, 0, 0);
      column->addWidget(head);
    }
    InspectorRow* widget = add_row(row, static_cast<int>(row_widgets_.size()));
    row_widgets_.push_back(widget);
    column->addWidget(widget);
    label_width = std::max(label_width, widget->label_width());
  }
  label_width += kLabelGap;
  for (InspectorRow* widget : row_widgets_) widget->set_label_width(label_width);
  column_->insertWidget(column_->count() - 1, list_);  // before what stretches
  list_->show();
}

InspectorRow* Inspector::add_row(const InspectedRow& row, int index) {
  InspectorRow* widget = new_row(row, list_);
  connect(widget, &InspectorRow::burst_began, this, [this, index](int field, bool pulled) {
    const Inspected& value = rows_[static_cast<std::size_t>(index)].values[static_cast<std::size_t>(field)];
    ++burst_;
    before_burst_ = value.values;
    pulled_ = pulled ? std::optional(value) : std::nullopt;
    pulled_at_ = {static_cast<std::size_t>(index), static_cast<std::size_t>(field)};
    begin_edit(index, field);
  });
  connect(widget, &InspectorRow::typed, this, [this, index](int field) {
    say({});
    begin_edit(index, field);
  });
  connect(widget, &InspectorRow::changed, this,
          [this, index](int field, const std::vector<double>& values, bool in_burst) {
            accept(index, field, values, in_burst);
          });
  connect(widget, &InspectorRow::edited, this, [this](const NamedEdits& named) {
    // Shown anew before it returns, the row has no longer what it was.
    const NamedEdits made = named;
    say({});
    emit edited(made.edits, made.name, 0);
  });
  connect(widget, &InspectorRow::dropped, this, [this, widget](const QString& sentence) {
    say({});
    if (sentence.isEmpty()) return;
    told_ = widget;
    widget->say(sentence);
  });
  for (const TypedField* field : widget->findChildren<TypedField*>())
    connect(field, &TypedField::entered, this, &Inspector::left);
  connect(widget, &InspectorRow::opened, this, [this](const PartId part) { open(part); });
  connect(widget, &InspectorRow::stopsAsked, this, &Inspector::stopsAsked);
  connect(widget, &InspectorRow::keepsChosen, this, [this](Keeps keeps) {
    keeps_ = keeps;
    show_rows();
    emit keepsChosen(keeps);
  });
  connect(widget, &InspectorRow::folded, this, [this](const QString& list) { fold(list); });
  return widget;
}

std::optional<Inspector::Focused> Inspector::focused_field() const {
  QWidget* field = list_ == nullptr ? nullptr : list_->focusWidget();
  if (field == nullptr || !field->hasFocus()) return std::nullopt;
  return Focused{field->accessibleName(), fields_of(*list_).indexOf(field)};
}

void Inspector::focus_field(const Focused& focused) {
  const QList<QWidget*> fields = fields_of(*list_);
  const auto same = std::find_if(fields.begin(), fields.end(),
                                 [&](const QWidget* field) { return field->accessibleName() == focused.name; });
  QWidget* field = same != fields.end() ? *same : fields.value(focused.place);
  if (field == nullptr) return;
  field->setFocus();
  if (auto* line = qobject_cast<QLineEdit*>(field)) line->selectAll();
}

void Inspector::set_frozen(bool frozen) {
  if (frozen && content_->isEnabled()) restore();
  content_->setEnabled(!frozen);
  name_->setEnabled(!frozen);
  back_->setEnabled(!frozen);
  set_line(hint_, !frozen ? QString() : plays_ ? tr("Pause to edit") : tr("Computing this moment"));
}

// What is pulled while the run plays changes what there is now.
void Inspector::follow_run() {
  if (!pulled_) return;
  const auto [row, field] = pulled_at_;
  if (row < rows_.size() && field < rows_[row].values.size()) pulled_ = rows_[row].values[field];
}

void Inspector::begin_edit(int row, int field) {
  const InspectedRow& shown = rows_[static_cast<std::size_t>(row)];
  if (shown.values[static_cast<std::size_t>(field)].is_of_motion) emit pauseRequested();
}

void Inspector::restore() {
  for (InspectorRow* row : row_widgets_) row->restore();
  name_->restore();
}

void Inspector::say(const QString& sentence) {
  if (hands_out_ && !sentence.isEmpty()) {
    refusal_ = sentence;
    return;
  }
  if (!sentence.isEmpty()) restore();
  if (told_) told_->say({});
  told_ = nullptr;
  set_line(name_fault_, {});
  set_line(sentence_, sentence);
}

void Inspector::accept(int row, int field, const std::vector<double>& values, bool in_burst) {
  const Inspected& value = rows_[static_cast<std::size_t>(row)].values[static_cast<std::size_t>(field)];
  const int drag = in_burst ? burst_ : 0;
  // The receiver may show the scene with these edits before it returns, which makes the rows anew.
  const QString name = value.undo_name(in_burst ? before_burst_ : value.values, values);
  std::function<void()> hand_out = [this, duration = values.front(), name, drag] {
    emit durationEdited(duration, name, drag);
  };
  if (!value.is_duration) {
    const SceneEdits edits = (in_burst && pulled_ ? *pulled_ : value).edits(values);
    // What a pull adds, a surface that was not listed, it changes from then on.
    const bool adds = std::any_of(edits.begin(), edits.end(), [](const SceneEdit& edit) {
      return std::holds_alternative<Add<Material>>(edit);
    });
    if (adds) pulled_.reset();
    hand_out = [this, edits, name, drag] { emit edited(edits, name, drag); };
  }
  say({});
  in_burst ? hand_out() : hand_out_typed(row, field, hand_out);
}

void Inspector::hand_out_typed(int row, int field, const std::function<void()>& hand_out) {
  InspectorRow* widget = row_widgets_[static_cast<std::size_t>(row)];
  refusal_.clear();
  hands_out_ = true;
  hand_out();
  hands_out_ = false;
  if (!refusal_.isEmpty()) widget->refuse(field, refusal_);
}

}  // namespace carom
