#include "widgets/plot_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "physics/scene/validate.h"
#include "widgets/plot_content.h"
#include "widgets/quantity_picker.h"

namespace carom {

PlotDialog::PlotDialog(const std::vector<Body>& bodies, QWidget* parent) : QDialog(parent), bodies_(bodies) {
  setWindowTitle(tr("Plot"));
  auto* column = new QVBoxLayout(this);
  column->setSpacing(10);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(10);
  auto* curves = new QWidget(this);
  rows_layout_ = new QVBoxLayout(curves);
  rows_layout_->setContentsMargins(0, 0, 0, 0);
  rows_layout_->setSpacing(6);
  another_ = new QPushButton(tr("+ Another curve"), this);
  another_->setAutoDefault(false);
  rows_layout_->addWidget(another_, 0, Qt::AlignLeft);
  connect(another_, &QPushButton::clicked, this, [this] { add_curve(); });
  form->addRow(tr("Curves"), curves);
  x_ = new QuantityPicker(bodies_, tr("time"), this);
  form->addRow(tr("over"), x_);
  logarithmic_ = new QCheckBox(tr("Logarithmic axis, of the magnitudes"), this);
  form->addRow(QString(), logarithmic_);
  title_ = new QLineEdit(this);
  form->addRow(tr("Title"), title_);
  column->addLayout(form);
  message_ = new QLabel(this);
  message_->setObjectName("muted");
  message_->setWordWrap(true);
  column->addWidget(message_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addStretch(1);
  column->addWidget(buttons);
  connect(x_, &QuantityPicker::changed, this, &PlotDialog::check);
  connect(logarithmic_, &QCheckBox::toggled, this, &PlotDialog::check);
  setMinimumWidth(560);
  add_curve();
}

QuantityPicker* PlotDialog::add_curve() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* picker = new QuantityPicker(bodies_, {}, row);
  auto* away = new QPushButton(QString::fromUtf8("✕"), row);
  away->setAutoDefault(false);
  away->setFixedWidth(32);
  away->setStyleSheet("padding: 5px 0;");
  away->setToolTip(tr("Take this curve away"));
  away->setAccessibleName(away->toolTip());
  layout->addWidget(picker, 1);
  layout->addWidget(away);
  if (!rows_.empty()) picker->set_quantity(next_body(rows_.back().picker->quantity()));
  rows_layout_->insertWidget(static_cast<int>(rows_.size()), row);
  rows_.push_back({row, picker, away});
  connect(away, &QPushButton::clicked, this, [this, row] {
    std::erase_if(rows_, [row](const Row& r) { return r.row == row; });
    row->deleteLater();
    check();
  });
  connect(picker, &QuantityPicker::changed, this, &PlotDialog::check);
  check();
  return picker;
}

// Of one body: the same of the next one that moves, as people compare them.
QuantityName PlotDialog::next_body(QuantityName quantity) const {
  if (quantity.bodies.size() != 1) return quantity;
  bool found = false;
  for (const Body& body : bodies_) {
    if (found && !is_immovable(body)) {
      quantity.bodies = {body.name};
      return quantity;
    }
    found = found || body.name == quantity.bodies[0];
  }
  return quantity;
}

void PlotDialog::check() {
  another_->setEnabled(rows_.size() < kMostCurves);
  for (const Row& row : rows_) row.away->setEnabled(rows_.size() > 1);
  QString wrong;
  try {
    const PlotContent content = content_of(plot(), bodies_);
    title_->setPlaceholderText(content.title);
  } catch (const SceneError& error) {
    wrong = QString::fromUtf8(error.what());
  }
  message_->setText(wrong);
  ok_->setEnabled(wrong.isEmpty());
}

void PlotDialog::set_plot(const Plot& plot) {
  for (std::size_t i = 0; i < plot.y.size(); ++i) {
    QuantityPicker* picker = i < rows_.size() ? rows_[i].picker : add_curve();
    picker->set_quantity(plot.y[i]);
  }
  if (plot.x) x_->set_quantity(*plot.x);
  logarithmic_->setChecked(plot.logarithmic);
  title_->setText(QString::fromStdString(plot.title));
  check();
}

Plot PlotDialog::plot() const {
  Plot plot;
  plot.title = title_->text().trimmed().toStdString();
  for (const Row& row : rows_) plot.y.push_back(row.picker->quantity());
  if (QuantityName x = x_->quantity(); !x.observable.empty()) plot.x = std::move(x);
  plot.logarithmic = logarithmic_->isChecked();
  return plot;
}

}  // namespace carom
