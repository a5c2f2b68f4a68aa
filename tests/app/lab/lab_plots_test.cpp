#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_plot_curve.h>

#include "app/lab/drawer.h"
#include "app/lab/export_dialog.h"
#include "app/lab/lab_window.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/lab_fixture.h"
#include "tests/support/wait_events.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/reading_table.h"
#include "widgets/plot/run_plot.h"

namespace carom {
namespace {

class LabPlotsTest : public LabTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(show("bouncing-ball"));
    panel_ = window_.findChild<PlotPanel*>();
    height_.y = {{"y", {"ball"}}};
  }
  [[nodiscard]] static std::size_t points(const RunPlot* plot) {
    const QwtPlotItemList curves = plot->plot()->itemList(QwtPlotItem::Rtti_PlotCurve);
    return curves.isEmpty() ? 0 : static_cast<const QwtPlotCurve*>(curves.front())->dataSize();
  }
  // The points that a plot draws for its first curve.
  [[nodiscard]] const QwtPlotCurve& curve(const RunPlot* plot) const {
    return *static_cast<const QwtPlotCurve*>(plot->plot()->itemList(QwtPlotItem::Rtti_PlotCurve).front());
  }

  PlotPanel* panel_ = nullptr;
  Plot height_;
};

// A plot made during a run shows the run from its start; it is saved with the preset.
TEST_F(LabPlotsTest, APlotMadeLateIsWholeAndSaved) {
  window_.run_until(2.0);
  panel_->add(height_);
  EXPECT_TRUE(window_.isWindowModified());
  const RunPlot* plot = panel_->plots().back();
  ASSERT_TRUE(test::wait_in_event_loop([&] { return points(plot) > 100; }));
  EXPECT_EQ(curve(plot).sample(0).x(), 0.0);
  EXPECT_NEAR(curve(plot).sample(static_cast<int>(curve(plot).dataSize()) - 1).x(), 2.0, 0.006);
  window_.run_until(2.5);
  ASSERT_TRUE(test::wait_in_event_loop(
      [&] { return curve(plot).sample(static_cast<int>(curve(plot).dataSize()) - 1).x() > 2.49; }));

  QTemporaryDir dir;
  const std::string file = dir.filePath("mine.json").toStdString();
  save_preset(window_.preset(), file);
  EXPECT_EQ(read_preset(file).plots.back(), height_);
  ASSERT_TRUE(panel_->plots().size() > 1);
  panel_->remove(panel_->plots().back());
}

// No panel opens by itself.
TEST_F(LabPlotsTest, MarksAreReadWhereTheReadingIsOpen) {
  window_.run_until(1.0);
  const auto* table = window_.findChild<ReadingTable*>();
  ASSERT_NE(table, nullptr);
  EXPECT_FALSE(table->isVisible());
  QWidget* canvas = panel_->plots().front()->plot()->canvas();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, {canvas->width() / 3, 20});
  QTest::mouseClick(canvas, Qt::LeftButton, Qt::ShiftModifier, {canvas->width() / 2, 20});
  EXPECT_FALSE(table->isVisible());
  window_.findChild<Drawer*>()->choose(const_cast<ReadingTable*>(table));
  EXPECT_EQ(table->model()->index(1, 0).data().toString(), "Energy, kinetic / J");
  EXPECT_FALSE(table->model()->index(1, 3).data().toString().isEmpty());
}

// Through the dialogs, like a user.
TEST_F(LabPlotsTest, DataAreSavedFromTheWindow) {
  window_.run_until(1.0);
  QTemporaryDir dir;
  const QString file = dir.filePath("ball.csv");
  // Answers each dialog when it is open.
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, [&] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (auto* what = qobject_cast<ExportDialog*>(dialog)) {
      EXPECT_EQ(what->what(), ExportDialog::What::kPlot);
      what->accept();
    } else if (auto* where = qobject_cast<QFileDialog*>(dialog)) {
      where->setDirectory(dir.path());
      where->findChild<QLineEdit*>("fileNameEdit")->setText("ball.csv");
      QMetaObject::invokeMethod(where, "accept", Qt::QueuedConnection);
    }
  });
  answer.start(50);
  emit panel_->dataAsked(panel_->plots().front());
  ASSERT_TRUE(test::wait_in_event_loop([&] { return QFile::exists(file); }));
  answer.stop();
  QFile data(file);
  ASSERT_TRUE(data.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = data.readAll().trimmed().split('\n');
  EXPECT_EQ(lines.front(), "time [s],kinetic_energy [J],potential_energy [J],total_energy [J]");
  EXPECT_EQ(lines.size(), 1 + 201 + 2) << "the start, 200 steps, one impact";
}

// Notes are work; the choice of named plots beside a preset's own is not.
TEST_F(LabPlotsTest, NotesAreSavedWithThePreset) {
  ASSERT_TRUE(window_.open("spring-box"));
  panel_->set_shown("ledger", true);
  EXPECT_FALSE(window_.isWindowModified());
  RunPlot* energy = nullptr;
  for (RunPlot* plot : panel_->plots()) {
    if (plot->content().plot.id == "energy") energy = plot;
  }
  ASSERT_NE(energy, nullptr);
  energy->set_notes({{1.5, 12.0, "a swing and a half"}});
  emit panel_->layoutChanged();
  EXPECT_TRUE(window_.isWindowModified());
  QTemporaryDir dir;
  const std::string file = dir.filePath("mine.json").toStdString();
  save_preset(window_.preset(), file);
  const Preset saved = read_preset(file);
  EXPECT_EQ(saved.plots.size(), panel_->plots().size());
  bool found = false;
  for (const Plot& plot : saved.plots) {
    found = found ||
            (plot.id == "energy" && plot.notes == std::vector<PlotNote>{{1.5, 12.0, "a swing and a half"}});
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace carom
