#pragma once

#include <QHBoxLayout>
#include <QPointer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/part_id.h"
#include "physics/scene/scene.h"
#include "widgets/edit/inspected.h"
#include "widgets/edit/inspected_parts.h"

class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace carom {

class InspectorRow;
class NameField;

// The properties of the selected bodies, of a joint, spring or force, or of the scene if nothing is selected,
// as fields. It changes nothing itself: each accepted value is an edit that it hands out.
class Inspector : public QWidget {
  Q_OBJECT

 public:
  explicit Inspector(QWidget* parent = nullptr);

  // The scene as it stands, or at the shown moment of a run that plays, and the names of the selected bodies.
  // Null: there is none now, nothing can be typed and what is shown stays. A field in which the user types is
  // left alone as long as the selection is the same. `time` (s) of the scene: driven bodies are where they are
  // then.
  void show_selection(std::shared_ptr<const Scene> scene, const std::vector<std::string>& names,
                      double time = 0.0);
  // The same for a joint, a spring or a force.
  void show_part(std::shared_ptr<const Scene> scene, PartId part);
  // The duration and the stops of the runs, which stand with the scene.
  void show_duration_and_stops(const DurationAndStops& shown);
  // Whether a run plays, so that the scene which is shown next is another moment of it.
  void set_playing(bool playing) { plays_ = playing; }
  [[nodiscard]] const std::optional<PartId>& part() const { return part_; }
  // The line with the title, over what scrolls; at its right there is room for more.
  [[nodiscard]] QWidget* head() const { return bar_; }
  void add_to_head(QWidget* widget) { top_->addWidget(widget); }
  // What is done with several bodies together, over their values.
  void set_group_tools(QWidget* tools);
  // Puts the cursor into the name of the selected body.
  void edit_name();
  // While a drag changes what is shown, the fields that change have a ring.
  void watch_changes(bool watch);
  // Says why an edit could not be. Of a typed value that is being handed out its field says so, and keeps what
  // is typed. Else it stands at the bottom until the next edit, and the fields show the scene again. Empty:
  // nothing to say.
  void say(const QString& sentence);

 signals:
  // Edits to be made together, and their name in the undo stack. Those with the same number `drag` > 0 follow
  // one another in one drag of a label, or in one burst of arrow keys, and are one step of undo; 0: an edit by
  // itself.
  void edited(const carom::SceneEdits& edits, const QString& name, int drag);

  // Another duration (s) of the runs, as `edited` has it.
  void durationEdited(double duration, const QString& name, int drag);
  void stopsAsked();  // their editor
  // What bodies are to keep, also those that the mouse gives another size.
  void keepsChosen(carom::Keeps keeps);

  void left();            // by Esc, or Enter in a field: the keys are the scene's again
  void partOpened();      // part() was chosen here
  void pauseRequested();  // the user begins to change what moves while a run plays

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void choose(std::shared_ptr<const Scene> scene, const std::vector<std::string>& names,
              const std::optional<PartId>& part, double time);
  // Shows a part that was chosen in the list of the scene; nothing: the scene again.
  void open(const std::optional<PartId>& part);
  // Shows a list of the rows, or hides it.
  void fold(const QString& list);
  void show_rows();
  [[nodiscard]] std::vector<InspectedRow> rows() const;
  void build_rows();
  void build_bar();
  void fit_name();
  [[nodiscard]] InspectorRow* add_row(const InspectedRow& row, int index);
  void show_title();
  // A field of the rows: by its accessible name, or where that has changed by its place among all of them.
  struct Focused {
    QString name;
    qsizetype place;
  };
  [[nodiscard]] std::optional<Focused> focused_field() const;
  void focus_field(const Focused& focused);
  void set_frozen(bool frozen);
  void begin_edit(int row, int field);
  void follow_run();
  void restore();
  void accept(int row, int field, const std::vector<double>& values, bool in_burst);
  void hand_out_typed(int row, int field, const std::function<void()>& hand_out);

  std::shared_ptr<const Scene> scene_;
  std::optional<DurationAndStops> duration_and_stops_;
  std::vector<std::string> names_;
  std::optional<PartId> part_;
  Keeps keeps_ = Keeps::kDensity;
  std::vector<Body> bodies_;
  std::optional<InspectedPart> shown_part_;
  std::set<QString> unfolded_;  // lists of the selection
  std::vector<InspectedRow> rows_;
  QStringList layout_;  // which rows are built
  std::vector<InspectorRow*> row_widgets_;
  QPointer<InspectorRow> told_;  // which says why a text was dropped
  int burst_ = 0;
  std::vector<double> before_burst_;
  // A pull changes what there was at its beginning: a speed that comes from 0 again keeps its direction.
  std::optional<Inspected> pulled_;
  std::pair<std::size_t, std::size_t> pulled_at_;  // its row and field
  bool hands_out_ = false;                         // what is typed
  QString refusal_;                                // of that
  bool plays_ = false;
  bool played_ = false;  // when the scene was last shown

  QScrollArea* scroll_;
  QWidget* content_;
  QVBoxLayout* column_;
  QWidget* bar_;
  QHBoxLayout* top_;  // of the bar
  QToolButton* back_;
  NameField* name_;  // the title, if it is that of one body
  QLabel* name_fault_;
  QLabel* title_;
  QLabel* kind_;
  QWidget* group_tools_ = nullptr;
  QWidget* list_ = nullptr;  // of the rows
  QLabel* hint_;
  QLabel* sentence_;
};

}  // namespace carom
