#include <bit>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/sections_json.h"
#include "physics/world/ledger_entries.h"
#include "physics/world/run_state.h"

namespace carom {
namespace {

constexpr double kMostCount = 9e15;  // whole numbers that doubles hold exactly

// The length of a list: known from the scene, or free.
constexpr std::size_t kFree = std::numeric_limits<std::size_t>::max();

struct Sizes {
  std::size_t bodies, islands, springs, joints, applied;
};

ValueReader element(const ValueReader& list, std::size_t i) {
  return {list.value()[i], fmt::format("{}/{}", list.place(), i)};
}

void check_array(const ValueReader& v, std::size_t size) {
  if (!v.value().is_array()) refuse_value(v.place(), quoted(v.value()), "an array, [...]");
  if (size != kFree && v.value().size() != size)
    refuse_value(v.place(), fmt::format("an array of {}", v.value().size()), fmt::format("{} values", size));
}

template <class T>
void take(const ValueReader& v, T& x) {
  const auto refuse = [&v](const std::string& allowed) { refuse_value(v.place(), quoted(v.value()), allowed); };
  if constexpr (std::is_same_v<T, double>) {
    if (!v.value().is_number()) refuse("a number");
    x = v.value().get<double>();  // the parser has refused what is no double
  } else if constexpr (std::is_same_v<T, bool>) {
    if (!v.value().is_boolean()) refuse("true or false");
    x = v.value().get<bool>();
  } else if constexpr (std::is_integral_v<T>) {
    const double most = std::min(kMostCount, static_cast<double>(std::numeric_limits<T>::max()));
    if (!v.value().is_number_integer() || !(std::abs(v.value().get<double>()) <= most))
      refuse(fmt::format("a whole number up to {}", most));
    x = v.value().get<T>();
  } else if constexpr (std::is_same_v<T, Vec2>) {
    if (!v.value().is_array() || v.value().size() != 2) refuse("two numbers, [x, y]");
    for (int i = 0; i < 2; ++i) take(element(v, static_cast<std::size_t>(i)), x[i]);
  } else if constexpr (std::is_same_v<T, Method>) {
    v.object([&](FieldReader& r) { fields(r, x); });
  } else {
    check_array(v, kFree);
    x.resize(v.value().size());
    for (std::size_t i = 0; i < x.size(); ++i) take(element(v, i), x[i]);
  }
}

// One value may stand for all of a list whose length the scene says.
template <class T>
void take_list(const ValueReader& v, std::vector<T>& values, std::size_t size) {
  if (v.value().is_array() || size == kFree) {
    check_array(v, size);
    take(v, values);
    return;
  }
  T all{};
  take(v, all);
  values.assign(size, all);
}

// Half-planes have no bounds.
template <class T>
void take_bound(const ValueReader& v, T& x) {
  if constexpr (std::is_same_v<T, double>) {
    if (v.value() == "inf" || v.value() == "-inf") {
      x = std::copysign(std::numeric_limits<double>::infinity(), v.value() == "inf" ? 1.0 : -1.0);
      return;
    }
  }
  take(v, x);
}

template <class T>
Json written(const char* key, const T& x) {
  if constexpr (std::is_same_v<T, double>) {
    if (!std::isfinite(x)) {
      throw SceneError(
          fmt::format("/state: {} has a number that is {}; allowed: a run that has not blown up", key, x));
    }
    return x;
  } else if constexpr (std::is_same_v<T, Vec2>) {
    return Json::array({written(key, x.x()), written(key, x.y())});
  } else if constexpr (std::is_same_v<T, Method>) {
    return carom::written(x, true);
  } else {
    return x;
  }
}

template <class T>
Json written_bound(const char* key, const T& x) {
  if constexpr (std::is_same_v<T, double>) {
    if (std::isinf(x)) return x > 0.0 ? "inf" : "-inf";
  }
  return written(key, x);
}

// Equal values, of a list whose length the scene says, become one.
template <class T>
Json written_list(const char* key, const std::vector<T>& values, std::size_t size) {
  const auto same = [&](const T& x) {
    if constexpr (std::is_same_v<T, double>) {
      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(values[0]);
    } else {
      return x == values[0];
    }
  };
  if (size != kFree && values.size() > 1 && std::all_of(values.begin(), values.end(), same))
    return written(key, values[0]);
  Json list = Json::array();
  for (const T& x : values) list.push_back(written(key, x));
  return list;
}

// A part of the state, member by member: constant ones are written, with all their digits; the others are read.
// Each error is one line with the place.
class StatePart {
 public:
  explicit StatePart(const Sizes& sizes, FieldReader* reader = nullptr) : size(sizes), reader_(reader) {}

