#include "widgets/plot/plot_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "physics/observe/quantity_name.h"
#include "physics/scene/validate.h"
#include "widgets/base/plain_text.h"
#include "widgets/plot/curve_row.h"
#include "widgets/plot/plot_content.h"
#include "widgets/plot/quantity_picker.h"

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
  title_->setMaxLength(kLongestTitle);
  form->addRow(tr("Title"), title_);
  column->addLayout(form);
  message_ = new PlainLabel(this);
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

CurveRow* PlotDialog::add_curve() {
  auto* row = new CurveRow(bodies_, this);
  if (!rows_.empty()) row->set_quantity(next_body(rows_.back()->quantity()));
  rows_layout_->insertWidget(static_cast<int>(rows_.size()), row);
  rows_.push_back(row);
  connect(row, &CurveRow::removeAsked, this, [this, row] {
    std::erase(rows_, row);
    row->deleteLater();
    check();
  });
  connect(row, &CurveRow::changed, this, &PlotDialog::check);
  check();
  return row;
}

// For one body: the same quantity of the next moving body, as a likely comparison.
QuantityName PlotDialog::next_body(QuantityName quantity) const {
  quantity.theory.clear();  // a theory belongs to one body alone
  quantity.residual = false;
  if (quantity.bodies.size() != 1) return quantity;
  bool found = false;
  for (const Body& body : bodies_) {
    if (found && !has_infinite_mass(body)) {
      quantity.bodies = {body.name};
      return quantity;
    }
    found = found || body.name == quantity.bodies[0];
  }
  return quantity;
}

void PlotDialog::check() {
  another_->setEnabled(rows_.size() < kMostCurves);
  for (CurveRow* row : rows_) row->set_removable(rows_.size() > 1);
  QString wrong;
  try {
    const PlotContent content = content_of(plot(), bodies_);
    title_->setPlaceholderText(content.title);
  } catch (const SceneError& error) {
    wrong = QString::fromUtf8(error.what());
  }
  message_->setText(wrong);
  if (!wrong.isEmpty()) {
    // The form keeps its height, whatever the message.
    message_->setMinimumHeight(message_->heightForWidth(std::max(message_->width(), minimumWidth())));
    adjustSize();
  }
  ok_->setEnabled(wrong.isEmpty());
}

void PlotDialog::set_plot(const Plot& plot) {
  for (std::size_t i = 0; i < plot.y.size(); ++i) {
    (i < rows_.size() ? rows_[i] : add_curve())->set_quantity(plot.y[i]);
  }
  if (plot.x) x_->set_quantity(*plot.x);
  logarithmic_->setChecked(plot.logarithmic);
  title_->setText(QString::fromStdString(plot.title));
  notes_ = plot.notes;
  check();
}

Plot PlotDialog::plot() const {
  Plot plot;
  plot.title = title_->text().trimmed().toStdString();
  for (const CurveRow* row : rows_) plot.y.push_back(row->quantity());
  if (QuantityName x = x_->quantity(); !x.observable.empty()) plot.x = std::move(x);
  plot.logarithmic = logarithmic_->isChecked();
  plot.notes = notes_;
  return plot;
}

}  // namespace carom
