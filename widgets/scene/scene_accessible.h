#pragma once

#include <QAccessibleWidget>
#include <optional>
#include <string>
#include <vector>

#include "physics/record/frame.h"

namespace carom {

class SceneView;

// What a screen reader finds in a SceneView: a list whose items are the bodies, in the order of the frame, each
// named by spoken_text() and selected by its action; then the handles around what is selected, each with its
// value, which its action types; then the widgets that lie over the scene.
class SceneAccessible : public QAccessibleWidget {
 public:
  explicit SceneAccessible(SceneView* view);
  ~SceneAccessible() override;
  SceneAccessible(const SceneAccessible&) = delete;
  SceneAccessible& operator=(const SceneAccessible&) = delete;

  // For QAccessible::installFactory().
  static QAccessibleInterface* make(const QString& class_name, QObject* object);

  [[nodiscard]] int childCount() const override;
  [[nodiscard]] QAccessibleInterface* child(int index) const override;
  [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override;
  [[nodiscard]] QAccessibleInterface* childAt(int x, int y) const override;
  [[nodiscard]] QAccessibleInterface* focusChild() const override;

 private:
  class Part;
  class Item;
  class HandleItem;

  [[nodiscard]] int body_count() const;
  [[nodiscard]] int handle_count() const;

  SceneView& view_;
  // Made when they are asked for; QAccessible owns them.
  mutable std::vector<QAccessible::Id> items_, handles_;
};

// What screen readers are told of the body that was selected last, and only while nothing plays: that would be
// a running clock.
class SpokenBody {
 public:
  struct News {
    QAccessible::Event event;
    int body;
  };
  // Another selection; another frame.
  [[nodiscard]] std::optional<News> selected(const Frame* frame, const std::vector<std::string>& selection);
  [[nodiscard]] std::optional<News> shown(const Frame* frame, const std::vector<std::string>& selection);

 private:
  QString text_;  // as told
};
// To those that are there.
void tell(SceneView& view, const std::optional<SpokenBody::News>& news);

}  // namespace carom
