#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/preset/json_text.h"
#include "physics/scene/limits.h"
#include "physics/scene/scene.h"
#include "physics/scene/validate.h"

// Reads a preset file value by value; each error is one line with the JSON pointer of the place. The same
// functions describe the format: a reader without a value records in a JSON Schema what it would have read.
// So each key is stated once, with its kind, range, unit and meaning.
namespace carom {

class FieldReader;

// Limits of the number of elements of a list, or of characters of a text.
struct Count {
  std::size_t least = 0;
  std::size_t most = 0;
};

inline constexpr Count kName{1, kLongestName};
inline constexpr Count kStem{1, kLongestStem};
inline constexpr Count kPerhapsName{0, kLongestName};
inline constexpr Count kWords{0, kLongestTitle};
inline constexpr Count kText{0, kLongestText};

// Whole numbers from low to high.
struct Whole {
  double low;
  double high;
};

// The words that stand for the ids of a table.
template <class Table>
[[nodiscard]] std::vector<std::string> words_of(const Table& table) {
  std::vector<std::string> words;
  for (const auto& row : table) {
    if constexpr (requires { row.name; }) {
      words.emplace_back(row.name);
    } else if constexpr (requires { row.second; }) {
      words.emplace_back(row.second);
    } else {
      words.emplace_back(row);
    }
  }
  return words;
}

// One value and its place.
class ValueReader {
 public:
  ValueReader(const Json& value, std::string place) : value_(&value), place_(std::move(place)) {}
  explicit ValueReader(Json& schema) : schema_(&schema) {}

  // False while the format is described; the functions below then return placeholders.
  [[nodiscard]] bool has_value() const { return value_ != nullptr; }
  [[nodiscard]] bool is_object() const { return has_value() && value_->is_object(); }
  [[nodiscard]] bool has(const std::string& key) const { return is_object() && value_->contains(key); }
  [[nodiscard]] const std::string& place() const { return place_; }
  [[nodiscard]] const Json& value() const { return *value_; }

  [[nodiscard]] double number(const Range& range) const;
  [[nodiscard]] std::int64_t whole(const Whole& range) const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string text(const Count& length) const;
  [[nodiscard]] Vec2 pair(const Range& x, const Range& y) const;
  [[nodiscard]] Vec2 pair(const Range& both) const { return pair(both, both); }
  // The index of one of the words.
  [[nodiscard]] std::size_t word(const std::vector<std::string>& words) const;
  void list(const Count& count, const std::function<void(const ValueReader&)>& each) const;
  void object(const std::function<void(FieldReader&)>& read) const;
  // An object of numbers under keys of any name.
  void numbers(std::size_t most, const Range& range,
               const std::function<void(const std::string&, double)>& each) const;
  // An object whose members are not checked.
  [[nodiscard]] std::string free_object() const;
  // Reads the value as the chosen one of several forms, or describes all of them.
  void one_of(std::size_t chosen, std::initializer_list<std::function<void(const ValueReader&)>> forms) const;

 private:
  [[noreturn]] void refuse(const std::string& allowed) const { refuse_value(place_, quoted(*value_), allowed); }

  const Json* value_ = nullptr;
  Json* schema_ = nullptr;
  std::string place_;
};

// A key of an object, and its meaning for the description of the format.
struct Key {
  const char* name;
  const char* meaning;
};

// Reads the members of one object; finish() refuses keys that were not asked for.
class FieldReader {
 public:
  explicit FieldReader(const ValueReader& value);
  FieldReader() : described_(Json::object()) {}  // describes

  [[nodiscard]] std::string at(std::string_view key) const { return place_ + "/" + pointer_token(key); }
  [[nodiscard]] bool reads() const { return object_ != nullptr; }
  [[nodiscard]] bool has(const std::string& key) const { return reads() && object_->contains(key); }

  // Calls read(member) if the key is there, or to describe it.
  template <class Read>
  void member(const Key& key, const Read& read) {
    if (const auto value = find(key)) read(*value);
  }
  template <class Read>
  void needed(const Key& key, const Read& read) {
    if (!reads()) required_.emplace_back(key.name);
    if (const auto value = find(key)) {
      read(*value);
      return;
    }
    Json description = Json::object();
    read(ValueReader(description));
    refuse_missing(key, description);
  }

  void read(const Key& key, double& to, const Range& range) {
    member(key, [&](const ValueReader& v) { to = v.number(range); });
  }
  void read(const Key& key, std::optional<double>& to, const Range& range) {
    member(key, [&](const ValueReader& v) { to = v.number(range); });
  }
  void read(const Key& key, Vec2& to, const Range& range) {
    member(key, [&](const ValueReader& v) { to = v.pair(range); });
  }
  void read(const Key& key, bool& to) {
    member(key, [&](const ValueReader& v) { to = v.boolean(); });
  }
  void read(const Key& key, std::string& to, const Count& length) {
    member(key, [&](const ValueReader& v) { to = v.text(length); });
  }
  template <class Integer>
  void read(const Key& key, Integer& to, const Whole& range) {
    member(key, [&](const ValueReader& v) { to = static_cast<Integer>(v.whole(range)); });
  }
  void require(const Key& key, double& to, const Range& range) {
    needed(key, [&](const ValueReader& v) { to = v.number(range); });
  }
  void require(const Key& key, Vec2& to, const Range& range) {
    needed(key, [&](const ValueReader& v) { to = v.pair(range); });
  }
  void require(const Key& key, std::string& to, const Count& length) {
    needed(key, [&](const ValueReader& v) { to = v.text(length); });
  }
  // One of the words of a table of ids.
  template <class Table, class Id>
  void read_choice(const Key& key, const Table& table, Id& to) {
    member(key, [&](const ValueReader& v) { choose(v, table, to); });
  }
  template <class Table, class Id>
  void require_choice(const Key& key, const Table& table, Id& to) {
    needed(key, [&](const ValueReader& v) { choose(v, table, to); });
  }
  // Lists of objects.
  void read_objects(const Key& key, std::size_t most,
                    const std::function<void(FieldReader&, const std::string& place)>& each);

  // A word under `key` that says which other keys there are: cases[i] for words[i].
  void cases(const Key& key, const std::vector<std::string>& words,
             const std::function<void(std::size_t, FieldReader&)>& each);
  // A condition on several keys, as JSON Schema; the reader checks it separately.
  void also(Json condition) {
    if (!reads()) conditions_.push_back(std::move(condition));
  }

  // Refuses unknown keys.
  void finish() const;
  // The description so far.
  [[nodiscard]] Json schema() const;

 private:
  template <class Table, class Id>
  static void choose(const ValueReader& v, const Table& table, Id& to) {
    const std::size_t i = v.word(words_of(table));
    if constexpr (requires { table[i].id; }) {
      to = table[i].id;
    } else {
      to = table[i].first;
    }
  }
  [[nodiscard]] std::optional<ValueReader> find(const Key& key);
  [[noreturn]] void refuse_missing(const Key& key, const Json& description) const;

  const Json* object_ = nullptr;
  std::string place_;
  std::vector<std::string> known_;

  // Of a description: the keys, the required ones, the cases as separate objects.
  Json described_;
  std::vector<std::string> required_;
  std::vector<FieldReader> cases_;
  std::vector<Json> conditions_;
};

}  // namespace carom
