#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "physics/record/recorder.h"
#include "physics/scene/stop.h"
#include "widgets/theme/theme.h"

class QPainter;

namespace carom {

// One stop on the timeline: at the time that it tells, or at a moment where it was met.
struct TimelineFlag {
  double time = 0.0;     // s
  std::size_t stop = 0;  // its index in the document
  bool met = false;
  bool moves = false;  // a stop at a time
};

// The flags of a document's stops on the timeline.
class TimelineFlags {
 public:
  using XOf = std::function<double(double time)>;  // px

  void set_stops(const std::vector<Stop>& stops);
  // Those that the run met; flags that come closer than `least` (s) to the one before are left out.
  void update_from(const Recorder& recorder, double least);
  [[nodiscard]] const std::vector<TimelineFlag>& all() const { return flags_; }
  [[nodiscard]] QString sentence(std::size_t stop) const;
  // The one under the mouse, within the upper half of the line.
  [[nodiscard]] std::optional<TimelineFlag> at(double x, double y, double middle, const XOf& x_of) const;
  void paint(QPainter& painter, const Theme& theme, double middle, const XOf& x_of,
             std::optional<std::size_t> chosen) const;
  // Where it is drawn while it is dragged, s.
  void drag_to(std::size_t stop, double time);

 private:
  std::vector<Stop> stops_;
  std::vector<TimelineFlag> flags_;
};

// s: rounded to what a pixel can tell, of `pixel` s.
[[nodiscard]] double round_to_pixel(double time, double pixel);

}  // namespace carom
