#include "physics/preset/setting.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>

#include "physics/preset/preset.h"
#include "physics/preset/preset_json.h"

namespace carom {
namespace {

constexpr std::string_view kForces = "/forces/";
constexpr const char* kPlaceAllowed =
    "the JSON pointer of a number of this preset, such as /gravity/1 or /bodies/0/position/0";

// The number that stands at a JSON pointer; nullptr if there is none.
Json* number_at(Json& json, const std::string& place) {
  try {
    const Json::json_pointer pointer(place);
    if (!json.contains(pointer)) return nullptr;
    Json& found = json.at(pointer);
    return found.is_number() ? &found : nullptr;
  } catch (const Json::exception&) {
    return nullptr;  // not a JSON pointer
  }
}

// Of each force the place in the file and the one in a file that Carom writes.
std::map<int, int> moves(const Forces& forces, const ForcePlaces& file) {
  const ForcePlaces written = written_places(forces);
  std::map<int, int> pairs;
  const auto one = [&](const std::optional<int>& from, const std::optional<int>& to) {
    if (from && to) pairs.emplace(*from, *to);
  };
  one(file.linear_drag, written.linear_drag);
  one(file.quadratic_drag, written.quadratic_drag);
  one(file.attraction, written.attraction);
  for (std::size_t i = 0; i < file.springs.size(); ++i) pairs.emplace(file.springs[i], written.springs[i]);
  for (std::size_t i = 0; i < file.applied.size(); ++i) pairs.emplace(file.applied[i], written.applied[i]);
  return pairs;
}

// The place in a file that Carom writes.
std::string moved(const std::string& place, const std::map<int, int>& moves) {
  if (!place.starts_with(kForces)) return place;
  int index = -1;
  const char* end = place.data() + place.size();
  const auto [rest, error] = std::from_chars(place.data() + kForces.size(), end, index);
  if (error != std::errc()) return place;
  const auto found = moves.find(index);
  return found == moves.end() ? place : fmt::format("{}{}{}", kForces, found->second, std::string(rest, end));
}

Json full_json(const Preset& preset) {
  Json json = preset_json(preset, true);
  json.erase("expect");
  json.erase("extra");
  return json;
}

}  // namespace

Preset variant(const Preset& preset, const std::vector<Setting>& settings) {
  Json json = full_json(preset);
  for (const Setting& s : settings) {
    Json* number = number_at(json, s.place);
    if (number == nullptr) refuse_by(Rule::kPlaces, s.place, "a setting where no number stands", kPlaceAllowed);
    // Counts and seeds are whole numbers in a file.
    if (number->is_number_integer() && std::floor(s.value) == s.value && std::abs(s.value) < 9e15) {
      *number = static_cast<std::int64_t>(s.value);
    } else {
      *number = s.value;
    }
  }
  Preset changed = preset_of(json);
  changed.topic = preset.topic;
  return changed;
}

void resolve_places(Preset& preset, const ForcePlaces& places) {
  const auto has_places = [](const Expectation& e) { return e.over || !e.settings.empty(); };
  if (std::none_of(preset.expect.begin(), preset.expect.end(), has_places)) return;
  Json json = full_json(preset);
  const auto pairs = moves(preset.scene.forces, places);
  const auto resolve = [&](const std::string& at, std::string& place) {
    std::string now = moved(place, pairs);
    if (number_at(json, now) == nullptr) refuse_by(Rule::kPlaces, at, "\"" + place + "\"", kPlaceAllowed);
    place = std::move(now);
  };
  for (std::size_t i = 0; i < preset.expect.size(); ++i) {
    Expectation& e = preset.expect[i];
    for (Setting& s : e.settings) resolve(fmt::format("/expect/{}/with", i), s.place);
    if (e.over) resolve(fmt::format("/expect/{}/over/place", i), e.over->place);
  }
}

}  // namespace carom
