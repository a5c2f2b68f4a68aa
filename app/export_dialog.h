#pragma once

#include <QDialog>

class QRadioButton;

namespace carom {

// Which data of a run are to be saved: of what, and of which time.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  enum class What { kPlot, kPlots, kRun };
  enum class Time { kAll, kShown, kMarked };

  // `plot`: the title of the plot that was asked for, or nothing; `marked`: there are two marks.
  ExportDialog(const QString& plot, bool marked, QWidget* parent);

  [[nodiscard]] What what() const;
  [[nodiscard]] Time time() const;

 private:
  QRadioButton* plot_;
  QRadioButton* plots_;
  QRadioButton* run_;
  QRadioButton* all_;
  QRadioButton* shown_;
  QRadioButton* marked_;
};

}  // namespace carom
