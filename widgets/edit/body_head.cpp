#include "widgets/edit/body_head.h"

#include <QGridLayout>
#include <QLabel>
#include <algorithm>
#include <set>

#include "widgets/base/plain_text.h"
#include "widgets/edit/choice_box.h"
#include "widgets/edit/driven.h"
#include "widgets/edit/inspected.h"
#include "widgets/edit/name_field.h"

namespace carom {
namespace {

enum Kind { kMoves, kFixed, kDriven };

int kind_of(const Body& body) { return body.drive ? kDriven : body.fixed ? kFixed : kMoves; }

// A drive goes on as fast as the body moved, and a body as fast as its drive was.
Body of_kind(Body body, int kind) {
  const Vec2 velocity = body.drive ? body.drive->velocity : body.velocity;
  if (kind_of(body) == kind) return body;
  if (kind == kDriven) return driven(body, Drive{.velocity = velocity});
  body.fixed = kind == kFixed;
  body.drive.reset();
  body.velocity = kind == kMoves ? velocity : Vec2(Vec2::Zero());
  if (kind != kMoves) body.spin = 0.0;
  return body;
}

}  // namespace

BodyHead::BodyHead(QWidget* parent)
    : QWidget(parent),
      name_(new NameField(this)),
      fault_(new PlainLabel(this)),
      kind_(new ChoiceBox(this)),
      material_(new ChoiceBox(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(6);
  grid->setColumnStretch(1, 1);
  const auto add = [&](int row, const QString& text, QWidget* field, const QString& tip) {
    auto* label = new PlainLabel(text, this);
    label->setObjectName("muted");
    label->setToolTip(tip);
    labels_.push_back(label);
    field->setAccessibleName(text);
    field->setToolTip(tip);
    grid->addWidget(label, row, 0);
    grid->addWidget(field, row, 1);
  };
  add(0, tr("Name"), name_, tr("A name of its own"));
  grid->addWidget(fault_, 1, 1);
  add(2, tr("Kind"), kind_, tr("Whether forces and impacts move it"));
  add(3, tr("Surface"), material_, tr("The material of its surface"));
  fault_->setObjectName("fault");
  fault_->setWordWrap(true);
  fault_->hide();
  kind_->addItems({tr("moves"), tr("fixed"), tr("driven")});
  connect(name_, &NameField::named, this, &BodyHead::rename);
  connect(name_, &QLineEdit::textEdited, this, [this] { emit dropped({}); });
  connect(name_, &TypedField::dropped, this, &BodyHead::dropped);
  connect(name_, &TypedField::refused, this, [this](const QString& sentence) {
    fault_->setText(sentence);
    fault_->setVisible(!sentence.isEmpty());
  });
  connect(kind_, &QComboBox::activated, this, &BodyHead::set_kind);
  connect(material_, &QComboBox::textActivated, this, &BodyHead::set_material);
}

void BodyHead::show_bodies(const std::shared_ptr<const Scene>& scene, const std::vector<Body>& bodies) {
  scene_ = scene;
  bodies_ = bodies;
  const bool one = bodies.size() == 1;
  name_->setVisible(one);
  labels_.front()->setVisible(one);
  if (one) {
    name_->show_text(QString::fromStdString(bodies[0].name));
  } else {
    name_->restore();
  }
  show_kind();
  show_materials();
}

void BodyHead::show_kind() {
  std::set<int> kinds;
  for (const Body& body : bodies_) kinds.insert(kind_of(body));
  kind_->setCurrentIndex(kinds.size() == 1 ? *kinds.begin() : -1);
  kind_->setPlaceholderText(tr("%1 kinds").arg(kinds.size()));
  // A half-plane can only stand still.
  kind_->setEnabled(
      std::none_of(bodies_.begin(), bodies_.end(), [](const Body& body) { return is_half_plane(body.shape); }));
}

void BodyHead::show_materials() {
  QStringList names;
  bool has_default = false;
  for (const Material& material : scene_->materials) {
    names << QString::fromStdString(material.name);
    has_default = has_default || material.name == Material{}.name;
  }
  if (!has_default) names << QString::fromStdString(Material{}.name);
  material_->list(names);
  std::set<std::string> used;
  for (const Body& body : bodies_) used.insert(body.material);
  material_->setCurrentIndex(used.size() == 1 ? material_->findText(QString::fromStdString(*used.begin()))
                                              : -1);
  material_->setPlaceholderText(tr("%1 surfaces").arg(used.size()));
}

void BodyHead::edit_name() {
  name_->setFocus();
  name_->selectAll();
}

void BodyHead::restore() {
  name_->restore();
  if (scene_ == nullptr) return;
  show_kind();
  show_materials();
}

int BodyHead::label_width() const {
  int width = 0;
  for (const QLabel* label : labels_) width = std::max(width, label->sizeHint().width());
  return width;
}

void BodyHead::set_label_width(int width) {
  for (QLabel* label : labels_) label->setFixedWidth(width);
}

void BodyHead::rename(const QString& name) {
  const NamedEdits edits = renaming(bodies_[0], name);
  emit edited(edits.edits, edits.name);
}

void BodyHead::set_kind(int kind) {
  const auto is_so = [kind](const Body& body) { return kind_of(body) == kind; };
  if (std::all_of(bodies_.begin(), bodies_.end(), is_so)) return;
  const QString subject = subject_of(bodies_);
  const QString name = kind == kMoves   ? tr("Let %1 move").arg(subject)
                       : kind == kFixed ? tr("Fix %1").arg(subject)
                                        : tr("Drive %1").arg(subject);
  emit edited(edits_of(bodies_, [kind](Body& body) { body = of_kind(std::move(body), kind); }), name);
}

void BodyHead::set_material(const QString& material) {
  const std::string name = material.toStdString();
  const auto has_it = [&](const Body& body) { return body.material == name; };
  if (std::all_of(bodies_.begin(), bodies_.end(), has_it)) return;
  const QString text = tr("Surface of %1: %2").arg(subject_of(bodies_), material);
  emit edited(edits_of(bodies_, [&](Body& body) { body.material = name; }), text);
}

}  // namespace carom
