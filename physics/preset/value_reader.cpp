#include "physics/preset/value_reader.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace carom {
namespace {

constexpr double kLargestWhole = 9e15;  // up to here every whole number is a double

void describe_range(Json& schema, const Range& range) {
  Json limits;
  limits["type"] = "number";
  limits["minimum"] = range.low;
  limits["maximum"] = range.high;
  if (range.or_zero) {
    schema["anyOf"] = Json::array({{{"const", 0}}, limits});
  } else {
    schema.update(limits);
  }
  if (range.unit.empty()) return;
  schema["description"] = fmt::format("{}, in {}", schema.value("description", "a number"), range.unit);
}

std::string text_of(const Count& count, const char* what) {
  if (count.least == count.most) return fmt::format("{} {}", count.least, what);
  return count.least == 0 ? fmt::format("up to {} {}", count.most, what)
                          : fmt::format("{} to {} {}", count.least, count.most, what);
}

}  // namespace

double ValueReader::number(const Range& range) const {
  if (!has_value()) {
    describe_range(*schema_, range);
    return 0.0;
  }
  if (!value_->is_number()) refuse("a number");
  const auto x = value_->get<double>();
  if (!range.contains(x)) refuse_value(place_, fmt::format("{}", x), range.text());
  return x;
}

std::int64_t ValueReader::whole(const Whole& range) const {
  if (!has_value()) {
    (*schema_)["type"] = "integer";
    (*schema_)["minimum"] = range.low;
    (*schema_)["maximum"] = range.high;
    return 0;
  }
  const double x = value_->is_number() ? value_->get<double>() : std::nan("");
  if (!(x >= range.low && x <= range.high && x == std::floor(x) && std::abs(x) <= kLargestWhole))
    refuse(fmt::format("a whole number from {} to {}", range.low, range.high));
  return static_cast<std::int64_t>(x);
}

bool ValueReader::boolean() const {
  if (!has_value()) {
    (*schema_)["type"] = "boolean";
    return false;
  }
  if (!value_->is_boolean()) refuse("true or false");
  return value_->get<bool>();
}

std::string ValueReader::text(const Count& length) const {
  if (!has_value()) {
    (*schema_)["type"] = "string";
    if (length.least > 0) (*schema_)["minLength"] = length.least;
    (*schema_)["maxLength"] = length.most;
    return {};
  }
  if (!value_->is_string()) refuse("a text, \"...\"");
  const auto& text = value_->get_ref<const std::string&>();
  if (const std::size_t size = characters(text); size < length.least || size > length.most)
    refuse("a text of " + text_of(length, "characters"));
  return text;
}

Vec2 ValueReader::pair(const Range& x, const Range& y) const {
  if (!has_value()) {
    (*schema_)["type"] = "array";
    Json first = Json::object();
    Json second = Json::object();
    describe_range(first, x);
    describe_range(second, y);
    (*schema_)["items"] = Json::array({first, second});
    (*schema_)["minItems"] = 2;
    (*schema_)["maxItems"] = 2;
    return Vec2::Zero();
  }
  if (!value_->is_array() || value_->size() != 2) refuse("two numbers, [x, y]");
  return {ValueReader((*value_)[0], place_ + "/0").number(x),
          ValueReader((*value_)[1], place_ + "/1").number(y)};
}

std::size_t ValueReader::word(const std::vector<std::string>& words) const {
  if (!has_value()) {
    (*schema_)["enum"] = words;
    return 0;
  }
  if (value_->is_string()) {
    const auto found = std::find(words.begin(), words.end(), value_->get_ref<const std::string&>());
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  }
  refuse(fmt::format("\"{}\"", fmt::join(words, "\", \"")));
}

void ValueReader::list(const Count& count, const std::function<void(const ValueReader&)>& each) const {
  if (!has_value()) {
    (*schema_)["type"] = "array";
    if (count.least > 0) (*schema_)["minItems"] = count.least;
    (*schema_)["maxItems"] = count.most;
    Json element = Json::object();
    each(ValueReader(element));
    (*schema_)["items"] = std::move(element);
    return;
  }
  if (!value_->is_array()) refuse("an array, [...]");
  if (value_->size() < count.least || value_->size() > count.most)
    refuse_value(place_, fmt::format("an array of {} elements", value_->size()), text_of(count, "elements"));
  for (std::size_t i = 0; i < value_->size(); ++i)
    each(ValueReader((*value_)[i], fmt::format("{}/{}", place_, i)));
}

