#pragma once

#include <QToolButton>
#include <QWidget>
#include <vector>

namespace carom {

class LegendButton;

// The legend over a plot, in one line. Names are shortened where there is little room; the rest is in the menu
// of a last button, "+ 12 more". Its least width is kLeastWidth, however many curves there are.
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
  void place();
  void fill_menu();
  [[nodiscard]] int whole_width() const;  // px, of all names

  std::vector<LegendButton*> buttons_;
  std::size_t shown_ = 0;  // the first ones; the others are in the menu
  QToolButton* more_;
};

}  // namespace carom
