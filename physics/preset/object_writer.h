#pragma once

#include <string>

#include "physics/preset/json_text.h"
#include "physics/scene/scene.h"

namespace carom {

[[nodiscard]] inline Json pair_json(const Vec2& v) { return Json::array({v.x(), v.y()}); }

// Puts together one object. Members that hold their default are left out, as people leave them out, unless
// `all` of them are asked for.
struct ObjectWriter {
  explicit ObjectWriter(bool write_all) : all(write_all) {}

  template <class T>
  void put(const char* key, const T& value, const T& usual) {
    if (all || value != usual) json[key] = value;
  }
  void put(const char* key, const Vec2& value, const Vec2& usual) {
    if (all || value != usual) json[key] = pair_json(value);
  }

  bool all;
  Json json;
};

}  // namespace carom
