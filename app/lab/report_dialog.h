#pragma once

#include <QDialog>
#include <optional>

#include "app/export/lab_report.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace carom {

// Parses times, "0; 0.25; 1.5" or "0, 0.25, 1.5"; returns them sorted and unique. Throws SceneError for a time
// outside 0 to `end` (s), or for more than LabReport::kMostMoments.
[[nodiscard]] std::vector<double> times_of(const QString& text, double end);

// The user's part of a lab report, beside the data of the run.
class ReportDialog : public QDialog {
  Q_OBJECT

 public:
  // `suggestion` has all parts; report() leaves out those that the user does not want. `of_shown`: the one that
  // ends at the shown moment, if that is not the newest one.
  ReportDialog(const LabReport& suggestion, const std::optional<LabReport>& of_shown, QWidget* parent);

  [[nodiscard]] LabReport report() const;

 private:
  [[nodiscard]] const LabReport& suggestion() const;
  void choose_end();
  void check();

  LabReport suggestion_;
  std::optional<LabReport> of_shown_;
  QComboBox* end_;
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
