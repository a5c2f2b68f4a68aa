#include "physics/preset/state_json.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/method_json.h"
#include "physics/preset/object_reader.h"
#include "physics/preset/object_writer.h"
#include "physics/preset/preset.h"
#include "physics/world/ledger_entries.h"
#include "physics/world/run_state.h"

namespace carom {
namespace {

constexpr double kMostCount = 9e15;  // whole numbers that doubles hold exactly

// The length of a list: known from the scene, or free.
constexpr std::size_t kFree = std::numeric_limits<std::size_t>::max();

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Writes numbers with all their digits. A list of known length whose values are equal is written as one
// value.
class StateWriter {
 public:
  Json json = Json::object();

  void value(const char* key, double x) { json[key] = finite(key, x); }
  template <class T>
  void later(const char* key, T x) {
    value(key, x);
  }
  void value(const char* key, std::int64_t x) { json[key] = x; }
  void value(const char* key, int x) { json[key] = x; }
  void value(const char* key, bool x) { json[key] = x; }
  void value(const char* key, const Vec2& x) { json[key] = {finite(key, x.x()), finite(key, x.y())}; }
  void value(const char* key, const Method& method) { json[key] = method_json(method, true); }
  template <class T>
  void list(const char* key, const std::vector<T>& values, std::size_t size) {
    json[key] = list_json(key, values.size(), size != kFree, [&](std::size_t i) { return values[i]; });
  }
  template <class Matrix>
  void rows(const char* key, const Matrix& m, std::size_t) {
    Json& to = json[key] = Json::array();
    for (Eigen::Index row = 0; row < m.rows(); ++row) {
      to.push_back(list_json(key, static_cast<std::size_t>(m.cols()), true,
                             [&](std::size_t i) { return m(row, static_cast<Eigen::Index>(i)); }));
    }
  }
  template <class T, class Describe>
  void object(const char* key, const T& value, const Describe& describe) {
    StateWriter inner;
    describe(inner, value);
    json[key] = std::move(inner.json);
  }
  template <class T, class Describe>
  void later(const char* key, const T& value, const Describe& describe) {
    object(key, value, describe);
  }
  template <class T, class Describe>
  void optional(const char* key, const std::optional<T>& value, const Describe& describe) {
    if (value) object(key, *value, describe);
  }
  // Each element an array of its values.
  template <class T, class Describe>
  void tuples(const char* key, const std::vector<T>& values, std::size_t, const Describe& describe) {
    Json& to = json[key] = Json::array();
    for (const T& value : values) {
      Json tuple = Json::array();
      describe([&](const auto& x) { tuple.push_back(element(key, x)); }, value);
      to.push_back(std::move(tuple));
    }
  }

 private:
  static double finite(const char* key, double x) {
    if (!std::isfinite(x)) {
      throw SceneError(
          fmt::format("/state: {} has a number that is {}; allowed: a run that has not blown up", key, x));
    }
    return x;
  }
  template <class T>
  static Json element(const char* key, const T& x) {
    if constexpr (std::is_same_v<T, double>) {
      // Half-planes have no bounds.
      if (std::isinf(x)) return x > 0.0 ? "inf" : "-inf";
      return finite(key, x);
    } else {
      return x;
    }
  }
  template <class At>
  static Json list_json(const char* key, std::size_t size, bool may_shrink, const At& at) {
    const auto same = [&](std::size_t i) {
      if constexpr (std::is_same_v<std::decay_t<decltype(at(0))>, double>) {
        return same_bits(at(i), at(0));
      } else {
        return at(i) == at(0);
      }
    };
    std::size_t equal = 0;
    while (equal < size && same(equal)) ++equal;
    Json list = Json::array();
    for (std::size_t i = 0; i < size; ++i) {
      if constexpr (std::is_same_v<std::decay_t<decltype(at(0))>, double>) {
        list.push_back(finite(key, at(i)));
      } else {
        list.push_back(at(i));
      }
      if (may_shrink && size > 1 && equal == size) return list[0];
    }
    return list;
  }
};

// Reads what StateWriter writes; each error is one line with the place.
class StateReader {
 public:
  StateReader(const Json& json, std::string place) : reader_(json, std::move(place)) {}
  void finish() const { reader_.finish(); }

