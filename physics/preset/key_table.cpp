#include "physics/preset/key_table.h"

#include <fmt/ranges.h>

#include "physics/dynamics/integrators/method_fields.h"
#include "physics/scene/scene.h"
#include "physics/scene/stop.h"

namespace carom {

void KeyTable::points(const Key& key, const std::vector<Vec2>&, const Count& count, const Range& range) {
  add(key, fmt::format("{} to {} points [x, y] in {}", count.least, count.most, text_of(range)), "");
  rows_.back().required = true;
}

void KeyTable::ends_of_range(const Key& key, double, double, const Range& range) {
  add(key, "[least, largest] in " + text_of(range), "");
  rows_.back().required = true;
}

void KeyTable::two_names(const Key& key, const std::string&, const std::string&) {
  add(key, "two names", "");
  rows_.back().required = true;
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

std::vector<KeySection> key_sections() {
  return {{"method", KeyTable::of(unstated_method())},
          {"materials", KeyTable::of<Material>()},
          {"material_pairs", KeyTable::of<MaterialPair>()},
          {"bodies", KeyTable::of<Body>()},
          {"generators", KeyTable::of<GridGenerator>()},
          {"forces: spring", KeyTable::of<Spring>()},
          {"forces: attraction", KeyTable::of<Attraction>()},
          {"forces: force", KeyTable::of<AppliedForce>()},
          {"links", KeyTable::of<Joint>()},
          {"stop", KeyTable::of<Stop>()}};
}

std::string markdown_of(const std::vector<KeyRow>& rows) {
  std::string text = "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const KeyRow& row : rows) {
    // The word of a case stands before the key.
    const std::size_t at = row.key.starts_with('`') ? row.key.rfind("`: ") + 3 : 0;
    const std::string mark = row.required ? "**" : "";
    text += fmt::format("| {}{}{}{} | {} | {} | {} |\n", row.key.substr(0, at), mark, row.key.substr(at), mark,
                        row.values, row.usual, row.meaning);
  }
  return text;
}

}  // namespace carom
