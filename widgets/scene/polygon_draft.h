#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "widgets/scene/shape_tools.h"

namespace carom {

// A polygon that is drawn corner by corner, whose edges don't cross.
class PolygonDraft {
 public:
  [[nodiscard]] const std::vector<Vec2>& corners() const { return corners_; }  // m
  // The newest corner, if it was not set because an edge would cross another.
  [[nodiscard]] const std::optional<Vec2>& refused() const { return refused_; }
  [[nodiscard]] bool empty() const { return corners_.empty(); }
  // A click on the first corner closes it.
  [[nodiscard]] bool can_close() const { return corners_.size() >= 3; }

  // Why no corner can stand there next, in words; empty if one can.
  [[nodiscard]] QString fault_at(const Vec2& corner) const;
  // Likewise why the edge that closes it can't be; there are three corners or more.
  [[nodiscard]] QString fault_of_closing() const;
  void set(const Vec2& corner);
  void take_back();
  void clear();
  // Where edges would cross, the convex hull of all corners, the refused one included. Nothing if there is
  // none.
  [[nodiscard]] std::optional<Drawn> closed() const;
  // Why there is none, in words.
  [[nodiscard]] QString fault_of_closed() const;

 private:
  std::vector<Vec2> corners_;
  std::optional<Vec2> refused_;
};

}  // namespace carom
