#include "tests/app/lab/killed_starts.h"

#include <cstdio>

#include "app/lab/lab_window.h"
#include "tests/support/wait_events.h"

namespace carom {

int keep_starts(const QString& folder) {
  LabWindow window(light_theme());
  window.show();
  window.keep_work(folder);
  Session& session = window.session();
  if (!window.open("head-on") || !test::wait_in_event_loop([&] { return window.frame() != nullptr; })) return 1;
  for (int i = 1;; ++i) {
    window.run_until(0.01 * i);
    Body body = session.runs().scene()->bodies[0];
    body.position.y() += 0.001;
    session.edit({Replace<Body>{body}}, QString("Move %1").arg(i));
    if (!test::wait_in_event_loop([&] { return window.frame()->time == 0.0; })) return 1;
    window.keep_now();
    std::puts("kept");
    std::fflush(stdout);
  }
}

}  // namespace carom
