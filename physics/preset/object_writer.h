#pragma once

#include <string>

#include "physics/preset/json_text.h"
#include "physics/scene/scene.h"

namespace carom {

[[nodiscard]] inline Json pair_json(const Vec2& v) { return Json::array({v.x(), v.y()}); }

// Builds one object. Members with their default value are left out, unless `all` is set.
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
