#include "tests/fuzz/json_mutator.h"

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace carom::fuzz {
namespace {

std::size_t below(std::size_t count, Random& random) { return static_cast<std::size_t>(random() % count); }

constexpr auto kNumbers = std::to_array<double>({0.0,
                                                 -0.0,
                                                 1.0,
                                                 -1.0,
                                                 0.5,
                                                 2.0,
                                                 -9.81,
                                                 3.0,
                                                 1e-3,
                                                 1e-9,
                                                 1e-12,
                                                 0.99e-12,
                                                 1e-14,
                                                 5e-324,
                                                 1e-300,
                                                 1e3,
                                                 1.001e3,
                                                 1e5,
                                                 100001.0,
                                                 1e6,
                                                 1e9,
                                                 9e15,
                                                 1e12,
                                                 -1e12,
                                                 1.01e12,
                                                 1e13,
                                                 1e300,
                                                 -1e300,
                                                 std::numeric_limits<double>::max()});

constexpr auto kWholeNumbers = std::to_array<std::int64_t>(
    {0, 1, -1, 2, 3, 16, 17, 300, 1000, 100'000, 100'001, 2'147'483'647, 2'147'483'648, -2'147'483'649,
     std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()});

constexpr auto kTexts = std::to_array<std::string_view>({"",
                                                         "a",
                                                         "b",
                                                         "default",
                                                         "disc",
                                                         "box",
                                                         "polygon",
                                                         "wall",
                                                         "spring",
                                                         "force",
                                                         "attraction",
                                                         "linear_drag",
                                                         "quadratic_drag",
                                                         "rod",
                                                         "string",
                                                         "pin",
                                                         "weld",
                                                         "grid",
                                                         "rk4",
                                                         "exact-flight",
                                                         "explicit-euler",
                                                         "dormand-prince-adaptive",
                                                         "located",
                                                         "step-end",
                                                         "lasting",
                                                         "impulse",
                                                         "push",
                                                         "pull",
                                                         "while-short",
                                                         "newton",
                                                         "simultaneous",
                                                         "energy",
                                                         "x",
                                                         "distance",
                                                         "speed",
                                                         "time",
                                                         "final",
                                                         "at",
                                                         "impact",
                                                         "mean",
                                                         "count",
                                                         "fit",
                                                         "exponent",
                                                         "where-maximum",
                                                         "/gravity/1",
                                                         "/bodies/0/mass",
                                                         "/method/step",
                                                         "/forces/0/coefficient",
                                                         "exp(-t)",
                                                         "t < 1 ? t : 1/t",
                                                         "\x1b[31m",
                                                         "\u202e",
                                                         {"\0", 1},
                                                         "<img src=x>",
                                                         "\xc3\xa9",
                                                         "a,\"b\"\n"});

constexpr auto kKeys = std::to_array<const char*>({"about",
                                                   "observe",
                                                   "duration",
                                                   "gravity",
                                                   "method",
                                                   "compare",
                                                   "materials",
                                                   "bodies",
                                                   "forces",
                                                   "material_pairs",
                                                   "impact_law",
                                                   "several_impacts",
                                                   "generators",
                                                   "links",
                                                   "plots",
                                                   "view",
                                                   "expect",
                                                   "extra",
                                                   "integrator",
                                                   "impacts",
                                                   "contacts",
                                                   "step",
                                                   "tolerance",
                                                   "name",
                                                   "restitution",
                                                   "tangential_restitution",
                                                   "kinetic_friction",
                                                   "static_friction",
                                                   "rolling_resistance",
                                                   "sticks",
                                                   "shape",
                                                   "type",
                                                   "radius",
                                                   "width",
                                                   "height",
                                                   "vertices",
                                                   "rounding",
                                                   "length",
                                                   "position",
                                                   "angle",
                                                   "velocity",
                                                   "spin",
                                                   "mass",
                                                   "density",
                                                   "inertia",
                                                   "fixed",
                                                   "drive",
                                                   "amplitude",
                                                   "angular_frequency",
                                                   "phase",
                                                   "material",
                                                   "group",
                                                   "columns",
                                                   "rows",
                                                   "origin",
                                                   "spacing",
                                                   "jitter",
                                                   "speed",
                                                   "seed",
                                                   "body",
                                                   "to",
                                                   "anchor",
                                                   "stiffness",
                                                   "damping",
                                                   "rest_length",
                                                   "acts",
                                                   "constant",
                                                   "softening",
                                                   "coefficient",
                                                   "force",
                                                   "torque",
                                                   "start",
                                                   "rise",
                                                   "end",
                                                   "point",
                                                   "observable",
                                                   "reduction",
                                                   "time",
                                                   "impact",
                                                   "above",
                                                   "from",
                                                   "until",
                                                   "with",
                                                   "over",
                                                   "place",
                                                   "values",
                                                   "value",
                                                   "source",
                                                   "title",
                                                   "y",
                                                   "x",
                                                   "theory",
                                                   "residual",
                                                   "logarithmic",
                                                   "notes",
                                                   "plot",
                                                   "at",
                                                   "text",
                                                   "center",
                                                   "no such key"});

template <class Table>
auto one_of(const Table& table, Random& random) {
  return table[below(table.size(), random)];
}

Json any_number(Random& random) {
  if (below(2, random) == 0) return one_of(kWholeNumbers, random);
  const double x = one_of(kNumbers, random);
  return below(4, random) == 0 ? x * (1.0 + std::numeric_limits<double>::epsilon()) : x;
}

Json any_value(Random& random) {
  switch (below(9, random)) {
    case 0:
      return nullptr;
    case 1:
      return below(2, random) == 0;
    case 2:
      return Json::array();
    case 3:
      return Json::object();
    case 4:
      return Json::array({any_number(random), any_number(random)});
    case 5:
    case 6:
      return one_of(kTexts, random);
    default:
      return any_number(random);
  }
}

// Every value of the tree, parents before children.
void collect(Json& value, std::vector<Json*>& all) {
  all.push_back(&value);
  if (!value.is_structured()) return;
  for (Json& child : value) collect(child, all);
}

void change_value(Json& value, Random& random) {
  if (value.is_number() && below(4, random) != 0) {
    const double x = value.get<double>();
    switch (below(4, random)) {
      case 0:
        value = -x;
        return;
      case 1:
        value = x * (below(2, random) == 0 ? 10.0 : 0.1);
        return;
      default:
        value = any_number(random);
        return;
    }
  }
  if (value.is_boolean() && below(4, random) != 0) {
    value = !value.get<bool>();
  } else if (value.is_string() && below(4, random) != 0) {
    value = one_of(kTexts, random);
  } else {
    value = any_value(random);
  }
}

void change_array(Json& array, Random& random) {
  if (array.empty()) {
    array.push_back(any_value(random));
    return;
  }
  const std::size_t i = below(array.size(), random);
  switch (below(4, random)) {
    case 0:
      array.erase(i);
      return;
    case 1:
      std::swap(array[i], array[below(array.size(), random)]);
      return;
    case 2:
      array.push_back(Json(array[i]));
      return;
    default:
      array.push_back(any_value(random));
      return;
  }
}

void change_object(Json& object, Random& random) {
  const std::string key = one_of(kKeys, random);
  if (object.empty()) {
    object[key] = any_value(random);
    return;
  }
  const auto item = std::next(object.begin(), static_cast<std::ptrdiff_t>(below(object.size(), random)));
  switch (below(5, random)) {
    case 0:
      object.erase(item);
      return;
    case 1: {
      Json value = item.value();
      object.erase(item);
      object[key] = std::move(value);
      return;
    }
    case 2: {
      const auto other = std::next(object.begin(), static_cast<std::ptrdiff_t>(below(object.size(), random)));
      std::swap(item.value(), other.value());
      return;
    }
    default:
      object[key] = any_value(random);
      return;
  }
}

}  // namespace

void mutate(Json& preset, Random& random) {
  std::vector<Json*> all;
  collect(preset, all);
  Json& value = *all[below(all.size(), random)];
  if (below(8, random) == 0) {
    value = Json(*all[below(all.size(), random)]);
  } else if (value.is_array() && below(8, random) != 0) {
    change_array(value, random);
  } else if (value.is_object() && below(8, random) != 0) {
    change_object(value, random);
  } else {
    change_value(value, random);
  }
}

}  // namespace carom::fuzz
