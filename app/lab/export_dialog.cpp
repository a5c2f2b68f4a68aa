#include "app/lab/export_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/lab/marks_text.h"
#include "widgets/base/plain_text.h"

namespace carom {

ExportDialog::ExportDialog(const QString& plot, const QString& marked, const std::vector<QString>& runs,
                           QWidget* parent)
    : QDialog(parent),
      plot_(new QRadioButton(tr("The curves of “%1”").arg(QString(plot).replace('&', "&&")))),
      plots_(new QRadioButton(tr("The curves of all plots"))),
      run_(new QRadioButton(tr("The whole run: sums, bodies (up to 50) and ledger"))),
      all_(new QRadioButton(tr("From the start until now"))),
      shown_(new QRadioButton(tr("What the plots show"))),
      marked_(new QRadioButton(marked.isEmpty() ? tr("From mark A to mark B")
                                                : tr("From mark A to mark B: %1").arg(marked))),
      runs_(new QComboBox) {
  setWindowTitle(tr("Save data"));
  auto* column = new QVBoxLayout(this);
  column->setSpacing(10);
  const auto group = [&](const QString& title, std::initializer_list<QRadioButton*> buttons) {
    auto* box = new QGroupBox(title, this);
    auto* inside = new QVBoxLayout(box);
    for (QRadioButton* button : buttons) inside->addWidget(button);
    column->addWidget(box);
  };
  group(tr("What"), {plot_, plots_, run_});
  group(tr("Of which time"), {all_, shown_, marked_});
  for (const QString& name : runs) runs_->addItem(name);
  auto* under = new QGroupBox(tr("Under which method"), this);
  (new QVBoxLayout(under))->addWidget(runs_);
  column->addWidget(under);
  under->setVisible(runs.size() > 1);
  plot_->setVisible(!plot.isEmpty());
  (plot.isEmpty() ? run_ : plot_)->setChecked(true);
  all_->setChecked(true);
  marked_->setEnabled(!marked.isEmpty());
  marked_->setToolTip(marks_tip());
  auto* note =
      new PlainLabel(tr("CSV, units in the header, every digit: one line for each step's end, two for each "
                        "impact. The run is computed once more."),
                     this);
  note->setObjectName("muted");
  note->setWordWrap(true);
  column->addWidget(note);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Save)->setText(tr("Save as..."));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

ExportDialog::What ExportDialog::what() const {
  return plot_->isChecked() ? What::kPlot : plots_->isChecked() ? What::kPlots : What::kRun;
}

ExportDialog::Time ExportDialog::time() const {
  return all_->isChecked() ? Time::kAll : shown_->isChecked() ? Time::kShown : Time::kMarked;
}

std::size_t ExportDialog::run() const { return static_cast<std::size_t>(std::max(runs_->currentIndex(), 0)); }

}  // namespace carom
