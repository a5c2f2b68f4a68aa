#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextDocument>
#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_plot_marker.h>
#include <qwt_text.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "app/lab/lab_window.h"
#include "app/library/preset_library.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/support/wait_events.h"

// A malicious preset: every text in it is HTML that shows a picture from this machine.
namespace carom {
namespace {

class LabPlainText : public testing::Test {
 protected:
  LabPlainText() {
    picture_ = folder_.filePath("picture.png");
    QImage(4, 4, QImage::Format_RGB32).save(picture_);
    watch_ = inotify_init1(IN_NONBLOCK);
    inotify_add_watch(watch_, picture_.toUtf8().constData(), IN_OPEN);
    html_ = "<img src=\"" + picture_.toStdString() + "\"><b>x</b>";
    Preset preset = read_preset(find_preset("head-on"));
    preset.title = preset.about = preset.observe = html_;
    for (std::size_t i = 0; i < preset.scene.bodies.size(); ++i)
      preset.scene.bodies[i].name = html_ + std::to_string(i);
    preset.expect.clear();
    Plot plot;
    plot.title = html_;
    plot.y = {{.observable = "speed", .bodies = {preset.scene.bodies[0].name}},
              {.observable = "speed", .bodies = {preset.scene.bodies[1].name}}};
    plot.notes = {{0.0, 0.0, html_}};
    Plot untitled = plot;
    untitled.title.clear();
    Plot over = untitled;
    over.x = plot.y[0];
    over.y.pop_back();
    preset.plots = {plot, untitled, over};
    QDir(folder_.path()).mkpath("presets/<b>topic");
    file_ = folder_.filePath("presets/<b>topic/<img src=a>.json");
    save_preset(preset, file_.toStdString());
    qputenv("CAROM_PRESETS", folder_.filePath("presets").toUtf8());
  }
  ~LabPlainText() override {
    qunsetenv("CAROM_PRESETS");
    close(watch_);
  }

  [[nodiscard]] bool picture_opened() const {
    char events[512];
    return read(watch_, events, sizeof events) > 0;
  }

  static void expect_plain(const QString& text, const char* where) {
    // A tooltip may be our own HTML with the text escaped.
    EXPECT_FALSE(Qt::mightBeRichText(text) && text.contains("<img")) << where << ": " << text.toStdString();
  }
  static void expect_plain(const QwtText& text, const char* where) {
    QwtText plain = text;
    plain.setText(text.text(), QwtText::PlainText);
    if (!(text == plain)) expect_plain(text.text(), where);
  }
  // Checks `top` and all widgets in it. Returns their number.
  static int look_at(QWidget* top) {
    (void)top->grab();
    int count = 1;
    QList<QWidget*> all = top->findChildren<QWidget*>();
    all << top;
    for (QWidget* widget : all) {
      ++count;
      expect_plain(widget->toolTip(), "tooltip");
      expect_plain(widget->statusTip(), "status tip");
      expect_plain(widget->whatsThis(), "what's this");
      if (const auto* label = qobject_cast<QLabel*>(widget);
          label != nullptr && label->textFormat() != Qt::PlainText)
        expect_plain(label->text(), "label");
      if (const auto* view = qobject_cast<QAbstractItemView*>(widget);
          view != nullptr && view->model() != nullptr) {
        for (int row = 0; row < view->model()->rowCount(); ++row) {
          for (int column = 0; column < view->model()->columnCount(); ++column)
            expect_plain(view->model()->index(row, column).data(Qt::ToolTipRole).toString(), "item");
        }
      }
      if (const auto* plot = qobject_cast<QwtPlot*>(widget)) {
        expect_plain(plot->title(), "plot");
        for (int axis = 0; axis < QwtAxis::AxisPositions; ++axis) expect_plain(plot->axisTitle(axis), "axis");
        for (const QwtPlotItem* item : plot->itemList()) {
          expect_plain(item->title(), "curve");
          if (const auto* marker = dynamic_cast<const QwtPlotMarker*>(item))
            expect_plain(marker->label(), "marker");
        }
      }
    }
    for (const QAction* action : top->findChildren<QAction*>()) expect_plain(action->toolTip(), "action");
    return count;
  }
  // Runs an action, checks the dialog that opens, and closes it.
  template <class Ask>
  int look_at_dialog(const Ask& ask) {
    int seen = 0;
    QTimer looking;
    QObject::connect(&looking, &QTimer::timeout, [&] {
      QWidget* dialog = QApplication::activeModalWidget();
      if (dialog == nullptr) return;
      seen += look_at(dialog);
      dialog->close();
    });
    looking.start(10);
    ask();
    EXPECT_TRUE(test::wait_in_event_loop([&] { return seen > 0; }));
    return seen;
  }

  QTemporaryDir folder_;
  QString picture_, file_;
  std::string html_;
  int watch_ = -1;
};

TEST_F(LabPlainText, NothingInTheWindowIsHtml) {
  LabWindow window(light_theme());
  window.resize(1400, 900);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  ASSERT_TRUE(window.open(file_.toStdString()));
  window.run_until(1.0);
  auto* tabs = window.findChild<QTabWidget*>();
  for (int i = 0; i < tabs->count(); ++i) {
    tabs->setCurrentIndex(i);
    QCoreApplication::processEvents();
    EXPECT_GT(look_at(&window), 100);
  }
  QAction* compare = nullptr;
  for (QAction* action : window.findChildren<QAction*>()) {
    if (action->shortcut() == QKeySequence(Qt::Key_C)) compare = action;
  }
  ASSERT_NE(compare, nullptr);
  compare->trigger();
  window.run_until(1.0);
  look_at(&window);
  EXPECT_FALSE(picture_opened());
}

TEST_F(LabPlainText, NothingInItsDialogsIsHtml) {
  LabWindow window(dark_theme());
  window.show();
  ASSERT_TRUE(window.open(file_.toStdString()));
  window.run_until(0.5);
  int dialogs = 0;
  for (const QString text : {"&New plot...", "&Lab report...", "&Film...", "Save &data...", "&About Carom"}) {
    for (QAction* action : window.findChildren<QAction*>()) {
      if (action->text() != text) continue;
      EXPECT_GT(look_at_dialog([&] { action->trigger(); }), 3) << text.toStdString();
      ++dialogs;
      break;  // others may be deleted by now
    }
  }
  EXPECT_EQ(dialogs, 5);
  // The message quotes a file that cannot be opened.
  QFile bad(folder_.filePath("<img src=a>bad.json"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write(("{\"" + html_ + "\": 1}").c_str());
  bad.close();
  look_at_dialog([&] { EXPECT_FALSE(window.open(bad.fileName().toStdString())); });
  EXPECT_FALSE(picture_opened());
}

}  // namespace
}  // namespace carom
