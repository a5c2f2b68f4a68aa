#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <gtest/gtest.h>
#include <memory>

#include "widgets/edit/inspector.h"

namespace carom {

inline Body wooden_body(const char* name, double mass, double x) {
  Body b;
  b.name = name;
  b.mass = mass;
  b.position = Vec2(x, 0.0);
  b.velocity = Vec2(2.0, 0.0);
  b.material = "wood";
  return b;
}

// An inspector and, as a document does, the scene that its edits change.
class InspectorTest : public testing::Test {
 protected:
  struct Edit {
    SceneEdits edits;
    QString name;
    int drag;
  };

  InspectorTest() {
    Scene scene;
    Material wood;
    wood.name = "wood";
    wood.restitution = 0.6;
    Material rubber;
    rubber.name = "rubber";
    scene.materials = {wood, rubber};
    scene.bodies = {wooden_body("light", 1.0, -1.0), wooden_body("heavy", 2.5, 1.0)};
    Joint rod;
    rod.body = "light";
    rod.to = "heavy";
    scene.joints = {rod};
    scene.forces.gravity = Vec2(0.0, -9.81);
    give_ids(scene);
    scene_ = std::make_shared<const Scene>(scene);
    QObject::connect(&inspector_, &Inspector::edited, &inspector_,
                     [this](const SceneEdits& edits, const QString& name, int drag) {
                       made_.push_back({edits, name, drag});
                       apply(edits);
                       inspector_.show_selection(scene_, names_);
                     });
    inspector_.resize(320, 700);
    inspector_.show();
    inspector_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&inspector_));
  }

  void apply(const SceneEdits& edits) {
    Scene scene = *scene_;
    apply_edits(scene, edits);
    scene_ = std::make_shared<const Scene>(scene);
  }
  void select(const std::vector<std::string>& names) {
    names_ = names;
    inspector_.show_selection(scene_, names_);
  }
  QLineEdit* field(const QString& name) {
    for (QLineEdit* line : inspector_.findChildren<QLineEdit*>()) {
      if (line->accessibleName() == name && line->isVisibleTo(&inspector_)) return line;
    }
    ADD_FAILURE() << "no field " << name.toStdString();
    return nullptr;
  }
  // The first of this text.
  QLabel* label(const QString& text) {
    for (QLabel* shown : inspector_.findChildren<QLabel*>()) {
      if (shown->text() == text) return shown;
    }
    ADD_FAILURE() << "no label " << text.toStdString();
    return nullptr;
  }
  bool has_field(const QString& name) {
    for (QLineEdit* line : inspector_.findChildren<QLineEdit*>()) {
      if (line->accessibleName() == name && line->isVisibleTo(&inspector_)) return true;
    }
    return false;
  }
  static void type(QLineEdit* line, const QString& text) {
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
  }
  static void enter(QLineEdit* line, const QString& text) {
    type(line, text);
    QTest::keyClick(line, Qt::Key_Return);
  }
  // The sentences that can be read.
  QStringList sentences() {
    QStringList texts;
    for (const QLabel* label : inspector_.findChildren<QLabel*>("fault")) {
      if (label->isVisibleTo(&inspector_)) texts << label->text();
    }
    return texts;
  }
  QStringList texts() {
    QStringList shown;
    for (const QLabel* label : inspector_.findChildren<QLabel*>()) {
      if (label->isVisibleTo(&inspector_)) shown << label->text();
    }
    return shown;
  }
  QPushButton* button(const QString& text) {
    for (QPushButton* each : inspector_.findChildren<QPushButton*>()) {
      const bool has_name = each->text() == text || each->accessibleName() == text;
      if (has_name && each->isVisibleTo(&inspector_)) return each;
    }
    ADD_FAILURE() << "no button " << text.toStdString();
    return nullptr;
  }
  QComboBox* box(const QString& name) {
    for (QComboBox* each : inspector_.findChildren<QComboBox*>()) {
      if (each->accessibleName() == name && each->isVisibleTo(&inspector_)) return each;
    }
    ADD_FAILURE() << "no choice " << name.toStdString();
    return nullptr;
  }
  // As many words further down.
  static void choose_below(QComboBox* box, int words = 1) {
    box->setFocus();
    for (int i = 0; i < words; ++i) QTest::keyClick(box, Qt::Key_Down);
  }
  const Body& light() { return scene_->bodies[0]; }
  const Body& heavy() { return scene_->bodies[1]; }

  Inspector inspector_;
  std::shared_ptr<const Scene> scene_;
  std::vector<std::string> names_;
  std::vector<Edit> made_;
};

}  // namespace carom
