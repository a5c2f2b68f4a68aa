#include "widgets/run/ledger_table.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cstddef>

#include "physics/model/needs.h"
#include "physics/preset/preset.h"

namespace carom {
namespace {

// One line of the table. `idle`: no run of the scene can change the entry; without it, none of any scene.
template <class Value>
struct Entry {
  const char* name = nullptr;
  const char* tip = nullptr;
  Value (*value)(const Ledger& ledger, const Totals& now) = nullptr;
  bool (*idle)(const Preset& preset, const Needs& needs) = nullptr;
};

bool has_dampers(const Preset& preset) {
  return std::any_of(preset.scene.forces.springs.begin(), preset.scene.forces.springs.end(),
                     [](const Spring& spring) { return spring.damping > 0.0; });
}

bool has_drag(const Preset& preset) {
  return preset.scene.forces.linear_drag > 0.0 || preset.scene.forces.quadratic_drag > 0.0;
}

// Of contacts that last only.
bool has_rolling_resistance(const Preset& preset) {
  if (preset.method.contacts != ContactsId::kLasting) return false;
  const auto resists = [](const Material& material) { return material.rolling_resistance > 0.0; };
  return std::any_of(preset.scene.materials.begin(), preset.scene.materials.end(), resists) ||
         std::any_of(preset.scene.pairs.begin(), preset.scene.pairs.end(),
                     [&](const MaterialPair& pair) { return resists(pair.surface); });
}

constexpr std::size_t kEntries = 14;

constexpr std::array<Entry<double>, kEntries> kEnergy = {{
    {QT_TRANSLATE_NOOP("LedgerTable", "initial energy"),
     QT_TRANSLATE_NOOP("LedgerTable", "Kinetic and potential energy at the start of the run"),
     [](const Ledger& l, const Totals&) { return l.initial; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "lost to restitution"),
     QT_TRANSLATE_NOOP("LedgerTable", "Taken by impacts with a restitution below 1: ½ μ (1 − e²) uₙ² each"),
     [](const Ledger& l, const Totals&) { return l.lost_to_restitution; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "lost to friction"),
     QT_TRANSLATE_NOOP("LedgerTable",
                       "Work of the tangential impulses of impacts and of friction where contacts last"),
     [](const Ledger& l, const Totals&) { return l.lost_to_friction; },
     [](const Preset&, const Needs& needs) { return !needs.friction; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "lost to rolling"),
     QT_TRANSLATE_NOOP("LedgerTable", "Work of the moment that resists rolling at contacts that last"),
     [](const Ledger& l, const Totals&) { return l.lost_to_rolling; },
     [](const Preset& preset, const Needs&) { return !has_rolling_resistance(preset); }},
    {QT_TRANSLATE_NOOP("LedgerTable", "lost to drag"),
     QT_TRANSLATE_NOOP("LedgerTable", "Work of linear and quadratic drag, integrated along with the motion"),
     [](const Ledger& l, const Totals&) { return l.lost_to_drag; },
     [](const Preset& preset, const Needs&) { return !has_drag(preset); }},
    {QT_TRANSLATE_NOOP("LedgerTable", "lost to dampers"),
     QT_TRANSLATE_NOOP("LedgerTable", "Work of the dampers of springs, integrated along with the motion"),
     [](const Ledger& l, const Totals&) { return l.lost_to_dampers; },
     [](const Preset& preset, const Needs&) { return !has_dampers(preset); }},
    {QT_TRANSLATE_NOOP("LedgerTable", "lost to sticking"),
     QT_TRANSLATE_NOOP("LedgerTable", "Taken by impacts after which the bodies stay joined"),
     [](const Ledger& l, const Totals&) { return l.lost_to_sticking; },
     [](const Preset& preset, const Needs&) { return !has_sticking_surface(preset.scene); }},
    {QT_TRANSLATE_NOOP("LedgerTable", "lost to links"),
     QT_TRANSLATE_NOOP("LedgerTable", "Taken where strings jerked taut"),
     [](const Ledger& l, const Totals&) { return l.lost_to_links; },
     [](const Preset& preset, const Needs&) {
       return std::none_of(preset.scene.links.begin(), preset.scene.links.end(),
                           [](const Link& link) { return link.kind == LinkKind::kString; });
     }},
    {QT_TRANSLATE_NOOP("LedgerTable", "overlap correction"),
     QT_TRANSLATE_NOOP("LedgerTable",
                       "Potential energy that changed where overlapping bodies were pushed apart"),
     [](const Ledger& l, const Totals&) { return l.overlap_correction; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "put in by drives"),
     QT_TRANSLATE_NOOP("LedgerTable", "Work of driven bodies and of applied forces and torques"),
     [](const Ledger& l, const Totals&) { return l.put_in_by_drives; },
     [](const Preset&, const Needs& needs) { return !needs.drives; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "put in by the user"),
     QT_TRANSLATE_NOOP("LedgerTable", "Energy of the bodies that were added during the run"),
     [](const Ledger& l, const Totals&) { return l.put_in_by_user; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "expected energy"),
     QT_TRANSLATE_NOOP("LedgerTable",
                       "Initial energy less what was lost, with the correction and what was put in"),
     [](const Ledger& l, const Totals&) { return l.expected(); }},
    {QT_TRANSLATE_NOOP("LedgerTable", "energy now"),
     QT_TRANSLATE_NOOP("LedgerTable", "Kinetic and potential energy of the bodies as they move now"),
     [](const Ledger&, const Totals& now) { return now.energy(); }},
    {QT_TRANSLATE_NOOP("LedgerTable", "numerical drift"),
     QT_TRANSLATE_NOOP("LedgerTable",
                       "Energy now less the expected one: what the method itself gained or lost"),
     [](const Ledger& l, const Totals& now) { return l.numerical_drift(now.energy()); }},
}};

// Stands beside, so that both end in the drift.
constexpr std::array<Entry<Vec2>, kEntries> kMomentum = {{
    {QT_TRANSLATE_NOOP("LedgerTable", "initial momentum"),
     QT_TRANSLATE_NOOP("LedgerTable", "Momentum of all bodies that move freely at the start of the run"),
     [](const Ledger& l, const Totals&) -> Vec2 { return l.initial_momentum; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "from gravity"),
     QT_TRANSLATE_NOOP("LedgerTable", "Given by uniform gravity: its force times the time"),
     [](const Ledger& l, const Totals&) -> Vec2 { return l.momentum_from_gravity; },
     [](const Preset& preset, const Needs&) { return preset.scene.forces.gravity.isZero(0.0); }},
    {QT_TRANSLATE_NOOP("LedgerTable", "from forces"),
     QT_TRANSLATE_NOOP(
         "LedgerTable",
         "Given by drag, by springs and links to fixed points and driven bodies, and by applied forces"),
     [](const Ledger& l, const Totals&) -> Vec2 { return l.momentum_from_forces; },
     [](const Preset& preset, const Needs&) {
       return !has_drag(preset) && preset.scene.forces.springs.empty() && preset.scene.links.empty() &&
              preset.scene.forces.applied.empty();
     }},
    {QT_TRANSLATE_NOOP("LedgerTable", "from the user"),
     QT_TRANSLATE_NOOP("LedgerTable", "Of the bodies that were added during the run"),
     [](const Ledger& l, const Totals&) -> Vec2 { return l.momentum_from_user; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "to walls"),
     QT_TRANSLATE_NOOP("LedgerTable", "What impacts gave to fixed and driven bodies; it is taken from the sum"),
     [](const Ledger& l, const Totals&) -> Vec2 { return l.momentum_to_walls; },
     [](const Preset& preset, const Needs&) {
       return std::none_of(preset.scene.bodies.begin(), preset.scene.bodies.end(), is_immovable);
     }},
    {},
    {},
    {},
    {},
    {},
    {},
    {QT_TRANSLATE_NOOP("LedgerTable", "expected momentum"),
     QT_TRANSLATE_NOOP("LedgerTable", "Initial momentum with what was given, less what went to walls"),
     [](const Ledger& l, const Totals&) -> Vec2 { return l.expected_momentum(); }},
    {QT_TRANSLATE_NOOP("LedgerTable", "momentum now"),
     QT_TRANSLATE_NOOP("LedgerTable", "Momentum of the bodies as they move now"),
     [](const Ledger&, const Totals& now) -> Vec2 { return now.momentum; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "numerical drift"),
     QT_TRANSLATE_NOOP("LedgerTable",
                       "Momentum now less the expected one: what the method itself gained or lost"),
     [](const Ledger& l, const Totals& now) -> Vec2 { return l.momentum_drift(now.momentum); }},
}};

constexpr int kEnergyName = 0;
constexpr int kEnergyValue = 1;
constexpr int kGap = 2;
constexpr int kMomentumName = 3;
constexpr int kMomentumX = 4;

class LedgerModel : public FigureModel {
 public:
  using FigureModel::FigureModel;

