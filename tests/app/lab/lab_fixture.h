#pragma once

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/lab/lab_window.h"
#include "tests/support/wait_events.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/run/experiment_list.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_view.h"

namespace carom {

// The window, used with real mouse and key events.
class LabTest : public testing::Test {
 protected:
  // On the screen, with an experiment if there is a name.
  void show(const std::string& experiment, const QSize& size = {1280, 800}) {
    window_.resize(size);
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
    if (!experiment.empty()) {
      ASSERT_TRUE(window_.open(experiment));
    }
  }

  QTemporaryDir folder_;
  LabWindow window_{light_theme()};
};

// A window with the experiment head-on, whose parts are found by what they say.
class LabWindowTest : public LabTest {
 protected:
  void SetUp() override {
    // Every question is answered at once, so that no test can hang.
    QObject::connect(&answering_, &QTimer::timeout, [this] { answer(); });
    answering_.start(10);
    ASSERT_NO_FATAL_FAILURE(show("head-on"));
    ASSERT_TRUE(wait_for([this] { return window_.frame()->bodies->size() == 2; }));
    window_.scene_view().setFocus();
  }

  // Waits until this number of questions were asked and answered in all.
  [[nodiscard]] bool wait_for_boxes(std::size_t count) {
    return test::wait_in_event_loop(
        [&] { return boxes_.size() >= count && QApplication::activeModalWidget() == nullptr; });
  }
  // Waits for a frame with `fulfilled`; returns false if that takes too long.
  template <class Condition>
  bool wait_for(const Condition& fulfilled) {
    return test::wait_in_event_loop([&] { return window_.frame() != nullptr && fulfilled(); });
  }
  [[nodiscard]] double time() const { return window_.frame()->time; }
  [[nodiscard]] std::int64_t steps() const { return window_.frame()->steps; }

  QAction* action(const QString& text) {
    for (QAction* a : window_.findChildren<QAction*>()) {
      if (a->text().remove('&') == text) return a;
    }
    ADD_FAILURE() << "no action " << text.toStdString();
    return nullptr;
  }
  void choose_speed(double speed) { action(TransportBar::speed_text(speed))->trigger(); }
  QToolButton* button(const QString& tip) {
    for (QToolButton* b : window_.findChildren<QToolButton*>()) {
      if (b->toolTip().startsWith(tip)) return b;
    }
    throw std::runtime_error("no button " + tip.toStdString());
  }
  void click_button(const QString& tip) { QTest::mouseClick(button(tip), Qt::LeftButton); }
  QLabel* chip(const QString& name) {
    for (QLabel* label : window_.findChildren<QLabel*>("chip")) {
      if (label->accessibleName() == name) return label;
    }
    throw std::runtime_error("no chip " + name.toStdString());
  }
  QAction* plot_action(const QString& title) {
    for (QAction* a : window_.findChild<PlotPanel*>()->menu()->actions()) {
      if (a->text() == title) return a;
    }
    throw std::runtime_error("no plot " + title.toStdString());
  }
  // The text of the tab "About".
  [[nodiscard]] QString about() const {
    QString text;
    for (const QLabel* label : window_.findChildren<QLabel*>()) {
      if (label->text().contains("Not needed by this scene")) text = label->text();
    }
    return text;
  }
  // With the disc tool.
  void click_scene(const Vec2& world) {
    window_.scene_view().set_tool(SceneTool::kDisc);
    const QPoint at = window_.scene_view().camera().to_screen(world).toPoint();
    ASSERT_TRUE(window_.scene_view().rect().contains(at));
    QTest::mouseClick(&window_.scene_view(), Qt::LeftButton, {}, at);
  }
  QListWidget* list() { return window_.findChild<ExperimentList*>()->findChild<QListWidget*>(); }
  void click_experiment(const QString& name) {
    for (int row = 0; row < list()->count(); ++row) {
      QListWidgetItem* item = list()->item(row);
      if (item->data(Qt::UserRole).toString() != name) continue;
      list()->scrollToItem(item);
      QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualItemRect(item).center());
      return;
    }
    ADD_FAILURE() << "no experiment " << name.toStdString();
  }
  [[nodiscard]] QString marked_experiment() {
    const QListWidgetItem* item = list()->currentItem();
    return item == nullptr ? QString() : item->data(Qt::UserRole).toString();
  }

  std::vector<QString> boxes_;                                // texts of the message boxes so far
  QMessageBox::StandardButton button_ = QMessageBox::Cancel;  // pressed in them
  QString offer_;                                             // pressed instead, where there is one
  QString chosen_file_;                                       // in a file dialog

 private:
  void answer() {
    QWidget* asking = QApplication::activeModalWidget();
    if (auto* box = qobject_cast<QMessageBox*>(asking)) {
      boxes_.push_back(box->text() + "\n" + box->informativeText());
      for (QAbstractButton* button : box->buttons()) {
        if (!offer_.isEmpty() && button->text() == offer_) return button->click();
      }
      QAbstractButton* button = box->button(button_);
      if (button != nullptr) {
        button->click();
      } else {
        box->reject();
      }
    } else if (auto* dialog = qobject_cast<QFileDialog*>(asking)) {
      if (chosen_file_.isEmpty()) return dialog->reject();
      const QString file = std::exchange(chosen_file_, {});
      dialog->setDirectory(QFileInfo(file).path());
      auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
      name->setText(QFileInfo(file).fileName());
      // Deferred: a question of the dialog would wait for the end of this timer event.
      QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
    } else if (asking != nullptr) {
      asking->close();
    }
  }
  QTimer answering_;
};

}  // namespace carom
