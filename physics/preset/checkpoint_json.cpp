#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <numeric>

#include "physics/ledger/ledger_entries.h"
#include "physics/preset/sections_json.h"
#include "physics/run/checkpoint.h"
#include "physics/run/simulation.h"

namespace carom {
namespace {

constexpr double kMostCount = 9e15;  // whole numbers that doubles hold exactly

ValueReader element(const ValueReader& list, std::size_t i) {
  return {list.value()[i], fmt::format("{}/{}", list.place(), i)};
}

void check_array(const ValueReader& v) {
  if (!v.value().is_array()) refuse_value(v.place(), quoted(v.value()), "an array, [...]");
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
  } else if constexpr (std::is_same_v<T, BodyIndex>) {
    int body = 0;
    take(v, body);
    x = BodyIndex{body};
  } else if constexpr (std::is_same_v<T, NoticeBodies>) {
    if (!v.value().is_array() || v.value().size() != 2) refuse("two bodies, [a, b]");
    take(element(v, 0), x.a);
    take(element(v, 1), x.b);
  } else if constexpr (std::is_same_v<T, Vec2>) {
    if (!v.value().is_array() || v.value().size() != 2) refuse("two numbers, [x, y]");
    for (int i = 0; i < 2; ++i) take(element(v, static_cast<std::size_t>(i)), x[i]);
  } else if constexpr (std::is_same_v<T, Method>) {
    v.object([&](FieldReader& r) { fields(r, x); });
  } else {
    check_array(v);
    x.resize(v.value().size());
    for (std::size_t i = 0; i < x.size(); ++i) take(element(v, i), x[i]);
  }
}

// One value may stand for all of a list.
template <class T>
void take_list(const ValueReader& v, std::vector<T>& values, std::size_t size) {
  if (v.value().is_array()) {
    take(v, values);
    return;
  }
  T all{};
  take(v, all);
  values.assign(size, all);
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
  } else if constexpr (std::is_same_v<T, NoticeBodies>) {
    return Json::array({int{x.a}, int{x.b}});
  } else if constexpr (std::is_same_v<T, Method>) {
    return carom::written(x, true);
  } else if constexpr (std::is_same_v<T, BodyIndex>) {
    return int{x};
  } else {
    return x;
  }
}

// Equal values become one.
template <class T>
Json written_list(const char* key, const std::vector<T>& values) {
  if (values.size() > 1 &&
      std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end())
    return written(key, values[0]);
  Json list = Json::array();
  for (const T& x : values) list.push_back(written(key, x));
  return list;
}

// Members of a checkpoint: constant ones are written, with all their digits; the others are read. Each error is
// one line with the place.
class Members {
 public:
  explicit Members(FieldReader* reader = nullptr) : reader_(reader) {}

  Json json = Json::object();

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
  template <class List>
  void list(const char* key, List& values, std::size_t length, bool needed = true) {
    if constexpr (std::is_const_v<List>) {
      json[key] = written_list(key, values);
    } else {
      read(key, needed, [&](const ValueReader& v) { take_list(v, values, length); });
    }
  }
  template <class T, class Describe>
  void object(const char* key, T& value, const Describe& describe, bool needed = true) {
    if constexpr (std::is_const_v<T>) {
      Members inner;
      describe(inner, value);
      json[key] = std::move(inner.json);
    } else {
      read(key, needed, [&](const ValueReader& v) {
        v.object([&](FieldReader& r) {
          Members inner(&r);
          describe(inner, value);
        });
      });
    }
  }
  // Each element an array of its values.
  template <class List, class Describe>
  void tuples(const char* key, List& values, const Describe& describe) {
    if constexpr (std::is_const_v<List>) {
      json[key] = Json::array();
      for (const auto& value : values) {
        Json tuple = Json::array();
        describe([&](const auto&... x) { (tuple.push_back(written(key, x)), ...); }, value);
        json[key].push_back(std::move(tuple));
      }
    } else {
      read(key, true, [&](const ValueReader& v) {
        check_array(v);
        values.clear();
        for (std::size_t i = 0; i < v.value().size(); ++i)
          take_tuple(element(v, i), values.emplace_back(), describe);
      });
    }
  }
  // Calls read(value), of a reader.
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

