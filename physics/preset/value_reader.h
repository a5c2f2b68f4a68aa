#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/preset/json_text.h"
#include "physics/scene/scene.h"
#include "physics/scene/validate.h"

// Reads a preset file value by value; each error is one line with the JSON pointer of the place. The same
// functions describe the format: a reader without a value records in a JSON Schema what it would have read.
// The keys of a scene stand beside its types: see physics/scene/fields.h.
namespace carom {

class FieldReader;

inline constexpr Count kWords{0, kLongestTitle};
inline constexpr Count kText{0, kLongestText};

[[nodiscard]] inline Json pair_json(const Vec2& v) { return Json::array({v.x(), v.y()}); }

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
  void get(double& to, const Range& range) const { to = number(range); }
  void get(std::optional<double>& to, const Range& range) const { to = number(range); }
  void get(Vec2& to, const Range& range) const { to = pair(range); }
  void get(std::string& to, const Count& length) const { to = text(length); }
  template <class Integer>
  void get(Integer& to, const Whole& range) const {
    to = static_cast<Integer>(whole(range));
  }
  // An object that is not looked into.
  [[nodiscard]] std::string free_object() const;
  // Reads the value as the chosen one of several forms, or describes all of them.
  void one_of(std::size_t chosen, std::initializer_list<std::function<void(const ValueReader&)>> forms) const;

 private:
  [[noreturn]] void refuse(const std::string& allowed) const { refuse_value(place_, quoted(*value_), allowed); }

  const Json* value_ = nullptr;
  Json* schema_ = nullptr;
  std::string place_;
};

class FieldReader;
// What fields() writes of a value (below).
template <class T>
[[nodiscard]] Json written(const T& value, bool all);

// The visitor of fields.h that reads the members of one object, or writes or describes them. After reading,
// finish() refuses keys that were not asked for.
class FieldReader {
 public:
  explicit FieldReader(const ValueReader& value);
  FieldReader() : described_(Json::object()) {}  // describes
  enum class Write { kAll, kUnusual };
  explicit FieldReader(Write what) : write_(what), described_(Json::object()) {}

  [[nodiscard]] std::string at(std::string_view key) const { return place_ + "/" + pointer_token(key); }
  [[nodiscard]] bool reads() const { return object_ != nullptr; }
  [[nodiscard]] bool writes() const { return write_.has_value(); }
  [[nodiscard]] bool writes_all() const { return write_ == Write::kAll; }
  [[nodiscard]] bool has(const std::string& key) const { return reads() && object_->contains(key); }

  // Calls read(member) if the key is there, or to describe it.
  template <class Read>
  void member(const Key& key, const Read& read) {
    if (writes()) return;
    if (const auto value = find(key)) read(*value);
  }
  template <class Read>
  void needed(const Key& key, const Read& read) {
    if (!reads()) required_.emplace_back(key.name);
    if (writes()) return;
    if (const auto value = find(key)) {
      read(*value);
      return;
    }
    Json description = Json::object();
    read(ValueReader(description));
    refuse_missing(key, description);
  }

