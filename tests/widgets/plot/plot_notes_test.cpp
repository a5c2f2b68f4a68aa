#include "widgets/plot/plot_notes.h"

#include <QAction>
#include <QApplication>
#include <QImage>
#include <QInputDialog>
#include <QMenu>
#include <QTemporaryDir>
#include <QTimer>
#include <gtest/gtest.h>
#include <qwt_plot.h>

#include "physics/preset/preset.h"
#include "tests/support/run_fixture.h"
#include "widgets/plot/note_menu.h"
#include "widgets/plot/plot_export.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"

namespace carom {
namespace {

class PlotNotesTest : public testing::Test {
 protected:
  PlotNotesTest() {
    Plot energy = named("energy");
    energy.notes = {{0.5, 2.0, "half a second"}};
    panel.set_plots({energy}, preset.scene.bodies);
    recorder->add(run_to(preset, 1.0, panel.curves()));
    panel.resize(600, 300);
    panel.show();
    show();
  }
  void show() {
    panel.update_from({{recorder, "run"}});
    QApplication::processEvents();
  }
  [[nodiscard]] RunPlot* plot() const { return panel.plots()[0]; }
  [[nodiscard]] QPoint pixel(double x, double y) const {
    return {qRound(plot()->plot()->transform(QwtAxis::XBottom, x)),
            qRound(plot()->plot()->transform(QwtAxis::YLeft, y))};
  }
  // Chooses the entry with this beginning, and answers its question.
  void choose(const QPoint& at, const QString& entry, const QString& answer) {
    QMenu menu;
    add_note_entries(menu, *plot(), at, &panel, [this] { ++changes; });
    QTimer::singleShot(0, [&] {
      if (auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget()); dialog != nullptr) {
        dialog->setTextValue(answer);
        dialog->accept();
      }
    });
    for (QAction* action : menu.actions()) {
      if (action->text().remove('&').startsWith(entry)) action->trigger();
    }
    QApplication::processEvents();
  }

  Preset preset = head_on_scene();
  std::shared_ptr<Recorder> recorder = std::make_shared<Recorder>();
  PlotPanel panel{light_theme()};
  int changes = 0;
};

TEST_F(PlotNotesTest, OfANamedPlotIsShownAndKept) {
  EXPECT_EQ(panel.chosen()[0].notes, (std::vector<PlotNote>{{0.5, 2.0, "half a second"}}));
  EXPECT_EQ(plot()->note_at(pixel(0.5, 2.0)), std::optional<std::size_t>(0));
  EXPECT_EQ(plot()->note_at(pixel(0.5, 2.0) + QPoint(20, -12)), std::optional<std::size_t>(0));  // its words
  EXPECT_EQ(plot()->note_at(pixel(0.2, 1.0)), std::nullopt);
  // A note out of view cannot be hit.
  emit plot()->boxAsked(QRectF(QPointF(0.6, 0.0), QPointF(0.9, 5.0)));
  QApplication::processEvents();
  EXPECT_EQ(plot()->note_at(pixel(0.5, 2.0)), std::nullopt);
}

TEST_F(PlotNotesTest, IsPutChangedAndRemovedByTheMenu) {
  const QPoint at = pixel(0.25, 1.0);
  choose(at, "Note here", "here");
  ASSERT_EQ(panel.chosen()[0].notes.size(), 2u);
  EXPECT_EQ(panel.chosen()[0].notes[1].text, "here");
  EXPECT_NEAR(panel.chosen()[0].notes[1].x, 0.25, 0.01);
  EXPECT_NEAR(panel.chosen()[0].notes[1].y, 1.0, 0.1);
  choose(at, "Change this note", "there");
  EXPECT_EQ(panel.chosen()[0].notes[1].text, "there");
  choose(at, "Change this note", "  ");  // empty text: unchanged
  EXPECT_EQ(panel.chosen()[0].notes[1].text, "there");
  choose(at, "Remove this note", {});
  EXPECT_EQ(panel.chosen()[0].notes.size(), 1u);
  EXPECT_EQ(changes, 3);
}

TEST_F(PlotNotesTest, IsInPictures) {
  const QImage with = plot_picture(*plot()).toImage();
  plot()->set_notes({});
  EXPECT_NE(plot_picture(*plot()).toImage(), with);
  QTemporaryDir dir;
  plot()->set_notes({{0.5, 2.0, "words of mine"}});
  for (const char* name : {"a.pdf", "a.svg"}) {
    QString error;
    EXPECT_TRUE(save_plot_picture(*plot(), dir.filePath(name), &error)) << error.toStdString();
  }
  QFile file(dir.filePath("a.svg"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains("words of mine"));
}

// At every edge the text stays within the plot.
TEST_F(PlotNotesTest, WordsStayWithinThePlot) {
  for (const double x : {0.001, 0.5, 0.999}) {
    for (const double share : {0.02, 0.5, 0.98}) {
      const QwtInterval values = plot()->value_range();
      const double y = values.minValue() + share * values.width();
      plot()->set_notes({{x, y, "some longer words that take some room in the plot, more than a line of it"}});
      panel.repaint();
      const QRect canvas = plot()->plot()->canvas()->rect();
      int met = 0;
      for (int i = 0; i < canvas.width(); i += 4) {
        for (int j = 0; j < canvas.height(); j += 4) met += plot()->note_at(QPointF(i, j)).has_value() ? 1 : 0;
      }
      EXPECT_GT(met, 150) << x << ' ' << share;  // some 4000 px² of words
    }
  }
}

}  // namespace
}  // namespace carom
