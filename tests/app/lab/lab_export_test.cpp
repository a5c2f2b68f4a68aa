#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPointer>
#include <QProgressDialog>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <qwt_plot.h>
#include <utility>

#include "app/export/run_export.h"
#include "app/export/run_progress.h"
#include "app/lab/export_dialog.h"
#include "app/lab/film_dialog.h"
#include "app/lab/lab_window.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/lab_fixture.h"
#include "tests/support/wait.h"
#include "tests/support/wait_events.h"
#include "widgets/edit/inspected.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/run_plot.h"
#include "widgets/scene/scene_view.h"

namespace carom {
namespace {

// Exports of the window, through its menus and dialogs, like a user.
class LabExportTest : public LabTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(show("bouncing-ball"));
    panel_ = window_.findChild<PlotPanel*>();
    QGuiApplication::clipboard()->clear();
  }

  // Runs `what` and answers each dialog that opens, until there are no more and `done` holds.
  static void with_answers(const std::function<void(QWidget*)>& answer, const std::function<void()>& what,
                           const std::function<bool()>& done) {
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
      if (QWidget* dialog = QApplication::activeModalWidget(); dialog != nullptr) answer(dialog);
    });
    timer.start(50);
    what();
    EXPECT_TRUE(test::wait_until([&] {
      QApplication::processEvents();
      return QApplication::activeModalWidget() == nullptr && done();
    }));
  }
  void trigger(const QString& text) {
    for (QAction* action : window_.findChildren<QAction*>()) {
      if (action->text().remove('&') == text) return action->trigger();
    }
    ADD_FAILURE() << "no action " << text.toStdString();
  }
  // An entry of the first plot's context menu.
  void trigger_in_plot(std::size_t plot, const QString& text) {
    QApplication::processEvents();  // lays out a new plot
    QContextMenuEvent event(QContextMenuEvent::Mouse, panel_->plots()[plot]->geometry().center(),
                            panel_->mapToGlobal(panel_->plots()[plot]->geometry().center()));
    QApplication::sendEvent(panel_, &event);
    for (QMenu* menu : panel_->findChildren<QMenu*>()) {
      if (menu == panel_->menu() || !menu->isVisible()) continue;
      const QList<QAction*> actions = menu->actions();
      const auto found = std::find_if(actions.begin(), actions.end(),
                                      [&](const QAction* a) { return a->text().remove('&') == text; });
      ASSERT_NE(found, actions.end());
      const QPointer<QMenu> open(menu);
      (*found)->trigger();
      if (open) open->close();
      return;
    }
    FAIL() << "no menu";
  }
  [[nodiscard]] static QStringList clipboard_lines() {
    return QGuiApplication::clipboard()->text().trimmed().split('\n');
  }

  // As this file, which must not exist.
  void save_run_as(const QString& file) {
    const auto answer = [&](QWidget* dialog) {
      auto* where = qobject_cast<QFileDialog*>(dialog);
      if (where == nullptr) return;
      where->setDirectory(QFileInfo(file).path());
      where->findChild<QLineEdit*>("fileNameEdit")->setText(QFileInfo(file).fileName());
      QMetaObject::invokeMethod(where, "accept", Qt::QueuedConnection);
    };
    with_answers(
        answer, [&] { trigger("Save the run as it stands..."); }, [&] { return QFile::exists(file); });
  }

  PlotPanel* panel_ = nullptr;
};

TEST_F(LabExportTest, ThePictureOfTheSceneIsCopied) {
  window_.run_until(0.5);
  trigger("Copy the picture of the scene");
  const QImage copied = QGuiApplication::clipboard()->image();
  EXPECT_EQ(copied.size(), window_.scene_view().size() * 2);
  EXPECT_EQ(copied.convertToFormat(QImage::Format_RGB32), window_.scene_view().picture());
  window_.set_theme(dark_theme());
  EXPECT_GT(window_.scene_view().picture().pixelColor(3, 3).lightnessF(), 0.9F) << "on white";
}

