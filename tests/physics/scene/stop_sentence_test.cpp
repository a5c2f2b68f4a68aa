#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <string>
#include <vector>

#include "physics/scene/stop.h"
#include "physics/scene/validate.h"

// Stops are written and read as sentences.
namespace carom {
namespace {

Stop at_impact(int number, const std::string& body = "", const std::string& with = "", bool with_wall = false) {
  Stop stop;
  stop.kind = StopKind::kImpact;
  stop.number = number;
  stop.body = body;
  stop.with = with;
  stop.with_wall = with_wall;
  return stop;
}

Stop when_passing(const std::string& body, StopQuantity quantity, double value, PassingWay way) {
  Stop stop;
  stop.kind = StopKind::kPassing;
  stop.body = body;
  stop.quantity = quantity;
  stop.value = value;
  stop.way = way;
  return stop;
}

TEST(StopSentence, TellsEveryKind) {
  Stop stop;
  stop.time = 2.5;
  EXPECT_EQ(sentence_of(stop), "at 2.5 s");
  EXPECT_EQ(sentence_of(at_impact(3)), "at the 3rd impact");
  EXPECT_EQ(sentence_of(at_impact(1, "A")), "at the 1st impact of A");
  EXPECT_EQ(sentence_of(at_impact(2, "A", "B")), "at the 2nd impact of A with B");
  EXPECT_EQ(sentence_of(at_impact(11, "", "", true)), "at the 11th impact with a wall");
  EXPECT_EQ(sentence_of(at_impact(122, "", "B")), "at the 122nd impact with B");
  EXPECT_EQ(sentence_of(at_impact(113)), "at the 113th impact");
  EXPECT_EQ(sentence_of(at_impact(4)), "at the 4th impact");
  EXPECT_EQ(sentence_of(when_passing("A", StopQuantity::kX, 0.4, PassingWay::kEither)),
            "when A passes x = 0.4 m");
  EXPECT_EQ(sentence_of(when_passing("A", StopQuantity::kAngle, -1, PassingWay::kUpwards)),
            "when A passes angle = -1 rad upwards");
  EXPECT_EQ(sentence_of(when_passing("A", StopQuantity::kSpeed, 2, PassingWay::kDownwards)),
            "when A passes speed = 2 m/s downwards");
  stop = {};
  stop.kind = StopKind::kEveryImpact;
  stop.body = "A";
  EXPECT_EQ(sentence_of(stop), "at every impact of A");
  stop = {};
  stop.kind = StopKind::kRest;
  EXPECT_EQ(sentence_of(stop), "when all is at rest");
  stop = {};
  stop.kind = StopKind::kKineticEnergy;
  stop.below = 1.0;
  EXPECT_EQ(sentence_of(stop), "when K falls below 1 J");
}

TEST(StopSentence, IsReadWithNamesOfSeveralWords) {
  EXPECT_EQ(stop_of("", "at the 2nd impact of left ball with right ball"),
            at_impact(2, "left ball", "right ball"));
  EXPECT_EQ(stop_of("", "when my ball passes y = 1e-3 m"),
            when_passing("my ball", StopQuantity::kY, 1e-3, PassingWay::kEither));
  EXPECT_EQ(stop_of("", "at the 2nd impact of \"a wall\" with \"a wall\""), at_impact(2, "a wall", "a wall"));
}

// The words of sentences, and what is special in them, as parts of names.
rc::Gen<std::string> names() {
  return rc::gen::map(
      rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
          "A", "ball", " ", "\"", " with ", " passes ", "a wall", " of ", "é", "x = 1 m", " upwards"))),
      [](const std::vector<std::string>& parts) {
        std::string name;
        for (std::size_t i = 0; i < std::min<std::size_t>(parts.size(), 12); ++i) name += parts[i];
        return name;
      });
}

TEST(StopSentence, IsReadAsItIsTold) {
  EXPECT_TRUE(rc::check([] {
    Stop stop;
    stop.kind = kStopNames[*rc::gen::inRange<std::size_t>(0, kStopNames.size())].id;
    const auto number = [] { return 1e-3 * *rc::gen::arbitrary<int>() / *rc::gen::inRange(1, 1000); };
    if (stop.kind == StopKind::kTime) stop.time = std::abs(number());
    if (stop.kind == StopKind::kKineticEnergy) stop.below = 1e-6 + std::abs(number());
    if (stop.kind == StopKind::kImpact) stop.number = *rc::gen::inRange(1, 1'000'000'000);
    if (stop.kind == StopKind::kImpact || stop.kind == StopKind::kEveryImpact) {
      if (*rc::gen::arbitrary<bool>()) stop.body = *names();
      const int with = *rc::gen::inRange(0, 3);
      if (with == 1) stop.with = *names();
      stop.with_wall = with == 2;
    }
    if (stop.kind == StopKind::kPassing) {
      stop.body = *names();
      stop.quantity = kStopQuantityNames[*rc::gen::inRange<std::size_t>(0, 4)].id;
      stop.value = number();
      stop.way = kPassingWayNames[*rc::gen::inRange<std::size_t>(0, 3)].id;
    }
    const std::string sentence = sentence_of(stop);
    RC_LOG() << sentence;
    RC_ASSERT(stop_of("", sentence) == stop);
  }));
}

TEST(StopSentence, RefusesOthersInOneLine) {
  const auto line = [](const std::string& sentence) -> std::string {
    try {
      (void)stop_of("--stop", sentence);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "taken";
  };
  for (const char* sentence :
       {"", "at", "at 2.5", "at 2.5 m", "at two s", "at the 3 impact", "at the 1st impact of",
        "at every impacts", "at the 1st impact with", "when A passes z = 1 m", "when A passes x = 1",
        "when A passes x = 1 rad", "when A passes x = 1 m sideways", "when all is at rest ",
        "when K falls below 1", "when passes x = 1 m", "at the 1st impact of \"A",
        "at the 99999999999st impact"}) {
    const std::string refusal = line(sentence);
    EXPECT_EQ(
        refusal.rfind("--stop: \"" + std::string(sentence) + "\" is not allowed; allowed: \"at 2.5 s\"", 0), 0U)
        << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos);
  }
  EXPECT_EQ(line("at -1 s"), "--stop/time: -1 is not allowed; allowed: a number from 0 to 1000000000000 s");
  EXPECT_EQ(line("at nan s"), "--stop/time: nan is not allowed; allowed: a number from 0 to 1000000000000 s");
  EXPECT_EQ(line("when K falls below 0 J"),
            "--stop/below: 0 is not allowed; allowed: a number from 1e-12 to 1000000000000 J");
  EXPECT_EQ(line("at the 0th impact").rfind("--stop/number: 0 is not allowed", 0), 0U);
}

}  // namespace
}  // namespace carom
