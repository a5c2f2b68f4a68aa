#pragma once

#include <vector>

#include "physics/model/geometry.h"
#include "physics/scene/scene.h"

namespace carom {

// Finds the corners of parts that other parts meet for good, those of the same body, of bodies that don't move
// or of those that one drive moves, and what outward normals remain there (ConvexShapes::cone_at).
void find_corner_cones(const std::vector<Body>& bodies, Geometry& g);

}  // namespace carom
