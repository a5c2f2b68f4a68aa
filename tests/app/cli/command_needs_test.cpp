#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace carom {
namespace {

TEST(NeedsCommand, SaysWhichPartsAreInAndWhy) {
  const Program carom;
  const ProgramResult result = carom({"needs", "drag-projectile", "--json"});
  EXPECT_EQ(result.code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["parts"].size(), 11U);
  for (const auto& part : json["parts"]) {
    EXPECT_FALSE(part["why"].get<std::string>().empty());
    const std::string key = part["part"];
    EXPECT_EQ(part["needed"].get<bool>(), key == "drag" || key == "resting_contacts") << key;
  }
}

TEST(NeedsCommand, PrintsATable) {
  const ProgramResult result = Program()({"needs", "head-on"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("not needed: rotation, friction"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("no body is driven"), std::string::npos);
}

TEST(NeedsCommand, RefusesBadInput) {
  const Program carom;
  expect_refused(carom({"needs"}), "preset is required");
  expect_refused(carom({"needs", "no-such"}), "no-such");
}

}  // namespace
}  // namespace carom
