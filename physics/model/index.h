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
enum class AppliedForceIndex : int {};
enum class IslandIndex : int {};  // of the bodies that are advanced together, or one that is alone
enum class GroupIndex : int {};   // of an island of coupled bodies, among these

inline constexpr ShapeIndex kNoShape{-1};
inline constexpr IslandIndex kNoIsland{-1};
inline constexpr GroupIndex kNoGroup{-1};

// What starts and stops to act in flight: a one-sided spring or a string.
using Switch = std::variant<SpringIndex, JointIndex>;

// One shape of each of two bodies a and b.
struct ShapePair {
  ShapeIndex a = kNoShape;
  ShapeIndex b = kNoShape;

  [[nodiscard]] bool known() const { return a != kNoShape; }
};

// The first `count` numbers of a kind, to walk over.
template <class Index>
class Indices {
 public:
  explicit constexpr Indices(std::size_t count) : count_(static_cast<int>(count)) {}
  struct Iterator {
    int at;
    constexpr Index operator*() const { return Index{at}; }
    constexpr Iterator& operator++() {
      ++at;
      return *this;
    }
    constexpr bool operator==(const Iterator&) const = default;
  };
  [[nodiscard]] constexpr Iterator begin() const { return {0}; }
  [[nodiscard]] constexpr Iterator end() const { return {count_}; }
  [[nodiscard]] constexpr std::size_t size() const { return static_cast<std::size_t>(count_); }

 private:
  int count_;
};

// An array that is looked up by one kind of index alone.
template <class Index, class T>
class ArrayOf {
 public:
  void push_back(T value) { values_.push_back(std::move(value)); }
  T& emplace_back() { return values_.emplace_back(); }
  void clear() { values_.clear(); }
  void resize(std::size_t size) { values_.resize(size); }
  void assign(std::size_t size, const T& value) { values_.assign(size, value); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] Index end_index() const { return Index{static_cast<int>(values_.size())}; }
  [[nodiscard]] auto begin() { return values_.begin(); }
  [[nodiscard]] auto end() { return values_.end(); }
  [[nodiscard]] auto begin() const { return values_.begin(); }
  [[nodiscard]] auto end() const { return values_.end(); }
  [[nodiscard]] Indices<Index> indices() const { return Indices<Index>(values_.size()); }
  [[nodiscard]] T& operator[](Index i) { return values_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const T& operator[](Index i) const { return values_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] T& back() { return values_.back(); }

 private:
  std::vector<T> values_;
};

}  // namespace carom
