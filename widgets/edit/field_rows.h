#pragma once

#include <QString>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "physics/scene/scene.h"

// The members of a body, a material, a joint, a spring or a force as rows that can be shown and set: numbers,
// the components of vectors, and flags, with their ranges and meanings as its fields state them.
namespace carom {

// Nothing where an optional number is not given.
using FieldValue = std::variant<std::monostate, double, bool>;

// Where a member stands in its value.
struct FieldPlace {
  std::string key;  // "mass"; of an object in it "shape/radius", in a list "shapes/0/angle"
  int part = -1;    // 0, 1: x, y of a vector

  bool operator==(const FieldPlace&) const = default;
};

struct FieldRow {
  FieldPlace place;
  QString label;    // for people: "Restitution e", "Position x"
  QString meaning;  // one sentence without its full stop
  Range range;      // with the SI unit; of a flag without meaning
  FieldValue value;
};

[[nodiscard]] FieldRow field_row(const FieldPlace& place, const char* meaning, const Range& range,
                                 const FieldValue& value);

// The visitor of fields.h that calls visit(place, meaning, range, member) for each number, optional number,
// component and flag.
template <class Visit>
class EachMember : public OnlyLooks {
 public:
  explicit EachMember(Visit& visit, std::string before = {}) : visit_(visit), before_(std::move(before)) {}

  void field(const Key& key, auto& member, const Range& range) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, Vec2>) {
      visit_(FieldPlace{before_ + key.name, 0}, key.meaning, range, member.x());
      visit_(FieldPlace{before_ + key.name, 1}, key.meaning, range, member.y());
    } else {
      visit_(FieldPlace{before_ + key.name, -1}, key.meaning, range, member);
    }
  }
  void field(const Key& key, auto& flag) {
    visit_(FieldPlace{before_ + key.name, -1}, key.meaning, Range{}, flag);
  }
  void field(const Key&, const std::string&, const Count&) {}
  void required(const Key& key, auto& member, const auto& kind) { field(key, member, kind); }
  template <class Table, class Id>
  void choice(const Key&, const Table&, Id) {}
  void required_object(const Key& key, auto& member) {
    EachMember inner(visit_, before_ + key.name + "/");
    fields(inner, member);
  }
  void alternative(const Key& key, auto& member) { required_object(key, member); }
  void compound(const Key& key, auto& shape, const Count& /*count*/) {
    auto* compound = std::get_if<Compound>(&shape);
    if (compound == nullptr) return;
    for (std::size_t i = 0; i < compound->shapes.size(); ++i) {
      EachMember inner(visit_, before_ + key.name + "/" + std::to_string(i) + "/");
      fields(inner, compound->shapes[i]);
    }
  }
  void object(const Key& key, auto& member) {
    if (member) required_object(key, *member);
  }
  void points(const Key& key, auto& list, const Count& /*count*/, const Range& range) {
    EachMember inner(visit_, before_ + key.name + "/");
    for (std::size_t i = 0; i < list.size(); ++i)
      inner.field({std::to_string(i).c_str(), key.meaning}, list[i], range);
  }
  [[nodiscard]] static bool shows(bool condition) { return condition; }
  void cases(const Key&, const Words&, std::size_t chosen, const auto& each) { each(chosen, *this); }

 private:
  Visit& visit_;
  std::string before_;
};

// The rows of a value, in the order of its fields.
template <class T>
[[nodiscard]] std::vector<FieldRow> field_rows(const T& value) {
  std::vector<FieldRow> rows;
  auto list = [&rows](const FieldPlace& place, const char* meaning, const Range& range, const auto& member) {
    FieldValue shown;
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, std::optional<double>>) {
      if (member) shown = *member;
    } else {
      shown = member;
    }
    rows.push_back(field_row(place, meaning, range, shown));
  };
  EachMember<decltype(list)> each(list);
  fields(each, value);
  return rows;
}

// A copy of the value in which the member at `place` is `set`. Nothing changes if there is no such member, or
// if it can't hold that.
template <class T>
[[nodiscard]] T with_field(T value, const FieldPlace& place, const FieldValue& set) {
  auto put = [&](const FieldPlace& here, const char* /*meaning*/, const Range& /*range*/, auto& member) {
    using Member = std::remove_reference_t<decltype(member)>;
    if (here != place) return;
    if constexpr (std::is_same_v<Member, std::optional<double>>) {
      if (std::holds_alternative<std::monostate>(set)) member.reset();
      if (const auto* number = std::get_if<double>(&set)) member = *number;
    } else {
      if (const auto* same = std::get_if<Member>(&set)) member = *same;
    }
  };
  EachMember<decltype(put)> each(put);
  fields(each, value);
  return value;
}

}  // namespace carom
