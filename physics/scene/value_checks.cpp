#include "physics/scene/value_checks.h"

#include <fmt/format.h>

#include "physics/scene/plain_text.h"
#include "physics/scene/range_check.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

std::string refusal(const std::string& place, const std::string& found, const std::string& allowed) {
  return fmt::format("{}: {} is not allowed; allowed: {}", place.empty() ? "/" : shortened(place),
                     shortened(found), shortened(allowed, 300));
}

}  // namespace

std::string Range::text() const {
  return fmt::format("{}a number from {} to {}{}{}", or_zero ? "0, or " : "", low, high,
                     unit.empty() ? "" : " ", unit);
}

void refuse_value(const std::string& place, const std::string& found, const std::string& allowed) {
  throw SceneError(refusal(place, found, allowed));
}

void refuse_by(Rule rule, const std::string& place, const std::string& found, const std::string& allowed) {
  throw RuleError(rule, refusal(place, found, allowed));
}

void check_range(const std::string& place, double value, const Range& range) {
  if (!range.contains(value)) refuse_value(place, fmt::format("{}", value), range.text());
}

void check_order(const std::string& place, double value, double least, const std::string& what) {
  if (value >= least) return;
  refuse_by(Rule::kOrderOfNumbers, place, fmt::format("{}", value),
            fmt::format("{} = {} or more", what, least));
}

void check_name(const std::string& place, const std::string& name, std::size_t longest) {
  if (name.empty()) refuse_value(place, "an empty name", "a name");
  if (characters(name) > longest)
    refuse_value(place, "\"" + name + "\"", fmt::format("a name of up to {} characters", longest));
}

void check_own_name(std::unordered_set<std::string>& names, const std::string& place, const std::string& name) {
  if (!names.insert(name).second)
    refuse_by(Rule::kOwnNames, place, fmt::format("\"{}\", used before,", shortened(name, 40)),
              "a name of its own");
}

void check_count(const std::string& place, std::size_t count, std::size_t most, const char* what) {
  if (count > most) refuse_value(place, fmt::format("{} {}", count, what), fmt::format("up to {}", most));
}

const Body& named_body(const NamedBodies& bodies, const std::string& place, const std::string& name) {
  const auto found = bodies.find(name);
  if (found == bodies.end()) refuse_by(Rule::kReferences, place, "\"" + name + "\"", "the name of a body");
  return *found->second;
}

const Body& movable_body(const NamedBodies& bodies, const std::string& place, const std::string& name) {
  const Body& body = named_body(bodies, place, name);
  if (has_infinite_mass(body))
    refuse_by(Rule::kReferences, place, fmt::format("\"{}\", which no force moves,", shortened(name, 40)),
              "a body that is neither fixed nor driven");
  return body;
}

void check_stop(const std::string& place, const Stop& stop, const NamedBodies& bodies) {
  check_fields(place, stop);
  if (!stop.body.empty()) (void)named_body(bodies, place + "/body", stop.body);
  if (!stop.with.empty()) (void)named_body(bodies, place + "/with", stop.with);
  if (!stop.with.empty() && stop.with == stop.body)
    refuse_by(Rule::kReferences, place + "/with", "\"" + stop.with + "\" again", "another body");
}

}  // namespace carom