  void value(const char* key, double& x) { x = finite(required(key), reader_.at(key)); }
  // A value that older files lack.
  template <class T>
  void later(const char* key, T& x) {
    if (reader_.find(key) != nullptr) value(key, x);
  }
  void value(const char* key, std::int64_t& x) { x = whole<std::int64_t>(required(key), reader_.at(key)); }
  void value(const char* key, int& x) { x = whole<int>(required(key), reader_.at(key)); }
  void value(const char* key, bool& x) { x = flag(required(key), reader_.at(key)); }
  void value(const char* key, Vec2& x) {
    const Json& v = required(key);
    if (!v.is_array() || v.size() != 2) refuse_value(reader_.at(key), quoted(v), "two numbers, [x, y]");
    x = {finite(v[0], reader_.at(key) + "/0"), finite(v[1], reader_.at(key) + "/1")};
  }
  void value(const char* key, Method& method) {
    ValueReader(required(key), reader_.at(key)).object([&](FieldReader& r) { read_method(r, method); });
  }
  template <class T>
  void list(const char* key, std::vector<T>& values, std::size_t size) {
    const Json& v = required(key);
    if (!v.is_array() && size != kFree) {
      values.assign(size, element<T>(v, reader_.at(key)));
      return;
    }
    check_array(v, reader_.at(key), size);
    values.clear();
    values.reserve(v.size());
    for (std::size_t i = 0; i < v.size(); ++i)
      values.push_back(element<T>(v[i], fmt::format("{}/{}", reader_.at(key), i)));
  }
  template <class Matrix>
  void rows(const char* key, Matrix& m, std::size_t columns) {
    const Json& v = required(key);
    constexpr auto kCount = static_cast<std::size_t>(Matrix::RowsAtCompileTime);
    check_array(v, reader_.at(key), kCount);
    m.resize(Eigen::NoChange, static_cast<Eigen::Index>(columns));
    for (std::size_t row = 0; row < kCount; ++row) {
      const std::string at = fmt::format("{}/{}", reader_.at(key), row);
      if (!v[row].is_array()) {
        m.row(static_cast<Eigen::Index>(row)).setConstant(finite(v[row], at));
        continue;
      }
      check_array(v[row], at, columns);
      for (std::size_t i = 0; i < columns; ++i) {
        m(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i)) =
            finite(v[row][i], fmt::format("{}/{}", at, i));
      }
    }
  }
  template <class T, class Describe>
  void object(const char* key, T& value, const Describe& describe) {
    StateReader inner(required(key), reader_.at(key));
    describe(inner, value);
    inner.finish();
  }
  template <class T, class Describe>
  void later(const char* key, T& value, const Describe& describe) {
    if (reader_.find(key) != nullptr) object(key, value, describe);
  }
  template <class T, class Describe>
  void optional(const char* key, std::optional<T>& value, const Describe& describe) {
    if (reader_.find(key) != nullptr) object(key, value.emplace(), describe);
  }
  template <class T, class Describe>
  void tuples(const char* key, std::vector<T>& values, std::size_t size, const Describe& describe) {
    const Json& v = required(key);
    check_array(v, reader_.at(key), size);
    values.clear();
    for (std::size_t i = 0; i < v.size(); ++i) {
      const std::string at = fmt::format("{}/{}", reader_.at(key), i);
      if (!v[i].is_array()) refuse_value(at, quoted(v[i]), "an array, [...]");
      std::size_t next = 0;
      describe(
          [&](auto& x) {
            if (next >= v[i].size()) refuse_value(at, quoted(v[i]), "more numbers");
            x = element<std::decay_t<decltype(x)>, true>(v[i][next], fmt::format("{}/{}", at, next));
            ++next;
          },
          values.emplace_back());
      if (next != v[i].size()) refuse_value(at, quoted(v[i]), fmt::format("{} values", next));
    }
  }

