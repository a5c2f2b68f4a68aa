#include "widgets/scene/scene_accessible.h"

#include <algorithm>
#include <utility>

#include "widgets/scene/body_text.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/scene_view.h"

namespace carom {

// What a list has beside widgets, by its place among its kind: without parts of its own, and with one action.
class SceneAccessible::Part : public QAccessibleInterface, public QAccessibleActionInterface {
 public:
  Part(SceneView& view, int index) : view_(view), index_(index) {}

  [[nodiscard]] QObject* object() const override { return nullptr; }
  [[nodiscard]] QWindow* window() const override { return view_.window()->windowHandle(); }
  [[nodiscard]] QAccessibleInterface* parent() const override {
    return QAccessible::queryAccessibleInterface(&view_);
  }
  [[nodiscard]] QAccessibleInterface* child(int) const override { return nullptr; }
  [[nodiscard]] QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  [[nodiscard]] int childCount() const override { return 0; }
  [[nodiscard]] int indexOfChild(const QAccessibleInterface*) const override { return -1; }
  void setText(QAccessible::Text, const QString&) override {}
  void* interface_cast(QAccessible::InterfaceType type) override {
    return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this) : nullptr;
  }
  [[nodiscard]] QStringList actionNames() const override { return {pressAction()}; }
  [[nodiscard]] QStringList keyBindingsForAction(const QString&) const override { return {}; }

 protected:
  [[nodiscard]] SceneView& view() const { return view_; }
  [[nodiscard]] int index() const { return index_; }
  [[nodiscard]] bool is_offscreen() const {
    return !rect().intersects(QRect(view_.mapToGlobal(QPoint()), view_.size()));
  }

 private:
  SceneView& view_;
  int index_;
};

class SceneAccessible::Item : public Part {
 public:
  using Part::Part;

  [[nodiscard]] bool isValid() const override {
    return view().frame() != nullptr && index() < carom::body_count(*view().frame());
  }
  [[nodiscard]] QAccessible::Role role() const override { return QAccessible::ListItem; }

  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    return kind == QAccessible::Name && isValid() ? spoken_text(*view().frame(), index()) : QString();
  }

  [[nodiscard]] QRect rect() const override {
    if (!isValid()) return {};
    const WorldRect around = bounds(*view().frame(), {name()});
    if (around.empty()) return QRect(view().mapToGlobal(QPoint()), view().size());  // a half-plane
    const QRectF shown =
        QRectF(view().camera().to_screen(around.lower), view().camera().to_screen(around.upper)).normalized();
    return shown.toAlignedRect().translated(view().mapToGlobal(QPoint()));
  }

  [[nodiscard]] QAccessible::State state() const override {
    QAccessible::State state;
    if (!isValid()) {
      state.invalid = true;
      return state;
    }
    const std::vector<std::string>& selected = view().selection();
    state.focusable = state.selectable = state.multiSelectable = true;
    state.selected = std::find(selected.begin(), selected.end(), name()) != selected.end();
    state.focused = view().hasFocus() && !selected.empty() && selected.back() == name();
    state.offscreen = is_offscreen();
    return state;
  }

  void doAction(const QString& action) override {
    if (action == pressAction() && isValid()) view().select({name()});
  }

 private:
  [[nodiscard]] const std::string& name() const {
    return (*view().frame()->bodies)[static_cast<std::size_t>(index())].name;
  }
};

class SceneAccessible::HandleItem : public Part {
 public:
  using Part::Part;

