#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <optional>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "physics/preset/preset_json.h"
#include "physics/scene/validate.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/support/preset_files.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// A whole number is one however it is written: 1.0 as well as 1. The validator knows the second alone. It
// counts the characters of a text up to a zero only.
nlohmann::json plain(const Json& value) {
  if (value.is_array() || value.is_object()) {
    nlohmann::json out = value.is_array() ? nlohmann::json::array() : nlohmann::json::object();
    for (const auto& item : value.items()) {
      if (value.is_array()) {
        out.push_back(plain(item.value()));
      } else {
        out[item.key()] = plain(item.value());
      }
    }
    return out;
  }
  if (value.is_string()) {
    auto text = value.get<std::string>();
    std::replace(text.begin(), text.end(), '\0', ' ');
    return text;
  }
  if (value.is_number_float() && std::abs(value.get<double>()) < 9e15) {
    const auto x = value.get<double>();
    if (x == std::floor(x)) return static_cast<std::int64_t>(x);
  }
  return nlohmann::json::parse(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

class SchemaValidator {
 public:
  SchemaValidator() : text_(nlohmann::json::parse(preset_schema().dump())) {
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(valijson::adapters::NlohmannJsonAdapter(text_), schema_);
  }
  [[nodiscard]] bool accepts(const Json& preset) const {
    const nlohmann::json value = plain(preset);
    return valijson::Validator().validate(schema_, valijson::adapters::NlohmannJsonAdapter(value), nullptr);
  }

 private:
  nlohmann::json text_;
  valijson::Schema schema_;
};

std::vector<Json> good_presets() {
  std::vector<Json> presets;
  std::vector<fs::path> files = test::preset_files();
  for (const auto& entry : fs::directory_iterator(test::source("tests/fuzz/seeds")))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) presets.push_back(parse_json(test::content(file)));
  return presets;
}

struct Verdict {
  bool good = true;
  bool by_rule = false;  // of kRules
  std::string line;
};

Verdict reader_says(const Json& preset) {
  try {
    (void)preset_of(preset);
    return {};
  } catch (const RuleError& error) {
    return {false, true, error.what()};
  } catch (const SceneError& error) {
    return {false, false, error.what()};
  }
}

// Both refuse, or the reader alone for what no schema can say.
void expect_agreement(const SchemaValidator& schema, const Json& preset) {
  const Verdict reader = reader_says(preset);
  const bool accepted = schema.accepts(preset);
  if (reader.good) {
    EXPECT_TRUE(accepted) << "only the schema refuses " << preset;
  } else if (accepted) {
    EXPECT_TRUE(reader.by_rule) << "only the reader refuses: " << reader.line << "\n" << preset;
  }
}

TEST(PresetSchema, AcceptsEveryPreset) {
  const SchemaValidator schema;
  for (const Json& preset : good_presets()) {
    EXPECT_TRUE(schema.accepts(preset)) << preset["title"];
    expect_agreement(schema, preset);
  }
}

TEST(PresetSchema, AgreesWithTheReaderOnBrokenPresets) {
  const SchemaValidator schema;
  const std::vector<Json> presets = good_presets();
  fuzz::Random random(14);
  int refused = 0;
  int by_rule = 0;
  for (int i = 0; i < 5000; ++i) {
    Json preset = presets[static_cast<std::size_t>(i) % presets.size()];
    for (std::uint64_t left = 1 + random() % 2; left > 0; --left) fuzz::mutate(preset, random);
    expect_agreement(schema, preset);
    const Verdict verdict = reader_says(preset);
    refused += verdict.good ? 0 : 1;
    by_rule += verdict.by_rule ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_GT(refused, 2500);
  EXPECT_GT(by_rule, 100);
  EXPECT_LT(by_rule, refused / 2);
}

// What every number of the schema claims is what the reader takes, to the last bit, and what its message says.
TEST(PresetSchema, RangesAreThoseThatTheReaderKeeps) {
  const Json whole = parse_json(test::content(test::source("tests/fuzz/seeds/every-key.json")));
  const Json flat = whole.flatten();
  int numbers = 0;
  for (const auto& item : flat.items()) {
    if (!item.value().is_number() || item.key().starts_with("/extra") || item.key() == "/version") continue;
    const Json::json_pointer at(item.key());
    const auto line_about = [&](double x) -> std::string {
      Json preset = whole;
      preset[at] = x;
      return reader_says(preset).line;
    };
    const std::string line = line_about(-1.5e12);
    const auto from = line.find("number from ");
    ASSERT_NE(from, std::string::npos) << item.key() << ": " << line;
    double low = 0.0;
    double high = 0.0;
    ASSERT_EQ(std::sscanf(line.c_str() + from, "number from %lf to %lf", &low, &high), 2) << line;
    const bool counted = line.find("whole number") != std::string::npos;
    const double below = counted ? low - 1.0 : std::nextafter(low, -INFINITY);
    const double above = counted ? high + 1.0 : std::nextafter(high, INFINITY);
    for (const double bad : {below, above})
      EXPECT_NE(line_about(bad).find(line.substr(from)), std::string::npos) << item.key() << " = " << bad;
    for (const double good : {low, high}) {
      // Another part of the scene may forbid it, its range does not.
      EXPECT_EQ(line_about(good).find("number from "), std::string::npos)
          << item.key() << " = " << good << line_about(good);
    }
    if (line.find("0, or a number") != std::string::npos) {
      EXPECT_EQ(line_about(0.0).find("number from "), std::string::npos) << item.key();
    } else if (low > 0.0) {
      EXPECT_NE(line_about(0.0).find("number from "), std::string::npos) << item.key();
    }
    ++numbers;
  }
  EXPECT_GT(numbers, 80);
}

TEST(PresetSchema, DescribesEveryKey) {
  const std::string text = preset_schema().dump();
  const Json whole = parse_json(test::content(test::source("tests/fuzz/seeds/every-key.json")));
  const Json flat = whole.flatten();
  for (const auto& item : flat.items()) {
    const std::string key = item.key().substr(item.key().rfind('/') + 1);
    if (key.empty() || std::isdigit(static_cast<unsigned char>(key[0])) != 0 ||
        item.key().starts_with("/extra"))
      continue;
    if (item.key().find("/with/") != std::string::npos) continue;
    EXPECT_NE(text.find(fmt::format("\"{}\":{{", key)), std::string::npos) << item.key();
  }
}

}  // namespace
}  // namespace carom