 private:
  const Json& required(const char* key) { return reader_.require(key, "what a saved run leaves there"); }
  static void check_array(const Json& v, const std::string& at, std::size_t size) {
    if (!v.is_array()) refuse_value(at, quoted(v), "an array, [...]");
    if (size != kFree && v.size() != size)
      refuse_value(at, fmt::format("an array of {}", v.size()), fmt::format("{} values", size));
  }
  static double finite(const Json& v, const std::string& at) {
    if (!v.is_number()) refuse_value(at, quoted(v), "a number");
    return v.get<double>();  // the parser has refused what is not a double
  }
  static bool flag(const Json& v, const std::string& at) {
    if (!v.is_boolean()) refuse_value(at, quoted(v), "true or false");
    return v.get<bool>();
  }
  template <class Integer>
  static Integer whole(const Json& v, const std::string& at) {
    const double most = std::min(kMostCount, static_cast<double>(std::numeric_limits<Integer>::max()));
    if (!v.is_number_integer() || !(std::abs(v.get<double>()) <= most))
      refuse_value(at, quoted(v), fmt::format("a whole number up to {}", most));
    return v.get<Integer>();
  }
  template <class T, bool may_be_infinite = false>
  static T element(const Json& v, const std::string& at) {
    if constexpr (std::is_same_v<T, double>) {
      if (may_be_infinite && v.is_string()) {
        if (v == "inf") return std::numeric_limits<double>::infinity();
        if (v == "-inf") return -std::numeric_limits<double>::infinity();
      }
      return finite(v, at);
    } else if constexpr (std::is_same_v<T, bool>) {
      return flag(v, at);
    } else if constexpr (std::is_same_v<T, std::vector<int>>) {
      check_array(v, at, kFree);
      std::vector<int> inner;
      for (std::size_t i = 0; i < v.size(); ++i) inner.push_back(whole<int>(v[i], fmt::format("{}/{}", at, i)));
      return inner;
    } else {
      return whole<T>(v, at);
    }
  }
  ObjectReader reader_;
};

// --- the lists
// The content of the file: one function per type, for writing and reading. A structured binding names all
// members of the type, so a new one does not compile until it is listed here.

struct Sizes {
  std::size_t bodies, islands, springs, joints, applied;
};

constexpr auto kLedger = [](auto& a, auto& ledger) {
  for (const EnergyEntry& entry : kEnergyEntries) a.value(entry.key.data(), ledger.*entry.value);
  for (const MomentumEntry& entry : kMomentumEntries) a.value(entry.key.data(), ledger.*entry.value);
};

constexpr auto kNotices = [](auto& a, auto& notices) {
  for (const NoticeEntry& entry : notice_entries()) {
    a.later(entry.key.data(), notices.*entry.since);
    if (entry.number != nullptr) a.later(entry.number_key.data(), notices.*entry.number);
  }
};

constexpr auto kImpactCounts = [](auto& a, auto& counts) {
  auto& [counted, walls, mutual, wall_impulse, pairs] = counts;
  a.value("counted", counted);
  a.value("walls", walls);
  a.value("mutual", mutual);
  a.value("wall_impulse", wall_impulse);
  a.tuples("pairs", pairs, kFree, [](const auto& each, auto& pair) {
    auto& [body, other, count] = pair;
    each(body);
    each(other);
    each(count);
  });
};

constexpr auto kWork = [](auto& a, auto& work) {
  auto& [scarce, reserve] = work;
  a.value("scarce", scarce);
  a.value("reserve", reserve);
};

const auto kTrajectories = [](const Sizes& size) {
  return [size](auto& a, auto& trajectories) {
    auto& [epoch, start, end, next_step, switching, at_start, engaged, taut, released_at, phase, constant,
           contact, evaluations, rejected_steps, tolerance_missed, joints_missed, switches_missed,
           lost_to_joints] = trajectories;
    a.value("epoch", epoch);
    a.list("start", start, size.islands);
    a.list("end", end, size.islands);
    a.list("next_step", next_step, size.islands);
    a.list("switching", switching, size.islands);
    a.rows("settled", at_start, size.bodies);
    a.list("engaged", engaged, size.springs);
    a.list("taut", taut, size.joints);
    a.list("let_go_at", released_at, size.joints);
    a.list("phase", phase, size.applied);
    bool touched = contact.cols() > 0;
    a.value("touched", touched);
    if (touched) {
      a.rows("constant", constant, size.bodies);
      a.rows("contact", contact, size.bodies);
    }
    a.value("evaluations", evaluations);
    a.value("rejected_steps", rejected_steps);
    a.value("tolerance_missed_since", tolerance_missed);
    a.value("links_missed_since", joints_missed);
    a.value("switches_missed_since", switches_missed);
    a.value("lost_to_links", lost_to_joints);
  };
};

const auto kContactMemory = [](const Sizes& size) {
  return [size](auto& a, auto& contacts) {
    auto& [forces, support, held, pushed] = contacts;
    a.tuples("forces", forces, kFree, [](const auto& each, auto& force) {
      auto& [body, other, id, point, normal, normal_force, tangential_force, rolling_moment, sticks] = force;
      each(body);
      each(other);
      each(id);
      each(point.x());
      each(point.y());
      each(normal.x());
      each(normal.y());
      each(normal_force);
      each(tangential_force);
      each(rolling_moment);
      each(sticks);
    });
    a.tuples("hold", support, kFree, [](const auto& each, auto& of) {
      each(of.x());
      each(of.y());
      each(of.z());
    });
    bool stepped = !held.empty();
    a.value("stepped", stepped);
    if (stepped) a.list("held", held, size.bodies);
    a.list("pushed", pushed, kFree);
  };
};

const auto kAhead = [](const Sizes& size) {
  return [size](auto& a, auto& ahead) {
    auto& [trajectories, grid, events, waiting, reach, stretch, epoch_length, last_impact] = ahead;
    auto& [at_end, curvature_bound, turn_bound, cached] = trajectories;
    a.value("reach", reach);
    a.value("stretch", stretch);
    a.value("epoch_length", epoch_length);
    a.value("last_impact", last_impact);
    a.rows("at_end", at_end, size.bodies);
    a.list("bend", curvature_bound, size.bodies);
    a.list("turn", turn_bound, size.bodies);
    a.list("cached", cached, size.islands);
    a.tuples("events", events, kFree, [](const auto& each, auto& event) {
      auto& [time, body, other] = event;
      each(time);
      each(body);
      each(other);
    });
    a.tuples("waiting", waiting, kFree, [](const auto& each, auto& pair) {
      auto& [body, other, resting] = pair;
      each(body);
      each(other);
      each(resting);
    });
    a.object("grid", grid, [size](auto& inner, auto& order) {
      auto& [inverse_size, bounds, cells, large] = order;
      inner.value("inverse_size", inverse_size);
      inner.tuples("bounds", bounds, size.bodies, [](const auto& each, auto& b) {
        each(b.low.x());
        each(b.low.y());
        each(b.high.x());
        each(b.high.y());
      });
      inner.list("cells", cells, kFree);
      inner.list("large", large, kFree);
    });
  };
};

template <class Archive, class Kept>
void describe(Archive& a, Kept& state, const Sizes& size) {
  auto& [method, clock, sums, at_once, work, motions, trajectories, contacts, ahead] = state;
  // The end of the current step is recomputed in each step.
  auto& [time, step_end, origin, origin_step, steps_since_origin, steps] = clock;
  auto& [impact_count, impact_counts, ledger, gravity_since, peak_kinetic, energy_doubts, notices] = sums;
  a.value("method", method);
  // The time is at the head of the section.
  a.value("origin", origin);
  a.value("origin_step", origin_step);
  a.value("steps_since_origin", steps_since_origin);
  a.value("steps", steps);
  a.value("impacts", impact_count);
  a.later("impact_counts", impact_counts, kImpactCounts);
  a.value("at_once", at_once);
  a.object("work", work, kWork);
  a.rows("positions", motions.q, size.bodies);
  a.rows("velocities", motions.v, size.bodies);
  a.rows("books", motions.quadratures, size.bodies);
  a.object("ledger", ledger, kLedger);
  a.value("gravity_since", gravity_since);
  a.later("peak_kinetic", peak_kinetic);
  a.later("energy_doubts", energy_doubts);
  a.object("notices", notices, kNotices);
  a.object("tracks", trajectories, kTrajectories(size));
  a.object("contacts", contacts, kContactMemory(size));
  a.optional("ahead", ahead, kAhead(size));
}

std::string hexadecimal(std::uint64_t number) { return fmt::format("{:016x}", number); }

}  // namespace

