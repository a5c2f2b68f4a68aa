#pragma once

#include <QApplication>
#include <gtest/gtest.h>
#include <memory>

#include "physics/record/frame.h"
#include "physics/record/recorder.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/theme/theme.h"

namespace carom {

// A panel of plots, and the record that it shows.
class PlotPanelFixture : public testing::Test {
 protected:
  void show(const Frame& frame) {
    recorder->add(frame);
    panel.resize(400, 560);
    panel.show();
    QApplication::processEvents();
    panel.update_from({{recorder, "run"}});
    panel.show_now();
    QApplication::processEvents();
  }

  std::shared_ptr<Recorder> recorder = std::make_shared<Recorder>();
  PlotPanel panel{light_theme()};
};

}  // namespace carom