// With tabs, units in the header and every digit; the whole run, or the visible part.
TEST_F(LabExportTest, ThePlotsDataAreCopied) {
  window_.run_until(1.0);
  trigger_in_plot(0, "Copy all the data");
  const QStringList all = clipboard_lines();
  EXPECT_EQ(all.front(), "time [s]\tkinetic_energy [J]\tpotential_energy [J]\ttotal_energy [J]");
  ASSERT_EQ(all.size(), 1 + 201 + 2) << "the start, 200 steps, before and after one impact";
  Simulation run(setup_of(window_.preset()));
  run.step();
  const QStringList second = all[2].split('\t');
  ASSERT_EQ(second.size(), 4);
  EXPECT_EQ(second[0].toDouble(), run.time());
  EXPECT_EQ(second[1].toDouble(), run.totals().kinetic());

  QTest::keyClick(panel_, Qt::Key_Home, Qt::ControlModifier);
  QWidget* canvas = panel_->plots().front()->plot()->canvas();
  QWheelEvent wheel({canvas->width() / 2.0, 20.0}, canvas->mapToGlobal(QPointF(canvas->width() / 2.0, 20.0)),
                    {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(canvas, &wheel);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return panel_->marks().from > 0.0; }));
  trigger_in_plot(0, "Copy the data that is shown");
  const QStringList shown = clipboard_lines();
  const ReadingMarks marks = panel_->marks();
  EXPECT_GT(marks.from, 0.0);
  EXPECT_GT(shown.size(), 20);
  EXPECT_LT(shown.size(), all.size());
  EXPECT_GE(shown[1].split('\t')[0].toDouble(), marks.from);
  EXPECT_TRUE(all.contains(shown[1]));
}

TEST_F(LabExportTest, TheImpactsOfAPlotAreCopied) {
  panel_->set_shown("impulse", true);
  window_.run_until(1.5);
  std::size_t impulses = 0;
  while (panel_->plots()[impulses]->content().plot.id != "impulse") ++impulses;
  trigger_in_plot(impulses, "Copy all the data");
  const QStringList lines = clipboard_lines();
  EXPECT_TRUE(lines.front().startsWith("time [s]\tbody_a\tbody_b\t")) << lines.front().toStdString();
  ASSERT_EQ(lines.size(), 1 + window_.frame()->impact_count);
  EXPECT_EQ(lines[1].split('\t').size(), 13);
}

// No table of a million rows: a message names the alternative.
TEST_F(LabExportTest, TooMuchForTheClipboardIsSaid) {
  window_.run_until(0.005 * static_cast<double>(kMostCopied + 10));
  QString said;
  with_answers(
      [&](QWidget* dialog) {
        if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
          said = box->text();
          box->accept();
        }
      },
      [&] { trigger_in_plot(0, "Copy all the data"); }, [&] { return !said.isEmpty(); });
  EXPECT_TRUE(said.contains("100000 rows")) << said.toStdString();
  EXPECT_TRUE(said.contains("Save the data"));
  EXPECT_EQ(QGuiApplication::clipboard()->text(), "");
}

// Frames as the window shows them: the last one equals the window's picture.
TEST_F(LabExportTest, AFilmIsMade) {
  // A film's frames have even sizes, so the compared picture must too.
  const auto odd = [this] {
    const QSize size = window_.scene_view().size();
    return QSize(size.width() % 2, size.height() % 2);
  };
  for (int i = 0; i < 8 && odd() != QSize(0, 0); ++i) {
    window_.resize(window_.size() + odd());
    QApplication::processEvents();
  }
  ASSERT_EQ(odd(), QSize(0, 0));
  window_.run_until(1.35);  // shortly after an impact, whose arrow is still visible
  const QImage shown = window_.scene_view().picture();
  EXPECT_FALSE(window_.scene_view().drawing().arrows.empty());
  QTemporaryDir dir;
  const QString folder = dir.filePath("ball");
  QString said;
  const auto answer = [&](QWidget* dialog) {
    if (auto* film = qobject_cast<FilmDialog*>(dialog)) {
      const QList<QDoubleSpinBox*> numbers = film->findChildren<QDoubleSpinBox*>();
      EXPECT_EQ(film->film().to, window_.frame()->time);
      numbers[0]->setValue(1.15);
      numbers[1]->setValue(1.35);
      numbers[2]->setValue(0.5);   // speed
      numbers[3]->setValue(20.0);  // frames a second
      const QList<QSpinBox*> pixels = film->findChildren<QSpinBox*>();
      pixels[0]->setValue(shown.width());
      pixels[1]->setValue(shown.height());
      film->findChild<QLineEdit*>("folder")->setText(folder);
      film->accept();
    } else if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
      said = box->text() + box->informativeText();
      box->accept();
    }
  };
  with_answers(
      answer, [&] { trigger("Film..."); }, [&] { return !said.isEmpty(); });
  EXPECT_TRUE(said.contains("9 frames")) << said.toStdString();
  EXPECT_TRUE(said.contains("ffmpeg -framerate 20")) << said.toStdString();
  const QStringList frames = frames_in(folder);
  ASSERT_EQ(frames.size(), 9);
  EXPECT_EQ(QImage(folder + "/" + frames.back()), shown);
  EXPECT_NE(QImage(folder + "/" + frames.front()), shown);
}

