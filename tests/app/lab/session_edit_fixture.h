#pragma once

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "app/lab/session.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/two_discs.h"
#include "tests/support/wait_events.h"

namespace carom {

// A session whose scene is edited, at the start and on the way.
class SessionEditTest : public testing::Test {
 protected:
  SessionEditTest() {
    QObject::connect(&session_, &Session::editRefused, [this](const QString& why) { refused_ = why; });
    open(two_discs());
  }
  void open(const Preset& preset) {
    session_.open(preset, preset.plots, {}, {}, {});
    settle();
  }
  // Waits until the runs have done all that was asked for before: a curve that is asked for now comes last.
  void settle() {
    const Curve curve{{find_observable(settled_++ % 2 == 0 ? "kinetic_energy" : "total_energy"), {}}, {}};
    session_.runs().record(always_);
    std::vector<Curve> curves = always_;
    curves.push_back(curve);
    session_.runs().record(curves);
    ASSERT_TRUE(test::wait_in_event_loop([&] {
      const auto frame = session_.runs().frame();
      return frame && frame->scene && !session_.runs().replayed() &&
             session_.runs().recorders()[0]->series(curve) != nullptr && frame->rows_known_until >= frame->time;
    }));
  }
  void run_to(double time) {
    session_.runs().run_until(time);
    settle();
  }
  [[nodiscard]] Body now(const std::string& name) const {
    for (const Body& body : session_.runs().frame()->scene->bodies) {
      if (body.name == name) return body;
    }
    ADD_FAILURE() << "no body " << name;
    return {};
  }
  [[nodiscard]] const Body& start(std::size_t i) const { return session_.document().scene.bodies.at(i); }
  void edit(const SceneEdit& edit, const char* text = "change", int drag = 0) {
    session_.edit({edit}, text, drag);
    settle();
  }
  void undo() {
    session_.edits().undo();
    settle();
  }
  void redo() {
    session_.edits().redo();
    settle();
  }
  [[nodiscard]] std::string document() const { return write_preset(session_.document()); }

  Session session_;
  QString refused_;
  std::vector<Curve> always_;  // recorded all the time

 private:
  int settled_ = 0;
};

}  // namespace carom
