#include "widgets/plot/plot_export.h"

#include <QApplication>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "tests/support/run_fixture.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/plot_render.h"

namespace carom {
namespace {

class PlotExportTest : public testing::Test {
 protected:
  void SetUp() override {
    recorder->add(run_to(head_on_scene(), 1.0, panel.curves()));
    panel.resize(400, 560);
    panel.show();
    panel.update_from({{recorder, "run"}});
    panel.show_now();
    QApplication::processEvents();
  }
  [[nodiscard]] RunPlot& plot() { return *panel.plots().front(); }

  std::shared_ptr<Recorder> recorder = std::make_shared<Recorder>();
  PlotPanel panel{dark_theme()};
};

TEST_F(PlotExportTest, PicturesAreWhole) {
  QTemporaryDir dir;
  for (const char* suffix : {"png", "svg", "pdf"}) {
    QString error;
    const QString file = dir.filePath(QString("plot.") + suffix);
    EXPECT_TRUE(save_plot_picture(plot(), file, &error)) << error.toStdString();
    EXPECT_GT(QFileInfo(file).size(), 2000);
  }
  const QImage picture(dir.filePath("plot.png"));
  ASSERT_FALSE(picture.isNull());
  EXPECT_EQ(picture.pixelColor(2, 2), QColor(Qt::white));
  EXPECT_FALSE(plot_picture(plot()).isNull());
  EXPECT_TRUE(plot().theme().dark) << "the window keeps its colours";
  QString error;
  EXPECT_FALSE(save_plot_picture(plot(), dir.filePath("no/plot.png"), &error));
  EXPECT_FALSE(error.isEmpty());
}

// The line under the mouse is not part of the exported plot.
TEST_F(PlotExportTest, TheCursorStaysOut) {
  const QImage without = plot_picture(plot()).toImage();
  plot().set_cursor(0.5);
  EXPECT_EQ(plot_picture(plot()).toImage(), without);
}

// On a device with many dots an inch, such as a PDF, text has its size in px: a tenth of the area is ink, not
// all.
TEST_F(PlotExportTest, TextFitsWhateverTheResolution) {
  plot().set_theme(light_theme());
  const auto ink = [&](int dots) {
    QImage image(QSize(400, 200) * dots, QImage::Format_RGB32);
    image.setDotsPerMeterX(static_cast<int>(96 * dots / 0.0254));
    image.setDotsPerMeterY(static_cast<int>(96 * dots / 0.0254));
    image.fill(Qt::white);
    {
      QPainter painter(&image);
      painter.scale(dots, dots);
      render_plot(*plot().plot(), painter, QRectF(0, 0, 400, 200));
    }
    int dark = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) dark += image.pixelColor(x, y).lightness() < 200 ? 1 : 0;
    }
    return static_cast<double>(dark) / (image.width() * image.height());
  };
  const double coarse = ink(1);
  EXPECT_GT(coarse, 0.005);
  EXPECT_LT(coarse, 0.1);
  EXPECT_NEAR(ink(6), coarse, 0.3 * coarse);
}

}  // namespace
}  // namespace carom
