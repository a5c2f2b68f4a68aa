#include <QImage>
#include <set>

#include "tests/support/program.h"

namespace carom {
namespace {

std::size_t colours_of(const QImage& image) {
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, y));
  }
  return colours.size();
}

class CommandPicture : public testing::Test {
 protected:
  void draw(const QStringList& arguments) const {
    const ProgramResult result = carom_(QStringList{"picture"} + arguments);
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
  }
  [[nodiscard]] QImage image(const QString& name) const { return QImage(carom_.path(name)); }
  Program carom_;
};

TEST_F(CommandPicture, PngIsDrawnWithoutADisplay) {
  draw({"head-on", "-o", "scene.png"});
  EXPECT_EQ(image("scene.png").size(), QSize(1280, 800));
  EXPECT_GT(colours_of(image("scene.png")), 3U);
  EXPECT_EQ(carom_.files(), QStringList{"scene.png"});
}

TEST_F(CommandPicture, MomentSizeAndColoursAreChosen) {
  draw({"head-on", "--at", "0", "-o", "start.png", "--width", "400", "--height", "300"});
  draw({"head-on", "-o", "end.png", "--width", "400", "--height", "300"});
  draw({"head-on", "-o", "dark.png", "--width", "400", "--height", "300", "--dark"});
  EXPECT_EQ(image("start.png").size(), QSize(400, 300));
  EXPECT_NE(image("start.png"), image("end.png"));
  EXPECT_LT(image("dark.png").pixelColor(2, 2).lightnessF(), 0.4F);
  EXPECT_GT(image("end.png").pixelColor(2, 2).lightnessF(), 0.6F);
}

TEST_F(CommandPicture, MethodIsChosen) {
  const QStringList options{"spring-box", "--width", "400", "--height", "300"};
  draw(options + QStringList{"-o", "rk4.png", "--integrator", "rk4"});
  draw(options + QStringList{"-o", "euler.png", "--integrator", "explicit-euler", "--step", "0.05"});
  EXPECT_NE(image("rk4.png"), image("euler.png"));
}

TEST_F(CommandPicture, SvgHasTheScenesShapes) {
  draw({"head-on", "-o", "scene.svg"});
  const QByteArray svg = carom_.read("scene.svg");
  EXPECT_TRUE(svg.contains("<svg"));
  EXPECT_TRUE(svg.contains("<path") || svg.contains("<ellipse") || svg.contains("<circle"));
  EXPECT_TRUE(svg.trimmed().endsWith("</svg>"));
}

TEST_F(CommandPicture, PdfIsOnePage) {
  draw({"head-on", "-o", "scene.pdf"});
  const QByteArray pdf = carom_.read("scene.pdf");
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  EXPECT_TRUE(pdf.trimmed().endsWith("%%EOF"));
  EXPECT_TRUE(pdf.contains("/Count 1"));
  EXPECT_GT(pdf.size(), 1000);
}

TEST_F(CommandPicture, WindowIsDrawnWhole) {
  draw({"head-on", "--window", "-o", "window.png"});
  EXPECT_EQ(image("window.png").size(), QSize(1280, 800));
  EXPECT_GT(colours_of(image("window.png")), 30U);
  draw({"head-on", "--window", "--at", "0", "-o", "start.png"});
  EXPECT_NE(image("window.png"), image("start.png"));
}

TEST_F(CommandPicture, LabWithoutADisplayPrintsTheRunAndAPicture) {
  const ProgramResult result = carom_({});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("There is no display"), std::string::npos);
  EXPECT_NE(result.out.find("kinetic energy / J"), std::string::npos);
  const std::string mark = "picture of the lab: ";
  const auto at = result.out.find(mark);
  ASSERT_NE(at, std::string::npos) << result.out;
  const QString file = QString::fromStdString(result.out.substr(at + mark.size())).trimmed();
  EXPECT_EQ(QFileInfo(file).dir().canonicalPath(), QFileInfo(carom_.path("x")).dir().canonicalPath());
  EXPECT_EQ(QImage(file).size(), QSize(1280, 800));
  EXPECT_GT(colours_of(QImage(file)), 30U);
}

TEST_F(CommandPicture, LabWithoutADisplayRunsTheNamedExperiment) {
  const ProgramResult result = carom_({"head-on"});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.out.find("-1.42857"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace carom