  template <class T, class Kind>
  void field(const Key& key, T& to, const Kind& kind) {
    put(key.name, to);
    member(key, [&](const ValueReader& v) { v.get(to, kind); });
  }
  void field(const Key& key, bool& to) {
    put(key.name, to);
    member(key, [&](const ValueReader& v) { to = v.boolean(); });
  }
  template <class T, class Kind>
  void required(const Key& key, T& to, const Kind& kind) {
    put(key.name, to);
    needed(key, [&](const ValueReader& v) { v.get(to, kind); });
  }
  // One of the words of a table of ids.
  template <class Table, class Id>
  void choice(const Key& key, const Table& table, Id& to) {
    const std::vector<std::string> words = words_of(table);
    if (writes()) put(key.name, words[index_of(table, to)]);
    member(key, [&](const ValueReader& v) { to = table[v.word(words)].id; });
  }
  template <class T>
  void object(const Key& key, std::optional<T>& to) {
    if (writes() && to) put(key.name, written(*to, writes_all()));
    member(key, [&](const ValueReader& v) { v.object([&](FieldReader& r) { fields(r, to.emplace()); }); });
  }
  template <class T>
  void required_object(const Key& key, T& to) {
    if (writes()) put(key.name, written(to, false));
    needed(key, [&](const ValueReader& v) { v.object([&](FieldReader& r) { fields(r, to); }); });
  }
  template <class T>
  void alternative(const Key& key, T& to) {
    if (writes()) put(key.name, written(to, false));
    member(key, [&](const ValueReader& v) { v.object([&](FieldReader& r) { fields(r, to); }); });
  }
  void compound(const Key& key, Shape& shape, const Count& count);
  void points(const Key& key, std::vector<Vec2>& list, const Count& count, const Range& range);
  void numbers(const Key& key, std::vector<double>& list, const Count& count, const Range& range);
  void ends_of_range(const Key& key, double& low, double& high, const Range& range);
  void two_names(const Key& key, std::string& a, std::string& b);
  // Lists of objects.
  void read_objects(const Key& key, std::size_t most,
                    const std::function<void(FieldReader&, const std::string& place)>& each);

  // A word under `key` that says which other keys there are: cases[i] for words[i]; of what is written the
  // chosen one.
  void cases(const Key& key, const std::vector<std::string>& words, std::size_t chosen,
             const std::function<void(std::size_t, FieldReader&)>& each);
  void together(const KeysTogether& rule);
  [[nodiscard]] bool shows(bool condition) const { return !writes() || condition; }
  void follows(double& member, double other) const {
    if (!writes()) member = other;
  }
  // Written where all members are: every number has a place then.
  void stands_for(const char* key, double value, bool condition) {
    if (writes_all() && condition) put(key, value);
  }
  template <class Id>
  void chosen(Id& member, Id id) const {
    member = id;
  }
  // A condition on several keys, as JSON Schema; the reader checks it separately.
  void also(Json condition) {
    if (!reads()) conditions_.push_back(std::move(condition));
  }

  // Writes a member, where it writes at all: also what it cannot write by itself.
  template <class T>
  void put(const char* key, const T& value) {
    if (!writes()) return;
    if constexpr (std::is_same_v<T, std::optional<double>>) {
      if (value) described_[key] = *value;
    } else if constexpr (std::is_same_v<T, Vec2>) {
      described_[key] = pair_json(value);
    } else {
      described_[key] = value;
    }
  }
  // Written even if it holds its default.
  void keep(std::initializer_list<const char*> keys) {
    if (writes()) required_.insert(required_.end(), keys.begin(), keys.end());
  }
  // What was written but for what is there by default.
  [[nodiscard]] Json written_beside(const FieldReader& usual) const;

  // Refuses unknown keys.
  void finish() const;
  // The description so far.
  [[nodiscard]] Json schema() const;

 private:
  [[nodiscard]] std::optional<ValueReader> find(const Key& key);
  [[noreturn]] void refuse_missing(const Key& key, const Json& description) const;

  const Json* object_ = nullptr;
  std::optional<Write> write_;
  std::string place_;
  std::vector<std::string> known_;

  // What is written. Of a description: the keys, those that must be there, the cases as objects of their own.
  Json described_;
  std::vector<std::string> required_;
  std::vector<FieldReader> cases_;
  std::vector<Json> conditions_;
};

// What `read` reads; members that hold their default are left out, as people leave them out, unless `all` of
// them are asked for.
template <class T, class Read>
[[nodiscard]] Json written_by(T value, bool all, const Read& read) {
  FieldReader members(all ? FieldReader::Write::kAll : FieldReader::Write::kUnusual);
  read(members, value);
  FieldReader usual(FieldReader::Write::kUnusual);
  T plain{};
  if (!all) read(usual, plain);
  return members.written_beside(usual);
}

template <class T>
Json written(const T& value, bool all) {
  return written_by(value, all, [](FieldReader& r, T& members) { fields(r, members); });
}

}  // namespace carom
