#pragma once

#include <string>
#include <vector>

#include "physics/collision/convex.h"

namespace carom {

// What became of a list of vertices that someone wrote: either `vertices` or a `problem` in one line.
struct TidyPolygon {
  std::vector<Vec2> vertices;  // strictly convex, counter-clockwise, 3 to kMostVertices; in the given frame
  std::string problem;         // empty if there is none
  int vertex = -1;             // the place in the given list that the problem is about, if it is about one
};

// Two points nearer than this are one, and a vertex nearer than this to the line through its neighbours is
// none; relative to the larger side of the rectangle around all points. Files and hands round more coarsely
// than doubles do; no edge that matters to anyone is that short.
inline constexpr double kTidyTolerance = 1e-9;

// Turns clockwise lists round, drops repeated and collinear vertices, and refuses lists that are not finite, of
// fewer than three vertices then, of more than kMostVertices, that go round more than once, cross themselves or
// bend inwards. The list starts with the first vertex that is kept.
[[nodiscard]] TidyPolygon tidy_polygon(const std::vector<Vec2>& given);

}  // namespace carom
