#pragma once

#include <QDialog>
#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;

namespace carom {

// Asks for the steps of a study, as a list of milliseconds.
class StudyStepsDialog : public QDialog {
  Q_OBJECT

 public:
  // Begins with these `steps` (s); the `usual` ones are a button.
  StudyStepsDialog(const std::vector<double>& steps, const std::vector<double>& usual,
                   QWidget* parent = nullptr);

  // s, falling.
  [[nodiscard]] std::vector<double> steps() const;

 private:
  void check();

  QLineEdit* list_;
  QLabel* fault_;
  QPushButton* accept_ = nullptr;
};

}  // namespace carom