  [[nodiscard]] bool isValid() const override { return told().has_value(); }
  [[nodiscard]] QAccessible::Role role() const override { return QAccessible::Button; }
  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    const auto handle = told();
    if (!handle) return {};
    if (kind == QAccessible::Name) return handle->name;
    return kind == QAccessible::Value ? handle->value : QString();
  }
  [[nodiscard]] QRect rect() const override {
    const auto handle = told();
    if (!handle) return {};
    constexpr int kSize = 2 * static_cast<int>(kHandleReach);
    const QPoint corner = handle->at.toPoint() - QPoint(kSize / 2, kSize / 2);
    return QRect(view().mapToGlobal(corner), QSize(kSize, kSize));
  }
  [[nodiscard]] QAccessible::State state() const override {
    QAccessible::State state;
    state.invalid = !isValid();
    state.offscreen = isValid() && is_offscreen();
    return state;
  }
  void doAction(const QString& action) override {
    if (action == pressAction()) view().type_handle(static_cast<std::size_t>(index()));
  }

 private:
  [[nodiscard]] std::optional<SceneTools::ToldHandle> told() const {
    const std::vector<SceneTools::ToldHandle> all = view().told_handles();
    const auto place = static_cast<std::size_t>(index());
    return place < all.size() ? std::optional(all[place]) : std::nullopt;
  }
};

SceneAccessible::SceneAccessible(SceneView* view) : QAccessibleWidget(view, QAccessible::List), view_(*view) {}

SceneAccessible::~SceneAccessible() {
  for (const auto* parts : {&items_, &handles_}) {
    for (const QAccessible::Id id : *parts) QAccessible::deleteAccessibleInterface(id);
  }
}

QAccessibleInterface* SceneAccessible::make(const QString&, QObject* object) {
  auto* view = qobject_cast<SceneView*>(object);
  return view == nullptr ? nullptr : new SceneAccessible(view);
}

int SceneAccessible::body_count() const {
  return view_.frame() == nullptr ? 0 : carom::body_count(*view_.frame());
}

int SceneAccessible::handle_count() const { return static_cast<int>(view_.told_handles().size()); }

int SceneAccessible::childCount() const {
  return body_count() + handle_count() + QAccessibleWidget::childCount();
}

QAccessibleInterface* SceneAccessible::child(int index) const {
  const auto part = [](std::vector<QAccessible::Id>& parts, int place, const auto& make) {
    while (static_cast<int>(parts.size()) <= place)
      parts.push_back(QAccessible::registerAccessibleInterface(make(static_cast<int>(parts.size()))));
    return QAccessible::accessibleInterface(parts[static_cast<std::size_t>(place)]);
  };
  if (index < 0) return nullptr;
  if (index < body_count()) return part(items_, index, [this](int place) { return new Item(view_, place); });
  index -= body_count();
  if (index < handle_count())
    return part(handles_, index, [this](int place) { return new HandleItem(view_, place); });
  return QAccessibleWidget::child(index - handle_count());
}

int SceneAccessible::indexOfChild(const QAccessibleInterface* child) const {
  if (child == nullptr) return -1;
  if (child->object() != nullptr) {
    const int widget = QAccessibleWidget::indexOfChild(child);
    return widget < 0 ? -1 : body_count() + handle_count() + widget;
  }
  const QAccessible::Id id = QAccessible::uniqueId(const_cast<QAccessibleInterface*>(child));
  const auto place_in = [id](const std::vector<QAccessible::Id>& parts) {
    const auto same = std::find(parts.begin(), parts.end(), id);
    return same == parts.end() ? -1 : static_cast<int>(same - parts.begin());
  };
  if (!child->isValid()) return -1;
  const int body = place_in(items_);
  const int handle = place_in(handles_);
  return handle < 0 ? body : body_count() + handle;
}

QAccessibleInterface* SceneAccessible::childAt(int x, int y) const {
  const QPoint at = view_.mapFromGlobal(QPoint(x, y));
  if (!view_.rect().contains(at)) return nullptr;
  QAccessibleInterface* widget = QAccessibleWidget::childAt(x, y);
  if (widget != nullptr && widget->object() != view_.canvas()) return widget;
  if (const auto handle = view_.handle_under(at)) return child(body_count() + static_cast<int>(*handle));
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
