#include "app/help/keys_page.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <QStringList>
#include <array>

namespace carom {
namespace {

constexpr auto kSelectionKeys = std::to_array<KeyText>({
    {Qt::Key_Up, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "arrows"),
     QT_TRANSLATE_NOOP("KeysPage", "move by a step of the grid; with Shift ten")},
    {Qt::Key_Up, Qt::ControlModifier, QT_TRANSLATE_NOOP("KeysPage", "Ctrl and arrows"),
     QT_TRANSLATE_NOOP("KeysPage", "velocity by 0.1 m/s; with Shift 1 m/s")},
    {Qt::Key_BracketLeft, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "[ and ]"),
     QT_TRANSLATE_NOOP("KeysPage", "turn by 5°; with Shift 45°")},
    {Qt::Key_Less, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "< and >"),
     QT_TRANSLATE_NOOP("KeysPage", "turn by 5°")},
    {Qt::Key_Backspace, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "Backspace"),
     QT_TRANSLATE_NOOP("KeysPage", "delete; of a polygon that is being drawn, take the last corner back")},
    {Qt::Key_1, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "digits and −"),
     QT_TRANSLATE_NOOP("KeysPage",
                       "during a drag, and while its value stands beside the mouse, type that value")},
    {Qt::Key_Plus, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "+ and −"),
     QT_TRANSLATE_NOOP("KeysPage", "larger and smaller by 5 %; with nothing selected they zoom")},
    {Qt::Key_0, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "0"), QT_TRANSLATE_NOOP("KeysPage", "to rest")},
    {Qt::Key_X, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "X"),
     QT_TRANSLATE_NOOP("KeysPage", "reverse the velocity and the spin")},
    {Qt::Key_L, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "L"),
     QT_TRANSLATE_NOOP("KeysPage", "lock them, or unlock them")},
    {Qt::Key_F2, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "F2"),
     QT_TRANSLATE_NOOP("KeysPage", "type the name of a single one")},
    {Qt::Key_Tab, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "Tab, Shift+Tab"),
     QT_TRANSLATE_NOOP("KeysPage", "select the next body, the one before")},
    {Qt::Key_Space, Qt::ControlModifier, QT_TRANSLATE_NOOP("KeysPage", "Ctrl+Space"),
     QT_TRANSLATE_NOOP("KeysPage", "this body stays selected when Tab goes on; again: it does not")},
    {Qt::Key_Enter, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "Enter"),
     QT_TRANSLATE_NOOP("KeysPage", "with a tool in hand, draw or join")},
    {Qt::Key_Escape, Qt::NoModifier, QT_TRANSLATE_NOOP("KeysPage", "Esc"),
     QT_TRANSLATE_NOOP("KeysPage", "take a drag back; put the tool away; select nothing")},
    {Qt::Key_F10, Qt::ShiftModifier, QT_TRANSLATE_NOOP("KeysPage", "Shift+F10"),
     QT_TRANSLATE_NOOP("KeysPage", "the menu of what is selected")},
});

QString tr(const char* text) { return QCoreApplication::translate("KeysPage", text); }

QString plain(QString text) { return text.remove('&').replace('|', "\\|"); }

QString row(const QString& keys, const QString& what) { return QString("| %1 | %2 |\n").arg(keys, what); }

QString keys_of(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& each : action.shortcuts()) keys << each.toString(QKeySequence::NativeText);
  return keys.join(", ");
}

// Those of submenus too.
QString rows_of(const QMenu& menu) {
  QString rows;
  for (const QAction* action : menu.actions()) {
    if (action->menu() != nullptr) {
      rows += rows_of(*action->menu());
    } else if (!action->shortcuts().isEmpty()) {
      rows += row(plain(keys_of(*action)), plain(action->text()));
    } else if (const QStringList named = action->text().split('\t'); named.size() == 2) {
      rows += row(plain(named[1]), plain(named[0]));  // a key of the scene
    }
  }
  return rows;
}

QString section(const QString& title, const QString& rows) {
  return rows.isEmpty()
             ? QString()
             : QString("## %1\n\n| %2 | %3 |\n|---|---|\n%4\n").arg(title, tr("key"), tr("what it does"), rows);
}

}  // namespace

std::span<const KeyText> selection_keys() { return kSelectionKeys; }

QString keys_page(const QMenuBar& menus) {
  QString page = "# " + tr("Keys") + "\n\n";
  QString rows;
  for (const KeyText& each : kSelectionKeys) rows += row(tr(each.keys), tr(each.what));
  page += section(tr("Selected bodies"), rows);
  for (const QAction* action : menus.actions()) {
    if (action->menu() != nullptr) page += section(plain(action->text()), rows_of(*action->menu()));
  }
  return page;
}

}  // namespace carom
