#pragma once

#include <QStringList>
#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "physics/record/frame.h"
#include "physics/scene/edit.h"
#include "widgets/theme/theme.h"

class QLabel;
class QPushButton;

namespace carom {

class BodiesGrid;

// The table of the bodies, in which their values can be typed, and beside it a menu of its columns. Under it
// stand a sentence, if there is something to say, and a button if it does not show all bodies.
class BodiesSheet : public QWidget {
  Q_OBJECT

 public:
  explicit BodiesSheet(const Theme& theme, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  // The scene as it stands; while a run plays, that of the frame. Null: there is none, and the frame is shown.
  void show_moment(const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const Frame>& frame);
  // The names of the bodies that are selected in the scene.
  void show_selection(const std::vector<std::string>& names);
  // While a drag changes what is shown, the cells that change have a ring.
  void watch_changes(bool watch);
  // The ids of the shown columns of those that can be hidden.
  [[nodiscard]] QStringList shown_columns() const;
  void show_columns(const QStringList& ids);
  // Why the last edit could not be.
  void refuse(const QString& sentence);
  // The scene is another one: red cells, and what was said, are over.
  void forget_faults();
  // Of another document: no cell is the current one, and the first ones are in sight.
  void begin();
  // What was said is over, unless it is about red cells.
  void end_sentence();

 signals:
  // Edits that are one step of undo, with their name.
  void edited(const carom::SceneEdits& edits, const QString& name);
  // The user chose cells of these bodies.
  void chosen(const std::vector<std::string>& names);
  void pauseRequested();  // the user begins to change what moves while a run plays

 private:
  void say(const QString& sentence);  // empty: nothing
  void show_button();
  [[nodiscard]] QWidget* new_columns_button();

  BodiesGrid* grid_;
  QLabel* sentence_;
  QPushButton* all_;
};

}  // namespace carom