void ValueReader::object(const std::function<void(FieldReader&)>& read) const {
  if (!has_value()) {
    FieldReader description;
    read(description);
    schema_->update(description.schema());
    return;
  }
  FieldReader reader(*this);
  read(reader);
  reader.finish();
}

void ValueReader::numbers(std::size_t most, const Range& range,
                          const std::function<void(const std::string&, double)>& each) const {
  if (!has_value()) {
    (*schema_)["type"] = "object";
    (*schema_)["maxProperties"] = most;
    Json element = Json::object();
    describe_range(element, range);
    (*schema_)["additionalProperties"] = std::move(element);
    return;
  }
  if (!value_->is_object()) refuse("an object, {\"/bodies/0/mass\": 2, ...}");
  if (value_->size() > most)
    refuse_value(place_, fmt::format("an object of {} keys", value_->size()), fmt::format("up to {}", most));
  for (const auto& item : value_->items())
    each(item.key(),
         ValueReader(item.value(), fmt::format("{} {}", place_, shortened(item.key()))).number(range));
}

std::string ValueReader::free_object() const {
  if (!has_value()) {
    (*schema_)["type"] = "object";
    return {};
  }
  if (!value_->is_object()) refuse("an object, {...}");
  return value_->dump();
}

void ValueReader::one_of(std::size_t chosen,
                         std::initializer_list<std::function<void(const ValueReader&)>> forms) const {
  if (has_value()) {
    forms.begin()[chosen](*this);
    return;
  }
  (*schema_)["anyOf"] = Json::array();
  for (const auto& form : forms) {
    Json description = Json::object();
    form(ValueReader(description));
    (*schema_)["anyOf"].push_back(std::move(description));
  }
}

FieldReader::FieldReader(const ValueReader& value) : object_(&value.value()), place_(value.place()) {
  if (!object_->is_object()) refuse_value(place_, quoted(*object_), "an object, {...}");
}

void FieldReader::read_objects(const Key& key, std::size_t most,
                               const std::function<void(FieldReader&, const std::string&)>& each) {
  member(key, [&](const ValueReader& list) {
    list.list({0, most}, [&](const ValueReader& element) {
      element.object([&](FieldReader& r) { each(r, element.place()); });
    });
  });
}

void FieldReader::cases(const Key& key, const std::vector<std::string>& words, std::size_t chosen,
                        const std::function<void(std::size_t, FieldReader&)>& each) {
  if (reads() || writes()) {
    put(key.name, words[chosen]);
    needed(key, [&](const ValueReader& v) { chosen = v.word(words); });
    each(chosen, *this);
    return;
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    FieldReader& one = cases_.emplace_back();
    one.described_[key.name] = {{"description", key.meaning}, {"const", words[i]}};
    one.required_.emplace_back(key.name);
    each(i, one);
  }
}

void FieldReader::points(const Key& key, std::vector<Vec2>& list, const Count& count, const Range& range) {
  Json written = Json::array();
  for (const Vec2& point : list) written.push_back(pair_json(point));
  put(key.name, written);
  needed(key, [&](const ValueReader& v) {
    v.list(count, [&](const ValueReader& point) { list.push_back(point.pair(range)); });
  });
}

void FieldReader::numbers(const Key& key, std::vector<double>& list, const Count& count, const Range& range) {
  put(key.name, list);
  needed(key, [&](const ValueReader& v) {
    v.list(count, [&](const ValueReader& x) { list.push_back(x.number(range)); });
  });
}

void FieldReader::compound(const Key& key, Shape& shape, const Count& count) {
  if (const auto* compound = std::get_if<Compound>(&shape); writes() && compound != nullptr) {
    Json list = Json::array();
    for (const PlacedShape& placed : compound->shapes) list.push_back(written(placed, writes_all()));
    put(key.name, list);
  }
  member(key, [&](const ValueReader& v) {
    Compound compound;
    v.list(count, [&](const ValueReader& element) {
      element.object([&](FieldReader& r) { fields(r, compound.shapes.emplace_back()); });
    });
    shape = std::move(compound);
  });
}

