#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "widgets/run/impacts_table.h"

class QLabel;
class QLineEdit;

namespace carom {

// The table of impacts under a field that filters it (see typed_filter()). Beside the field stands how many are
// shown, or what of the filter was not understood: then the last good one holds.
class ImpactsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ImpactsPanel(QWidget* parent = nullptr);
  // `shown`: s, up to which impacts have been met.
  void update_from(const Frame& newest, double shown, const Recorder& recorder);
  [[nodiscard]] ImpactsTable& table() { return *table_; }

 signals:
  void filterChanged();  // the next update shows what it keeps

 private:
  void read_filter();
  void show_count();

  QLineEdit* filter_;
  QLabel* said_;
  ImpactsTable* table_;
  QString fault_;
  std::shared_ptr<const std::vector<Body>> bodies_;
  std::int64_t all_ = 0;    // impacts of the run so far
  std::int64_t kept_ = 0;   // of them
  double kept_from_ = 0.0;  // s
};

}  // namespace carom
