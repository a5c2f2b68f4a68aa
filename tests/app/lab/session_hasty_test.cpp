#include <QCoreApplication>
#include <QElapsedTimer>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "app/lab/session.h"
#include "tests/app/lab/two_discs.h"
#include "tests/support/effort.h"

// What is done in a session without waiting for the runs, which are slow on a busy machine. Whenever frames are
// shown, each has its record.
namespace carom {
namespace {

class Hasty {
 public:
  explicit Hasty(unsigned seed) : random_(seed) {
    QObject::connect(&session_.runs(), &LabRuns::framesChanged, [this] { look(); });
    open();
  }
  void act() {
    Session& s = session_;
    std::vector<SessionStarts::Known> known;
    switch (random_() % 15) {
      case 0:
        if (random_() % 4 == 0) open();
        return;
      case 1:
        return s.starts().set_playing(random_() % 3 != 0);
      case 2:
      case 3:
        return change();
      case 4:
      case 5:
        return s.edits().undo();
      case 6:
        return s.edits().redo();
      case 7:
        return s.starts().restart();
      case 8:
        return s.starts().go_to_first();
      case 9:
        known = s.starts().known();
        return s.starts().go_to(known[random_() % known.size()]);
      case 10:
        return compare();
      case 11:
        if (!s.runs().frames().empty()) s.runs().go_to(0.01 * static_cast<double>(random_() % 40));
        return;
      case 12:
        if (!s.runs().frames().empty()) s.starts().step_by(random_() % 2 == 0 ? 1 : -1);
        return;
      case 13:
        return s.runs().when_still("wait", [this] { change(); });
      default:
        return wait();
    }
  }

  void look() {
    const LabRuns& runs = session_.runs();
    if (runs.frames().empty()) return;
    ASSERT_EQ(runs.recorders().size(), runs.frames().size());
    for (const auto& recorder : runs.recorders()) ASSERT_NE(recorder, nullptr);
    ASSERT_EQ(runs.newest().size(), runs.frames().size());
    ASSERT_LE(runs.frame()->bodies->size(), session_.history().bodies().size());
  }

 private:
  void open() {
    Preset preset = two_discs();
    if (random_() % 2 == 0) preset.compare = {preset.method};
    session_.open(preset, {}, {}, {}, {});
  }
  void change() {
    const auto& bodies = session_.document().scene.bodies;
    Body body = bodies[random_() % bodies.size()];
    if (random_() % 2 == 0) {
      body.mass = *body.mass + 0.01;
    } else {
      body.position.y() += 0.001;
    }
    session_.edit({Replace<Body>{body}}, "change");
  }
  void compare() {
    MethodEdits& methods = session_.methods();
    const std::vector<Method>& others = session_.document().compare;
    Method method = session_.document().method;
    method.step *= 0.5;
    switch (random_() % 4) {
      case 0:
        return others.size() < 3 ? methods.add(method) : methods.remove(1);
      case 1:
        if (!others.empty()) methods.remove(1 + random_() % others.size());
        return;
      case 2:
        return methods.change_step(0.01 / static_cast<double>(1 + random_() % 4), {0}, 0);
      default:
        return methods.compare_usual({}, {});
    }
  }
  void wait() {
    QElapsedTimer clock;
    clock.start();
    const auto ms = static_cast<qint64>(random_() % 40);
    do {
      QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    } while (clock.elapsed() < ms);
  }

  std::mt19937 random_;
  Session session_;
};

TEST(SessionHasty, EachFrameThatIsShownHasItsRecord) {
  const unsigned seeds = static_cast<unsigned>(test::by_effort(5, 10, 200));
  for (unsigned seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(seed);
    Hasty hasty(seed);
    for (int i = 0; i < 300; ++i) {
      hasty.act();
      hasty.look();
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace carom
