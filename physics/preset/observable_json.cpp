#include "physics/preset/observable_json.h"

#include <fmt/format.h>
#include <map>

#include "physics/observe/observables.h"

namespace carom {
namespace {

// The most bodies that any observable needs.
constexpr std::size_t kMostObserved = 2;

}  // namespace

void read_observable(FieldReader& r, bool in_plot, std::string& name, std::vector<std::string>& bodies) {
  std::vector<std::string> names;
  std::map<int, std::vector<std::string>> by_bodies;
  for (const Observable& o : observables()) {
    if (!in_plot && o.is_error() && !r.reads()) continue;
    names.emplace_back(o.name);
    by_bodies[o.bodies].emplace_back(o.name);
  }
  r.needed({"observable", "the name of one"}, [&](const ValueReader& v) { name = names[v.word(names)]; });
  r.member({"bodies", "as many as the observable asks for"}, [&](const ValueReader& v) {
    v.list({0, kMostObserved}, [&](const ValueReader& body) { bodies.push_back(body.text(kName)); });
  });
  for (const auto& [count, group] : by_bodies) {
    Json then = {{"properties", {{"bodies", {{"minItems", count}, {"maxItems", count}}}}}};
    if (count > 0) then["required"] = Json::array({"bodies"});
    r.also({{"if",
             {{"properties", {{"observable", {{"enum", group}}}}}, {"required", Json::array({"observable"})}}},
            {"then", then}});
  }
  if (!r.reads()) return;
  const Observable& observable = *find_observable(name);
  if (observable.is_error() && !in_plot)
    refuse_value(r.at("observable"), "\"" + name + "\"", "it in plots only");
  if (static_cast<int>(bodies.size()) != observable.bodies) {
    refuse_value(r.at("bodies"), fmt::format("{} names", bodies.size()),
                 fmt::format("{} for \"{}\"", observable.bodies, name));
  }
}

}  // namespace carom