// The saved preset continues from there, and its restart returns there; a preset of "Save as" begins at the
// start.
TEST_F(LabExportTest, TheRunIsSavedAtItsPresentTime) {
  window_.run_until(1.0);
  const State shown = window_.frame()->state;
  const QTemporaryDir dir;
  const std::string file = dir.filePath("mid.json").toStdString();
  save_run_as(dir.filePath("mid.json"));
  const Preset saved = read_preset(file);
  ASSERT_TRUE(saved.saved && saved.saved->checkpoint);
  EXPECT_FALSE(window_.preset().saved);

  window_.run_until(1.5);
  const State later = window_.frame()->state;
  ASSERT_TRUE(window_.open(file));
  window_.run_until(1.5);
  EXPECT_LT((window_.frame()->state.q - later.q).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(window_.frame()->status, "ok");
  trigger("Restart");
  ASSERT_TRUE(test::wait_in_event_loop([&] { return window_.frame()->time < 1.2; }));
  EXPECT_NEAR(window_.frame()->time, 1.0, 0.01);
  EXPECT_EQ(window_.frame()->state.q, shown.q);
}

// At the end of a step, and within one: just before an impact.
TEST_F(LabExportTest, TheRunIsSavedAtTheShownMoment) {
  window_.run_until(1.0);
  const QTemporaryDir dir;
  LabRuns& runs = window_.session().runs();
  for (const bool at_impact : {false, true}) {
    SCOPED_TRACE(at_impact);
    if (at_impact) {
      runs.go_by_impact(false);
    } else {
      runs.go_to(0.9);
    }
    ASSERT_TRUE(test::wait_in_event_loop([&] { return runs.there(); }));
    const std::shared_ptr<const Frame> shown = window_.frame();
    ASSERT_LT(shown->time, 0.91);
    const QString file = dir.filePath(at_impact ? "impact.json" : "step.json");
    save_run_as(file);
    EXPECT_EQ(window_.frame(), shown) << "it is shown on";
    const Preset saved = read_preset(file.toStdString());
    EXPECT_EQ(saved.saved->time, shown->time);
    const Simulation again(setup_of(saved));
    EXPECT_EQ(again.state().q, shown->state.q);
    EXPECT_EQ(again.state().v, shown->state.v);
  }
}

// Before a body that a plot and a stop name had the name that it has now.
TEST_F(LabExportTest, TheRunIsSavedBeforeABodyWasRenamed) {
  window_.run_until(1.0);
  const Body body = window_.frame()->scene->bodies[1];
  Session& session = window_.session();
  Stop stop;
  stop.kind = StopKind::kPassing;
  stop.body = body.name;
  session.change_stops({stop}, "a stop");
  std::vector<Plot> plots = session.document().plots;
  plots.emplace_back().y = {{.observable = "x", .bodies = {body.name}}};
  session.change_plots(plots);
  const NamedEdits renamed = renaming(body, "another name");
  session.edit(renamed.edits, renamed.name);
  ASSERT_EQ(session.document().stops.front().body, "another name");
  session.runs().go_to(0.5);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session.runs().there(); }));
  const QTemporaryDir dir;
  save_run_as(dir.filePath("early.json"));
  const Preset saved = read_preset(dir.filePath("early.json").toStdString());
  EXPECT_EQ(saved.saved->time, 0.5);
  EXPECT_EQ(saved.scene.bodies[1].name, body.name);
  EXPECT_EQ(saved.stops.front().body, body.name);
  EXPECT_EQ(saved.plots.back().y.front().bodies, std::vector{body.name});
}

