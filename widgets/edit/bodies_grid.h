#pragma once

#include <QPointer>
#include <memory>
#include <string>
#include <vector>

#include "widgets/base/figure_table.h"
#include "widgets/edit/bodies_model.h"
#include "widgets/theme/theme.h"

class QLabel;
class QMenu;

namespace carom {

class CellField;

// The cells of the bodies: typing, moving on, marking, copying and pasting. It changes nothing itself: each
// value that is taken is an edit that it hands out.
class BodiesGrid : public FigureTable {
  Q_OBJECT

 public:
  explicit BodiesGrid(QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  [[nodiscard]] const Theme& theme() const { return theme_; }
  [[nodiscard]] BodiesModel& rows() { return *rows_; }
  // A cell in which the user types is left alone as long as it is of the same body, and can be edited.
  void show(const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const Frame>& frame);
  void show_selection(const std::vector<std::string>& names);
  // The columns that can be hidden, as entries of a menu; their ids, for the next time.
  [[nodiscard]] QMenu* columns_menu() const { return columns_menu_; }
  [[nodiscard]] QStringList shown_columns() const;
  void show_columns(const QStringList& ids);
  // Why an edit could not be; of one that is being handed out, its cell says so.
  void refuse(const QString& sentence);

  // For the cells' editors: takes a text, or returns one sentence on why it can't be.
  QString take(int row, int column, const QString& text);
  // The value of a formula that is typed there.
  [[nodiscard]] QString value_of(int row, int column, const QString& text) const;
  void begin(CellField* field, int row, int column);
  void end(CellField* field);
  // From the current cell to the next one that can be edited, one row down (-1: up), or to the right (-1:
  // left). False if there is none.
  bool go_down(int rows);
  bool go_right(int columns);
  // To the right or left, and out of the table after the last cell of the row.
  void go_on(bool right);
  // Puts the cells of the clipboard into the marked ones, or into those from the current one on.
  void paste();

 signals:
  void edited(const carom::SceneEdits& edits, const QString& name);
  // The user marked cells of these bodies.
  void chosen(const std::vector<std::string>& names);
  void pauseRequested();  // the user begins to change what moves while a run plays
  // A sentence to be shown; empty: none any more.
  void said(const QString& sentence);

 protected:
  [[nodiscard]] QString copied() const override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  // Keys type into cells; they look for none.
  void keyboardSearch(const QString& /*text*/) override {}
  bool focusNextPrevChild(bool next) override;
  bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
  void selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) override;

 private:
  [[nodiscard]] std::vector<std::string> names_of_marked_cells() const;
  [[nodiscard]] bool can_edit(const QModelIndex& index) const;
  void make_columns_menu();
  void show_column(std::size_t choice, bool shown);
  void show_value(const QWidget& field, const QString& text);
  // Whether a key begins what is typed into the current cell.
  [[nodiscard]] bool begins_cell(const QKeyEvent& key) const;
  void say_why_not(const QModelIndex& index);
  void say(const QString& sentence);
  // Returns why the receiver refused them.
  QString hand_out(const SceneEdits& edits, const QString& name);

  BodiesModel* rows_;
  QMenu* columns_menu_ = nullptr;
  QLabel* value_;  // of the formula that is typed, by its cell
  Theme theme_ = light_theme();
  std::vector<std::string> selection_;  // in the scene
  bool shows_selection_ = false;        // the marked cells follow the scene
  bool says_why_not_ = false;           // the sentence is about the current cell
  bool hands_out_ = false;
  QString refusal_;            // of what is handed out
  QPointer<CellField> field_;  // of the cell that is edited
  Id<Body> edited_;            // its body
};

}  // namespace carom
