#pragma once

#include <QTest>
#include <gtest/gtest.h>

#include "widgets/scene/scene_view.h"

namespace carom {

// A view of 600×400 px at 100 px/m: the world's origin stands at (300, 200).
class SceneViewFixture : public testing::Test {
 protected:
  void SetUp() override {
    view_.resize(600, 400);
    view_.set_view(View{Vec2::Zero(), 6.0});
    view_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_));
  }

  SceneView view_{light_theme()};
};

}  // namespace carom
