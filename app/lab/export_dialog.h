#pragma once

#include <QDialog>
#include <vector>

class QComboBox;
class QRadioButton;

namespace carom {

// Which data of a run are to be saved: of what, and of which time.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  enum class What { kPlot, kPlots, kRun };
  enum class Time { kAll, kShown, kMarked };

  // `plot`: the title of the plot that was asked for, or nothing; `marked`: there are two marks; `runs`: the
  // names of the methods that are compared.
  ExportDialog(const QString& plot, bool marked, const std::vector<QString>& runs, QWidget* parent);

  [[nodiscard]] What what() const;
  [[nodiscard]] Time time() const;
  [[nodiscard]] std::size_t run() const;  // which of them

 private:
  QRadioButton* plot_;
  QRadioButton* plots_;
  QRadioButton* run_;
  QRadioButton* all_;
  QRadioButton* shown_;
  QRadioButton* marked_;
  QComboBox* runs_;
};

}  // namespace carom