 private:
  template <class T, class Describe>
  static void take_tuple(const ValueReader& v, T& value, const Describe& describe) {
    check_array(v);
    std::size_t next = 0;
    const auto take_next = [&](auto& x) {
      if (next >= v.value().size()) refuse_value(v.place(), quoted(v.value()), "more numbers");
      take(element(v, next), x);
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

// By the keys of notices.
constexpr auto kNoticeBodies = [](auto& a, auto& notices) {
  for (std::size_t i = 0; i < Notices::kKinds; ++i) {
    auto& of = notices.bodies[i];
    if (!std::is_const_v<std::remove_reference_t<decltype(of)>> || of.a != kNoBody)
      a.value(notice_entries()[i].key.data(), of, false);
  }
};

constexpr auto kNotices = [](auto& a, auto& notices) {
  for (const NoticeEntry& entry : notice_entries()) {
    a.value(entry.key.data(), notices.*entry.since, false);
    if (entry.number != nullptr) a.value(entry.number_key.data(), notices.*entry.number, false);
  }
  const bool any = std::any_of(notices.bodies.begin(), notices.bodies.end(),
                               [](const NoticeBodies& of) { return of.a != kNoBody; });
  if (any || !std::is_const_v<std::remove_reference_t<decltype(notices)>>)
    a.object("of", notices, kNoticeBodies, false);
};

constexpr auto kImpactCounts = [](auto& a, auto& counts) {
  auto& [counted, walls, mutual, wall_impulse, pairs] = counts;
  a.value("counted", counted);
  a.value("walls", walls);
  a.value("mutual", mutual);
  a.value("wall_impulse", wall_impulse);
  a.tuples("pairs", pairs, [](const auto& each, auto& pair) {
    auto& [body, other, count] = pair;
    each(body, other, count);
  });
};

constexpr auto kContacts = [](auto& a, auto& checkpoint) {
  a.tuples("forces", checkpoint.contacts, [](const auto& each, auto& force) {
    auto& [body, other, id, point, normal, normal_force, tangential_force, rolling_moment, sticks] = force;
    each(body, other, id, point.x(), point.y(), normal.x(), normal.y());
    each(normal_force, tangential_force, rolling_moment, sticks);
  });
  a.tuples("hold", checkpoint.support, [](const auto& each, auto& of) { each(of.x(), of.y(), of.z()); });
};

constexpr auto kSums = [](auto& a, auto& sums) {
  // The ledger holds all momentum up to the time.
  auto& [impact_count, impact_counts, ledger, gravity_since, peak_kinetic, energy_doubts, notices] = sums;
  a.value("impacts", impact_count);
  a.object("impact_counts", impact_counts, kImpactCounts, false);
  a.object("ledger", ledger, kLedger);
  a.value("peak_kinetic", peak_kinetic, false);
  a.value("energy_doubts", energy_doubts, false);
  a.object("notices", notices, kNotices);
};

constexpr auto kCheckpoint = [](auto& a, auto& checkpoint, const Scene& scene, std::size_t bodies) {
  auto& [method, steps, sums, evaluations, rejected_steps, engaged, taut, released_at, next_step, waiting,
         contacts, support] = checkpoint;
  a.value("method", method);
  a.value("steps", steps);
  kSums(a, sums);
  a.value("evaluations", evaluations);
  a.value("rejected_steps", rejected_steps);
  a.list("engaged", engaged, scene.forces.springs.size());
  a.list("taut", taut, scene.joints.size());
  a.list("let_go_at", released_at, scene.joints.size());
  a.list("next_step", next_step, bodies);
  a.tuples("waiting", waiting, [](const auto& each, auto& pair) {
    auto& [body, other, resting] = pair;
    each(body, other, resting);
  });
  a.object("contacts", checkpoint, kContacts);
};

// Files of earlier versions held the solver's own state, too. Of it is read what a checkpoint has.
constexpr auto kEarlierContacts = [](Members& a, Checkpoint& checkpoint) {
  kContacts(a, checkpoint);
  for (const char* key : {"stepped", "held", "pushed"}) a.dropped(key);
};

// By kind of quadrature a list, or one number for all bodies; the last ones may be missing.
void add_quadratures(const ValueReader& rows, std::size_t bodies, Ledger& ledger) {
  constexpr auto kKinds = std::to_array<QuadratureRow>(
      {kDragLoss, kDamperLoss, kWorkIn, kImpulseX, kImpulseY, kAngularImpulse, kGravityAngularImpulse});
  check_array(rows);
  if (rows.value().size() > kKinds.size())
    refuse_value(rows.place(), fmt::format("{} rows", rows.value().size()),
                 fmt::format("up to {}", kKinds.size()));
  State sums;
  sums.resize(1);
  sums.quadratures.setZero();
  for (std::size_t row = 0; row < rows.value().size(); ++row) {
    std::vector<double> values;
    take_list(element(rows, row), values, bodies);
    sums.quadratures(kKinds[row], 0) = std::accumulate(values.begin(), values.end(), 0.0);
  }
  ledger.add(1.0, ledger_of_quadratures(sums));
}

void read_earlier(Members& a, Checkpoint& checkpoint, const Scene& scene, std::size_t bodies) {
  checkpoint.next_step.assign(bodies, 0.0);
  a.value("method", checkpoint.method);
  a.value("steps", checkpoint.steps);
  kSums(a, checkpoint.sums);
  a.value("gravity_since", checkpoint.sums.gravity_since);
  a.object("tracks", checkpoint, [&](Members& tracks, Checkpoint& c) {
    tracks.value("evaluations", c.evaluations);
    tracks.value("rejected_steps", c.rejected_steps);
    tracks.list("engaged", c.engaged, scene.forces.springs.size());
    tracks.list("taut", c.taut, scene.joints.size());
    tracks.list("let_go_at", c.released_at, scene.joints.size());
    tracks.value("tolerance_missed_since", c.sums.notices.tolerance_missed_since);
    tracks.value("links_missed_since", c.sums.notices.joints_missed_since);
    tracks.value("switches_missed_since", c.sums.notices.switches_missed_since);
    tracks.value("lost_to_links", c.sums.ledger.lost_to_joints);
    for (const char* key : {"epoch", "start", "end", "next_step", "switching", "settled", "phase", "touched",
                            "constant", "contact"}) {
      tracks.dropped(key);
    }
  });
  a.object("contacts", checkpoint, kEarlierContacts);
  a.read("books", true, [&](const ValueReader& v) { add_quadratures(v, bodies, checkpoint.sums.ledger); });
  for (const char* key :
       {"origin", "origin_step", "steps_since_origin", "at_once", "work", "positions", "velocities", "ahead"}) {
    a.dropped(key);
  }
}

std::string hexadecimal(std::uint64_t number) { return fmt::format("{:016x}", number); }

}  // namespace

SavedRun read_clock(const Json& json) {
  FieldReader r(ValueReader(json, "/state"));
  SavedRun saved;
  r.needed({"time", "a number, in s"}, [&](const ValueReader& v) {
    if (!v.has_value()) return;
    take(v, saved.time);
    if (!kMomentOfRun.contains(saved.time)) refuse_value(v.place(), quoted(v.value()), kMomentOfRun.text());
  });
  r.member({"fingerprint", ""}, [&](const ValueReader& v) {
    const std::string text = v.text({0, 16});
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), saved.fingerprint, 16);
    if (error != std::errc() || end != text.data() + text.size() || hexadecimal(saved.fingerprint) != text ||
        saved.fingerprint == 0) {
      refuse_value(v.place(), quoted(v.value()), "16 hexadecimal digits, as a saved run has them");
    }
  });
  if (saved.fingerprint == 0) r.finish();  // nothing but a clock
  return saved;
}

