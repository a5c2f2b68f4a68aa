#pragma once

#include <QFrame>
#include <QPoint>
#include <optional>
#include <vector>

#include "physics/scene/scene.h"
#include "physics/scene/stop.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace carom {

class ChoiceBox;

// The stops of a document in a small window of its own: a list of their sentences, and one that is built from
// choices or typed.
class StopEditor : public QFrame {
  Q_OBJECT

 public:
  explicit StopEditor(QWidget* parent);

  void set_document(const std::vector<Stop>& stops, const std::vector<Body>& bodies);
  // Over this widget, with the sentence of this stop, if one is named.
  void open_over(const QWidget& anchor, std::optional<std::size_t> stop);
  // Over this widget, to add a stop that begins as this one.
  void open_over(const QWidget& anchor, const Stop& begun);

 signals:
  // `text`: what it is called in undo.
  void stopsChanged(const std::vector<Stop>& stops, const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_choices();
  void connect_choices();
  void show_stop(const Stop& stop);
  void show_rows(StopKind kind, StopQuantity quantity);
  void take_choices();
  void take_sentence();
  // Checks the stop; the line that says what is wrong with it stands under the sentence.
  void take(const Stop& stop);
  void refuse(const QString& why);
  void choose_row(int row);
  void add();
  void change();
  void remove();
  void take_enter();
  void enable();
  void fit();

  std::vector<Stop> stops_;
  std::vector<Body> bodies_;
  QPoint corner_;             // of the screen, under its own lower right one
  std::optional<Stop> made_;  // none where the sentence can't be taken
  QListWidget* list_;
  ChoiceBox* kind_ = nullptr;
  QSpinBox* number_ = nullptr;
  QLabel* of_ = nullptr;
  ChoiceBox* body_ = nullptr;
  QLabel* with_word_ = nullptr;
  ChoiceBox* with_ = nullptr;
  ChoiceBox* quantity_ = nullptr;
  QLineEdit* value_ = nullptr;
  QLabel* unit_ = nullptr;
  ChoiceBox* way_ = nullptr;
  QLineEdit* sentence_;
  QLabel* fault_;
  QPushButton* add_;
  QPushButton* change_;
  QPushButton* remove_;
};

}  // namespace carom
