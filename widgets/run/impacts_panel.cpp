#include "widgets/run/impacts_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>
#include <QVBoxLayout>
#include <utility>

#include "widgets/base/plain_text.h"

namespace carom {

ImpactsPanel::ImpactsPanel(QWidget* parent)
    : QWidget(parent),
      filter_(new QLineEdit(this)),
      said_(new PlainLabel(this)),
      table_(new ImpactsTable(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(2);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  constexpr int kFieldWidth = 300;  // px
  filter_->setObjectName("cell");
  filter_->setMaximumWidth(kFieldWidth);
  filter_->setClearButtonEnabled(true);
  filter_->setPlaceholderText(tr("filter: light wall loss > 0.1 t < 2"));
  filter_->setAccessibleName(tr("Filter of the impacts"));
  filter_->setToolTip(
      tr("Names of bodies, \"wall\" for any that is fixed or driven, and bounds of\n"
         "#, t (s), closing (m/s), jn, jt (N·s) and loss (J), such as loss > 0.1.\n"
         "Impacts that fulfil all terms are shown, copied and saved."));
  said_->setAccessibleName(tr("How many impacts are shown"));
  row->addWidget(filter_, 1);
  row->addWidget(said_, 1);
  column->addLayout(row);
  constexpr int kLeastTable = 52;  // px: a row under the heading; more of them scroll in the table itself
  table_->setMinimumHeight(kLeastTable);
  column->addWidget(table_, 1);
  connect(filter_, &QLineEdit::textChanged, this, [this] {
    read_filter();
    emit filterChanged();
  });
}

void ImpactsPanel::update_from(const Frame& newest, double shown, const Recorder& recorder) {
  // A filter is of these bodies.
  const bool others = std::exchange(bodies_, newest.bodies) != newest.bodies;
  if (others && !filter_->text().isEmpty()) read_filter();
  all_ = newest.impact_count;
  const Ring<ImpactRecord>& kept = recorder.impacts();
  kept_ = static_cast<std::int64_t>(kept.size());
  kept_from_ = kept.size() > 0 ? kept[0].time : 0.0;
  table_->update_from(newest, shown, recorder);
  show_count();
}

void ImpactsPanel::read_filter() {
  static const std::vector<Body> none;
  const TypedFilter typed = typed_filter(filter_->text(), bodies_ ? *bodies_ : none);
  fault_ = typed.fault;
  if (fault_.isEmpty()) table_->set_filter(typed.filter);
  filter_->setProperty("fault", !fault_.isEmpty());
  said_->setObjectName(fault_.isEmpty() ? "muted" : "fault");
  for (QWidget* each : {static_cast<QWidget*>(filter_), static_cast<QWidget*>(said_)}) {
    each->style()->unpolish(each);
    each->style()->polish(each);
  }
  show_count();
}

void ImpactsPanel::show_count() {
  if (!fault_.isEmpty()) return said_->setText(fault_);
  QString text = tr("%1 of %2 shown").arg(table_->model()->rowCount()).arg(all_);
  if (kept_ < all_)
    text += tr("; only the newest %1 are kept, from %2 s on").arg(kept_).arg(kept_from_, 0, 'f', 3);
  said_->setText(text);
}

}  // namespace carom
