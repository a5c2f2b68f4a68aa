#pragma once

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace carom {

// Numbers of things that are counted apart: none converts to another, nor a plain number to any of them.

// A body. It converts to the number of its column in the matrices of the state, and of its place in lists by
// body.
class BodyIndex {
 public:
  BodyIndex() = default;  // none
  explicit constexpr BodyIndex(int column) : column_(column) {}
  constexpr operator int() const { return column_; }  // NOLINT(google-explicit-constructor): reads columns
  constexpr BodyIndex& operator++() {
    ++column_;
    return *this;
  }

 private:
  int column_ = -1;
};

inline constexpr BodyIndex kNoBody{-1};
using BodyPair = std::pair<BodyIndex, BodyIndex>;

enum class ShapeIndex : int {};  // a convex shape of the collision geometry: all of a body, or a part of it
enum class JointIndex : int {};  // a joint of the scene, or a weld that the run has made
enum class SpringIndex : int {};

inline constexpr ShapeIndex kNoShape{-1};

// What starts and stops to act in flight: a one-sided spring or a string.
using Switch = std::variant<SpringIndex, JointIndex>;

// One shape of each of two bodies a and b.
struct ShapePair {
  ShapeIndex a = kNoShape;
  ShapeIndex b = kNoShape;

  [[nodiscard]] bool known() const { return a != kNoShape; }
};

// An array that is looked up by one kind of index alone.
template <class Index, class T>
class ArrayOf {
 public:
  void push_back(T value) { values_.push_back(std::move(value)); }
  void resize(std::size_t size) { values_.resize(size); }
  void assign(std::size_t size, const T& value) { values_.assign(size, value); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] Index end_index() const { return Index{static_cast<int>(values_.size())}; }
  [[nodiscard]] auto begin() const { return values_.begin(); }
  [[nodiscard]] auto end() const { return values_.end(); }
  // Calls visit(index) for each in order.
  template <class Visit>
  void each_index(const Visit& visit) const {
    for (int i = 0; i < static_cast<int>(values_.size()); ++i) visit(Index{i});
  }
  [[nodiscard]] T& operator[](Index i) { return values_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const T& operator[](Index i) const { return values_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] T& back() { return values_.back(); }

 private:
  std::vector<T> values_;
};

}  // namespace carom