void FieldReader::ends_of_range(const Key& key, double& low, double& high, const Range& range) {
  put(key.name, Vec2(low, high));
  needed(key, [&](const ValueReader& v) {
    const Vec2 ends = v.pair(range);
    low = ends.x();
    high = ends.y();
  });
}

void FieldReader::two_names(const Key& key, std::string& a, std::string& b) {
  put(key.name, Json::array({a, b}));
  needed(key, [&](const ValueReader& v) {
    std::vector<std::string> two;
    v.list({2, 2}, [&](const ValueReader& name) { two.push_back(name.text(kNameLength)); });
    a = two.front();
    b = two.back();
  });
}

void FieldReader::together(const KeysTogether& rule) {
  using Which = KeysTogether::Rule;
  if (reads()) {
    const bool first = has(rule.first);
    const bool second = has(rule.second);
    if (!first && !second && rule.rule != Which::kNotBoth)
      refuse_value(at(rule.second), rule.neither, rule.allowed);
    if (first && second && rule.rule != Which::kOneOrBoth)
      refuse_value(at(rule.second), rule.both, rule.allowed);
    return;
  }
  if (rule.rule == Which::kNotBoth) {
    also({{"not", {{"required", {rule.first, rule.second}}}}});
  } else {
    const char* const word = rule.rule == Which::kExactlyOne ? "oneOf" : "anyOf";
    also({{word, {{{"required", Json::array({rule.first})}}, {{"required", Json::array({rule.second})}}}}});
  }
}

std::optional<ValueReader> FieldReader::find(const Key& key) {
  if (!reads()) {
    described_[key.name] = {{"description", key.meaning}};
    return ValueReader(described_[key.name]);
  }
  known_.push_back(key.name);
  const auto found = object_->find(key.name);
  if (found == object_->end()) return std::nullopt;
  return ValueReader(*found, at(key.name));
}

void FieldReader::refuse_missing(const Key& key, const Json& description) const {
  std::string allowed = key.meaning;
  if (description.contains("enum")) {
    allowed.clear();
    for (const Json& word : description["enum"]) allowed += (allowed.empty() ? "" : ", ") + word.dump();
  }
  throw SceneError(fmt::format("{}: \"{}\" is missing; allowed: {}", place_.empty() ? "/" : place_, key.name,
                               shortened(allowed, 300)));
}

Json FieldReader::written_beside(const FieldReader& usual) const {
  Json out = described_;
  for (const auto& [key, value] : usual.described_.items()) {
    const bool kept = std::find(required_.begin(), required_.end(), key) != required_.end();
    if (!kept && out.contains(key) && out[key] == value) out.erase(key);
  }
  return out;
}

void FieldReader::finish() const {
  for (const auto& item : object_->items()) {
    if (std::find(known_.begin(), known_.end(), item.key()) != known_.end()) continue;
    std::vector<std::string> allowed = known_;
    std::sort(allowed.begin(), allowed.end());
    throw SceneError(fmt::format("{}: unknown key; allowed here: {}", shortened(at(shortened(item.key())), 120),
                                 shortened(fmt::format("{}", fmt::join(allowed, ", ")), 300)));
  }
}

Json FieldReader::schema() const {
  const auto object = [](const Json& properties, const std::vector<std::string>& required) {
    Json one = {{"type", "object"}, {"properties", properties}};
    if (!required.empty()) one["required"] = required;
    one["additionalProperties"] = false;
    return one;
  };
  Json out;
  if (cases_.empty()) {
    out = object(described_, required_);
  } else {
    // A case repeats the common keys, because no keys are allowed beside those of one object.
    out["anyOf"] = Json::array();
    for (const FieldReader& one : cases_) {
      Json properties = described_;
      properties.update(one.described_);
      std::vector<std::string> required = required_;
      required.insert(required.end(), one.required_.begin(), one.required_.end());
      Json form = object(properties, required);
      if (!one.conditions_.empty()) form["allOf"] = one.conditions_;
      out["anyOf"].push_back(std::move(form));
    }
  }
  if (!conditions_.empty()) out["allOf"] = conditions_;
  return out;
}

}  // namespace carom