// A disc that was dropped into the run, before it had its name, and before it was there.
TEST_F(LabExportTest, TheRunIsSavedBeforeADroppedDiscWasRenamed) {
  window_.run_until(0.5);
  Session& session = window_.session();
  const std::string name = session.add_body(0.0, 3.0, 0.1);
  ASSERT_FALSE(name.empty());
  window_.run_until(1.0);
  std::vector<Plot> plots = session.document().plots;
  const std::size_t before = plots.size();
  plots.emplace_back().y = {{.observable = "x", .bodies = {name}}};
  session.change_plots(plots);
  const std::vector<Body>& bodies = window_.frame()->scene->bodies;
  const auto disc = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
  ASSERT_NE(disc, bodies.end());
  const NamedEdits renamed = renaming(*disc, "another name");
  session.edit(renamed.edits, renamed.name);
  ASSERT_EQ(session.document().plots.back().y.front().bodies.front(), "another name");
  const QTemporaryDir dir;
  const auto saved_at = [&](double time, const QString& file) {
    session.runs().go_to(time);
    EXPECT_TRUE(test::wait_in_event_loop([&] { return session.runs().there(); }));
    save_run_as(dir.filePath(file));
    return read_preset(dir.filePath(file).toStdString());
  };
  EXPECT_EQ(saved_at(0.75, "there.json").plots.back().y.front().bodies, std::vector{name});
  EXPECT_EQ(saved_at(0.25, "not_there.json").plots.size(), before);
}

TEST_F(LabExportTest, TheFilmDialogShowsNumberAndLengthOfFrames) {
  window_.run_until(0.1);
  Film film;
  film.runs.emplace_back();
  film.to = 2.0;
  film.look = window_.scene_view().look();
  QTemporaryDir dir;
  FilmDialog dialog(film, dir.path(), {}, &window_);
  const auto* summary = dialog.findChild<QLabel*>("summary");
  const auto* make = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
  EXPECT_TRUE(summary->text().contains("51 frames")) << summary->text().toStdString();
  const QList<QDoubleSpinBox*> numbers = dialog.findChildren<QDoubleSpinBox*>();
  numbers[2]->setValue(0.1);
  EXPECT_TRUE(summary->text().contains("501 frames, a film of 20.04 s; 250 frames in a second of the run"))
      << summary->text().toStdString();
  numbers[0]->setValue(3.0);
  EXPECT_TRUE(summary->text().contains("a time from the film's first moment"));
  EXPECT_FALSE(make->isEnabled());
  numbers[0]->setValue(1.0);
  EXPECT_TRUE(make->isEnabled());

  // Existing frames are replaced only if the user confirms it.
  QFile old(dir.filePath("frame-0001.png"));
  ASSERT_TRUE(old.open(QIODevice::WriteOnly));
  old.close();
  const auto press = [&](bool replace) {
    with_answers(
        [&](QWidget* widget) {
          auto* box = qobject_cast<QMessageBox*>(widget);
          ASSERT_NE(box, nullptr);
          for (QAbstractButton* button : box->buttons()) {
            if ((button->text() == "Replace") == replace) button->click();
          }
        },
        [&] { dialog.accept(); }, [&] { return QApplication::activeModalWidget() == nullptr; });
  };
  press(false);
  EXPECT_NE(dialog.result(), QDialog::Accepted);
  press(true);
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  EXPECT_TRUE(dialog.may_replace());
}

TEST_F(LabExportTest, AFilmIsOfThePartFromMarkToMark) {
  Film film;
  film.to = 2.0;
  film.look = window_.scene_view().look();
  const auto enabled = [](const FilmDialog& dialog) {
    return dialog.findChild<QComboBox*>("part")->model()->index(1, 0).flags().testFlag(Qt::ItemIsEnabled);
  };
  const FilmDialog without(film, "/films/ball", {}, &window_);
  EXPECT_FALSE(enabled(without));
  EXPECT_TRUE(without.findChild<QComboBox*>("part")->toolTip().contains("Ctrl+M"));
  const FilmDialog dialog(film, "/films/ball", std::pair(0.25, 0.75), &window_);
  EXPECT_TRUE(enabled(dialog));
  auto* part = dialog.findChild<QComboBox*>("part");
  EXPECT_EQ(part->itemText(1), "From A to B: 0.25 s to 0.75 s");
  part->setCurrentIndex(1);
  EXPECT_EQ(dialog.film().from, 0.25);
  EXPECT_EQ(dialog.film().to, 0.75);
  EXPECT_EQ(dialog.folder(), "/films/ball, 0.25 s to 0.75 s");
  part->setCurrentIndex(0);
  EXPECT_EQ(dialog.film().to, 2.0);
  EXPECT_EQ(dialog.folder(), "/films/ball");
}

