#include "widgets/run/ledger_table.h"

#include <QCoreApplication>
#include <array>
#include <cstddef>
#include <string_view>

#include "physics/ledger/ledger_entries.h"
#include "physics/model/needs.h"
#include "physics/preset/preset.h"

namespace carom {
namespace {

// Rows derived from the ledger's entries; each side ends with the drift.
struct Sum {
  const char* energy_name;
  const char* energy_tip;
  double (*energy)(const Ledger& ledger, const Totals& now);
  const char* momentum_name;
  const char* momentum_tip;
  Vec2 (*momentum)(const Ledger& ledger, const Totals& now);
  double (*angular)(const Ledger& ledger, const Totals& now);
};
constexpr std::array<Sum, 3> kSums = {{
    {QT_TRANSLATE_NOOP("LedgerTable", "expected energy"),
     QT_TRANSLATE_NOOP("LedgerTable",
                       "Initial energy minus the losses, plus the correction and what was put in"),
     [](const Ledger& l, const Totals&) { return l.expected(); },
     QT_TRANSLATE_NOOP("LedgerTable", "expected momentum"),
     QT_TRANSLATE_NOOP("LedgerTable", "Initial momentum plus the impulses of forces, minus those on walls"),
     [](const Ledger& l, const Totals&) -> Vec2 { return l.expected_momentum(); },
     [](const Ledger& l, const Totals&) { return l.expected_angular_momentum(); }},
    {QT_TRANSLATE_NOOP("LedgerTable", "energy now"),
     QT_TRANSLATE_NOOP("LedgerTable", "Kinetic and potential energy of the bodies as they move now"),
     [](const Ledger&, const Totals& now) { return now.energy(); },
     QT_TRANSLATE_NOOP("LedgerTable", "momentum now"),
     QT_TRANSLATE_NOOP("LedgerTable",
                       "Momentum of the bodies as they move now, and angular momentum about the origin"),
     [](const Ledger&, const Totals& now) -> Vec2 { return now.momentum; },
     [](const Ledger&, const Totals& now) { return now.angular_momentum; }},
    {QT_TRANSLATE_NOOP("LedgerTable", "numerical drift"),
     QT_TRANSLATE_NOOP("LedgerTable",
                       "Energy now less the expected one: what the method itself gained or lost"),
     [](const Ledger& l, const Totals& now) { return l.numerical_drift(now.energy()); },
     QT_TRANSLATE_NOOP("LedgerTable", "numerical drift"),
     QT_TRANSLATE_NOOP("LedgerTable",
                       "Momentum now less the expected one: what the method itself gained or lost"),
     [](const Ledger& l, const Totals& now) -> Vec2 { return l.momentum_drift(now.momentum); },
     [](const Ledger& l, const Totals& now) { return l.angular_momentum_drift(now.angular_momentum); }},
}};
constexpr std::size_t kRows = kEnergyEntries.size() + kSums.size();

constexpr int kEnergyName = 0;
constexpr int kEnergyValue = 1;
constexpr int kGap = 2;
constexpr int kMomentumName = 3;
constexpr int kMomentumX = 4;
constexpr int kAngular = 6;

QString in_words(std::string_view text) {
  return QCoreApplication::translate("LedgerTable", text.data());  // a literal, so null-terminated
}

class LedgerModel : public FigureModel {
 public:
  using FigureModel::FigureModel;

  void set(const Preset& preset) {
    const Needs needs = needs_of(preset.scene);
    for (std::size_t i = 0; i < kEnergyEntries.size(); ++i) {
      const auto idle = kEnergyEntries[i].idle;
      energy_idle_[i] = idle != nullptr && idle(preset.scene, preset.method.contacts, needs);
    }
    for (std::size_t i = 0; i < kMomentumEntries.size(); ++i) {
      const auto idle = kMomentumEntries[i].idle;
      momentum_idle_[i] = idle != nullptr && idle(preset.scene);
    }
    rows_changed(kRows);
  }

  void set(const Frame& frame) {
    ledger_ = frame.ledger;
    now_ = frame.totals;
    rows_changed(kRows);
  }

  [[nodiscard]] bool is_sum(int row) const override { return row == kRows - 1; }

  // An entry that changed before the scene was edited is not pale.
  [[nodiscard]] bool is_idle(int row, int column) const override {
    const auto i = static_cast<std::size_t>(row);
    if (column < kGap)
      return i < kEnergyEntries.size() && energy_idle_[i] && ledger_.*kEnergyEntries[i].value == 0.0;
    if (i >= kMomentumEntries.size() || !momentum_idle_[i]) return false;
    const MomentumEntry& entry = kMomentumEntries[i];
    return (ledger_.*entry.value).isZero(0.0) && ledger_.*entry.angular == 0.0;
  }

  [[nodiscard]] Cell cell(int row, int column) const override {
    const auto i = static_cast<std::size_t>(row);
    if (column == kGap) return {};
    if (const Sum* sum = sum_at(row)) {
      if (column == kEnergyName) return in_words(sum->energy_name);
      if (column == kEnergyValue) return sum->energy(ledger_, now_);
      if (column == kMomentumName) return in_words(sum->momentum_name);
      if (column == kAngular) return sum->angular(ledger_, now_);
      return sum->momentum(ledger_, now_)[column - kMomentumX];
    }
    if (column == kEnergyName) return in_words(kEnergyEntries[i].name);
    if (column == kEnergyValue) return ledger_.*kEnergyEntries[i].value;
    if (i >= kMomentumEntries.size()) return {};
    if (column == kMomentumName) return in_words(kMomentumEntries[i].name);
    if (column == kAngular) return ledger_.*kMomentumEntries[i].angular;
    return (ledger_.*kMomentumEntries[i].value)[column - kMomentumX];
  }

  [[nodiscard]] QString tip(int row, int column) const override {
    const auto i = static_cast<std::size_t>(row);
    const bool energy = column < kGap;
    QString tip;
    if (const Sum* sum = sum_at(row)) {
      tip = in_words(energy ? sum->energy_tip : sum->momentum_tip);
    } else if (energy) {
      tip = in_words(kEnergyEntries[i].tip);
    } else if (i < kMomentumEntries.size()) {
      tip = in_words(kMomentumEntries[i].tip);
    }
    if (is_idle(row, column)) tip += "\n" + in_words("Nothing in this scene can change it.");
    return tip;
  }

 private:
  // nullptr: an entry of the ledger.
  static const Sum* sum_at(int row) {
    const auto i = static_cast<std::size_t>(row);
    return i < kEnergyEntries.size() ? nullptr : &kSums[i - kEnergyEntries.size()];
  }

  Ledger ledger_;
  Totals now_;
  std::array<bool, kEnergyEntries.size()> energy_idle_{};
  std::array<bool, kMomentumEntries.size()> momentum_idle_{};
};

}  // namespace

LedgerTable::LedgerTable(QWidget* parent)
    : FigureTable(new LedgerModel({{"energy", 128, true},
                                   {"J", 76},
                                   {"", 20},
                                   {"momentum", 130, true},
                                   {"x / kg m/s", 84},
                                   {"y / kg m/s", 84},
                                   {"angular / kg m²/s", 118}},
                                  nullptr),
                  tr("Ledger"), parent) {}

void LedgerTable::set_scene(const Preset& preset) { static_cast<LedgerModel*>(model())->set(preset); }

void LedgerTable::update_from(const Frame& frame) { static_cast<LedgerModel*>(model())->set(frame); }

}  // namespace carom