void read_checkpoint(const Json& json, Preset& preset) {
  Json rest = json;
  rest.erase("time");
  rest.erase("fingerprint");
  SavedRun& saved = *preset.saved;
  const std::size_t bodies = all_bodies(preset.scene).size();
  Checkpoint checkpoint;
  checkpoint.sums.gravity_since = saved.time;
  ValueReader(rest, "/state").object([&](FieldReader& r) {
    Members members(&r);
    if (r.has("tracks")) {
      read_earlier(members, checkpoint, preset.scene, bodies);
    } else {
      kCheckpoint(members, checkpoint, preset.scene, bodies);
    }
  });
  // A file that is older than the balance of angular momentum: the balance begins where the run was saved.
  if (!rest.at("ledger").contains("initial_angular_momentum")) {
    const Simulation start({preset.scene, preset.method, SavedRun{saved.time}});
    checkpoint.sums.ledger.initial_angular_momentum = start.totals().angular_momentum;
  }
  check_checkpoint(preset.scene, checkpoint);
  saved.checkpoint = std::make_shared<Checkpoint>(std::move(checkpoint));
}

Json state_json(const SavedRun& saved, const Scene& scene) {
  Json json = {{"time", saved.time}};
  if (saved.fingerprint == 0) return json;
  json["fingerprint"] = hexadecimal(saved.fingerprint);
  if (saved.checkpoint == nullptr) return json;
  Members members;
  kCheckpoint(members, *saved.checkpoint, scene, 0);
  json.update(members.json);
  return json;
}

}  // namespace carom