TEST_F(LabExportTest, DataAreFromMarkToMark) {
  window_.run_until(1.0);
  panel_->set_mark(0.75, false);
  panel_->set_mark(0.25, true);
  QTemporaryDir dir;
  const QString file = dir.filePath("part.csv");
  QString suggested;
  with_answers(
      [&](QWidget* widget) {
        if (auto* what = qobject_cast<ExportDialog*>(widget)) {
          for (QRadioButton* button : what->findChildren<QRadioButton*>()) {
            if (button->text() == "From mark A to mark B: 0.25 s to 0.75 s") button->setChecked(true);
          }
          what->accept();
        } else if (auto* where = qobject_cast<QFileDialog*>(widget)) {
          if (suggested.isEmpty()) suggested = where->findChild<QLineEdit*>("fileNameEdit")->text();
          where->setDirectory(dir.path());
          where->findChild<QLineEdit*>("fileNameEdit")->setText("part.csv");
          QMetaObject::invokeMethod(where, "accept", Qt::QueuedConnection);
        }
      },
      [&] { emit panel_->dataAsked(panel_->plots().front()); }, [&] { return QFile::exists(file); });
  EXPECT_EQ(suggested, "run, 0.25 s to 0.75 s.csv");
  QFile data(file);
  ASSERT_TRUE(data.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = data.readAll().trimmed().split('\n');
  EXPECT_NEAR(lines[1].split(',').front().toDouble(), 0.25, 1e-9);
  EXPECT_NEAR(lines.back().split(',').front().toDouble(), 0.75, 1e-9);
}

// Long work runs beside the window: a dialog shows its progress, and Cancel leaves nothing behind.
TEST_F(LabExportTest, WhatTakesLongIsCancelled) {
  window_.run_until(500.0);
  QTemporaryDir dir;
  bool cancel = true;
  int cancelled = 0;
  const auto answer = [&](QWidget* dialog) {
    if (auto* what = qobject_cast<ExportDialog*>(dialog)) {
      what->accept();
    } else if (auto* where = qobject_cast<QFileDialog*>(dialog)) {
      where->setDirectory(dir.path());
      where->findChild<QLineEdit*>("fileNameEdit")->setText("run.csv");
      QMetaObject::invokeMethod(where, "accept", Qt::QueuedConnection);
    } else if (auto* progress = qobject_cast<QProgressDialog*>(dialog); progress != nullptr && cancel) {
      ++cancelled;
      progress->cancel();
    }
  };
  with_answers(
      answer, [&] { trigger("Save data..."); }, [&] { return cancelled > 0; });
  EXPECT_TRUE(QDir(dir.path()).isEmpty());
  cancel = false;
  with_answers(
      answer, [&] { trigger("Save data..."); }, [&] { return QFile::exists(dir.filePath("run.csv")); });
}

// Closing the window ends open questions and work.
TEST(LabWindowGoes, WhileItAsksOrWorks) {
  for (const char* text : {"Open...", "Save as...", "Film...", "Save data...", "About Carom", "Another..."}) {
    auto window = std::make_unique<LabWindow>(light_theme());
    window->show();
    ASSERT_TRUE(window->open("bouncing-ball"));
    window->run_until(1.0);
    for (QAction* action : window->findChildren<QAction*>()) {
      if (action->text().remove('&') == text) action->trigger();
    }
    QApplication::processEvents();
    window.reset();
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << text;
  }
  auto window = std::make_unique<QWidget>();
  window->show();
  bool left = false;
  bool after = false;
  with_progress(
      window.get(), "Work", "Failed",
      [&](const Progress& go_on) { left = test::wait_until([&] { return !go_on(0.5); }); },
      [&] { after = true; });
  EXPECT_NE(QApplication::activeModalWidget(), nullptr);
  window.reset();
  EXPECT_TRUE(left);
  EXPECT_FALSE(after);
}

}  // namespace
}  // namespace carom
