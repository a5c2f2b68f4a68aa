#include "widgets/scene_export.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "tests/widgets/scene_fixture.h"

namespace carom {
namespace {

class SceneExport : public testing::Test {
 protected:
  bool save(const QString& name) {
    path_ = folder_.filePath(name);
    return save_scene_picture(*frame_of(Simulation(two_discs())), View{Vec2(2.0, 1.0), 6.0}, {}, light_theme(),
                              QSize(600, 400), path_, &error_);
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

TEST_F(SceneExport, PdfIsVectors) {
  ASSERT_TRUE(save("scene.pdf")) << error_.toStdString();
  const QByteArray text = bytes();
  EXPECT_TRUE(text.startsWith("%PDF-"));
  EXPECT_TRUE(text.contains("/MediaBox [0 0 450"));
  EXPECT_FALSE(text.contains("/Subtype /Image"));
}

TEST_F(SceneExport, SaysWhyItCannot) {
  EXPECT_FALSE(save("scene.bmp"));
  EXPECT_TRUE(error_.contains(".png, .svg or .pdf")) << error_.toStdString();
  EXPECT_FALSE(save("no-such-folder/scene.png"));
  EXPECT_FALSE(error_.isEmpty());
}

}  // namespace
}  // namespace carom
