#pragma once

#include <QDialog>

#include "app/export/lab_report.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace carom {

// Times as people write them, "0; 0.25; 1.5" or "0, 0.25, 1.5", in the order of time and each once. Throws
// SceneError where one is no time from 0 to `end` (s), or there are more than LabReport::kMostMoments.
[[nodiscard]] std::vector<double> times_of(const QString& text, double end);

// What is to stand in a lab report beside what the run says itself.
class ReportDialog : public QDialog {
  Q_OBJECT

 public:
  // `suggestion` has all parts; those that the user doesn't want are left out of report().
  ReportDialog(const LabReport& suggestion, QWidget* parent);

  [[nodiscard]] LabReport report() const;

 private:
  void check();

  LabReport suggestion_;
  QLineEdit* title_;
  QLineEdit* name_;
  QLineEdit* form_;
  QLineEdit* date_;
  QLineEdit* times_;
  QCheckBox* plots_;
  QCheckBox* bodies_;
  QCheckBox* ledger_;
  QPlainTextEdit* questions_;
  QLabel* message_;
  QPushButton* save_ = nullptr;
};

}  // namespace carom
