#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>

#include "app/lab/drawer.h"
#include "tests/app/lab/lab_fixture.h"
#include "tests/support/source_folder.h"
#include "widgets/edit/bodies_sheet.h"

namespace carom {
namespace {

// The drawer, and what a window remembers.
class LabMemoryTest : public LabWindowTest {
 protected:
  [[nodiscard]] Drawer& drawer() const { return *window_.findChild<Drawer*>(); }
  void click_tab(int tab) {
    auto* bar = drawer().findChild<QTabBar*>();
    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(tab).center());
    QApplication::processEvents();
  }
  QSettings settings_{folder_.filePath("carom.ini"), QSettings::IniFormat};
};

TEST_F(LabMemoryTest, AClickOnTheOpenTabFoldsTheDrawer) {
  const int before = window_.scene_view().height();
  click_tab(0);
  EXPECT_TRUE(drawer().folded());
  EXPECT_GT(window_.scene_view().height(), before + 50);
  EXPECT_LT(drawer().height(), 48) << "the line of tabs";
  click_tab(2);
  EXPECT_FALSE(drawer().folded());
  EXPECT_NEAR(window_.scene_view().height(), before, 4);
  click_tab(0);
  EXPECT_FALSE(drawer().folded()) << "another tab is opened";
  action("Drawer")->trigger();
  EXPECT_TRUE(drawer().folded());
  action("Standard layout")->trigger();
  QApplication::processEvents();
  EXPECT_FALSE(drawer().folded());
  EXPECT_NEAR(window_.scene_view().height(), before, 4);
}

TEST_F(LabMemoryTest, TheNextWindowIsLikeTheLast) {
  window_.keep_layout(settings_);
  EXPECT_FALSE(settings_.contains("dark")) << "the system's colours are followed";
  const std::string file = test::preset_file("chains-and-cradles/newtons-cradle.json");
  const QString copy = folder_.filePath("mine.json");
  ASSERT_TRUE(QFile::copy(file.c_str(), copy));
  ASSERT_TRUE(window_.open(copy.toStdString()));
  drawer().set_folded(true);
  window_.findChild<BodiesSheet*>()->show_columns({"speed", "K"});
  action("Inspector")->trigger();
  action("Dark colours")->trigger();
  action("Slow near impacts")->trigger();
  action("Experiments beside the scene")->setChecked(false);
  window_.resize(1100, 720);
  window_.keep_layout(settings_);
  action("Light colours")->trigger();
  EXPECT_TRUE(settings_.value("dark").toBool());

  LabWindow next(light_theme());
  next.restore_layout(settings_);
  EXPECT_TRUE(next.findChild<Drawer*>()->folded());
  EXPECT_EQ(next.findChild<BodiesSheet*>()->shown_columns(), (QStringList{"speed", "K"}));
  EXPECT_EQ(next.size(), QSize(1100, 720));
  const auto is_checked = [&next](const char* text) {
    const QList<QAction*> actions = next.findChildren<QAction*>();
    return std::any_of(actions.begin(), actions.end(),
                       [&](const QAction* a) { return a->text().remove('&') == text && a->isChecked(); });
  };
  EXPECT_TRUE(is_checked("Slow near impacts"));
  EXPECT_FALSE(is_checked("Experiments beside the scene"));
  QMenu* recent = nullptr;
  for (QMenu* menu : next.findChildren<QMenu*>()) {
    if (menu->title() == "Open &recent") recent = menu;
  }
  ASSERT_NE(recent, nullptr);
  emit recent->aboutToShow();
  ASSERT_EQ(recent->actions().size(), 1);
  EXPECT_EQ(recent->actions()[0]->text(), copy);
}

TEST_F(LabMemoryTest, RecentFilesAreFewAndOnceEach) {
  const auto recent = [this] {
    for (QMenu* menu : window_.findChildren<QMenu*>()) {
      if (menu->title() != "Open &recent") continue;
      emit menu->aboutToShow();
      return menu->actions();
    }
    return QList<QAction*>();
  };
  ASSERT_EQ(recent().size(), 1);
  EXPECT_FALSE(recent()[0]->isEnabled()) << "built-in experiments are no files of the user";
  for (int k = 0; k < 12; ++k) {
    const QString copy = folder_.filePath(QString("%1.json").arg(k % 10));
    QFile::copy(test::preset_file("first-collisions/head-on.json").c_str(), copy);
    ASSERT_TRUE(window_.open(copy.toStdString()));
  }
  EXPECT_EQ(recent().size(), 8);
  EXPECT_EQ(recent()[0]->text(), folder_.filePath("1.json"));
}

}  // namespace
}  // namespace carom
