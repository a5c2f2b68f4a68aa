#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/lab/export_dialog.h"
#include "app/lab/lab_window.h"
#include "app/lab/report_dialog.h"
#include "tests/support/faults.h"
#include "tests/support/source_folder.h"
#include "tests/support/wait.h"

namespace carom {
namespace {

// Saving over existing files.
class LabOutputs : public testing::Test {
 protected:
  void SetUp() override {
    window_.resize(1000, 700);
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
    ASSERT_TRUE(QFile::copy(test::preset_file("bounces/bouncing-ball.json").c_str(), path("mine.json")));
    ASSERT_TRUE(window_.open(path("mine.json").toStdString()));
    window_.run_until(0.5);
  }
  [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }
  [[nodiscard]] QByteArray read(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  // Triggers an action of the menus and gives `file` to the file dialog. Returns the texts of message boxes,
  // except the question whether to replace a file, which is answered with yes.
  QString say(const QString& action, const QString& file) {
    QString said;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
      QWidget* dialog = QApplication::activeModalWidget();
      if (auto* what = qobject_cast<ExportDialog*>(dialog)) {
        what->accept();
      } else if (auto* report = qobject_cast<ReportDialog*>(dialog)) {
        report->accept();
      } else if (auto* where = qobject_cast<QFileDialog*>(dialog)) {
        where->setDirectory(QFileInfo(path(file)).path());
        where->findChild<QLineEdit*>("fileNameEdit")->setText(QFileInfo(path(file)).fileName());
        QMetaObject::invokeMethod(where, "accept", Qt::QueuedConnection);
      } else if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
        if (QAbstractButton* yes = box->button(QMessageBox::Yes)) {
          yes->click();
        } else {
          said += box->text();
          box->accept();
        }
      }
    });
    timer.start(30);
    for (QAction* each : window_.findChildren<QAction*>()) {
      if (each->text().remove('&') == action) {
        each->trigger();
        break;
      }
    }
    // Dialogs may follow one another within one turn of the event loop.
    const bool done = test::wait_until([] {
      QApplication::processEvents();
      return QApplication::activeModalWidget() == nullptr;
    });
    EXPECT_TRUE(done) << action.toStdString();
    return said;
  }

  QTemporaryDir folder_;
  LabWindow window_{light_theme()};
};

struct Export {
  const char* action;
  const char* suffix;
};
constexpr Export kExports[] = {{"Save the picture of the scene...", "png"},
                               {"Save the picture of the scene...", "pdf"},
                               {"Save data...", "csv"},
                               {"Lab report...", "pdf"}};

TEST_F(LabOutputs, ExportsNeverTakeThePlaceOfTheOpenPreset) {
  const QByteArray preset = read("mine.json");
  for (const auto& [action, suffix] : kExports) {
    const QString link = QString("link.%1").arg(suffix);
    QFile::remove(path(link));
    ASSERT_TRUE(QFile::link(path("mine.json"), path(link)));
    EXPECT_TRUE(say(action, link).contains("this is the file that is read")) << action;
    EXPECT_EQ(read("mine.json"), preset) << action;
    EXPECT_EQ(say(action, QString("other.%1").arg(suffix)), "") << action;
    EXPECT_GT(read(QString("other.%1").arg(suffix)).size(), 500) << action;
    QFile::remove(path(QString("other.%1").arg(suffix)));
  }
}

TEST_F(LabOutputs, OnAFullDiskOldFilesStay) {
  const test::SmallDisk disk(path("disk").toStdString(), 1 << 20);
  if (!disk.mounted()) GTEST_SKIP() << "no disk may be mounted here";
  ASSERT_TRUE(QFile::copy(path("mine.json"), path("disk/mine.json")));
  ASSERT_TRUE(window_.open(path("disk/mine.json").toStdString()));
  window_.run_until(0.5);
  for (const char* suffix : {"png", "pdf", "csv"})
    ASSERT_TRUE(QFile::copy(path("mine.json"), path(QString("disk/old.%1").arg(suffix))));
  disk.fill();
  for (const auto& [action, suffix] : kExports) {
    const QString old = QString("disk/old.%1").arg(suffix);
    EXPECT_TRUE(say(action, old).contains("No space left on device")) << action;
    EXPECT_EQ(read(old), read("mine.json")) << action;
  }
  EXPECT_TRUE(say("Save", "").contains("No space left on device"));
  EXPECT_EQ(read("disk/mine.json"), read("mine.json"));
  const QStringList left = QDir(path("disk")).entryList(QDir::Files | QDir::Hidden);
  EXPECT_EQ(left, (QStringList{"fill", "mine.json", "old.csv", "old.pdf", "old.png"}))
      << left.join(' ').toStdString();
}

}  // namespace
}  // namespace carom