  Json json = Json::object();
  Sizes size;

  // A file may be older than a value that is not needed.
  template <class T>
  void value(const char* key, T& x, bool needed = true) {
    if constexpr (std::is_const_v<T>) {
      json[key] = written(key, x);
    } else {
      read(key, needed, [&](const ValueReader& v) { take(v, x); });
    }
  }
  // A key of older files that says nothing any more.
  void dropped(const char* key) {
    if (reader_ != nullptr) reader_->member({key, ""}, [](const ValueReader&) {});
  }
  // Whether something follows.
  [[nodiscard]] bool flag(const char* key, bool now) {
    if (reader_ == nullptr) {
      json[key] = now;
    } else {
      value(key, now);
    }
    return now;
  }
  template <class List>
  void list(const char* key, List& values, std::size_t length) {
    if constexpr (std::is_const_v<List>) {
      json[key] = written_list(key, values, length);
    } else {
      read(key, true, [&](const ValueReader& v) { take_list(v, values, length); });
    }
  }
  // A file may be older than the last `newer` rows: they are 0 then.
  template <class Matrix>
  void rows(const char* key, Matrix& m, std::size_t columns, Eigen::Index newer = 0) {
    constexpr Eigen::Index kRows = Matrix::RowsAtCompileTime;
    if constexpr (std::is_const_v<Matrix>) {
      json[key] = Json::array();
      for (Eigen::Index row = 0; row < kRows; ++row) {
        std::vector<double> values(static_cast<std::size_t>(m.cols()));
        Eigen::RowVectorXd::Map(values.data(), m.cols()) = m.row(row);
        json[key].push_back(written_list(key, values, values.size()));
      }
    } else {
      read(key, true, [&](const ValueReader& v) {
        const bool old =
            newer > 0 && v.value().is_array() && v.value().size() == static_cast<std::size_t>(kRows - newer);
        const Eigen::Index known = old ? kRows - newer : kRows;
        check_array(v, known);
        m.setZero(kRows, static_cast<Eigen::Index>(columns));
        for (Eigen::Index row = 0; row < known; ++row) {
          std::vector<double> values;
          take_list(element(v, static_cast<std::size_t>(row)), values, columns);
          m.row(row) = Eigen::RowVectorXd::Map(values.data(), m.cols());
        }
      });
    }
  }
  template <class T, class Describe>
  void object(const char* key, T& value, const Describe& describe, bool needed = true) {
    if constexpr (std::is_const_v<T>) {
      StatePart inner(size);
      describe(inner, value);
      json[key] = std::move(inner.json);
    } else {
      read(key, needed, [&](const ValueReader& v) { take_object(v, value, describe); });
    }
  }
  template <class T, class Describe>
  void optional(const char* key, T& value, const Describe& describe) {
    if constexpr (std::is_const_v<T>) {
      if (value) object(key, *value, describe);
    } else {
      read(key, false, [&](const ValueReader& v) { take_object(v, value.emplace(), describe); });
    }
  }
  // Each element an array of its values.
  template <class List, class Describe>
  void tuples(const char* key, List& values, std::size_t length, const Describe& describe) {
    if constexpr (std::is_const_v<List>) {
      json[key] = Json::array();
      for (const auto& value : values) {
        Json tuple = Json::array();
        describe([&](const auto&... x) { (tuple.push_back(written_bound(key, x)), ...); }, value);
        json[key].push_back(std::move(tuple));
      }
    } else {
      read(key, true, [&](const ValueReader& v) {
        check_array(v, length);
        values.clear();
        for (std::size_t i = 0; i < v.value().size(); ++i)
          take_tuple(element(v, i), values.emplace_back(), describe);
      });
    }
  }

 private:
  template <class Read>
  void read(const char* key, bool needed, const Read& read) {
    const auto take = [&](const ValueReader& v) {
      if (v.has_value()) read(v);
    };
    if (needed) {
      reader_->needed({key, "what a saved run leaves there"}, take);
    } else {
      reader_->member({key, ""}, take);
    }
  }
  template <class T, class Describe>
  void take_object(const ValueReader& v, T& value, const Describe& describe) const {
    v.object([&](FieldReader& r) {
      StatePart inner(size, &r);
      describe(inner, value);
    });
  }
  template <class T, class Describe>
  static void take_tuple(const ValueReader& v, T& value, const Describe& describe) {
    if (!v.value().is_array()) refuse_value(v.place(), quoted(v.value()), "an array, [...]");
    std::size_t next = 0;
    const auto take_next = [&](auto& x) {
      if (next >= v.value().size()) refuse_value(v.place(), quoted(v.value()), "more numbers");
      take_bound(element(v, next), x);
      ++next;
    };
    describe([&](auto&... x) { (take_next(x), ...); }, value);
    if (next != v.value().size()) refuse_value(v.place(), quoted(v.value()), fmt::format("{} values", next));
  }

