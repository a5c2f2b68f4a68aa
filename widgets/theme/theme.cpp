#include "widgets/theme/theme.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QStyleFactory>
#include <QSvgRenderer>
#include <cmath>

// Links the resources of a static library; must be called outside of any namespace.
static void load_icons() { Q_INIT_RESOURCE(icons); }

namespace carom {
namespace {

Theme make_theme(bool dark, std::array<const char*, 15> c, std::array<const char*, 6> series) {
  Theme t;
  t.dark = dark;
  t.window = QColor(c[0]);
  t.panel = QColor(c[1]);
  t.border = QColor(c[2]);
  t.text = QColor(c[3]);
  t.muted = QColor(c[4]);
  t.accent = QColor(c[5]);
  t.accent_ground = QColor(c[6]);
  t.scene_ground = QColor(c[7]);
  t.grid = QColor(c[8]);
  t.strong_grid = QColor(c[9]);
  t.body_fill = QColor(c[10]);
  t.body_line = QColor(c[11]);
  t.wall_fill = QColor(c[12]);
  t.wall_line = QColor(c[13]);
  t.danger = QColor(c[14]);
  for (std::size_t i = 0; i < series.size(); ++i) t.series[i] = QColor(series[i]);
  return t;
}

// %1 window, %2 panel, %3 border, %4 text, %5 muted, %6 accent, %7 accent ground, %8 danger
constexpr const char* kStyleSheet = R"(
QWidget { color: %4; }
QMainWindow, QDialog, QWidget#window { background: %1; }
QMenuBar { background: %2; padding: 2px 4px; }
QMenuBar::item { padding: 4px 9px; border-radius: 5px; background: transparent; }
QMenuBar::item:selected { background: %7; }
QMenu { background: %2; border: 1px solid %3; padding: 4px; }
QMenu::item { padding: 5px 22px 5px 22px; border-radius: 4px; }
QMenu::item:selected { background: %7; }
QMenu::item:disabled { color: %5; }
QMenu::separator { height: 1px; background: %3; margin: 4px 6px; }
QToolBar { background: %2; border: none; border-bottom: 1px solid %3; padding: 4px 8px; spacing: 4px; }
QToolBar::separator { width: 1px; background: %3; margin: 6px 6px; }
QToolBar#column { border: 1px solid %3; border-radius: 6px; padding: 3px 2px; spacing: 1px; }
QToolBar#column::separator { height: 1px; margin: 4px 4px; }
QToolButton { border: 1px solid transparent; border-radius: 6px; padding: 5px; background: transparent; }
QToolButton:hover { background: %7; }
QToolButton:checked { background: %7; color: %6; }
QToolButton:focus { border-color: %6; }
QToolButton[kept="true"] { border-color: %6; border-bottom: 3px solid %6; padding-bottom: 3px; }
QToolButton:disabled { color: %5; }
QToolButton#choice { border: 1px solid %3; padding: 4px 10px; background: %1; }
QToolButton#more { padding: 0 4px; font-size: 11px; color: %5; }
QToolButton#more::menu-indicator { image: none; }
QToolButton#choice:hover { border-color: %6; }
QToolButton#choice::menu-indicator { image: none; }
QFrame#panel, QFrame#bubble { background: %2; border: 1px solid %3; border-radius: 6px; }
QFrame#notice { background: %7; border: 1px solid %6; border-radius: 6px; }
QFrame#sidebar { background: %2; border: none; border-right: 1px solid %3; }
QFrame#sidebar[over="true"] { border: 1px solid %5; border-radius: 8px; }
QLabel { background: transparent; }
QLabel#title { font-weight: bold; }
QLabel#caption { color: %5; font-size: 11px; }
QLabel#muted { color: %5; }
QLabel#note { color: %5; font-size: 11px; background: %2; border-radius: 4px; padding: 1px 5px; }
QLabel#chip { background: %2; border: 1px solid %3; border-radius: 11px; padding: 3px 9px; font-size: 11px; }
QLineEdit, QSpinBox, QDoubleSpinBox, QPlainTextEdit { background: %1; border: 1px solid %3; border-radius: 6px; padding: 5px 8px;
  selection-background-color: %6; selection-color: %2; }
QLineEdit:focus, QSpinBox:focus, QDoubleSpinBox:focus, QPlainTextEdit:focus { border-color: %6; }
QLineEdit:disabled, QComboBox:disabled { color: %5; }
QLineEdit[changes="true"] { border: 2px solid %6; padding: 4px 7px; }
QLineEdit[fault="true"] { border-color: %8; }
QLineEdit#title { font-weight: bold; background: transparent; border-color: transparent; padding: 2px 4px; margin-left: -5px; }
QLineEdit#title:hover, QLineEdit#title:focus { background: %1; border-color: %3; }
QWidget#rows QLineEdit { padding: 4px 8px; }
QWidget#rows QLineEdit[changes="true"] { padding: 3px 7px; }
QWidget#rows QComboBox { min-height: 18px; }
QWidget#rows QPushButton { padding: 4px 10px; }
QLineEdit#cell { padding: 0 4px; border-radius: 4px; font-size: 12px; }
QLabel#fault { color: %8; font-size: 11px; }
QSlider#value { min-height: 20px; }
QSlider#value::groove:horizontal { height: 4px; border-radius: 2px; background: %3; }
QSlider#value::sub-page:horizontal { height: 4px; border-radius: 2px; background: %6; }
QSlider#value[signed="true"]::sub-page:horizontal, QSlider#value::sub-page:horizontal:disabled { background: %3; }
QSlider#value::handle:horizontal { width: 10px; height: 10px; margin: -5px 0; border: 2px solid %6; border-radius: 7px;
  background: %2; }
QSlider#value::handle:horizontal:disabled { border-color: %5; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QComboBox { min-height: 20px; combobox-popup: 0; background: %1; border: 1px solid %3; border-radius: 6px; padding: 4px 8px; }
QComboBox:focus, QComboBox:on { border-color: %6; }
QComboBox::drop-down { border: none; width: 22px; }
QComboBox::down-arrow { image: url(:/icons/down.svg); width: 12px; height: 12px; }
QComboBox QLineEdit { border: none; padding: 0; }
QComboBox QAbstractItemView { background: %2; border: 1px solid %3; padding: 2px; }
QRadioButton:disabled, QCheckBox:disabled { color: %5; }
QCheckBox::indicator { width: 13px; height: 13px; border: 1px solid %5; border-radius: 3px; background: %1; }
QCheckBox::indicator:checked { background: %6; border-color: %6; image: url(:/icons/check.svg); }
QRadioButton::indicator { width: 13px; height: 13px; border: 1px solid %5; border-radius: 7px; background: %1; }
QRadioButton::indicator:checked { width: 5px; height: 5px; border: 5px solid %6; background: %2; }
QCheckBox::indicator:disabled, QRadioButton::indicator:disabled { border-color: %3; }
QGroupBox { border: 1px solid %3; border-radius: 8px; margin-top: 9px; padding: 10px 8px 6px 8px; }
QGroupBox::title { subcontrol-origin: margin; left: 10px; padding: 0 4px; color: %5; }
QPushButton { background: %2; border: 1px solid %3; border-radius: 6px; padding: 5px 14px; }
QPushButton:hover, QPushButton:focus { border-color: %6; }
QPushButton#chip { border-color: %6; border-radius: 11px; padding: 3px 9px; font-size: 11px; }
QPushButton#chip[start="true"] { background: %7; color: %6; font-weight: bold; }
QPushButton#chip::menu-indicator { image: none; }
QPushButton#word { background: %1; border-radius: 0; padding: 4px 6px; }
QPushButton#word[side="left"] { border-top-left-radius: 6px; border-bottom-left-radius: 6px; }
QPushButton#word[side="right"] { border-top-right-radius: 6px; border-bottom-right-radius: 6px; }
QPushButton#word[side="middle"] { border-left: none; border-right: none; }
QPushButton#word:checked { background: %7; color: %6; font-weight: bold; }
QPushButton#small { padding: 3px 6px; font-size: 12px; text-align: center; }
QPushButton#small::menu-indicator { image: none; }
QPushButton:default { background: %6; color: %2; border-color: %6; }
QPushButton:disabled, QPushButton:default:disabled { background: %1; color: %5; border-color: %3; }
QListView, QTreeView, QTableView, QTextBrowser { background: %2; border: none; outline: none;
  selection-background-color: %7; selection-color: %4; alternate-background-color: %2; gridline-color: %3; }
QHeaderView { background: %2; }
QHeaderView::section { background: %2; color: %5; border: none; border-bottom: 1px solid %3; padding: 3px 5px;
  font-size: 11px; font-weight: normal; }
QHeaderView::down-arrow { image: url(:/icons/down.svg); width: 9px; height: 9px; subcontrol-position: top center; }
QHeaderView::up-arrow { image: url(:/icons/up.svg); width: 9px; height: 9px; subcontrol-position: top center; }
QTableView { font-size: 12px; }
QTableView::item { padding: 2px 5px; }
QTabWidget::pane { border: none; border-top: 1px solid %3; }
QTabBar { background: transparent; qproperty-drawBase: 0; }
QTabBar::tab { background: transparent; color: %5; padding: 7px 2px; margin-right: 18px; border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: %4; font-weight: bold; border-bottom-color: %6; }
QTabBar::tab:selected:focus { border: 2px solid %6; border-radius: 4px; padding: 5px 4px; margin-right: 10px; }
QTabBar::tab:hover { color: %4; }
QSplitter::handle { background: %1; }
QStatusBar { background: %2; border-top: 1px solid %3; color: %5; }
QStatusBar::item { border: none; }
QToolTip { background: %2; color: %4; border: 1px solid %3; padding: 4px 6px; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: %3; border-radius: 4px; min-height: 24px; min-width: 24px; margin: 1px; }
QScrollBar::handle:hover { background: %5; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
)";

}  // namespace

