#include "tests/app/lab/late_discs.h"

#include <QApplication>
#include <cstdio>
#include <gtest/gtest.h>

#include "app/lab/lab_window.h"
#include "app/library/preset_library.h"
#include "physics/preset/preset_file.h"
#include "tests/support/wait_events.h"

namespace carom {

Preset late_discs_preset() {
  Preset preset = read_preset(find_preset("bouncing-ball"));
  preset.compare = {{.integrator = IntegratorId::kExplicitEuler, .step = 0.013}};
  return preset;
}

void add_late_discs(Session& session) {
  session.runs().run_until(0.7);
  session.add_body(0.05, 1.5);
  session.runs().run_until(1.2);
  session.add_body(-0.05, 1.8);
  session.runs().run_until(kLateDiscsEnd);
  wait_for_late_discs(session);
}

void wait_for_late_discs(const Session& session, std::size_t edits) {
  const LabRuns& runs = session.runs();
  const auto is_there = [&](const auto& frame) {
    return frame->setup->edits.size() == edits && frame->time + frame->method.step > kLateDiscsEnd &&
           !frame->playing;
  };
  EXPECT_TRUE(test::wait_in_event_loop([&] {
    return runs.frames().size() == 2 && !runs.replayed() &&
           std::all_of(runs.frames().begin(), runs.frames().end(), is_there);
  }));
}

int keep_late_discs(const QString& folder) {
  LabWindow window(light_theme());
  window.show();
  window.keep_work(folder);
  window.show_scene(late_discs_preset(), {}, {});
  add_late_discs(window.session());
  window.keep_now();
  std::puts("kept");
  std::fflush(stdout);
  window.session().runs().play_on();
  return QApplication::exec();
}

}  // namespace carom
