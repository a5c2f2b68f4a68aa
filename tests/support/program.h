#pragma once

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <gtest/gtest.h>
#include <string>

namespace carom {

struct ProgramResult {
  int code = -1;  // exit code; -1 if the program crashed or did not end
  std::string out;
  std::string err;
};

// The carom program with its own working folder, in an environment without a display.
class Program {
 public:
  // It stands beside the tests.
  static QString file() { return QCoreApplication::applicationDirPath() + "/carom"; }
  ProgramResult operator()(const QStringList& arguments) const { return run(file(), arguments); }

  // Runs a shell line in the working folder, where $carom is the program.
  [[nodiscard]] ProgramResult shell(const QString& line) const { return run("/bin/bash", {"-c", line}); }

  // A file in the working folder.
  [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }
  [[nodiscard]] QByteArray read(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  void write(const QString& name, const QByteArray& bytes) const {
    QFile file(path(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    ASSERT_EQ(file.write(bytes), bytes.size());
  }
  [[nodiscard]] QStringList files() const { return QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden); }

 private:
  [[nodiscard]] ProgramResult run(const QString& program, const QStringList& arguments) const {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name :
         {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "QT_LOGGING_RULES", "CAROM_PRESETS"}) {
      environment.remove(name);
    }
    environment.insert("carom", file());
    QProcess process;
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(folder_.path());
    process.start(program, arguments);
    ProgramResult result;
    if (!process.waitForFinished(600'000)) {
      process.kill();
      process.waitForFinished();
    } else if (process.exitStatus() == QProcess::NormalExit) {
      result.code = process.exitCode();
    }
    result.out = process.readAllStandardOutput().toStdString();
    result.err = process.readAllStandardError().toStdString();
    return result;
  }

  QTemporaryDir folder_;
};

// Bad input: exit code 2, one line with `part` on stderr, nothing on stdout.
inline void expect_refused(const ProgramResult& result, const std::string& part) {
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.starts_with("carom: ")) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_LT(result.err.size(), 1000U);
  EXPECT_NE(result.err.find(part), std::string::npos) << "no \"" << part << "\" in " << result.err;
}

}  // namespace carom
