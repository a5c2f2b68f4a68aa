#include "app/export/lab_report.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/lab/lab_window.h"
#include "app/lab/report_dialog.h"
#include "physics/scene/validate.h"
#include "tests/support/wait_events.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/scene/scene_view.h"

namespace carom {
namespace {

std::optional<PrintPages> pages_of(const LabReport& report) {
  const auto moments = report_moments(report, [](double) { return true; });
  return moments ? std::optional(report_pages(report, *moments)) : std::nullopt;
}

TEST(ReportTimes, AreAboutTheFirstImpact) {
  Method method;
  method.step = 0.005;
  using Times = std::vector<double>;
  const Times located = report_times(method, 0.45123, 2.0);
  ASSERT_EQ(located.size(), 4U);
  EXPECT_EQ(located[0], 0.0);
  EXPECT_DOUBLE_EQ(located[1], 0.451);
  EXPECT_DOUBLE_EQ(located[2], 0.452);
  EXPECT_EQ(located[3], 2.0);
  // An impact at a round time is between the moments before and after it.
  EXPECT_DOUBLE_EQ(report_times(method, 0.45, 2.0)[1], 0.449);
  EXPECT_DOUBLE_EQ(report_times(method, 0.45, 2.0)[2], 0.451);
  EXPECT_EQ(report_times(method, std::nullopt, 3.0), (Times{0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(report_times(method, 0.0001, 0.0005), (Times{0.0, 0.0005})) << "none beyond the run";
  // With impacts at the step's end: the step before, and this one.
  method.impacts = ImpactsId::kStepEnd;
  EXPECT_DOUBLE_EQ(report_times(method, 0.45, 2.0)[1], 0.445);
  EXPECT_DOUBLE_EQ(report_times(method, 0.45, 2.0)[2], 0.45);
}

TEST(ReportTimes, AreReadAsPeopleWriteThem) {
  using Times = std::vector<double>;
  EXPECT_EQ(times_of("0; 0.25;1.5", 2.0), (Times{0.0, 0.25, 1.5}));
  EXPECT_EQ(times_of("1.5, 0.25, 0, 0.25", 2.0), (Times{0.0, 0.25, 1.5}));
  EXPECT_EQ(times_of(" 0,25  1,5 ", 2.0), (Times{0.25, 1.5}));
  EXPECT_EQ(times_of("", 2.0), Times());
  for (const char* bad : {"0; x", "-1", "2.5", "nan", "1..2"})
    EXPECT_THROW((void)times_of(bad, 2.0), SceneError) << bad;
  EXPECT_THROW((void)times_of("0 .1 .2 .3 .4 .5 .6 .7 .8 .9 1 1.1 1.2", 2.0), SceneError);
}

class LabReportTest : public testing::Test {
 protected:
  void SetUp() override {
    window_.resize(1280, 800);
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }
  // Makes the report through its dialogs, like a user.
  void make(const QString& file, const std::function<void(ReportDialog&)>& fill = {}) {
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, [&] {
      QWidget* dialog = QApplication::activeModalWidget();
      if (auto* report = qobject_cast<ReportDialog*>(dialog)) {
        if (fill) fill(*report);
        report_ = report->report();
        report->accept();
      } else if (auto* where = qobject_cast<QFileDialog*>(dialog)) {
        suggested_ = where->findChild<QLineEdit*>("fileNameEdit")->text();
        where->setDirectory(dir_.path());
        where->findChild<QLineEdit*>("fileNameEdit")->setText(file);
        QMetaObject::invokeMethod(where, "accept", Qt::QueuedConnection);
      } else if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
        said_ = box->text();
        box->accept();
      }
    });
    answer.start(50);
    report_.reset();
    for (QAction* action : window_.findChildren<QAction*>()) {
      if (action->text().remove('&') == "Lab report...") action->trigger();
    }
    // A playing run is paused first.
    ASSERT_TRUE(test::wait_in_event_loop([&] { return report_ || !said_.isEmpty(); }));
    ASSERT_TRUE(test::wait_in_event_loop([&] { return QApplication::activeModalWidget() == nullptr; }));
  }
  [[nodiscard]] QByteArray bytes(const QString& file) const {
    QFile pdf(dir_.filePath(file));
    return pdf.open(QIODevice::ReadOnly) ? pdf.readAll() : QByteArray();
  }
  [[nodiscard]] static QImage page(const PrintPages& pages, int number) {
    QImage image(static_cast<int>(PrintPages::kWidth), static_cast<int>(PrintPages::kHeight),
                 QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    pages.paint(number, painter);
    return image;
  }

  LabWindow window_{dark_theme()};
  QTemporaryDir dir_;
  std::optional<LabReport> report_;
  QString said_;
  QString suggested_;
};

TEST_F(LabReportTest, IsAPdfOfVectorsAndText) {
  ASSERT_TRUE(window_.open("bouncing-ball"));
  window_.run_until(1.5);
  make("ball.pdf");
  const QByteArray pdf = bytes("ball.pdf");
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  EXPECT_TRUE(pdf.trimmed().endsWith("%%EOF"));
  EXPECT_TRUE(pdf.contains("/ToUnicode")) << "text can be selected";
  EXPECT_FALSE(pdf.contains("/Subtype /Image"));
  EXPECT_EQ(suggested_, "bouncing-ball.pdf");
  const std::optional<PrintPages> pages = pages_of(*report_);
  ASSERT_TRUE(pages);
  EXPECT_TRUE(pdf.contains(QString("/Count %1").arg(pages->count()).toLatin1()));
  ASSERT_EQ(report_->times.size(), 4U);
  ASSERT_TRUE(report_->first_impact);
  EXPECT_NEAR(*report_->first_impact, 0.45, 0.1);
  EXPECT_EQ(moment_text(report_->times[1], *report_), "just before the first impact");
  EXPECT_EQ(moment_text(report_->times[2], *report_), "just after the first impact");
  EXPECT_EQ(moment_text(report_->times[3], *report_), "end");
}

// A ball that is dropped and ends at rest: nothing but its impact tells of momentum.
TEST_F(LabReportTest, BeforeAndAfterAreThoseOfTheFirstImpact) {
  ASSERT_TRUE(window_.open("bouncing-ball"));
  window_.run_until(1.5);
  make("ball.pdf");
  const auto moments = report_moments(*report_, [](double) { return true; });
  ASSERT_TRUE(moments && moments->first_impact);
  const JumpMoment& impact = *moments->first_impact;
  const Scene& scene = window_.preset().scene;
  const auto ball = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                 [](const Body& body) { return !has_infinite_mass(body); });
  const BodyIndex index{static_cast<int>(ball - scene.bodies.begin())};
  const double speed = -scene.forces.gravity.y() * impact.time();
  EXPECT_NEAR(impact.before().velocity(index).y(), -speed, 1e-9);
  EXPECT_NEAR(impact.after().velocity(index).y(), 0.8 * speed, 1e-9);
  // Without an impact, since the start.
  LabReport until = *report_;
  until.first_impact.reset();
  EXPECT_FALSE(report_moments(until, [](double) { return true; })->first_impact);
}

// On white, whatever the window's colours; nothing extends beyond the margins.
TEST_F(LabReportTest, KeepsItsMargins) {
  for (const char* name : {"bouncing-ball", "newtons-cradle-hung", "billiard-break", "drag-projectile"}) {
    ASSERT_TRUE(window_.open(name));
    window_.run_until(0.7);
    make(QString(name) + ".pdf");
    const std::optional<PrintPages> pages = pages_of(*report_);
    ASSERT_TRUE(pages);
    EXPECT_GE(pages->count(), 3) << name;
    for (int number = 0; number < pages->count(); ++number) {
      const QImage image = page(*pages, number);
      int ink = 0;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          if (image.pixelColor(x, y).lightness() > 240) continue;
          ++ink;
          ASSERT_GE(x, PrintPages::kSide - 2.0) << name << ", page " << number + 1 << ", y " << y;
          ASSERT_LE(x, PrintPages::kSide + PrintPages::kTextWidth + 2.0) << name << ", page " << number + 1;
          ASSERT_GE(y, PrintPages::kTop - 2.0) << name << ", page " << number + 1;
          ASSERT_LE(y, PrintPages::kHeight - 20.0) << name << ", page " << number + 1;
        }
      }
      EXPECT_GT(ink, 3000) << name << ", page " << number + 1;
      EXPECT_LT(ink, image.width() * image.height() / 4) << name << ", page " << number + 1;
    }
  }
}

TEST_F(LabReportTest, HasWhatIsAskedFor) {
  ASSERT_TRUE(window_.open("bouncing-ball"));
  window_.run_until(1.0);
  make("all.pdf");
  const int all = pages_of(*report_)->count();
  make("few.pdf", [](ReportDialog& dialog) {
    dialog.findChild<QLineEdit*>("times")->setText("0.1, 0.2");
    dialog.findChild<QPlainTextEdit*>("questions")->setPlainText("Only this?\n\n");
    for (QCheckBox* part : dialog.findChildren<QCheckBox*>()) part->setChecked(false);
  });
  EXPECT_EQ(report_->times, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(report_->questions, QStringList{"Only this?"});
  EXPECT_TRUE(report_->plots.empty());
  EXPECT_EQ(report_->bodies, nullptr);
  const std::optional<PrintPages> few = pages_of(*report_);
  EXPECT_LT(few->count(), all);
  EXPECT_FALSE(report_moments(*report_, [](double) { return false; })) << "cancelled";
}

TEST_F(LabReportTest, SaysWhatIsMissing) {
  ASSERT_TRUE(window_.open("bouncing-ball"));
  ASSERT_TRUE(test::wait_in_event_loop([&] { return window_.frame() != nullptr; }));
  make("none.pdf");
  EXPECT_TRUE(said_.contains("play it first")) << said_.toStdString();
  EXPECT_FALSE(report_);
  window_.run_until(0.3);
  make("no-such-folder/report.pdf");
  EXPECT_TRUE(bytes("no-such-folder/report.pdf").isEmpty());
}

TEST_F(LabReportTest, IsOfTheShownMomentOrOfTheWholeRun) {
  ASSERT_TRUE(window_.open("bouncing-ball"));
  window_.run_until(1.5);
  QString only_end;
  const auto choose = [&](int end) {
    return [&only_end, end](ReportDialog& dialog) {
      auto* ends = dialog.findChild<QComboBox*>("end");
      const bool offered = ends->model()->index(1, 0).flags().testFlag(Qt::ItemIsEnabled);
      only_end = offered ? QString() : ends->toolTip();
      ends->setCurrentIndex(end);
    };
  };
  make("newest.pdf", choose(0));
  EXPECT_TRUE(only_end.contains("go there by the timeline")) << "nothing else is shown";
  LabRuns& runs = window_.session().runs();
  runs.go_to(0.3);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return runs.there(); }));
  make("shown.pdf", choose(1));
  EXPECT_TRUE(only_end.isEmpty());
  EXPECT_TRUE(report_->until_shown);
  EXPECT_NEAR(report_->ends.front().time, 0.3, 1e-9);
  EXPECT_NEAR(report_->times.back(), 0.3, 1e-9);
  EXPECT_EQ(moment_text(report_->times.back(), *report_), "shown moment");
  EXPECT_FALSE(report_->first_impact) << "it comes later";
  EXPECT_TRUE(runs.in_past()) << "the playhead stays";
  make("whole.pdf", choose(0));
  EXPECT_FALSE(report_->until_shown);
  EXPECT_NEAR(report_->ends.front().time, 1.5, 1e-9);
  EXPECT_FALSE(runs.in_past()) << "its plots have no line";
  EXPECT_GT(bytes("shown.pdf").size(), 1000);
}

