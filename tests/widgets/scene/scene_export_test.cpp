#include "widgets/scene/scene_export.h"

#include <QFile>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <array>
#include <gtest/gtest.h>

#include "tests/support/scene_fixture.h"

namespace carom {
namespace {

class SceneExport : public testing::Test {
 protected:
  bool save(const QString& name) {
    path_ = folder_.filePath(name);
    return save_scene_picture(*frame_of(Simulation(setup_of(two_discs()))), View{Vec2(2.0, 1.0), 6.0}, {},
                              light_theme(), QSize(600, 400), path_, &error_);
  }
  [[nodiscard]] QByteArray bytes() const {
    QFile file(path_);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  }

  QTemporaryDir folder_;
  QString path_;
  QString error_;
};

TEST_F(SceneExport, PngHasThePixels) {
  ASSERT_TRUE(save("scene.png")) << error_.toStdString();
  const QImage image(path_);
  EXPECT_EQ(image.size(), QSize(600, 400));
  EXPECT_EQ(image.pixelColor(180, 210), light_theme().body_fill);
  EXPECT_EQ(image.pixelColor(300, 311), light_theme().wall_fill);
}

TEST_F(SceneExport, SvgIsVectors) {
  ASSERT_TRUE(save("scene.svg")) << error_.toStdString();
  const QByteArray text = bytes();
  EXPECT_TRUE(text.contains("<circle"));
  EXPECT_TRUE(text.contains("<text"));
  EXPECT_FALSE(text.contains("<image"));
}

// A name at the lower edge stands where the grid has a number.
TEST_F(SceneExport, NamesAreNotWrittenOverNumbers) {
  Preset preset = two_discs();
  preset.scene.bodies[1].position = Vec2(3.0, -0.35);  // its lowest point is at -0.85 m, of -1 m
  const auto numbers = [&](bool names) {
    DrawingOptions options;
    options.names = names;
    EXPECT_TRUE(save_scene_picture(*frame_of(Simulation(setup_of(preset))), View{Vec2(2.0, 1.0), 6.0}, options,
                                   light_theme(), QSize(600, 400), folder_.filePath("names.svg"), &error_));
    path_ = folder_.filePath("names.svg");
    static const QRegularExpression one(">\\s*3\\s*</text>");
    return QString::fromUtf8(bytes()).count(one);
  };
  const auto without = numbers(false);
  EXPECT_GT(without, 0);
  EXPECT_EQ(numbers(true), without - 1);
}

TEST_F(SceneExport, PdfIsVectors) {
  ASSERT_TRUE(save("scene.pdf")) << error_.toStdString();
  const QByteArray text = bytes();
  EXPECT_TRUE(text.startsWith("%PDF-"));
  EXPECT_TRUE(text.contains("/MediaBox [0 0 450"));
  EXPECT_FALSE(text.contains("/Subtype /Image"));
}

// Other runs of the scene are outlines, in the colours of their curves.
TEST_F(SceneExport, OtherRunsAreOutlines) {
  const Frame frame = *frame_of(Simulation(setup_of(two_discs())));
  Frame other = frame;
  other.state.q(0, 2) += 1.5;  // B, at the right
  const auto picture = [&](std::span<const Frame> others) {
    SceneLook look = scene_look(frame, View{Vec2(2.0, 1.0), 6.0}, {}, light_theme(), QSize(600, 400));
    QImage image(600, 400, QImage::Format_RGB32);
    QPainter painter(&image);
    paint_scene(painter, frame, look, others);
    return image;
  };
  const QImage alone = picture({});
  const QImage beside = picture(std::array{other});
  // B's outline stands at (550, 200) px with a radius of 25 px, in the second colour, a red one.
  EXPECT_EQ(alone.pixelColor(560, 190), beside.pixelColor(560, 190)) << "no fill";
  const QColor rim = beside.pixelColor(550, 175);
  EXPECT_GT(rim.red(), rim.blue() + 50);
  EXPECT_NE(alone.pixelColor(550, 175), rim);
}

// The same part of the world, and no less, on paper of another shape.
TEST_F(SceneExport, ALookFitsOtherSizes) {
  const Frame frame = *frame_of(Simulation(setup_of(two_discs())));
  const SceneLook look = scene_look(frame, View{Vec2(2.0, 1.0), 6.0}, {}, light_theme(), QSize(600, 400));
  const WorldRect seen = look.camera.visible();
  for (const QSizeF size : {QSizeF(300, 200), QSizeF(800, 100), QSizeF(100, 800)}) {
    const WorldRect now = on_viewport(look, size).camera.visible();
    EXPECT_LE(now.lower.x(), seen.lower.x() + 1e-9);
    EXPECT_LE(now.lower.y(), seen.lower.y() + 1e-9);
    EXPECT_GE(now.upper.x(), seen.upper.x() - 1e-9);
    EXPECT_GE(now.upper.y(), seen.upper.y() - 1e-9);
  }
}

TEST_F(SceneExport, SaysWhyItCannot) {
  EXPECT_FALSE(save("scene.bmp"));
  EXPECT_TRUE(error_.contains(".png, .svg or .pdf")) << error_.toStdString();
  EXPECT_FALSE(save("no-such-folder/scene.png"));
  EXPECT_FALSE(error_.isEmpty());
}

}  // namespace
}  // namespace carom
