#pragma once

#include <QLabel>
#include <QTest>
#include <functional>
#include <memory>
#include <optional>

#include "tests/app/lab/lab_fixture.h"
#include "tests/support/scenes.h"
#include "widgets/run/timeline.h"

// Moments of the record. The experiment head-on has its one impact at a third of a second and lasts one second.
namespace carom {

class LabPlayheadTest : public LabWindowTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabWindowTest::SetUp());
    window_.run_until(1.0);
    end_ = window_.frame();
    ASSERT_EQ(end_->impact_count, 1);
  }

  LabRuns& runs() { return window_.session().runs(); }
  Timeline* timeline() { return window_.findChild<Timeline*>(); }
  [[nodiscard]] bool wait_there() {
    return wait_for([this] { return runs().there() && !runs().replayed() && !window_.frame()->playing; });
  }
  void press(Qt::Key key) {
    QTest::keyClick(&window_.scene_view(), key);
    ASSERT_TRUE(wait_there());
  }
  QString clock() {
    for (const QLabel* label : window_.findChildren<QLabel*>("chip")) {
      if (label->text().startsWith("t = ")) return label->text();
    }
    return {};
  }
  QString speed_chip() {
    for (const QLabel* label : window_.findChildren<QLabel*>("chip")) {
      if (label->text().startsWith(QChar(0xd7))) return label->text();
    }
    return {};
  }
  // s: of the first picture shown for which `fulfilled` is true.
  [[nodiscard]] double first_shown(const std::function<bool()>& fulfilled) {
    std::optional<double> first;
    const auto watch = QObject::connect(&runs(), &LabRuns::framesChanged, &window_, [&] {
      if (!first && fulfilled()) first = time();
    });
    EXPECT_TRUE(wait_for([&] { return first.has_value(); }));
    QObject::disconnect(watch);
    return first.value_or(-1.0);
  }
  // From 50 ms before the impact until 50 ms after it, whichever pictures a busy machine shows.
  void expect_slow_near_the_impact() {
    double last_fast = time();
    const double first_slow = first_shown([&] {
      if (!runs().slow()) last_fast = time();
      return runs().slow();
    });
    EXPECT_LT(last_fast, 0.29);
    EXPECT_GT(first_slow, 0.275);
    EXPECT_LT(first_slow, 0.39);
  }
  // The run alone, up to this step.
  [[nodiscard]] State state_at(std::int64_t steps) const {
    Simulation run(setup_of(window_.preset()));
    while (run.steps() < steps) run.step();
    return run.state();
  }
  void expect_step(std::int64_t steps_there) {
    EXPECT_EQ(steps(), steps_there);
    EXPECT_TRUE(test::same_bytes(window_.frame()->state, state_at(steps_there)));
  }
  void drag_timeline(double from, double to, Qt::KeyboardModifiers held = {}) {
    const auto at = [this](double time) {
      return QPoint(qRound(timeline()->x_of(time)), timeline()->height() / 2);
    };
    QTest::mousePress(timeline(), Qt::LeftButton, held, at(from));
    QMouseEvent move(QEvent::MouseMove, at(to), timeline()->mapToGlobal(at(to)), Qt::NoButton, Qt::LeftButton,
                     held);
    QApplication::sendEvent(timeline(), &move);
    QTest::mouseRelease(timeline(), Qt::LeftButton, held, at(to));
    ASSERT_TRUE(wait_there());
  }

  std::shared_ptr<const Frame> end_;
};

}  // namespace carom
