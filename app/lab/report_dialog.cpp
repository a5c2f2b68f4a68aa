#include "app/lab/report_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <algorithm>
#include <fmt/format.h>

#include "physics/scene/validate.h"
#include "widgets/base/plain_text.h"
#include "widgets/base/plain_text_edit.h"

namespace carom {

std::vector<double> times_of(const QString& text, double end) {
  static const QRegularExpression between("[;\\s]+|,\\s+");
  std::vector<double> times;
  for (QString part : text.split(between, Qt::SkipEmptyParts)) {
    part.replace(',', '.');  // a decimal comma
    bool good = false;
    const double time = part.toDouble(&good);
    if (!good || !(time >= 0.0 && time <= end)) {
      throw SceneError(
          fmt::format("{} is not allowed; allowed: a time from 0 to {} s", shortened(part.toStdString()), end));
    }
    times.push_back(time);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  if (times.size() > LabReport::kMostMoments) {
    throw SceneError(
        fmt::format("{} moments are not allowed; allowed: up to {}", times.size(), LabReport::kMostMoments));
  }
  return times;
}

ReportDialog::ReportDialog(const LabReport& suggestion, QWidget* parent)
    : QDialog(parent),
      suggestion_(suggestion),
      title_(new QLineEdit(suggestion.title)),
      name_(new QLineEdit(suggestion.name)),
      form_(new QLineEdit(suggestion.form)),
      date_(new QLineEdit(suggestion.date)),
      times_(new QLineEdit),
      plots_(new QCheckBox(tr("The plots, as they are shown"))),
      bodies_(new QCheckBox(tr("The bodies before and after"))),
      ledger_(new QCheckBox(tr("Where energy and momentum went"))),
      questions_(new PlainTextEdit(suggestion.questions.join('\n'))),
      message_(new PlainLabel) {
  setWindowTitle(tr("Lab report"));
  setMinimumWidth(500);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(12);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(10);
  form->addRow(tr("Title"), title_);
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Class"), form_);
  form->addRow(tr("Date"), date_);
  for (QLineEdit* field : {name_, form_, date_}) field->setPlaceholderText(tr("empty: a line to write on"));
  QStringList times;
  for (const double time : suggestion.times) times << QString::number(time, 'g', 10);
  times_->setObjectName("times");
  times_->setText(times.join("; "));
  times_->setToolTip(tr("The scene is shown at these times, up to %1 of them").arg(LabReport::kMostMoments));
  form->addRow(tr("Moments / s"), times_);
  auto* parts = new QVBoxLayout;
  parts->setSpacing(4);
  for (QCheckBox* part : {plots_, bodies_, ledger_}) {
    part->setChecked(true);
    parts->addWidget(part);
  }
  form->addRow(tr("With"), parts);
  questions_->setObjectName("questions");
  questions_->setTabChangesFocus(true);
  questions_->setFixedHeight(86);
  questions_->setToolTip(
      tr("One a line, each with room to write: the first before the run, the others at the end"));
  form->addRow(tr("Questions"), questions_);
  column->addLayout(form);
  message_->setObjectName("muted");
  message_->setWordWrap(true);
  column->addWidget(message_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  save_ = buttons->button(QDialogButtonBox::Save);
  save_->setText(tr("Save as..."));
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(times_, &QLineEdit::textChanged, this, &ReportDialog::check);
  check();
}

LabReport ReportDialog::report() const {
  LabReport report = suggestion_;
  report.title = title_->text().trimmed();
  report.name = name_->text().trimmed();
  report.form = form_->text().trimmed();
  report.date = date_->text().trimmed();
  report.times = times_of(times_->text(), report.ends.front().time);
  report.questions.clear();
  for (const QString& line : questions_->toPlainText().split('\n')) {
    if (!line.trimmed().isEmpty()) report.questions << line.trimmed();
  }
  if (!plots_->isChecked()) report.plots.clear();
  if (!bodies_->isChecked()) report.bodies = nullptr;
  if (!ledger_->isChecked()) report.ledger = nullptr;
  return report;
}

void ReportDialog::check() {
  QString message = tr("A PDF of A4 pages: pictures and plots as vectors, with room for words.");
  bool good = true;
  try {
    (void)times_of(times_->text(), suggestion_.ends.front().time);
  } catch (const SceneError& error) {
    message = QString::fromUtf8(error.what());
    good = false;
  }
  message_->setText(message);
  save_->setEnabled(good);
}

}  // namespace carom
