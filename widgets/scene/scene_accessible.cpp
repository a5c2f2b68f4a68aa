#include "widgets/scene/scene_accessible.h"

#include <algorithm>
#include <utility>

#include "widgets/scene/body_text.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/scene_view.h"

namespace carom {

// One body, by its place in the frame.
class SceneAccessible::Item : public QAccessibleInterface, public QAccessibleActionInterface {
 public:
  Item(SceneView& view, int index) : view_(view), index_(index) {}

  [[nodiscard]] int index() const { return index_; }
  [[nodiscard]] bool isValid() const override {
    return view_.frame() != nullptr && index_ < carom::body_count(*view_.frame());
  }
  [[nodiscard]] QObject* object() const override { return nullptr; }
  [[nodiscard]] QWindow* window() const override { return view_.window()->windowHandle(); }
  [[nodiscard]] QAccessibleInterface* parent() const override {
    return QAccessible::queryAccessibleInterface(&view_);
  }
  [[nodiscard]] QAccessibleInterface* child(int) const override { return nullptr; }
  [[nodiscard]] QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  [[nodiscard]] int childCount() const override { return 0; }
  [[nodiscard]] int indexOfChild(const QAccessibleInterface*) const override { return -1; }
  [[nodiscard]] QAccessible::Role role() const override { return QAccessible::ListItem; }

  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    return kind == QAccessible::Name && isValid() ? spoken_text(*view_.frame(), index_) : QString();
  }
  void setText(QAccessible::Text, const QString&) override {}

  [[nodiscard]] QRect rect() const override {
    if (!isValid()) return {};
    const WorldRect around = bounds(*view_.frame(), {name()});
    if (around.empty()) return QRect(view_.mapToGlobal(QPoint()), view_.size());  // a half-plane
    const QRectF shown =
        QRectF(view_.camera().to_screen(around.lower), view_.camera().to_screen(around.upper)).normalized();
    return shown.toAlignedRect().translated(view_.mapToGlobal(QPoint()));
  }

  [[nodiscard]] QAccessible::State state() const override {
    QAccessible::State state;
    if (!isValid()) {
      state.invalid = true;
      return state;
    }
    const std::vector<std::string>& selected = view_.selection();
    state.focusable = state.selectable = state.multiSelectable = true;
    state.selected = std::find(selected.begin(), selected.end(), name()) != selected.end();
    state.focused = view_.hasFocus() && !selected.empty() && selected.back() == name();
    state.offscreen = !rect().intersects(QRect(view_.mapToGlobal(QPoint()), view_.size()));
    return state;
  }

  void* interface_cast(QAccessible::InterfaceType type) override {
    return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this) : nullptr;
  }
  [[nodiscard]] QStringList actionNames() const override { return {pressAction()}; }
  void doAction(const QString& action) override {
    if (action == pressAction() && isValid()) view_.select({name()});
  }
  [[nodiscard]] QStringList keyBindingsForAction(const QString&) const override { return {}; }

 private:
  [[nodiscard]] const std::string& name() const {
    return (*view_.frame()->bodies)[static_cast<std::size_t>(index_)].name;
  }

  SceneView& view_;
  int index_;
};

SceneAccessible::SceneAccessible(SceneView* view) : QAccessibleWidget(view, QAccessible::List), view_(*view) {}

SceneAccessible::~SceneAccessible() {
  for (const QAccessible::Id id : items_) QAccessible::deleteAccessibleInterface(id);
}

QAccessibleInterface* SceneAccessible::make(const QString&, QObject* object) {
  auto* view = qobject_cast<SceneView*>(object);
  return view == nullptr ? nullptr : new SceneAccessible(view);
}

int SceneAccessible::body_count() const {
  return view_.frame() == nullptr ? 0 : carom::body_count(*view_.frame());
}

int SceneAccessible::childCount() const { return body_count() + QAccessibleWidget::childCount(); }

QAccessibleInterface* SceneAccessible::child(int index) const {
  if (index < 0) return nullptr;
  if (index >= body_count()) return QAccessibleWidget::child(index - body_count());
  while (static_cast<int>(items_.size()) <= index) {
    items_.push_back(
        QAccessible::registerAccessibleInterface(new Item(view_, static_cast<int>(items_.size()))));
  }
  return QAccessible::accessibleInterface(items_[static_cast<std::size_t>(index)]);
}

int SceneAccessible::indexOfChild(const QAccessibleInterface* child) const {
  if (child == nullptr) return -1;
  if (child->object() != nullptr) {
    const int widget = QAccessibleWidget::indexOfChild(child);
    return widget < 0 ? -1 : body_count() + widget;
  }
  const auto same =
      std::find(items_.begin(), items_.end(), QAccessible::uniqueId(const_cast<QAccessibleInterface*>(child)));
  return same == items_.end() ? -1 : static_cast<int>(same - items_.begin());
}

QAccessibleInterface* SceneAccessible::childAt(int x, int y) const {
  const QPoint at = view_.mapFromGlobal(QPoint(x, y));
  if (!view_.rect().contains(at)) return nullptr;
  QAccessibleInterface* widget = QAccessibleWidget::childAt(x, y);
  if (widget != nullptr && widget->object() != view_.canvas()) return widget;
  const int body = view_.frame() == nullptr ? -1 : body_at(*view_.frame(), view_.camera(), at);
  return body < 0 ? widget : child(body);
}

QAccessibleInterface* SceneAccessible::focusChild() const {
  if (!view_.hasFocus()) return QAccessibleWidget::focusChild();
  for (int i = 0; i < body_count(); ++i) {
    if (child(i)->state().focused) return child(i);
  }
  return nullptr;
}

namespace {

// -1: none of them is selected.
int last_selected(const Frame* frame, const std::vector<std::string>& selection) {
  if (frame == nullptr || frame->playing || selection.empty()) return -1;
  const auto begin = frame->bodies->begin();
  const auto body = std::find_if(begin, begin + body_count(*frame),
                                 [&](const Body& each) { return each.name == selection.back(); });
  return body == begin + body_count(*frame) ? -1 : static_cast<int>(body - begin);
}

}  // namespace

std::optional<SpokenBody::News> SpokenBody::selected(const Frame* frame,
                                                     const std::vector<std::string>& selection) {
  const int body = last_selected(frame, selection);
  if (body < 0) return std::nullopt;
  text_ = spoken_text(*frame, body);
  return News{QAccessible::Focus, body};
}

std::optional<SpokenBody::News> SpokenBody::shown(const Frame* frame,
                                                  const std::vector<std::string>& selection) {
  const int body = last_selected(frame, selection);
  if (body < 0) return std::nullopt;
  QString text = spoken_text(*frame, body);
  if (std::exchange(text_, std::move(text)) == text_) return std::nullopt;
  return News{QAccessible::NameChanged, body};
}

void tell(SceneView& view, const std::optional<SpokenBody::News>& news) {
  if (!news) return;
  QAccessibleEvent event(&view, news->event);
  event.setChild(news->body);  // its place among the children
  QAccessible::updateAccessibility(&event);
}

}  // namespace carom
