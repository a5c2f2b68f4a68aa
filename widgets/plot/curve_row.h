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

// The dialog's row for one curve: its quantity and, if opened, a line for the closed form and the choice of
// the residual.
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
