#include "app/export/bins_export.h"

#include <QTemporaryDir>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "physics/scene/validate.h"

namespace carom {
namespace {

std::string content(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(BinsExport, HasEveryBinWithAllDigits) {
  const QTemporaryDir dir;
  const std::string file = dir.filePath("bins.csv").toStdString();
  const std::vector<double> speeds = {0.05, 0.25, 0.25};
  const std::vector<double> masses(3, 2.0);
  const Maxwell law(masses, speeds);
  export_bins({{"now", histogram_of(speeds, 0.1), law}, {"mean, of all", histogram_of(speeds, 0.2), {}}}, "m/s",
              file);
  const double first = law.share_below(0.1) * 3.0;
  std::istringstream lines(content(file));
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);) all.push_back(line);
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[0],
            "distribution,from [m/s],to [m/s],count [1],share over width [1/(m/s)],expected by Maxwell [1]");
  EXPECT_TRUE(all[1].starts_with("now,0,0.1,1,3.333333333333333")) << all[1];
  EXPECT_EQ(std::stod(all[1].substr(all[1].rfind(',') + 1)), first);
  EXPECT_TRUE(all[2].starts_with("now,0.1,0.2,0,0,")) << all[2];
  EXPECT_TRUE(all[4].starts_with("\"mean, of all\",0,0.2,1,")) << all[4];
  EXPECT_TRUE(all[4].ends_with(",")) << all[4];
}

TEST(BinsExport, CopiesWithTabs) {
  EXPECT_EQ(
      bins_table({{"impulses", histogram_of(std::vector<double>{0.5}, 1.0), {}}}, "N·s", '\t'),
      (std::vector<std::string>{"distribution\tfrom [N·s]\tto [N·s]\tcount [1]\tshare over width [1/(N·s)]",
                                "impulses\t0\t1\t1\t1"}));
}

TEST(BinsExport, WithoutALawThereIsNoColumnForIt) {
  const QTemporaryDir dir;
  const std::string file = dir.filePath("bins.csv").toStdString();
  export_bins({{"impulses", histogram_of(std::vector<double>{1.5}, 1.0), {}}}, "N·s", file);
  EXPECT_EQ(content(file),
            "distribution,from [N·s],to [N·s],count [1],share over width [1/(N·s)]\n"
            "impulses,0,1,0,0\nimpulses,1,2,1,1\n");
  EXPECT_THROW(export_bins({}, "m/s", dir.filePath("no/such/bins.csv").toStdString()), SceneError);
}

}  // namespace
}  // namespace carom