// A body that a file lets come in later, a method, and edits of the scene, which the undo menu names.
TEST(ReportEdits, AreNamed) {
  const auto mass = [](double kilograms) {
    Body body;
    body.mass = kilograms;
    return SceneEdits{Replace<Body>{body}};
  };
  Body late;
  late.name = "late ball";
  LabReport report;
  report.runs.resize(1);
  report.runs.front().edits = {{0.1, 0, SceneEdits{Add<Body>{late}}},
                               {0.2, 3, Method{.integrator = IntegratorId::kExplicitEuler}},
                               {0.5, 7, mass(2.0)},
                               {0.5, 7, mass(3.0)},
                               {0.6, 8, SceneEdits{SetForces{}}},
                               {0.7, 9, SceneEdits{Remove<Joint>{}}},
                               {0.9, 10, SceneEdits{SetLaws{}}}};
  report.ends.resize(1);
  report.ends.front().time = 0.8;
  report.edit_names = {{7, "Mass of A 1 → 3 kg"}, {8, "Gravity of the Moon"}};
  QStringList lines = edit_lines(report);
  ASSERT_EQ(lines.size(), 5);
  EXPECT_TRUE(lines.takeAt(1).startsWith("from t = 0.2 s: Explicit Euler, "));
  EXPECT_EQ(lines, QStringList({"from t = 0.1 s: late ball added", "from t = 0.5 s: Mass of A 1 → 3 kg",
                                "from t = 0.6 s: Gravity of the Moon", "from t = 0.7 s: change of the scene"}));
}

