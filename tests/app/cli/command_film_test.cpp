#include <QImage>

#include "tests/support/program.h"

namespace carom {
namespace {

class CommandFilm : public testing::Test {
 protected:
  ProgramResult film(const QStringList& options) const {
    return carom_(QStringList{"film", "head-on", "--width", "320", "--height", "240"} + options);
  }
  [[nodiscard]] QStringList frames(const QString& folder) const {
    return QDir(carom_.path(folder)).entryList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot | QDir::Hidden);
  }
  Program carom_;
};

// One file for each time, with the picture of that time: at steps' ends, between them, before and after the
// impact.
TEST_F(CommandFilm, FramesAreThePicturesOfTheirMoments) {
  const ProgramResult result =
      film({"--from", "0.2", "--to", "0.8", "--rate", "20", "--speed", "0.5", "-o", "new/frames"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("25 frames in new/frames"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("ffmpeg -framerate 20 -i frame-%04d.png"), std::string::npos) << result.out;
  const QStringList files = frames("new/frames");
  ASSERT_EQ(files.size(), 25);
  EXPECT_EQ(files.front(), "frame-0001.png");
  EXPECT_EQ(files.back(), "frame-0025.png");
  for (const int frame : {1, 6, 14, 25}) {
    const QString time = QString::number(0.2 + 0.025 * (frame - 1));
    carom_({"picture", "head-on", "--at", time, "--width", "320", "--height", "240", "-o", "moment.png"});
    const QImage moment(carom_.path("moment.png"));
    ASSERT_EQ(moment.size(), QSize(320, 240));
    EXPECT_EQ(QImage(carom_.path("new/frames/" + files[frame - 1])), moment) << time.toStdString();
  }
}

TEST_F(CommandFilm, FramesThatAreThereStayUnlessTheyMayGo) {
  ASSERT_EQ(film({"--to", "0.2", "-o", "f"}).code, 0);
  EXPECT_EQ(frames("f").size(), 6);
  const QByteArray old = carom_.read("f/frame-0006.png");
  expect_refused(film({"--to", "0.08", "--dark", "-o", "f"}), "there are frames already");
  EXPECT_EQ(frames("f").size(), 6);
  EXPECT_EQ(carom_.read("f/frame-0006.png"), old);
  carom_.write("f/frame-of-mine.png", "kept");
  ASSERT_EQ(film({"--to", "0.08", "--dark", "--replace", "-o", "f"}).code, 0);
  EXPECT_EQ(frames("f"),
            (QStringList{"frame-0001.png", "frame-0002.png", "frame-0003.png", "frame-of-mine.png"}));
  EXPECT_LT(QImage(carom_.path("f/frame-0003.png")).pixelColor(2, 2).lightnessF(), 0.4F);
}

TEST_F(CommandFilm, SaysWhatIsWrong) {
  expect_refused(film({"--from", "2", "--to", "1", "-o", "f"}), "to: 1 is not allowed");
  expect_refused(film({"--rate", "0", "-o", "f"}), "frames a second: 0 is not allowed");
  expect_refused(film({"--speed", "-1", "-o", "f"}), "speed: -1 is not allowed");
  expect_refused(film({"--to", "1e6", "-o", "f"}), "up to 100000");
  expect_refused(carom_({"film", "head-on", "--width", "301", "-o", "f"}), "an even number");
  carom_.write("file", "no folder");
  expect_refused(film({"-o", "file/f"}), "file/f: no frames can be written there");
  EXPECT_EQ(carom_.files(), QStringList{"file"});
}

}  // namespace
}  // namespace carom
