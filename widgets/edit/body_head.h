#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/scene.h"

class QLabel;

namespace carom {

class ChoiceBox;
class NameField;

// What of the selected bodies is no number: the name of one, whether they move, and their material.
class BodyHead : public QWidget {
  Q_OBJECT

 public:
  explicit BodyHead(QWidget* parent = nullptr);

  void show_bodies(const std::shared_ptr<const Scene>& scene, const std::vector<Body>& bodies);
  // Puts the cursor into the name of the one body.
  void edit_name();
  // Forgets what is typed or chosen.
  void restore();
  // As in ValueRow.
  [[nodiscard]] int label_width() const;
  void set_label_width(int width);

 signals:
  void edited(const carom::SceneEdits& edits, const QString& name);
  // The name field was left with a name that can't be.
  void dropped(const QString& sentence);

 private:
  void show_kind();
  void show_materials();
  void rename(const QString& name);
  void set_kind(int kind);
  void set_material(const QString& material);

  std::shared_ptr<const Scene> scene_;
  std::vector<Body> bodies_;
  std::vector<QLabel*> labels_;
  NameField* name_;
  QLabel* fault_;
  ChoiceBox* kind_;
  ChoiceBox* material_;
};

}  // namespace carom
