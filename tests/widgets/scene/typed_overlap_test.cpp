#include "widgets/scene/typed_overlap.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

// Two discs of 10 cm, 1 m apart.
class TypedOverlapTest : public testing::Test {
 protected:
  TypedOverlapTest() {
    for (const char* name : {"light", "heavy"}) {
      Body body;
      body.name = name;
      body.mass = 1.0;
      body.shape = Disc{0.1};
      body.position = Vec2(scene_.bodies.empty() ? 0.0 : 1.0, 0.0);
      scene_.bodies.push_back(body);
    }
    give_ids(scene_);
  }
  template <class Change>
  [[nodiscard]] std::string said(const Change& change) const {
    Body light = scene_.bodies[0];
    change(light);
    return typed_overlap(scene_, {Replace<Body>{light}}).toStdString();
  }
  Scene scene_;
};

TEST_F(TypedOverlapTest, APlaceInsideAnotherBody) {
  EXPECT_EQ(said([](Body& body) { body.position.x() = 0.832; }),
            "light and heavy overlap by 3.2 cm: they stay so, and play parts them.");
}

TEST_F(TypedOverlapTest, ASizeThatReachesIntoAnotherBody) {
  EXPECT_EQ(said([](Body& body) { body.shape = Disc{0.95}; }),
            "light and heavy overlap by 5.0 cm: they stay so, and play parts them.");
}

TEST_F(TypedOverlapTest, NothingIsSaidOfTouchingNorOfOtherEdits) {
  EXPECT_EQ(said([](Body& body) { body.position.x() = 0.8; }), "");
  EXPECT_EQ(said([](Body& body) { body.position.x() = 0.800001; }), "") << "as numbers are rounded";
  scene_.bodies[1].position.x() = 0.1;
  EXPECT_EQ(said([](Body& body) { body.mass = 2.0; }), "");
  EXPECT_NE(said([](Body& body) { body.position.x() = 0.01; }), "");
}

// A field may still show a body that the scene has lost meanwhile; the edit itself is refused then.
TEST_F(TypedOverlapTest, NothingIsSaidOfABodyThatIsGone) {
  Body gone = scene_.bodies[0];
  gone.id.number = 99;
  EXPECT_EQ(typed_overlap(scene_, {Replace<Body>{gone}}).toStdString(), "");
}

}  // namespace
}  // namespace carom
