#pragma once

#include <QDialog>
#include <optional>
#include <utility>

#include "app/export/film.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace carom {

// Chooses the part of a run for a film, its speed and size, and the folder of its frames. A line always shows
// the result, or what is not allowed. The part from mark A to mark B fills in its times, and the suggested
// folder says so.
class FilmDialog : public QDialog {
  Q_OBJECT

 public:
  // `marked`: the interval between the marks, s, if there are two.
  FilmDialog(const Film& suggestion, const QString& folder,
             const std::optional<std::pair<double, double>>& marked, QWidget* parent);

  [[nodiscard]] Film film() const;
  [[nodiscard]] QString folder() const;
  // Whether existing frames in the folder may be replaced.
  [[nodiscard]] bool may_replace() const { return may_replace_; }

 public slots:
  void accept() override;  // asks before frames are replaced

 private:
  void choose_part();
  void choose_folder();
  void update_summary();

  Film suggestion_;
  QString suggested_folder_;
  std::optional<std::pair<double, double>> marked_;
  bool may_replace_ = false;
  QComboBox* part_;
  QDoubleSpinBox* from_;
  QDoubleSpinBox* to_;
  QDoubleSpinBox* rate_;
  QDoubleSpinBox* speed_;
  QSpinBox* width_;
  QSpinBox* height_;
  QComboBox* shown_;
  QLineEdit* folder_;
  QLabel* summary_;
  QPushButton* make_ = nullptr;
};

}  // namespace carom