SavedRun read_clock(const Json& json) {
  ObjectReader r(json, "/state");
  SavedRun saved;
  r.require_number("time", saved.time, "s");
  const Json* mark = r.find("fingerprint");
  if (mark == nullptr) {
    r.finish();  // only a clock
    return saved;
  }
  const std::string text = ObjectReader::text(*mark, r.at("fingerprint"));
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), saved.fingerprint, 16);
  if (error != std::errc() || end != text.data() + text.size() || hexadecimal(saved.fingerprint) != text ||
      saved.fingerprint == 0) {
    refuse_value(r.at("fingerprint"), quoted(*mark), "16 hexadecimal digits, as a saved run has them");
  }
  return saved;
}

void read_state(const Json& json, Preset& preset) {
  const std::vector<Body> bodies = all_bodies(preset.scene);
  const double start = start_time(preset.saved);
  const Trajectories trajectories(compile(preset.scene, needs_of(preset.scene), start), preset.method);
  const Sizes sizes{bodies.size(), static_cast<std::size_t>(trajectories.islands()),
                    preset.scene.forces.springs.size(), preset.scene.joints.size(),
                    preset.scene.forces.applied.size()};
  Json rest = json;
  rest.erase("time");
  rest.erase("fingerprint");
  StateReader reader(rest, "/state");
  auto state = std::make_shared<RunState>();
  describe(reader, *state, sizes);
  reader.finish();
  state->clock.time = preset.saved->time;
  check_state(preset.scene, start, *state);
  preset.saved->state = std::move(state);
}

Json state_json(const SavedRun& saved) {
  Json json = {{"time", saved.time}};
  if (saved.fingerprint == 0) return json;
  json["fingerprint"] = hexadecimal(saved.fingerprint);
  if (saved.state == nullptr) return json;
  StateWriter writer;
  const RunState& state = *saved.state;
  describe(writer, state, Sizes{});
  json.update(writer.json);
  return json;
}

}  // namespace carom
