#include "widgets/compare/study_steps.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>

#include "physics/scene/limits.h"
#include "physics/scene/validate.h"
#include "widgets/base/number_list.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"

namespace carom {
namespace {

constexpr std::size_t kMostSteps = 30;
constexpr double kMilli = 1e-3;

std::vector<double> steps_in(QString text) {
  static const QRegularExpression unit("\\s*ms\\b");
  text.remove(unit);
  std::vector<double> steps =
      numbers_in(text, kLeastStep / kMilli, kLargestStep / kMilli,
                 StudyStepsDialog::tr("a step from %1 to %2 ms")
                     .arg(short_figure(kLeastStep / kMilli), short_figure(kLargestStep / kMilli)));
  if (steps.empty() || steps.size() > kMostSteps)
    throw SceneError(StudyStepsDialog::tr("%1 steps are not allowed; allowed: 1 to %2")
                         .arg(steps.size())
                         .arg(kMostSteps)
                         .toStdString());
  for (double& step : steps) step *= kMilli;
  std::reverse(steps.begin(), steps.end());
  return steps;
}

QString listed(const std::vector<double>& steps) {
  QStringList texts;
  for (const double step : steps) texts << QString::number(step / kMilli, 'g', QLocale::FloatingPointShortest);
  return texts.join("; ");
}

}  // namespace

StudyStepsDialog::StudyStepsDialog(const std::vector<double>& steps, const std::vector<double>& usual,
                                   QWidget* parent)
    : QDialog(parent), list_(new QLineEdit), fault_(new PlainLabel) {
  setWindowTitle(tr("Steps of the study"));
  constexpr int kWidth = 460;  // px
  setMinimumWidth(kWidth);
  list_->setText(listed(steps));
  list_->setAccessibleName(tr("Steps in ms"));
  fault_->setObjectName("fault");
  fault_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  accept_ = buttons->button(QDialogButtonBox::Ok);
  auto* usual_button = buttons->addButton(tr("Usual steps"), QDialogButtonBox::ResetRole);
  connect(usual_button, &QPushButton::clicked, this, [this, usual] {
    list_->setText(listed(usual));
    check();
  });
  auto* column = new QVBoxLayout(this);
  column->addWidget(new PlainLabel(tr("Steps in ms, with semicolons between them:")));
  column->addWidget(list_);
  column->addWidget(fault_);
  column->addWidget(buttons);
  connect(list_, &QLineEdit::textEdited, this, &StudyStepsDialog::check);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  list_->selectAll();
  check();
}

std::vector<double> StudyStepsDialog::steps() const { return steps_in(list_->text()); }

void StudyStepsDialog::check() {
  QString fault;
  try {
    (void)steps();
  } catch (const SceneError& error) {
    fault = QString::fromUtf8(error.what());
  }
  fault_->setText(fault);
  accept_->setEnabled(fault.isEmpty());
}

}  // namespace carom
