#pragma once

#include <QFrame>
#include <QPixmap>
#include <QTimer>
#include <vector>

#include "widgets/theme/theme.h"

class QLineEdit;
class QListWidget;

namespace carom {

// One line of the list of experiments.
struct ExperimentItem {
  QString name;  // argument of openRequested()
  QString topic;
  QString title;
  QString observe;  // one short line under the title
  QString about;    // more, that is searched too
};

// The experiments under their topics, each with a small picture, a search field, and buttons for an empty scene
// and a file. One click opens an experiment; arrows and search mark one, which is to be shown when they rest,
// Enter opens it, Escape wants the list closed. The search knows words that belong together: "restitution"
// finds what is said with e.
class ExperimentList : public QFrame {
  Q_OBJECT

 public:
  explicit ExperimentList(const Theme& theme, QWidget* parent = nullptr);
  void set_theme(const Theme& theme);
  void set_items(std::vector<ExperimentItem> items);
  // 52×36 px in logical pixels, in the order of the items.
  void set_pictures(const std::vector<QPixmap>& pictures);
  // Marks the experiment that is open, none for an unknown name; while there are words to search, what Enter
  // opens.
  void set_current(const QString& name);
  // Whether it stands over something else, with a frame of its own.
  void set_over(bool over);
  // The search has the focus, its text is selected.
  void begin_search();
  void open_marked();

 signals:
  void openRequested(const QString& name);
  void previewRequested(const QString& name);  // of what is marked, once that rests; empty: nothing is
  void closeRequested();
  void newRequested();   // an empty scene
  void fileRequested();  // one from a file

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void choose_next(int way);  // 1: downwards, -1: upwards
  void fill();
  [[nodiscard]] QStringList search_words() const;
  void mark_best(const QStringList& words);

  Theme theme_;
  QLineEdit* search_;
  QListWidget* list_;
  std::vector<ExperimentItem> items_;
  std::vector<QPixmap> pictures_;
  QString current_;
  QTimer rest_;  // until the marked experiment is shown
};

}  // namespace carom
