#include <QApplication>
#include <cstring>
#include <gtest/gtest.h>

#include "app/cli/standard_output.h"
#include "tests/app/lab/killed_starts.h"
#include "tests/app/lab/late_discs.h"
#include "widgets/print/print_blocks.h"

namespace {

// Saves reports of two lengths in turn until it is killed: the child process of a test.
int write_reports(const QString& file) {
  const auto pages_of = [](int count) {
    std::vector<carom::PrintBlock> blocks;
    for (int i = 0; i < 40 * count; ++i)
      blocks.push_back(carom::print_text(QString("Line %1").arg(i), carom::print_font(20), Qt::black));
    return carom::PrintPages(std::move(blocks), "Carom");
  };
  const carom::PrintPages reports[] = {pages_of(1), pages_of(2)};
  QString error;
  for (int i = 0; reports[i % 2].save(file, "A report", &error); ++i) {
  }
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // Also needed to list the tests, which runs without their environment.
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  qunsetenv("CAROM_PRESETS");
  const QApplication application(argc, argv);
  if (argc == 3 && std::strcmp(argv[1], "--write-reports") == 0) {
    carom::prepare_process();
    return write_reports(argv[2]);
  }
  if (argc == 3 && std::strcmp(argv[1], "--keep-late-discs") == 0) return carom::keep_late_discs(argv[2]);
  if (argc == 3 && std::strcmp(argv[1], "--keep-starts") == 0) return carom::keep_starts(argv[2]);
  return RUN_ALL_TESTS();
}
