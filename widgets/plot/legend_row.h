#pragma once

#include <QToolButton>
#include <QWidget>
#include <vector>

namespace carom {

class LegendButton;

// The legend over a plot, in one line, or in as few more as its names need: they stay whole, unless one alone
// is wider than the legend. Where they would need too many lines, the rest is in the menu of a last button, "+
// 12 more". Its least width is kLeastWidth, however many curves there are.
class LegendRow : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kLeastWidth = 90;  // px

  explicit LegendRow(QWidget* parent = nullptr);

  // Takes ownership. A button without a name is never shown.
  void add(LegendButton* button);
  // Puts an added button last, or takes it out until it is there again.
  void set_there(LegendButton* button, bool there);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Spot {
    int x = 0;  // px
    int line = 0;
    int width = 0;  // px
  };
  [[nodiscard]] std::vector<Spot> spots(int lines, int kept) const;
  void place();
  void fill_menu();
  [[nodiscard]] int whole_width() const;  // px, of all names in one line
  [[nodiscard]] int line_height() const;  // px

  std::vector<LegendButton*> buttons_;
  std::size_t shown_ = 0;  // the first ones; the others are in the menu
  int lines_ = 1;
  QToolButton* more_;
};

}  // namespace carom