  void set(const Preset& preset) {
    const Needs needs = needs_of(preset.scene);
    for (std::size_t i = 0; i < kEntries; ++i) {
      energy_idle_[i] = kEnergy[i].idle != nullptr && kEnergy[i].idle(preset, needs);
      momentum_idle_[i] = kMomentum[i].idle != nullptr && kMomentum[i].idle(preset, needs);
    }
    rows_changed(kEntries);
  }

  void set(const Frame& frame) {
    ledger_ = frame.ledger;
    now_ = frame.totals;
    rows_changed(kEntries);
  }

  [[nodiscard]] bool is_sum(int row) const override { return row == kEntries - 1; }

  // An entry that was touched before the scene was edited is not pale.
  [[nodiscard]] bool is_idle(int row, int column) const override {
    const auto i = static_cast<std::size_t>(row);
    if (column < kGap) return energy_idle_[i] && kEnergy[i].value(ledger_, now_) == 0.0;
    return momentum_idle_[i] && kMomentum[i].value(ledger_, now_).isZero(0.0);
  }

  [[nodiscard]] Cell cell(int row, int column) const override {
    const auto i = static_cast<std::size_t>(row);
    const auto name = [](const char* text) { return QCoreApplication::translate("LedgerTable", text); };
    if (column == kEnergyName) return name(kEnergy[i].name);
    if (column == kEnergyValue) return kEnergy[i].value(ledger_, now_);
    if (column == kGap || kMomentum[i].value == nullptr) return {};
    if (column == kMomentumName) return name(kMomentum[i].name);
    return kMomentum[i].value(ledger_, now_)[column - kMomentumX];
  }

  [[nodiscard]] QString tip(int row, int column) const override {
    const auto i = static_cast<std::size_t>(row);
    const char* text = column < kGap ? kEnergy[i].tip : kMomentum[i].tip;
    if (text == nullptr) return {};
    QString tip = QCoreApplication::translate("LedgerTable", text);
    if (is_idle(row, column)) {
      tip += "\n" + QCoreApplication::translate("LedgerTable", "Nothing in this scene can change it.");
    }
    return tip;
  }

 private:
  Ledger ledger_;
  Totals now_;
  std::array<bool, kEntries> energy_idle_{};
  std::array<bool, kEntries> momentum_idle_{};
};

}  // namespace

LedgerTable::LedgerTable(QWidget* parent)
    : FigureTable(new LedgerModel({{"energy", 128, true},
                                   {"J", 76},
                                   {"", 20},
                                   {"momentum", 130, true},
                                   {"x / kg·m/s", 84},
                                   {"y / kg·m/s", 84}},
                                  nullptr),
                  parent) {}

void LedgerTable::set_scene(const Preset& preset) { static_cast<LedgerModel*>(model())->set(preset); }

void LedgerTable::update_from(const Frame& frame) { static_cast<LedgerModel*>(model())->set(frame); }

}  // namespace carom
