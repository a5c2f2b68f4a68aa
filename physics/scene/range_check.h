#pragma once

#include <fmt/format.h>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/scene/shape.h"
#include "physics/scene/value_checks.h"

namespace carom {

// A visitor of fields.h that checks each number and text against its range. Throws a SceneError with the place
// of the first that is outside; `place` is that of the value whose fields it visits.
class RangeCheck : public OnlyLooks {
 public:
  explicit RangeCheck(std::string place) : place_(std::move(place)) {}

  void field(const Key& key, double x, const Range& range) const {
    if (!range.contains(x)) check_range(at(key), x, range);
  }
  void field(const Key& key, const std::optional<double>& x, const Range& range) const {
    if (x) field(key, *x, range);
  }
  void field(const Key& key, const Vec2& x, const Range& range) const {
    for (int i = 0; i < 2; ++i) {
      if (!range.contains(x[i])) check_range(fmt::format("{}/{}", at(key), i), x[i], range);
    }
  }
  void field(const Key& key, const std::string& text, const Count& length) const {
    if (text.empty() ? length.least > 0 : text.size() > length.most) check_name(at(key), text, length.most);
  }
  template <class Integer>
  void field(const Key& key, Integer x, const Whole& range) const {
    field(key, static_cast<double>(x), Range{.low = range.low, .high = range.high});
  }
  void field(const Key&, bool) const {}
  template <class T, class Kind>
  void required(const Key& key, const T& x, const Kind& kind) const {
    field(key, x, kind);
  }
  template <class Table, class Id>
  void choice(const Key&, const Table&, Id) const {}
  template <class T>
  void required_object(const Key& key, const T& member) const {
    RangeCheck inner(at(key));
    fields(inner, member);
  }
  template <class T>
  void alternative(const Key& key, const T& member) const {
    required_object(key, member);
  }
  void compound(const Key& key, const Shape& shape, const Count& count) const {
    const auto* compound = std::get_if<Compound>(&shape);
    if (compound == nullptr) return;
    check_count(at(key), compound->shapes.size(), count.most, "shapes");
    for (std::size_t i = 0; i < compound->shapes.size(); ++i)
      RangeCheck(at(key)).required_object({std::to_string(i).c_str(), ""}, compound->shapes[i]);
  }
  template <class T>
  void object(const Key& key, const std::optional<T>& member) const {
    if (member) required_object(key, *member);
  }
  void points(const Key& key, const std::vector<Vec2>& list, const Count& count, const Range& range) const {
    check_count(at(key), list.size(), count.most, "points");
    const RangeCheck each(at(key));
    for (std::size_t i = 0; i < list.size(); ++i) each.field({std::to_string(i).c_str(), ""}, list[i], range);
  }
  void ends_of_range(const Key& key, double low, double high, const Range& range) const {
    field(key, Vec2(low, high), range);
  }
  void two_names(const Key&, const std::string&, const std::string&) const {}
  [[nodiscard]] static bool shows(bool condition) { return condition; }
  void cases(const Key&, const auto&, std::size_t chosen, const auto& each) { each(chosen, *this); }

 private:
  [[nodiscard]] std::string at(const Key& key) const { return place_ + "/" + key.name; }

  std::string place_;
};

// Checks the ranges of all fields of a value at `place`.
template <class T>
void check_fields(const std::string& place, const T& value) {
  RangeCheck check(place);
  fields(check, value);
}

}  // namespace carom
