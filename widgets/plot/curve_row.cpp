#include "widgets/plot/curve_row.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "physics/observe/quantity_name.h"
#include "physics/scene/limits.h"
#include "widgets/base/plain_text.h"
#include "widgets/plot/quantity_picker.h"

namespace carom {

CurveRow::CurveRow(const std::vector<Body>& bodies, QWidget* parent)
    : QWidget(parent),
      picker_(new QuantityPicker(bodies, {}, this)),
      open_(new QToolButton(this)),
      away_(new QPushButton(QString::fromUtf8("✕"), this)),
      below_(new QWidget(this)),
      theory_(new QLineEdit(below_)),
      residual_(new QCheckBox(tr("residual"), below_)) {
  open_->setText(tr("f(t)"));
  open_->setCheckable(true);
  open_->setToolTip(tr("A theory beside this curve: its closed form"));
  open_->setAccessibleName(open_->toolTip());
  away_->setAutoDefault(false);
  away_->setFixedWidth(32);
  away_->setStyleSheet("padding: 5px 0;");
  away_->setToolTip(tr("Remove this curve"));
  away_->setAccessibleName(away_->toolTip());
  theory_->setPlaceholderText(tr("closed form in t, as 2*exp(-t/3)"));
  theory_->setObjectName("theory");
  theory_->setAccessibleName(tr("Theory"));
  theory_->setToolTip(
      tr("In SI units. + - * / ^, < > ?:, pi, sin, cos, tan, exp, ln, sqrt, abs, min, max, floor, mod and "
         "others.\n"
         "It is drawn as a thin dashed line."));
  residual_->setToolTip(tr("Draw the measured values minus the theory, instead of both"));

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* above = new QHBoxLayout;
  above->addWidget(picker_, 1);
  above->addWidget(open_);
  above->addWidget(away_);
  column->addLayout(above);
  auto* below = new QHBoxLayout(below_);
  below->setContentsMargins(16, 0, 0, 2);
  below->addWidget(new PlainLabel(tr("theory"), below_));
  below->addWidget(theory_, 1);
  below->addWidget(residual_);
  column->addWidget(below_);
  below_->hide();

  connect(picker_, &QuantityPicker::changed, this, &CurveRow::changed);
  connect(away_, &QPushButton::clicked, this, &CurveRow::removeAsked);
  connect(open_, &QToolButton::toggled, this, [this](bool shown) {
    below_->setVisible(shown);
    emit changed();
  });
  connect(open_, &QToolButton::clicked, this, [this](bool shown) {
    if (shown) theory_->setFocus();
  });
  theory_->setMaxLength(kLongestTitle);
  connect(theory_, &QLineEdit::textChanged, this, &CurveRow::changed);
  connect(residual_, &QCheckBox::toggled, this, &CurveRow::changed);
}

void CurveRow::set_quantity(const QuantityName& quantity) {
  picker_->set_quantity(quantity);
  theory_->setText(QString::fromStdString(quantity.theory));
  residual_->setChecked(quantity.residual);
  open_->setChecked(!quantity.theory.empty());
}

// A theory whose line is closed counts as none.
QuantityName CurveRow::quantity() const {
  QuantityName quantity = picker_->quantity();
  if (open_->isChecked()) quantity.theory = theory_->text().trimmed().toStdString();
  quantity.residual = residual_->isChecked() && !quantity.theory.empty();
  return quantity;
}

void CurveRow::set_removable(bool removable) { away_->setEnabled(removable); }

}  // namespace carom
