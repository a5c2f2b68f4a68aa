#include <QImage>
#include <QXmlStreamReader>
#include <array>
#include <set>

#include "tests/support/program.h"

namespace carom {
namespace {

// A study of few short runs.
const QStringList kQuick = {"study",         "drag-projectile",
                            "--integrators", "explicit-euler,rk4",
                            "--steps",       "0.02,0.01,0.005",
                            "--repeats",     "1",
                            "--threads",     "2"};

QList<QStringList> rows_of(const QByteArray& csv) {
  QList<QStringList> rows;
  for (const QByteArray& line : csv.trimmed().split('\n')) rows.append(QString::fromUtf8(line).split(','));
  return rows;
}

TEST(CommandStudy, WritesTheColumnsThatOthersRelyOn) {
  const Program carom;
  const ProgramResult result = carom(kQuick + QStringList{"--csv", "s.csv"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const QList<QStringList> rows = rows_of(carom.read("s.csv"));
  const QStringList expected = {"integrator",
                                "impacts",
                                "contacts",
                                "step [s] or tolerance [m]",
                                "position error [m]",
                                "velocity error [m/s]",
                                "energy error [J]",
                                "impact-time error [s]",
                                "wall time [s]",
                                "evaluations [1]",
                                "number of impacts [1]",
                                "fitted order [1]"};
  EXPECT_EQ(rows.front().first(expected.size()), expected);
  ASSERT_EQ(rows.size(), 1 + 2 * 2 * 3);
  const QStringList& last = rows.back();
  EXPECT_EQ(last.first(4), (QStringList{"rk4", "located", "impulse", "0.005"}));
  EXPECT_LT(last[4].toDouble(), 1e-9);
  EXPECT_GT(last[4].toDouble(), 0.0);
  EXPECT_GT(last[8].toDouble(), 0.0);
  EXPECT_GE(last[9].toLongLong(), 4 * 400);
  EXPECT_EQ(last[10], "7");
  EXPECT_NEAR(last[11].toDouble(), 4.0, 0.15);
  EXPECT_NE(result.out.find("RK4, impacts at their own time: order 3.99 ± "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("not chaotic"), std::string::npos);
}

TEST(CommandStudy, DrawsPicturesWithoutADisplay) {
  const Program carom;
  for (const char* name : {"s.svg", "s.pdf", "s.png"}) {
    const ProgramResult result = carom(kQuick + QStringList{"--plot", name});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
  }
  const QImage image(carom.path("s.png"));
  EXPECT_GT(image.width(), 1000);
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); y += 2) {
    for (int x = 0; x < image.width(); x += 2) colours.insert(image.pixel(x, y));
  }
  EXPECT_GT(colours.size(), 50U);

  QXmlStreamReader svg(carom.read("s.svg"));
  QString words;
  while (!svg.atEnd()) {
    if (svg.readNext() == QXmlStreamReader::Characters) words += svg.text().toString() + ' ';
  }
  EXPECT_FALSE(svg.hasError()) << svg.errorString().toStdString();
  for (const char* word : {"Projectile with drag", "RK4", "Explicit Euler", "order 4", "wall time"}) {
    EXPECT_TRUE(words.contains(word)) << word;
  }
  const QByteArray pdf = carom.read("s.pdf");
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  EXPECT_TRUE(pdf.contains("/Count 1"));
  EXPECT_GT(pdf.size(), 5000);
}

struct BadStudy {
  const char* name;
  const char* arguments;
  const char* part;
};

void PrintTo(const BadStudy& study, std::ostream* out) { *out << study.arguments; }

class BadStudies : public testing::TestWithParam<BadStudy> {};

TEST_P(BadStudies, AreRefusedInOneLine) {
  const Program carom;
  expect_refused(carom(QString(GetParam().arguments).split(' ')), GetParam().part);
  EXPECT_EQ(carom.files(), QStringList());
}

INSTANTIATE_TEST_SUITE_P(
    Calls, BadStudies,
    testing::ValuesIn(std::to_array<BadStudy>({
        {"Nothing", "study", "preset is required"},
        {"UnknownName", "study no-such", "no-such: no such file or experiment"},
        {"Integrator", "study head-on --integrators rk4,leapfrog", "leapfrog"},
        {"Impacts", "study head-on --impacts never", "located"},
        {"StepZero", "study head-on --steps 0.1,0", "--steps: 0 is not allowed"},
        {"StepWord", "study head-on --steps 0.1,small", "--steps: small is not allowed"},
        {"StepTwice", "study head-on --steps 0.1,0.1", "--steps: 0.1 comes twice"},
        {"Tolerance", "study head-on --tolerances nan", "--tolerances: nan is not allowed"},
        {"Until", "study head-on --until -1", "--until: -1 is not allowed"},
        {"UntilZero", "study head-on --until 0", "--until: 0 is not allowed"},
        {"Repeats", "study head-on --repeats 0", "--repeats"},
        {"Threads", "study head-on --threads 0", "--threads"},
        {"PlotSuffix", "study head-on --plot a.txt", "a.txt: not a kind of picture"},
        {"PlotUnwritable", "study head-on --integrators rk4 --steps 0.1 --repeats 1 --plot no/such/a.png",
         "no/such/a.png"},
        {"CsvUnwritable", "study head-on --csv no/such/a.csv", "no/such/a.csv"},
        {"ExactFlight", "study drag-projectile --integrators exact-flight",
         "exact flight is not possible with drag"},
        {"ExactAtStepEnd", "study head-on --integrators exact-flight --impacts step-end", "--impacts: "},
    })),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace carom
