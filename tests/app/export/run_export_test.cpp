#include "app/export/run_export.h"

#include <QDir>
#include <QTemporaryDir>
#include <algorithm>
#include <charconv>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <vector>

#include "app/export/run_files.h"
#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "physics/scene/validate.h"
#include "physics/worker/live_run.h"
#include "tests/support/body_literal.h"

namespace carom {
namespace {

using namespace test::literals;

// Rows of fields.
std::vector<std::vector<std::string>> read(const std::string& file) {
  std::ifstream in(file);
  std::vector<std::vector<std::string>> lines;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string>& fields = lines.emplace_back();
    std::istringstream text(line);
    for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
    if (line.ends_with(',')) fields.emplace_back();
  }
  return lines;
}

double number(const std::string& text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_EQ(result.ptr, text.data() + text.size()) << text;
  return value;
}

Preset box() {
  Preset preset;
  preset.title = "box";
  preset.scene.materials = {{"default", 0.9, 0.0, 0.2, 0.2}};
  preset.scene.forces.gravity = {0.0, -9.81};
  preset.scene.forces.quadratic_drag = 0.01;
  for (int i = 0; i < 3; ++i) {
    Body body;
    body.name = std::string(1, static_cast<char>('A' + i));
    body.shape = Disc{0.1};
    body.position = {0.4 * i, 0.5 + 0.1 * i};
    body.velocity = {1.0 - i, 0.3};
    body.mass = 1.0;
    preset.scene.bodies.push_back(body);
  }
  Body floor;
  floor.name = "floor";
  floor.shape = Box{10.0, 1.0};
  floor.position = {0.0, -0.5};
  floor.fixed = true;
  preset.scene.bodies.push_back(floor);
  return preset;
}

const auto kGoOn = [](double) { return true; };

// A long run with edits, read back bit for bit: the file has the values of the run, however old, and equals
// the readings of the plots' cursor.
TEST(RunExport, HasEveryDigitOfALongPast) {
  Body late = box().scene.bodies[0];
  late.name = "late, \"D\"";
  late.position = {-1.0, 3.0};
  const Method method{IntegratorId::kVelocityVerlet, ImpactsId::kLocated, ContactsId::kImpulse, 0.001};
  DataExport what;
  what.setup = setup_of(box());
  const double h = what.setup.method.step;
  what.setup.edits = {{100 * h, 0, SceneEdits{Add<Body>{late}}}, {200 * h, 0, method}};
  what.steps = 60'000;
  what.to = 1e9;
  what.columns = run_columns([&] {
    std::vector<Body> all = box().scene.bodies;
    all.push_back(late);
    return all;
  }());
  Simulation run(what.setup);
  run.watch_impacts(true);
  std::vector<Curve> curves;
  for (const Quantity& column : what.columns) curves.push_back({column, std::nullopt});
  Sampler sampler(curves);
  sampler.begin(run);
  Frame frame;
  frame.run = 1;
  for (std::int64_t step = 0; step < what.steps; ++step) {
    while (const RunEdit* edit = run.due()) {
      run.apply_due();
      sampler.after_edit(run, *edit);
    }
    run.step();
    sampler.after_step(run);
  }
  frame.rows = {sampler.take()};
  frame.time = run.time();
  Recorder recorder;
  recorder.add(frame);

  QTemporaryDir dir;
  const std::string file = dir.filePath("run.csv").toStdString();
  ASSERT_TRUE(export_data(what, file, kGoOn));
  const auto lines = read(file);
  const Rows& rows = frame.rows[0];
  ASSERT_EQ(lines.size(), 1 + rows.size());
  EXPECT_EQ(lines[0][0], "time [s]");
  EXPECT_EQ(lines[0][7], "angular_momentum [kg m^2/s]");
  EXPECT_EQ(lines[0][10], "A x [m]");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // The name with a comma is in the header only.
    ASSERT_EQ(lines[i + 1].size(), 1 + what.columns.size()) << i;
    ASSERT_EQ(number(lines[i + 1][0]), rows.times[i]);
    for (std::size_t k = 0; k < what.columns.size(); ++k) {
      const double value = rows.values[i * what.columns.size() + k];
      if (std::isnan(value)) {
        ASSERT_EQ(lines[i + 1][k + 1], "") << "a body that is not there yet";
      } else {
        ASSERT_EQ(number(lines[i + 1][k + 1]), value) << i << " " << k;
      }
    }
  }
  // The newest rows are in the recorder unchanged: the cursor reads the last one of each time.
  const Series<1>& energy = *recorder.series(curves[0]);
  EXPECT_GT(energy.whole_since(), 0.0);
  for (std::size_t i = rows.size() - 20'000; i < rows.size(); i += 97) {
    const SeriesPoint<1>* point = energy.at(rows.times[i]);
    ASSERT_NE(point, nullptr);
    while (i + 1 < rows.size() && rows.times[i + 1] == rows.times[i]) ++i;
    ASSERT_EQ(point->at, rows.times[i]);
    ASSERT_EQ(point->value[0], number(lines[i + 1][1]));
  }
}

