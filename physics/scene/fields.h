#pragma once

#include <concepts>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "physics/scene/limits.h"

// What each type of a scene consists of, stated once, beside the type: its keys in files, their unit, range,
// default and meaning. fields(visitor, value) shows every member to a visitor. Visitors read a file, write it
// and describe its format (FieldReader in physics/preset/value_reader.h), and check ranges (RangeCheck in
// physics/scene/range_check.h).
//
// A visitor has these functions; a member with `required` in its name has no default.
//   field(key, member, kind)           a number, vector or text of a Range, Whole or Count
//   required(key, member, kind)
//   field(key, flag)                   true or false
//   choice(key, table, member)         one of a table's words
//   object(key, member)                a std::optional with fields of its own
//   required_object(key, member)
//   alternative(key, member)           an object, or else what another key holds (see together)
//   compound(key, shape, count)        the shapes of a Compound, where the shape is one
//   points(key, list, count, range)    a required list of points
//   numbers(key, list, count, range)   likewise of numbers
//   ends_of_range(key, low, high, range)  required, two numbers in one pair
//   two_names(key, a, b)               required
//   cases(key, words, chosen, each)    a word that says which fields there are: each(index, visitor)
//   together(rule)                     which of two keys there must be
//   shows(condition)  whether a member that is usual only under a condition is visited
//   keep(keys)        members that are written even if they have their default
//   follows(member, other)             the default of `member` is `other`
//   put(key, member)                   the place, in a file, of a member whose field comes later
//   stands_for(key, value, condition)  a value that holds without its key, where `condition` is true
namespace carom {

// A key of an object, and its meaning.
struct Key {
  const char* name;
  const char* meaning;
};

// Limits of the number of elements of a list, or of characters of a text.
struct Count {
  std::size_t least = 0;
  std::size_t most = 0;
};

inline constexpr Count kNameLength{1, kLongestName};
inline constexpr Count kStemLength{1, kLongestStem};
inline constexpr Count kPerhapsNameLength{0, kLongestName};

// Whole numbers from low to high.
struct Whole {
  double low;
  double high;
};

// Which of two keys an object has, and what is refused with which words.
struct KeysTogether {
  enum class Rule { kExactlyOne, kOneOrBoth, kNotBoth };
  Rule rule;
  const char* first;
  const char* second;  // the place of what is refused
  const char* neither;
  const char* both;
  const char* allowed;
};

using Words = std::vector<std::string>;

// What visitors need that neither set members nor write them.
class OnlyLooks {
 public:
  void together(const KeysTogether&) const {}
  void keep(std::initializer_list<const char*>) const {}
  void follows(double, double) const {}
  void put(const char*, double) const {}
  void stands_for(const char*, double, bool) const {}
  template <class Id>
  void chosen(Id, Id) const {}
};

template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

}  // namespace carom
