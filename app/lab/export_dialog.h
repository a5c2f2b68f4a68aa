#pragma once

#include <QDialog>
#include <vector>

class QComboBox;
class QRadioButton;

namespace carom {

// Chooses the data of a run to save, and their time.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  enum class What { kPlot, kPlots, kRun };
  enum class Time { kAll, kShown, kMarked };

  // `plot`: the title of the requested plot, or empty; `marked`: the times of the two marks, or empty; `runs`:
  // the names of the compared methods.
  ExportDialog(const QString& plot, const QString& marked, const std::vector<QString>& runs, QWidget* parent);

  [[nodiscard]] What what() const;
  [[nodiscard]] Time time() const;
  [[nodiscard]] std::size_t run() const;  // the chosen one

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
