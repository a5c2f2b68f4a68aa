#include <QCoreApplication>
#include <QElapsedTimer>
#include <csignal>
#include <map>
#include <random>

#include "tests/support/faults.h"
#include "tests/support/program.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

// A command killed at any time leaves each file in its old or its new version, and beside them at most
// temporary files. The time of each kill is random; the conditions hold for every time.
class OutputKills : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(QFile::copy(test::preset_file("first-collisions/head-on.json").c_str(), carom_.path("a.json")));
    environment_.remove("DISPLAY");
    environment_.remove("WAYLAND_DISPLAY");
    environment_.remove("QT_QPA_PLATFORM");
  }

  // `old_way` and `new_way` write the same files in the folder "out".
  void shoot(const QStringList& old_way, const QStringList& new_way, int times) {
    const auto files_after = [&](const QStringList& arguments) {
      EXPECT_EQ(carom_(arguments).code, 0);
      return files();
    };
    ASSERT_TRUE(QDir(carom_.path("")).mkpath("out"));
    const std::map<QString, QByteArray> old_files = files_after(old_way);
    QElapsedTimer clock;
    clock.start();
    const std::map<QString, QByteArray> new_files = files_after(new_way);
    const auto whole = static_cast<unsigned>(1000 * clock.elapsed() * 5 / 4 + 1);  // us, with a margin
    ASSERT_FALSE(old_files.empty());
    ASSERT_NE(old_files, new_files);
    std::mt19937 random(static_cast<unsigned>(new_way.size()));
    for (int k = 0; k < times; ++k) {
      QDir(carom_.path("out")).removeRecursively();
      ASSERT_TRUE(QDir(carom_.path("")).mkpath("out"));
      for (const auto& [name, bytes] : old_files) carom_.write("out/" + name, bytes);
      QProcess process;
      process.setProcessEnvironment(environment_);
      process.setWorkingDirectory(carom_.path(""));
      process.start(Program::file(), new_way);
      ASSERT_TRUE(process.waitForStarted());
      usleep(static_cast<useconds_t>(random() % whole));
      kill(static_cast<pid_t>(process.processId()), SIGKILL);
      ASSERT_TRUE(process.waitForFinished());
      std::map<QString, QByteArray> left = files();
      for (const auto& [name, bytes] : old_files) {
        ASSERT_TRUE(left[name] == bytes || left[name] == new_files.at(name))
            << name.toStdString() << " is neither the old one nor the new one, shot " << k;
        left.erase(name);
      }
      for (const auto& [name, bytes] : left) {
        EXPECT_TRUE(name.startsWith(".carom-") && name.endsWith(".part")) << name.toStdString() << " stayed";
      }
    }
  }

  [[nodiscard]] std::map<QString, QByteArray> files() const {
    std::map<QString, QByteArray> all;
    for (const QString& name : QDir(carom_.path("out")).entryList(QDir::Files | QDir::Hidden))
      all[name] = carom_.read("out/" + name);
    return all;
  }

  Program carom_;

 private:
  QProcessEnvironment environment_ = QProcessEnvironment::systemEnvironment();
};

TEST_F(OutputKills, Saving) {
  shoot({"run", "a.json", "--until", "0.5", "--save", "out/s.json"}, {"run", "a.json", "--save", "out/s.json"},
        test::kills(20));
}

TEST_F(OutputKills, WritingCsv) {
  shoot({"run", "a.json", "--csv", "out/x.csv", "--events", "out/e.csv", "--step", "0.002"},
        {"run", "a.json", "--csv", "out/x.csv", "--events", "out/e.csv", "--step", "0.0001"}, test::kills(20));
}

TEST_F(OutputKills, Filming) {
  const QStringList film = {"film",     "a.json", "--to",      "0.4", "--width", "200",
                            "--height", "200",    "--replace", "-o",  "out"};
  shoot(film, film + QStringList{"--dark"}, test::kills(20));
}

// The lab's report, written by a process that writes nothing else.
TEST_F(OutputKills, ReportsOfTheLab) {
  ASSERT_TRUE(QDir(carom_.path("")).mkpath("out"));
  carom_.write("out/report.pdf", "old");
  std::mt19937 random(3);
  for (int k = 0; k < test::kills(20); ++k) {
    QProcess process;
    process.start(QCoreApplication::applicationFilePath(), {"--write-reports", carom_.path("out/report.pdf")});
    ASSERT_TRUE(process.waitForStarted());
    usleep(static_cast<useconds_t>(random() % 400'000));
    kill(static_cast<pid_t>(process.processId()), SIGKILL);
    ASSERT_TRUE(process.waitForFinished());
    const QByteArray left = carom_.read("out/report.pdf");
    const bool pdf = left.startsWith("%PDF-") && left.endsWith("%%EOF\n") && left.contains("/Count ");
    ASSERT_TRUE(left == "old" || pdf) << left.size() << " bytes, shot " << k;
    for (const auto& [name, bytes] : files()) {
      if (name != "report.pdf") {
        EXPECT_TRUE(name.endsWith(".part")) << name.toStdString();
        QFile::remove(carom_.path("out/" + name));
      }
    }
  }
}

}  // namespace
}  // namespace carom