TEST(RunExport, WritesThePartThatIsAskedFor) {
  DataExport what;
  what.setup = setup_of(box());
  what.steps = 400;
  what.columns = {{find_observable("distance"), {0_b, 2_b}}, {find_observable("total_energy"), {}}};
  what.from = 0.5;
  what.to = 1.0;
  QTemporaryDir dir;
  const std::string file = dir.filePath("part.csv").toStdString();
  ASSERT_TRUE(export_data(what, file, kGoOn));
  const auto lines = read(file);
  EXPECT_EQ(lines[0], (std::vector<std::string>{"time [s]", "A C distance [m]", "total_energy [J]"}));
  EXPECT_EQ(number(lines[1][0]), 0.5);
  EXPECT_NEAR(number(lines.back()[0]), 1.0, 0.005);
  EXPECT_GE(lines.size(), 102U);
}

// A residual, whose header has its theory.
TEST(RunExport, WritesAResidualAsAColumnOfItsOwn) {
  DataExport what;
  what.setup = setup_of(box());
  what.steps = 20;
  what.to = 1.0;
  const std::vector<Body> bodies = box().scene.bodies;
  const QuantityName height{"y", {"A"}, "max(0.5, 2*t)"};
  const QuantityName place{"x", {"A"}, "2*x"};
  const Quantity measured = quantity_of(height, bodies);
  Quantity over_time = measured;
  over_time.less = theory_of(height, std::nullopt);
  Quantity over_height = quantity_of(place, bodies);
  over_height.less = theory_of(place, measured);
  what.columns = {measured, over_time, over_height, quantity_of({"x", {"A"}}, bodies)};
  EXPECT_EQ(csv_header(what.columns, bodies),
            "time [s],A y [m],\"A y - (max(0.5, 2*t)) [m]\",\"A x - (2*x), x = A y [m]\",A x [m]");
  QTemporaryDir dir;
  const std::string file = dir.filePath("part.csv").toStdString();
  ASSERT_TRUE(export_data(what, file, kGoOn));
  const auto lines = read(file);
  ASSERT_GE(lines.size(), 21u);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const double y = number(lines[i][1]);
    EXPECT_EQ(number(lines[i][2]), y - std::max(0.5, 2.0 * number(lines[i][0])));
    EXPECT_EQ(number(lines[i][3]), number(lines[i][4]) - 2.0 * y);
  }
}

TEST(RunExport, CancelsWithoutAFileAndSaysWhatIsWrong) {
  DataExport what;
  what.setup = setup_of(box());
  what.steps = 1000;
  what.to = 1e9;
  what.columns = {{find_observable("time"), {}}};
  QTemporaryDir dir;
  const std::string file = dir.filePath("run.csv").toStdString();
  double last = -1.0;
  EXPECT_FALSE(export_data(what, file, [&](double share) {
    EXPECT_GT(share, last);
    last = share;
    return share < 0.5;
  }));
  EXPECT_TRUE(QDir(dir.path()).isEmpty());
  EXPECT_GE(last, 0.5);
  EXPECT_THROW((void)export_data(what, dir.filePath("no/run.csv").toStdString(), kGoOn), SceneError);
}

// A late part of a long run, computed from a key frame, has the bytes of the whole export: with edits,
// impacts, counts of impacts and errors against a reference.
TEST(RunExport, APieceFromAKeyFrameIsThatOfTheWhole) {
  Body late = box().scene.bodies[0];
  late.name = "late";
  late.position = {-1.0, 3.0};
  const Quantity drift{find_observable("numerical_drift"), {}};
  const Quantity error{find_observable("position_error"), {}};
  const Quantity met{find_observable("impacts_between"), {0_b, 1_b}};
  std::vector<Curve> curves;
  for (const Quantity& q : {drift, error, met}) curves.push_back({q, std::nullopt});
  const ReferenceId reference = usual_reference(setup_of(box()));
  LiveRun lane(setup_of(box()), curves, reference);
  while (lane.simulation().steps() < 40'000) {
    if (lane.simulation().steps() == 20'000) lane.edit({lane.time(), 1, SceneEdits{Add<Body>{late}}});
    lane.step();
  }
  const std::shared_ptr<const Frame> frame = lane.take_frame();
  EXPECT_LE(frame->key_frames.size(), KeyFrames::kMost);
  EXPECT_GE(frame->key_frames.size(), KeyFrames::kMost / 2);

  QTemporaryDir dir;
  const auto lines_of = [&](DataExport what, const char* name) {
    const std::string file = dir.filePath(name).toStdString();
    EXPECT_TRUE(export_data(what, file, kGoOn));
    return read(file);
  };
  const double h = box().method.step;
  DataExport what{*frame->setup, {}, reference, frame->steps, {drift, error, met}, 30'000 * h, 31'000 * h};
  const auto whole = lines_of(what, "whole.csv");
  ASSERT_GE(whole.size(), 1001U);
  what.key_frames = frame->key_frames;
  what.setup.scene.bodies[0].position.x() += 0.125;  // a different start than the key frames'
  EXPECT_EQ(lines_of(what, "piece.csv"), whole);
  // A key frame has no counts that were not requested from the start.
  const Quantity other{find_observable("impacts_between"), {0_b, 2_b}};
  EXPECT_EQ(latest_before(frame->key_frames, 150.0, {{other, std::nullopt}}), nullptr);
  EXPECT_GT(latest_before(frame->key_frames, 150.0, curves)->state.clock.time, 120.0);
}

}  // namespace
}  // namespace carom
