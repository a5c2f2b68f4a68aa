#include "app/lab/report_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardItemModel>
#include <algorithm>
#include <fmt/format.h>

#include "physics/scene/validate.h"
#include "widgets/base/number_list.h"
#include "widgets/base/plain_text.h"
#include "widgets/base/plain_text_edit.h"

namespace carom {

namespace {

QString listed(const std::vector<double>& times) {
  QStringList texts;
  for (const double time : times) texts << QString::number(time, 'g', 10);
  return texts.join("; ");
}

}  // namespace

std::vector<double> times_of(const QString& text, double end) {
  std::vector<double> times = numbers_in(
      text, 0.0, end, QString("a time from 0 to %1 s").arg(QString::fromStdString(fmt::format("{}", end))));
  if (times.size() > LabReport::kMostMoments) {
    throw SceneError(
        fmt::format("{} moments are not allowed; allowed: up to {}", times.size(), LabReport::kMostMoments));
  }
  return times;
}

ReportDialog::ReportDialog(const LabReport& suggestion, const std::optional<LabReport>& of_shown,
                           QWidget* parent)
    : QDialog(parent),
      suggestion_(suggestion),
      of_shown_(of_shown),
      end_(new QComboBox),
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
  end_->setObjectName("end");
  end_->addItem(tr("To its end, t = %1 s").arg(suggestion.ends.front().time, 0, 'g', 6));
  end_->addItem(of_shown ? tr("To the shown moment, t = %1 s").arg(of_shown->ends.front().time, 0, 'g', 6)
                         : tr("To the shown moment"));
  if (!of_shown) static_cast<QStandardItemModel*>(end_->model())->item(1)->setEnabled(false);
  end_->setToolTip(
      tr("The shown moment, where it is not the newest one: go there by the timeline or PgUp first"));
  end_->setItemData(1, end_->toolTip(), Qt::ToolTipRole);
  form->addRow(tr("The run"), end_);
  times_->setObjectName("times");
  times_->setText(listed(suggestion.times));
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
  connect(end_, &QComboBox::currentIndexChanged, this, &ReportDialog::choose_end);
  check();
}

LabReport ReportDialog::report() const {
  LabReport report = suggestion();
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

const LabReport& ReportDialog::suggestion() const {
  return end_->currentIndex() == 1 && of_shown_ ? *of_shown_ : suggestion_;
}

// Times that the user has typed stay.
void ReportDialog::choose_end() {
  const QString text = times_->text();
  if (text == listed(suggestion_.times) || (of_shown_ && text == listed(of_shown_->times)))
    times_->setText(listed(suggestion().times));
  check();
}

void ReportDialog::check() {
  QString message = tr("A PDF of A4 pages: pictures and plots as vectors, with room for words.");
  bool good = true;
  try {
    (void)times_of(times_->text(), suggestion().ends.front().time);
  } catch (const SceneError& error) {
    message = QString::fromUtf8(error.what());
    good = false;
  }
  message_->setText(message);
  save_->setEnabled(good);
}

}  // namespace carom