TEST(ReportEdits, AreAsManyAsAPageHasRoomFor) {
  LabReport report;
  report.runs.resize(1);
  report.ends.resize(1);
  report.ends.front().time = 20.0;
  for (int i = 1; i <= 15; ++i) report.runs.front().edits.push_back({1.0 * i, 0, Method()});
  const QStringList lines = edit_lines(report);
  EXPECT_EQ(lines.size(), 13);
  EXPECT_EQ(lines.last(), "and 3 more");
}

TEST_F(LabReportTest, NamesTheEditsOfTheRun) {
  ASSERT_TRUE(window_.open("bouncing-ball"));
  window_.run_until(0.5);
  Session& session = window_.session();
  const Scene scene = *session.runs().scene();
  Body ball = scene.bodies.back();
  for (const double mass : {2.0, 3.0}) {  // as a slider does
    ball.mass = mass;
    session.edit({Replace<Body>{ball}}, "Mass of the ball", 5);
  }
  Material rubber = scene.materials.front();
  rubber.restitution = 0.5;
  session.edit({Replace<Material>{rubber}}, "Restitution of rubber");
  SetForces moon = scene.forces;
  moon.gravity.y() = -1.62;
  session.edit({moon}, "Gravity of the Moon");
  window_.run_until(1.0);
  make("edited.pdf");
  ASSERT_TRUE(report_);
  EXPECT_EQ(edit_lines(*report_),
            QStringList({"from t = 0.5 s: Mass of the ball", "from t = 0.5 s: Restitution of rubber",
                         "from t = 0.5 s: Gravity of the Moon"}));
  EXPECT_TRUE(bytes("edited.pdf").startsWith("%PDF-")) << said_.toStdString();
}

// A playing run is paused for its report: everything in it has one time.
TEST_F(LabReportTest, IsOfOneMoment) {
  ASSERT_TRUE(window_.open("bouncing-ball"));
  QTest::keyClick(&window_.scene_view(), Qt::Key_Space);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return window_.frame() && window_.frame()->time > 0.1; }));
  make("now.pdf");
  ASSERT_TRUE(report_);
  EXPECT_FALSE(window_.frame()->playing);
  EXPECT_EQ(report_->ends.front().time, window_.frame()->time);
  EXPECT_EQ(report_->times.back(), report_->ends.front().time);
}

}  // namespace
}  // namespace carom
