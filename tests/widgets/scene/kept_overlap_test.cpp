#include <QHelpEvent>
#include <QToolTip>

#include "tests/widgets/scene/scene_tools_fixture.h"

namespace carom {
namespace {

// The discs A and B overlap by 10 cm about (1.45, 1), which is (245, 200) on the screen.
class KeptOverlapTest : public SceneToolsTest {
 protected:
  void SetUp() override {
    SceneToolsTest::SetUp();
    answers_ = true;
    scene_.bodies[2].position = Vec2(1.65, 1.0);
    show(true);
  }
  [[nodiscard]] int reds() {
    const QImage image = view_.grab(QRect(sign_ - QPoint(10, 10), QSize(20, 20))).toImage();
    int found = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) found += alike(image.pixelColor(x, y), light_theme().danger);
    }
    return found;
  }
  [[nodiscard]] QString tip() {
    QHelpEvent help(QEvent::ToolTip, sign_, view_.mapToGlobal(sign_));
    QCoreApplication::sendEvent(&view_, &help);
    const QString text = QToolTip::text();
    QToolTip::hideText();
    return text;
  }
  const QPoint sign_{245, 200};
};

TEST_F(KeptOverlapTest, HasASignThatSaysHowDeepItIs) {
  EXPECT_GT(reds(), 20);
  EXPECT_EQ(tip(), "A and B overlap by 10.0 cm: play parts them");
  show(false);
  EXPECT_EQ(reds(), 0);
  EXPECT_NE(tip().left(5), "A and");
}

TEST_F(KeptOverlapTest, ComesWithADragThatKeepsItAndGoesWithTheNext) {
  scene_.bodies[2].position = Vec2(3.0, 1.0);
  show(true);
  EXPECT_EQ(reds(), 0);
  drag(b_, b_ + QPoint(-135, 0), Qt::ControlModifier);
  EXPECT_GT(reds(), 20);
  drag(b_ + QPoint(-135, 0), b_, Qt::ControlModifier);
  EXPECT_EQ(reds(), 0);
}

TEST_F(KeptOverlapTest, IsOneOfTheStartOnly) {
  Preset preset;
  preset.scene = scene_;
  const auto setup = std::make_shared<const RunSetup>(setup_of(preset));
  const Simulation run(*setup);
  auto frame = frame_of(run);
  frame->scene = std::make_shared<const Scene>(scene_now(run));
  frame->steps = 1;
  view_.set_frame(frame);
  EXPECT_EQ(reds(), 0);
}

}  // namespace
}  // namespace carom
