#pragma once

#include <QWidget>
#include <vector>

#include "physics/observe/quantity_name.h"
#include "physics/scene/scene.h"

class QCheckBox;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace carom {

class QuantityPicker;

// One curve of a plot that is put together: its quantity and, below it once it is asked for, the closed form
// beside it and whether what is drawn is the difference.
class CurveRow : public QWidget {
  Q_OBJECT

 public:
  explicit CurveRow(const std::vector<Body>& bodies, QWidget* parent = nullptr);

  void set_quantity(const QuantityName& quantity);
  [[nodiscard]] QuantityName quantity() const;
  void set_removable(bool removable);

 signals:
  void changed();
  void removeAsked();

 private:
  QuantityPicker* picker_;
  QToolButton* open_;
  QPushButton* away_;
  QWidget* below_;
  QLineEdit* theory_;
  QCheckBox* residual_;
};

}  // namespace carom