const Theme& light_theme() {
  static const Theme theme =
      make_theme(false,
                 {"#F3F5F8", "#FFFFFF", "#D7DDE6", "#17202C", "#5A6778", "#0B62C4", "#E4EFFC", "#FBFCFE",
                  "#E7ECF3", "#D3DBE6", "#CFE0F5", "#2B5F9E", "#C3CAD4", "#7B8796", "#B3261E"},
                 {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"});
  return theme;
}

const Theme& dark_theme() {
  static const Theme theme =
      make_theme(true,
                 {"#12161D", "#1A2029", "#2D3642", "#E4EAF2", "#93A1B4", "#62ABFF", "#1B3350", "#0F1319",
                  "#1D2530", "#2A3543", "#20395A", "#7FB4F2", "#303B49", "#6C7A8C", "#FF8A80"},
                 {"#4BA8E8", "#FF8A3D", "#2CC79B", "#E39BC5", "#F2B84B", "#8BD0F5"});
  return theme;
}

Qt::PenStyle series_dash(int index) {
  constexpr std::array kDashes = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine,
                                  Qt::DashDotDotLine};
  return kDashes[static_cast<std::size_t>(index) % kDashes.size()];
}

QColor blend(const QColor& from, const QColor& to, double share) {
  const auto mixed = [share](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
  return {mixed(from.red(), to.red()), mixed(from.green(), to.green()), mixed(from.blue(), to.blue())};
}

void apply_theme(QApplication& application, const Theme& t) {
  // Style and type are those of every theme: each of them would be put on every widget again.
  if (application.styleSheet().isEmpty()) {
    application.setStyle(QStyleFactory::create("Fusion"));
    QFont font = application.font();
    if (QFontDatabase::families().contains("Inter")) font.setFamily("Inter");
    font.setPixelSize(13);
    application.setFont(font);
  }

  QPalette p;
  p.setColor(QPalette::Window, t.window);
  p.setColor(QPalette::WindowText, t.text);
  p.setColor(QPalette::Base, t.panel);
  p.setColor(QPalette::AlternateBase, t.window);
  p.setColor(QPalette::Text, t.text);
  p.setColor(QPalette::Button, t.panel);
  p.setColor(QPalette::ButtonText, t.text);
  p.setColor(QPalette::ToolTipBase, t.panel);
  p.setColor(QPalette::ToolTipText, t.text);
  p.setColor(QPalette::PlaceholderText, t.muted);
  p.setColor(QPalette::Highlight, t.accent);
  p.setColor(QPalette::HighlightedText, t.panel);
  p.setColor(QPalette::Link, t.accent);
  p.setColor(QPalette::Mid, t.border);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, t.muted);
  }
  application.setPalette(p);
  application.setStyleSheet(QString(kStyleSheet)
                                .arg(t.window.name(), t.panel.name(), t.border.name(), t.text.name(),
                                     t.muted.name(), t.accent.name(), t.accent_ground.name(), t.danger.name()));
}

QIcon themed_icon(const QString& name, const QColor& color) {
  load_icons();
  QFile file(":/icons/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly)) return {};
  QSvgRenderer renderer(QString::fromUtf8(file.readAll()).replace("currentColor", color.name()).toUtf8());
  QIcon icon;
  for (const int size : {18, 36}) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    {
      QPainter painter(&pixmap);
      renderer.render(&painter);
    }
    icon.addPixmap(pixmap);
    QPixmap faint(size, size);
    faint.fill(Qt::transparent);
    {
      QPainter painter(&faint);
      painter.setOpacity(0.35);
      painter.drawPixmap(0, 0, pixmap);
    }
    icon.addPixmap(faint, QIcon::Disabled);
  }
  return icon;
}

}  // namespace carom
