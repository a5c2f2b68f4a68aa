#include "physics/preset/json_text.h"

#include <fmt/format.h>
#include <set>
#include <vector>

#include "physics/scene/validate.h"

namespace carom {
namespace {

// Follows the parser and knows where it is.
class PlaceKeeper {
 public:
  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    switch (event) {
      case Event::object_start:
      case Event::array_start:
        if (depth > kDeepestNesting) {
          throw SceneError(fmt::format("{}: nested deeper than {} levels; a preset needs five",
                                       shortened(place()), kDeepestNesting));
        }
        frames_.push_back({event == Event::array_start, 0, {}, {}});
        break;
      case Event::key:
        frames_.back().key = parsed.get<std::string>();
        if (!frames_.back().seen.insert(frames_.back().key).second) {
          throw SceneError(fmt::format("{}: this key stands here twice; allowed: once", shortened(place())));
        }
        break;
      case Event::object_end:
      case Event::array_end:
        frames_.pop_back();
        [[fallthrough]];
      case Event::value:
        if (!frames_.empty()) ++frames_.back().index;
        break;
    }
    return true;
  }

 private:
  struct Frame {
    bool array;
    std::size_t index;
    std::string key;
    std::set<std::string> seen;
  };
  [[nodiscard]] std::string place() const {
    std::string path;
    for (const Frame& f : frames_) path += "/" + (f.array ? std::to_string(f.index) : f.key);
    return path.empty() ? "/" : path;
  }
  std::vector<Frame> frames_;
};

}  // namespace

std::string quoted(const Json& value) {
  return shortened(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

Json parse_json(std::string_view text) {
  try {
    PlaceKeeper keeper;
    return Json::parse(text.begin(), text.end(), [&](int depth, Json::parse_event_t event, Json& parsed) {
      return keeper(depth, event, parsed);
    });
  } catch (const Json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error while ..."
    std::string what = error.what();
    if (const auto end = what.find("] "); end != std::string::npos) what = what.substr(end + 2);
    std::string place;
    if (const auto at = what.find(" at line "); at != std::string::npos) {
      if (const auto colon = what.find(": ", at); colon != std::string::npos) {
        place = what.substr(at + 4, colon - at - 4) + ": ";
        what = what.substr(colon + 2);
      }
    }
    if (what.find("number overflow") != std::string::npos) {
      const auto quote = what.find('\'');
      throw SceneError(fmt::format("{}the number {} is too large; allowed: up to 1e12 in SI units", place,
                                   quote == std::string::npos ? "" : shortened(what.substr(quote))));
    }
    if (const auto last = what.find("; last read: "); last != std::string::npos) {
      what = what.substr(0, last) + "; last read: " + shortened(what.substr(last + 13));
    }
    throw SceneError(fmt::format("{}this is not JSON: {}; allowed: a JSON object", place, what.substr(0, 240)));
  }
}

}  // namespace carom
