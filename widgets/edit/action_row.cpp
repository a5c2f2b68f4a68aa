#include "widgets/edit/action_row.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/base/plain_text.h"

namespace carom {

// A button whose text ends with … where it is too long; the tooltip has it whole.
class ElidedButton : public QPushButton {
 public:
  using QPushButton::QPushButton;
  void set_whole(const QString& text) {
    whole_ = text;
    elide();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QPushButton::resizeEvent(event);
    elide();
  }

 private:
  void elide() {
    constexpr int kInset = 8;  // px, border and padding in the style sheet
    QString shown = fontMetrics().elidedText(whole_, Qt::ElideRight, width() - 2 * kInset);
    // An ampersand in a name is no key.
    shown.replace('&', "&&");
    if (text() != shown) setText(shown);
  }
  QString whole_;
};

ActionRow::ActionRow(const InspectedRow& row, QWidget* parent)
    : InspectorRow(row, new PlainLabel(row.label), parent) {
  auto* line = new QHBoxLayout;
  line->setSpacing(6);
  for (std::size_t i = 0; i < row.actions.size(); ++i) {
    auto* button = new ElidedButton(this);
    button->setObjectName("small");
    // What is typed elsewhere is not taken by a click here.
    button->setFocusPolicy(Qt::TabFocus);
    button->setMinimumWidth(0);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    buttons_.push_back(button);
    line->addWidget(button, 1);
    connect(button, &QPushButton::clicked, this, [this, i] { act(actions_[i]); });
  }
  grid()->addLayout(line, 0, row.label.isEmpty() ? 0 : 1, 1, row.label.isEmpty() ? kColumns + 1 : kColumns);
  show_row(row);
}

void ActionRow::show_row(const InspectedRow& row) {
  actions_ = row.actions;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i]->set_whole(actions_[i].text);
    const QString tip = actions_[i].refusal.isEmpty() ? actions_[i].meaning : actions_[i].refusal;
    buttons_[i]->setToolTip(plain_tip(tip));
    buttons_[i]->setAccessibleName(actions_[i].name.isEmpty() ? actions_[i].text : actions_[i].name);
  }
}

}  // namespace carom