  FieldReader* reader_;
};

// --- the lists
// The content of the file: one function per type, for writing and reading. A structured binding names all
// members of the type, so a new one does not compile until it is listed here.

constexpr auto kLedger = [](auto& a, auto& ledger) {
  for (const EnergyEntry& entry : kEnergyEntries) a.value(entry.key.data(), ledger.*entry.value);
  for (const MomentumEntry& entry : kMomentumEntries) a.value(entry.key.data(), ledger.*entry.value);
  for (const MomentumEntry& entry : kMomentumEntries)
    a.value(entry.angular_key.data(), ledger.*entry.angular, false);
};

constexpr auto kNotices = [](auto& a, auto& notices) {
  for (const NoticeEntry& entry : notice_entries()) {
    a.value(entry.key.data(), notices.*entry.since, false);
    if (entry.number != nullptr) a.value(entry.number_key.data(), notices.*entry.number, false);
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
    each(body, other, count);
  });
};

constexpr auto kWork = [](auto& a, auto& work) {
  auto& [scarce, reserve] = work;
  a.value("scarce", scarce);
  a.value("reserve", reserve);
};

constexpr auto kTrajectories = [](auto& a, auto& trajectories) {
  auto& [epoch, start, end, next_step, switching, at_start, engaged, taut, released_at, phase, constant,
         contact, evaluations, rejected_steps, tolerance_missed, joints_missed, switches_missed,
         lost_to_joints] = trajectories;
  a.value("epoch", epoch);
  a.list("start", start, a.size.islands);
  a.list("end", end, a.size.islands);
  a.list("next_step", next_step, a.size.islands);
  a.list("switching", switching, a.size.islands);
  a.rows("settled", at_start, a.size.bodies, kAngularRows);
  a.list("engaged", engaged, a.size.springs);
  a.list("taut", taut, a.size.joints);
  a.list("let_go_at", released_at, a.size.joints);
  a.list("phase", phase, a.size.applied);
  if (a.flag("touched", contact.cols() > 0)) {
    a.rows("constant", constant, a.size.bodies);
    a.rows("contact", contact, a.size.bodies);
  }
  a.value("evaluations", evaluations);
  a.value("rejected_steps", rejected_steps);
  a.value("tolerance_missed_since", tolerance_missed);
  a.value("links_missed_since", joints_missed);
  a.value("switches_missed_since", switches_missed);
  a.value("lost_to_links", lost_to_joints);
};

constexpr auto kContactMemory = [](auto& a, auto& contacts) {
  auto& [forces, support, pushed] = contacts;
  a.tuples("forces", forces, kFree, [](const auto& each, auto& force) {
    auto& [body, other, id, point, normal, normal_force, tangential_force, rolling_moment, sticks] = force;
    each(body, other, id, point.x(), point.y(), normal.x(), normal.y());
    each(normal_force, tangential_force, rolling_moment, sticks);
  });
  a.tuples("hold", support, kFree, [](const auto& each, auto& of) { each(of.x(), of.y(), of.z()); });
  a.dropped("stepped");
  a.dropped("held");
  a.list("pushed", pushed, kFree);
};

constexpr auto kGrid = [](auto& a, auto& order) {
  auto& [inverse_size, bounds, cells, large] = order;
  a.value("inverse_size", inverse_size);
  a.tuples("bounds", bounds, a.size.bodies,
           [](const auto& each, auto& b) { each(b.low.x(), b.low.y(), b.high.x(), b.high.y()); });
  a.list("cells", cells, kFree);
  a.list("large", large, kFree);
};

constexpr auto kAhead = [](auto& a, auto& ahead) {
  auto& [trajectories, grid, events, waiting, reach, stretch, epoch_length, last_impact] = ahead;
  auto& [at_end, curvature_bound, turn_bound, cached] = trajectories;
  a.value("reach", reach);
  a.value("stretch", stretch);
  a.value("epoch_length", epoch_length);
  a.value("last_impact", last_impact);
  a.rows("at_end", at_end, a.size.bodies, kAngularRows);
  a.list("bend", curvature_bound, a.size.bodies);
  a.list("turn", turn_bound, a.size.bodies);
  a.list("cached", cached, a.size.islands);
  a.tuples("events", events, kFree, [](const auto& each, auto& event) {
    auto& [time, body, other] = event;
    each(time, body, other);
  });
  a.tuples("waiting", waiting, kFree, [](const auto& each, auto& pair) {
    auto& [body, other, resting] = pair;
    each(body, other, resting);
  });
  a.object("grid", grid, kGrid);
};

constexpr auto kState = [](auto& a, auto& state) {
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
  a.object("impact_counts", impact_counts, kImpactCounts, false);
  a.value("at_once", at_once);
  a.object("work", work, kWork);
  a.rows("positions", motions.q, a.size.bodies);
  a.rows("velocities", motions.v, a.size.bodies);
  a.rows("books", motions.quadratures, a.size.bodies, kAngularRows);
  a.object("ledger", ledger, kLedger);
  a.value("gravity_since", gravity_since);
  a.value("peak_kinetic", peak_kinetic, false);
  a.value("energy_doubts", energy_doubts, false);
  a.object("notices", notices, kNotices);
  a.object("tracks", trajectories, kTrajectories);
  a.object("contacts", contacts, kContactMemory);
  a.optional("ahead", ahead, kAhead);
};

// A file that is older than the balance of angular momentum: the balance begins where the run was saved.
void begin_angular_balance(Trajectories& trajectories, const Model& model, RunState& state) {
  trajectories.restore(state.trajectories, state.ahead ? &state.ahead->trajectories : nullptr);
  double given = 0.0;
  for (int i = 0; i < state.motions.size(); ++i) {
    const Motion now = trajectories.at(i, state.clock.time - trajectories.epoch());
    state.motions.quadratures.col(i).bottomRows<kAngularRows>() = angular_rows_of(now);
    given += angular_rows_of(now).sum();
  }
  state.sums.ledger.initial_angular_momentum =
      totals(state.motions, model.mass, trajectories.field()).angular_momentum - given;
}

std::string hexadecimal(std::uint64_t number) { return fmt::format("{:016x}", number); }

}  // namespace

