#include "physics/preset/key_table.h"

#include <fmt/ranges.h>

#include "physics/dynamics/integrators/method_fields.h"
#include "physics/preset/sections_json.h"
#include "physics/scene/scene.h"
#include "physics/scene/stop.h"

namespace carom {

void KeyTable::points(const Key& key, const std::vector<Vec2>&, const Count& count, const Range& range) {
  required_other(key, fmt::format("{} to {} points [x, y] in {}", count.least, count.most, text_of(range)));
}

void KeyTable::numbers(const Key& key, const std::vector<double>&, const Count& count, const Range& range) {
  required_other(key, fmt::format("{} to {} values, each {}", count.least, count.most, text_of(range)));
}

void KeyTable::ends_of_range(const Key& key, double, double, const Range& range) {
  required_other(key, "[least, largest] in " + text_of(range));
}

void KeyTable::two_names(const Key& key, const std::string&, const std::string&) {
  required_other(key, "two names");
}

std::string KeyTable::text_of(const Range& range) {
  std::string text(range.unit.empty() ? "a number" : range.unit);
  if (range.or_zero) return text + ", ≥ 0";
  if (range.low == kLeastPositive && range.high == kLargestNumber) return text + ", > 0";
  if (range.low == 0.0 && range.high == kLargestNumber) return text + ", ≥ 0";
  if (range.low == -kLargestNumber && range.high == kLargestNumber) return text;
  return fmt::format("{} from {} to {}", text, range.low, range.high);
}

std::string KeyTable::joined(const std::vector<std::string>& words) {
  return fmt::format("`{}`", fmt::join(words, "`, `"));
}

namespace {

// The keys of the file itself that hold no list.
std::vector<KeyRow> keys_of_the_whole() {
  return KeyTable::of_all([preset = Preset()](KeyTable& table) {
    head_fields(table, preset);
    law_fields(table, preset.scene);
    window_fields(table, preset);
  });
}

// The body has the keys of the table of bodies.
std::vector<KeyRow> keys_of_late_bodies() {
  std::vector<KeyRow> rows = KeyTable::of<LateBody>();
  std::erase_if(rows, [](const KeyRow& row) { return row.key.starts_with("body/"); });
  return rows;
}

std::vector<KeyRow> keys_of_forces() {
  return KeyTable::of_all([](KeyTable& table) {
    Forces forces;
    force_fields(table, forces, [](const std::string&) {});
  });
}

std::vector<KeyRow> keys_of_expectations() {
  return KeyTable::of_all([](KeyTable& table) {
    Expectation usual;
    table.required_other(kObservableKey, "a name");
    table.other(kObservedBodiesKey, "an array of names");
    reduction_fields(table, usual);
    table.other(kSettingsKey, "an object of numbers");
    table.object(kSweepKey, usual.over);
    value_fields(table, usual);
  });
}

// Text in a cell of a table of a Markdown page.
std::string in_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c;
  }
  return cell;
}

}  // namespace

std::vector<KeySection> key_sections() {
  return {{"the whole", keys_of_the_whole()},      {"method", KeyTable::of(unstated_method())},
          {"materials", KeyTable::of<Material>()}, {"material_pairs", KeyTable::of<MaterialPair>()},
          {"bodies", KeyTable::of<Body>()},        {"generators", KeyTable::of<GridGenerator>()},
          {"added", keys_of_late_bodies()},        {"forces", keys_of_forces()},
          {"links", KeyTable::of<Joint>()},        {"stop", KeyTable::of<Stop>()},
          {"expect", keys_of_expectations()}};
}

std::string markdown_of(const std::vector<KeyRow>& rows) {
  std::string text = "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const KeyRow& row : rows) {
    // The word of a case stands before the key.
    const std::size_t at = row.key.starts_with('`') ? row.key.rfind("`: ") + 3 : 0;
    const std::string mark = row.required ? "**" : "";
    text += fmt::format("| {}{}{}{} | {} | {} | {} |\n", row.key.substr(0, at), mark, row.key.substr(at), mark,
                        row.values, row.usual, in_cell(row.meaning));
  }
  return text;
}

}  // namespace carom
