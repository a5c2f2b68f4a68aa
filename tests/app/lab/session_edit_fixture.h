#pragma once

#include <gtest/gtest.h>
#include <string>

#include "physics/preset/preset_file.h"
#include "tests/app/lab/session_fixture.h"
#include "tests/app/lab/two_discs.h"

namespace carom {

// A session whose scene is edited, at the start and on the way.
class SessionEditTest : public SessionFixture {
 protected:
  SessionEditTest() {
    QObject::connect(&session_.history(), &EditHistory::editRefused,
                     [this](const QString& why) { refused_ = why; });
    QObject::connect(&session_.history(), &EditHistory::editSaid,
                     [this](const QString& sentence) { said_ = sentence; });
    open(two_discs());
  }
  void open(const Preset& preset) {
    session_.open(preset, preset.plots, {}, {}, {});
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
  [[nodiscard]] std::string document() const { return write_preset(session_.document()); }

  QString refused_;
  QString said_;
};

}  // namespace carom
