#pragma once

#include <QWidget>
#include <vector>

#include "physics/study/study_table.h"
#include "widgets/theme/theme.h"

namespace carom {

// The fitted orders of a study, a row for each integrator, a column for each choice of impacts; also the
// legend of its plot. Rows have minimal height. Tooltips show the whole name, the uncertainty and the range of
// the fit.
class OrderTable : public QWidget {
  Q_OBJECT

 public:
  explicit OrderTable(const Theme& theme, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  void set_groups(std::vector<StudyGroup> groups);

  [[nodiscard]] QSize sizeHint() const override { return {200, 100}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {170, 40}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Row {
    IntegratorId integrator;
    std::array<const StudyGroup*, 2> groups;  // by the choice of impacts, null where there is none
  };
  void draw_row(QPainter& painter, const QRectF& where, const Row& row) const;
  [[nodiscard]] double row_height() const;
  [[nodiscard]] double column_width() const;
  [[nodiscard]] double first_column() const;  // px: where the orders begin

  Theme theme_;
  std::vector<StudyGroup> groups_;
  std::vector<Row> rows_;
};

}  // namespace carom
