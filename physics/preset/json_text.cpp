#include "physics/preset/json_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <vector>

#include "physics/scene/validate.h"

namespace carom {
namespace {

// "line 3, column 5" of the byte at `position`, counted from 1 in bytes as editors of code do.
std::string line_and_column(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("line {}, column {}", line, before.size() - start + 1);
}

// Builds the tree. Keys are looked up in a separate set, because ordered objects search all their keys.
class TreeBuilder final : public nlohmann::json_sax<Json> {
 public:
  explicit TreeBuilder(std::string_view text) : text_(text) {}

  [[nodiscard]] Json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return start(Json::object()); }
  bool key(string_t& name) override {
    Frame& frame = frames_.back();
    frame.key = std::move(name);
    if (!frame.seen.insert(frame.key).second)
      throw SceneError(fmt::format("{}: this key stands here twice; allowed: once", shortened(place())));
    return true;
  }
  bool end_object() override { return end(); }
  bool start_array(std::size_t) override { return start(Json::array()); }
  bool end_array() override { return end(); }

  bool parse_error(std::size_t position, const std::string& last, const Json::exception& error) override {
    if (dynamic_cast<const Json::out_of_range*>(&error) != nullptr) {
      // The position is just behind the number.
      throw SceneError(fmt::format("{}, {}: the number {} is too large; allowed: up to {} in SI units",
                                   line_and_column(text_, position - std::min(position, last.size())),
                                   shortened(place()), shortened(last), kLargestNumber));
    }
    // "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error while ...; last read:
    // '...'"
    std::string what = error.what();
    if (const auto colon = what.find(": ", std::min(what.find(" at line "), what.size()));
        colon != std::string::npos)
      what = what.substr(colon + 2);
    std::string read;
    if (const auto at = what.find("; last read: "); at != std::string::npos) {
      read = "; last read: " + shortened(what.substr(at + 13));
      what = what.substr(0, at);
    }
    throw SceneError(fmt::format("{}: this is not JSON: {}{}; allowed: a JSON object",
                                 line_and_column(text_, position > 0 ? position - 1 : 0), shortened(what, 160),
                                 read));
  }

 private:
  struct Frame {
    Json* value;
    std::string key;
    std::set<std::string> seen;
  };

  bool add(Json&& value) {
    (void)put(std::move(value));
    return true;
  }
  bool start(Json&& value) {
    if (static_cast<int>(frames_.size()) >= kDeepestNesting) {
      throw SceneError(fmt::format("{}: nested deeper than {} levels; a preset needs five; allowed: up to {}",
                                   shortened(place()), kDeepestNesting, kDeepestNesting));
    }
    frames_.push_back({put(std::move(value)), {}, {}});
    return true;
  }
  bool end() {
    frames_.pop_back();
    return true;
  }

  Json* put(Json&& value) {
    if (frames_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Frame& frame = frames_.back();
    if (frame.value->size() >= kMostMembers) {
      throw SceneError(fmt::format("{}: more than {} {}; allowed: up to {}", shortened(place_of_frame()),
                                   kMostMembers, frame.value->is_array() ? "elements" : "keys", kMostMembers));
    }
    if (frame.value->is_array()) {
      auto& array = frame.value->get_ref<Json::array_t&>();
      array.push_back(std::move(value));
      return &array.back();
    }
    // Appends to the list below the map, which would search all keys.
    using Members = std::vector<Json::object_t::value_type>;
    auto& members = static_cast<Members&>(frame.value->get_ref<Json::object_t&>());
    members.emplace_back(frame.key, std::move(value));
    return &members.back().second;
  }

  // The pointer of the object or array that is being read.
  [[nodiscard]] std::string place_of_frame() const {
    std::string path;
    for (std::size_t i = 0; i + 1 < frames_.size(); ++i) path += "/" + step(frames_[i], 1);
    return path.empty() ? "/" : path;
  }
  // The pointer of the value that is next, or of the key that was read last.
  [[nodiscard]] std::string place() const {
    if (frames_.empty()) return "/";
    const std::string path = place_of_frame();
    return (path == "/" ? "" : path) + "/" + step(frames_.back(), 0);
  }
  // An array counts the element that is being read, once it has begun.
  static std::string step(const Frame& frame, std::size_t begun) {
    return frame.value->is_array() ? std::to_string(frame.value->size() - begun) : pointer_token(frame.key);
  }

  std::string_view text_;
  Json root_;
  std::vector<Frame> frames_;  // the values in it stay where they are: only the last one grows
};

}  // namespace

std::string quoted(const Json& value) {
  return shortened(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string pointer_token(std::string_view key) {
  std::string token;
  for (const char c : key) {
    if (c == '~')
      token += "~0";
    else if (c == '/')
      token += "~1";
    else
      token += c;
  }
  return token;
}

Json parse_json(std::string_view text) {
  // The parser takes a NUL for the end of the text.
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    throw SceneError(
        fmt::format("{}: a NUL character is not allowed; allowed: text in UTF-8", line_and_column(text, nul)));
  }
  if (const std::size_t bad = first_bad_byte(text); bad != text.size()) {
    throw SceneError(fmt::format("{}: the byte {} is not allowed; allowed: text in UTF-8",
                                 line_and_column(text, bad), printable(text.substr(bad, 1))));
  }
  TreeBuilder builder(text);
  (void)Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace carom