SavedRun read_clock(const Json& json) {
  FieldReader r(ValueReader(json, "/state"));
  SavedRun saved;
  r.needed({"time", "a number, in s"}, [&](const ValueReader& v) {
    if (!v.has_value()) return;
    take(v, saved.time);
    const Range range = any_number("");
    if (!range.contains(saved.time)) refuse_value(v.place(), quoted(v.value()), range.text());
  });
  r.member({"fingerprint", ""}, [&](const ValueReader& v) {
    const std::string text = v.text({0, kFree});
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), saved.fingerprint, 16);
    if (error != std::errc() || end != text.data() + text.size() || hexadecimal(saved.fingerprint) != text ||
        saved.fingerprint == 0) {
      refuse_value(v.place(), quoted(v.value()), "16 hexadecimal digits, as a saved run has them");
    }
  });
  if (saved.fingerprint == 0) r.finish();  // nothing but a clock
  return saved;
}

void read_state(const Json& json, Preset& preset) {
  const std::vector<Body> bodies = all_bodies(preset.scene);
  const double start = start_time(preset.saved);
  const std::shared_ptr<const Model> model = compile(preset.scene, needs_of(preset.scene), start);
  Trajectories trajectories(model, preset.method);
  const Sizes sizes{bodies.size(), static_cast<std::size_t>(trajectories.islands()),
                    preset.scene.forces.springs.size(), preset.scene.joints.size(),
                    preset.scene.forces.applied.size()};
  Json rest = json;
  rest.erase("time");
  rest.erase("fingerprint");
  auto state = std::make_shared<RunState>();
  ValueReader(rest, "/state").object([&](FieldReader& r) {
    StatePart part(sizes, &r);
    kState(part, *state);
  });
  state->clock.time = preset.saved->time;
  check_state(preset.scene, start, *state);
  if (!rest.at("ledger").contains("initial_angular_momentum")) {
    trajectories.set_method(state->method);
    begin_angular_balance(trajectories, *model, *state);
  }
  preset.saved->state = std::move(state);
}

Json state_json(const SavedRun& saved) {
  Json json = {{"time", saved.time}};
  if (saved.fingerprint == 0) return json;
  json["fingerprint"] = hexadecimal(saved.fingerprint);
  if (saved.state == nullptr) return json;
  StatePart part({});
  kState(part, *saved.state);
  json.update(part.json);
  return json;
}

}  // namespace carom
