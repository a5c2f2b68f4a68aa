#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "physics/dynamics/state.h"
#include "physics/model/mass.h"
#include "physics/record/frame.h"
#include "widgets/base/figure_table.h"
#include "widgets/edit/inspected.h"

namespace carom {

// A text that was typed into a cell: the edits that it makes, none if it changes nothing, or why it can't be.
struct TypedCell {
  NamedEdits made;
  QString fault;
};

// A row for each body at one moment: name, m, x, y, v, spin and e, which can be edited where there is a scene,
// and what follows from them. The last row has all bodies together: their mass, their centre of mass, p, L, K.
class BodiesModel : public FigureModel {
 public:
  enum Column {
    kBody,
    kMass,
    kX,
    kY,
    kVelocityX,
    kVelocityY,
    kSpeed,
    kDirection,
    kRelativeX,  // velocity less that of the centre of mass
    kRelativeY,
    kSpin,
    kRestitution,
    kMomentum,  // its size
    kMomentumX,
    kMomentumY,
    kAngularMomentum,  // about the origin
    kEnergy,
    kRadius,
    kInertia
  };
  static constexpr std::size_t kFirst = 200;  // bodies that are shown unless all are

  explicit BodiesModel(QObject* parent = nullptr);

  // The scene as it stands; while a run plays, that of the frame. Null: there is none, and nothing of the
  // frame, which is shown, can be edited.
  void show(const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const Frame>& frame);
  void show_all();
  void mark(const std::vector<std::string>& names);
  // Cells that could not take what was pasted, with the sentences why; they are red until the next call.
  using Faults = std::map<std::pair<int, int>, QString>;
  void set_faults(Faults faults);
  [[nodiscard]] bool has_faults() const { return !faults_.empty(); }

  // While a drag changes what is shown, the cells that differ from the beginning are changed ones.
  void watch_changes(bool watch);
  [[nodiscard]] bool is_changed(int row, int column) const;

  [[nodiscard]] const std::vector<Body>& bodies() const { return *bodies_; }
  // The scene with the surfaces of the bodies; null before the first one.
  [[nodiscard]] const Scene* surfaces() const { return surfaces_.get(); }
  // Whether the cells of the column follow from others.
  [[nodiscard]] static bool follows(int column);
  // Whether the cells of the column are about where things are and how fast they move.
  [[nodiscard]] static bool is_of_motion(int column) { return column >= kX && column <= kSpin; }
  [[nodiscard]] int shown_bodies() const { return static_cast<int>(shown_); }
  [[nodiscard]] bool is_marked(int row) const;
  [[nodiscard]] const QString* fault(int row, int column) const;
  [[nodiscard]] bool can_edit() const { return scene_ != nullptr; }
  // Why a cell can't be edited, in one sentence; empty if it can.
  [[nodiscard]] QString why_not(int row, int column) const;
  // With every digit.
  [[nodiscard]] QString full_text(int row, int column) const;

  [[nodiscard]] Cell cell(int row, int column) const override;
  [[nodiscard]] bool is_sum(int row) const override { return row == shown_bodies(); }
  [[nodiscard]] bool is_idle(int row, int column) const override;
  [[nodiscard]] QString tip(int row, int column) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  [[nodiscard]] Cell sum(int column) const;
  [[nodiscard]] Cell motion(int body, int column) const;
  [[nodiscard]] double angular_momentum(int body) const;
  [[nodiscard]] double kinetic_energy(int body) const;
  // m/s, of a velocity of the body: 0 where it is rounding, beside the fastest and in its momentum too.
  [[nodiscard]] double moved(int body, double velocity) const;
  [[nodiscard]] bool turns(int body) const;        // by more than rounding
  [[nodiscard]] double rim_speed(int body) const;  // m/s, by its spin
  [[nodiscard]] QString surface_tip(int row) const;
  [[nodiscard]] QString spoken(const QModelIndex& index) const;
  void count();
  void find_scales();

  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const Scene> surfaces_;  // the last scene that there was
  std::shared_ptr<const Frame> frame_;     // while there is no scene
  std::shared_ptr<const std::vector<Body>> bodies_ = std::make_shared<const std::vector<Body>>();
  State state_;
  MassProperties mass_;
  std::size_t shown_ = 0;
  bool all_ = false;
  std::unordered_set<std::string> marked_;
  Faults faults_;
  std::map<std::pair<std::string, int>, QString> watched_;  // by body and column, at the beginning
  // Of all that move: m, the farthest place from an axis, and the largest body; m/s, the fastest, at the rim
  // too. What is far below is rounding.
  double length_ = 0.0;
  double size_ = 0.0;
  double fastest_ = 0.0;   // at least a size a second
  double heaviest_ = 0.0;  // N s, the largest momentum
  double total_mass_ = 0.0;
  double energy_ = 0.0;
  double angular_momentum_ = 0.0;
  Vec2 momentum_ = Vec2::Zero();
  Vec2 centre_ = Vec2::Zero();  // of mass, where there is mass
};

// What `text` makes of a cell of one of these bodies of the scene that can be edited.
[[nodiscard]] TypedCell typed_cell(const Scene& scene, const std::vector<Body>& bodies, int row, int column,
                                   const QString& text);

// The value of a formula there, as value_of_typed() has it.
[[nodiscard]] QString value_of_cell(const Scene& scene, const std::vector<Body>& bodies, int row, int column,
                                    const QString& text);

// Columns that can be shown and hidden together.
struct ColumnChoice {
  const char* id;    // in what is remembered
  const char* text;  // for people; UTF-8
  std::vector<int> columns;
  bool usual = false;
};
[[nodiscard]] const std::vector<ColumnChoice>& column_choices();

}  // namespace carom
