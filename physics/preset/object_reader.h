#pragma once

#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "physics/preset/json_text.h"
#include "physics/scene/scene.h"
#include "physics/scene/validate.h"

// Reads the values of a preset file one by one; each error is one line with the JSON pointer of the place.
namespace carom {

inline double number(const Json& value, const std::string& place) {
  if (!value.is_number()) refuse_value(place, quoted(value), "a number");
  const auto x = value.get<double>();
  if (!(std::abs(x) <= kLargestNumber))
    refuse_value(place, quoted(value), fmt::format("a number from -{0} to {0}", kLargestNumber));
  return x;
}

inline Vec2 pair_of_numbers(const Json& value, const std::string& place) {
  if (!value.is_array() || value.size() != 2) refuse_value(place, quoted(value), "two numbers, [x, y]");
  return {number(value[0], place + "/0"), number(value[1], place + "/1")};
}

// The words of a table of pairs (see names.h), as a message lists them.
template <class Table>
std::string quoted_names(const Table& table) {
  std::string names;
  for (const auto& [id, name] : table) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", name);
  return names;
}

// Reads the members of one object; finish() refuses keys that were not asked for.
class ObjectReader {
 public:
  ObjectReader(const Json& object, std::string place) : object_(object), place_(std::move(place)) {
    if (!object.is_object()) refuse_value(place_, quoted(object), "an object, {...}");
  }

  [[nodiscard]] std::string at(std::string_view key) const { return fmt::format("{}/{}", place_, key); }

  const Json* find(const std::string& key) {
    known_.insert(key);
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }
  const Json& require(const std::string& key, std::string_view allowed) {
    const Json* value = find(key);
    if (value == nullptr)
      throw SceneError(
          fmt::format("{}: \"{}\" is missing; allowed: {}", place_.empty() ? "/" : place_, key, allowed));
    return *value;
  }

  void read(const std::string& key, double& to) {
    if (const Json* v = find(key)) to = number(*v, at(key));
  }
  void read(const std::string& key, std::optional<double>& to) {
    if (const Json* v = find(key)) to = number(*v, at(key));
  }
  void read(const std::string& key, Vec2& to) {
    if (const Json* v = find(key)) to = pair_of_numbers(*v, at(key));
  }
  void read(const std::string& key, bool& to) {
    if (const Json* v = find(key)) {
      if (!v->is_boolean()) refuse_value(at(key), quoted(*v), "true or false");
      to = v->get<bool>();
    }
  }
  void read(const std::string& key, std::string& to) {
    if (const Json* v = find(key)) to = text(*v, at(key));
  }
  template <class Integer>
  void read_integer(const std::string& key, Integer& to, double low, double high) {
    if (const Json* v = find(key)) {
      if (!v->is_number_integer() || v->get<double>() < low || v->get<double>() > high) {
        refuse_value(at(key), quoted(*v), fmt::format("a whole number from {} to {}", low, high));
      }
      to = v->get<Integer>();
    }
  }
  void require_number(const std::string& key, double& to, std::string_view unit) {
    to = number(require(key, fmt::format("a number, in {}", unit)), at(key));
  }
  void require_text(const std::string& key, std::string& to) { to = text(require(key, "a text"), at(key)); }

  // One of the names of a table of Choice.
  template <class Table, class Id>
  void read_choice(const std::string& key, const Table& table, Id& to) {
    const Json* v = find(key);
    if (v == nullptr) return;
    std::string names;
    for (const auto& choice : table) {
      if (v->is_string() && v->template get_ref<const std::string&>() == choice.name) {
        to = choice.id;
        return;
      }
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", choice.name);
    }
    refuse_value(at(key), quoted(*v), names);
  }

  // One of the words of a table of pairs (see names.h).
  template <class Table, class Id>
  void read_name(const std::string& key, const Table& table, Id& to) {
    const Json* v = find(key);
    if (v == nullptr) return;
    for (const auto& [id, name] : table) {
      if (v->is_string() && v->template get_ref<const std::string&>() == name) {
        to = id;
        return;
      }
    }
    refuse_value(at(key), quoted(*v), quoted_names(table));
  }

  // Calls each(element, place) for every element of an array.
  template <class Each>
  void read_array(const std::string& key, const Each& each) {
    const Json* v = find(key);
    if (v == nullptr) return;
    if (!v->is_array()) refuse_value(at(key), quoted(*v), "an array, [...]");
    for (std::size_t i = 0; i < v->size(); ++i) each((*v)[i], fmt::format("{}/{}", at(key), i));
  }

  void finish() const {
    for (const auto& item : object_.items()) {
      if (known_.contains(item.key())) continue;
      std::string allowed;
      for (const std::string& key : known_) allowed += (allowed.empty() ? "" : ", ") + key;
      throw SceneError(
          fmt::format("{}: unknown key; allowed here: {}", at(shortened(item.key())), shortened(allowed, 300)));
    }
  }

  static std::string text(const Json& value, const std::string& place) {
    if (!value.is_string()) refuse_value(place, quoted(value), "a text, \"...\"");
    return value.get<std::string>();
  }

 private:
  const Json& object_;
  std::string place_;
  std::set<std::string> known_;
};

}  // namespace carom
