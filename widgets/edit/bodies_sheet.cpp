#include "widgets/edit/bodies_sheet.h"

#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/base/plain_text.h"
#include "widgets/edit/bodies_grid.h"

namespace carom {

BodiesSheet::BodiesSheet(const Theme& theme, QWidget* parent)
    : QWidget(parent),
      grid_(new BodiesGrid(this)),
      sentence_(new PlainLabel(this)),
      all_(new QPushButton(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  auto* line = new QHBoxLayout;
  line->setSpacing(2);
  line->addWidget(grid_, 1);
  line->addWidget(new_columns_button(), 0, Qt::AlignTop);
  column->addLayout(line, 1);
  auto* foot = new QHBoxLayout;
  foot->setSpacing(8);
  foot->addWidget(sentence_, 1);
  foot->addWidget(all_);
  column->addLayout(foot);
  sentence_->setObjectName("fault");
  sentence_->setWordWrap(true);
  sentence_->hide();
  all_->hide();
  setFocusProxy(grid_);
  grid_->set_theme(theme);
  connect(grid_, &BodiesGrid::edited, this, &BodiesSheet::edited);
  connect(grid_, &BodiesGrid::chosen, this, &BodiesSheet::chosen);
  connect(grid_, &BodiesGrid::pauseRequested, this, &BodiesSheet::pauseRequested);
  connect(grid_, &BodiesGrid::said, this, &BodiesSheet::say);
  connect(all_, &QPushButton::clicked, this, [this] {
    grid_->rows().show_all();
    show_button();
  });
}

QWidget* BodiesSheet::new_columns_button() {
  auto* button = new QToolButton(this);
  button->setObjectName("more");
  button->setText(QStringLiteral("▾"));
  button->setToolTip(tr("Columns: what the table shows"));
  button->setAccessibleName(tr("Columns"));
  button->setFocusPolicy(Qt::TabFocus);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(grid_->columns_menu());
  return button;
}

QStringList BodiesSheet::shown_columns() const { return grid_->shown_columns(); }

void BodiesSheet::show_columns(const QStringList& ids) { grid_->show_columns(ids); }

void BodiesSheet::set_theme(const Theme& theme) { grid_->set_theme(theme); }

void BodiesSheet::show_moment(const std::shared_ptr<const Scene>& scene,
                              const std::shared_ptr<const Frame>& frame) {
  grid_->show(scene, frame);
  show_button();
}

void BodiesSheet::show_selection(const std::vector<std::string>& names) { grid_->show_selection(names); }

void BodiesSheet::watch_changes(bool watch) { grid_->rows().watch_changes(watch); }

void BodiesSheet::say(const QString& sentence) {
  sentence_->setText(sentence);
  sentence_->setVisible(!sentence.isEmpty());
}

void BodiesSheet::refuse(const QString& sentence) { grid_->refuse(sentence); }

void BodiesSheet::forget_faults() {
  grid_->rows().set_faults({});
  say({});
}

void BodiesSheet::begin() {
  grid_->setCurrentIndex({});
  grid_->scrollToTop();
  grid_->horizontalScrollBar()->setValue(0);
  say({});
}

void BodiesSheet::end_sentence() {
  if (!grid_->rows().has_faults()) say({});
}

void BodiesSheet::show_button() {
  const std::size_t count = grid_->rows().bodies().size();
  all_->setVisible(static_cast<std::size_t>(grid_->rows().shown_bodies()) < count);
  const QString text = tr("Show all %1 bodies").arg(count);
  if (all_->text() != text) all_->setText(text);
}

}  // namespace carom
