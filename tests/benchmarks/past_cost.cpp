// Cost of the past of long runs: of going to its moments (how long until the first picture, and until the
// moment itself is there), and of the undo of edits (how long until the first frame, and until the run stands
// again where it stood), with the key frames and the memory of the process. Prints figures, tests nothing.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/record/recorder.h"
#include "physics/worker/worker.h"
#include "tests/support/scenes.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// MB, of this process.
double resident() {
  std::ifstream file("/proc/self/statm");
  double all = 0.0;
  double pages = 0.0;
  file >> all >> pages;
  return 1e-6 * pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// 200 elastic discs of 0.1 m in a room of 4 m, with gravity.
Preset discs_in_a_room() {
  std::vector<Body> bodies = test::room(2.0, 0.5);
  std::mt19937_64 random(3);
  const auto draw = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  for (int i = 0; i < 200; ++i) {
    const Vec2 home(-1.9 + 0.2 * (i % 20), -1.8 + 0.4 * (i / 20));
    const double x = draw();
    bodies.push_back(test::disc(fmt::format("disc {}", i), home, {x, draw()}, 0.05));
  }
  Preset preset = test::preset_with(std::move(bodies));
  preset.title = "200 discs";
  preset.scene.forces.gravity = {0.0, -0.1};
  preset.method.step = 0.01;
  return preset;
}

// A worker whose frames are taken and recorded as a window does it.
class Bench {
 public:
  explicit Bench(const Preset& preset)
      : preset_(preset), worker_(preset, {{{find_observable("total_energy"), {}}, {}}}) {}

  // Until a frame comes for which `fulfilled` holds.
  template <class Condition>
  void wait(const Condition& fulfilled) {
    while (true) {
      worker_.wait_for_frames(std::chrono::milliseconds(100));
      const auto news = worker_.take_frames();
      if (news.empty()) continue;
      frame_ = news.front();
      recorder_.add(*frame_);
      if (fulfilled()) return;
    }
  }
  void run_to(double time) {
    worker_.run_until(time);
    wait([&] { return !frame_->playing && frame_->time > time - frame_->method.step; });
  }
  // Gravity grows by a hundredth.
  Worker::EditId edit() {
    const std::size_t edits = frame_->setup->edits.size();
    CommonForces forces = preset_.scene.forces;
    forces.gravity *= 1.0 + 0.01 * static_cast<double>(edits + 1);
    const Worker::EditId id = worker_.edit_scene({SetForces{forces}});
    wait([&] { return frame_->setup->edits.size() == edits + 1; });
    return id;
  }
  struct Cost {
    double first = 0.0;  // s, until the first picture
    double end = 0.0;    // s, until the end of the replay
  };
  Cost undo(Worker::EditId edit) {
    const std::size_t edits = frame_->setup->edits.size();
    const Clock::time_point begin = Clock::now();
    Cost cost;
    worker_.undo_or_redo(edit, preset_, ReferenceId::kNone);
    wait([&] { return frame_->setup->edits.size() + 1 == edits; });
    cost.first = since(begin);
    if (frame_->replay_until) wait([&] { return !frame_->replay_until; });
    cost.end = since(begin);
    return cost;
  }
  // To a moment of the past (s).
  Cost show(double time) {
    const Clock::time_point begin = Clock::now();
    Cost cost;
    const std::uint64_t number = worker_.show({.time = time});
    while (cost.end == 0.0) {
      const Worker::Shown shown = worker_.take_shown();
      if (shown.frames.empty() || shown.number != number) {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        continue;
      }
      if (cost.first == 0.0) cost.first = since(begin);
      if (shown.there) cost.end = since(begin);
    }
    return cost;
  }
  [[nodiscard]] std::size_t key_frames() const { return frame_->key_frames.size(); }

 private:
  Preset preset_;
  Worker worker_;
  std::shared_ptr<const Frame> frame_;
  Recorder recorder_;
};

// ms, at this share of the sorted values.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return 1e3 * values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void scrub_cost(Bench& bench, double end) {
  constexpr int kMoments = 200;
  std::mt19937_64 random(7);
  std::vector<double> first;
  std::vector<double> there;
  for (int i = 0; i < kMoments; ++i) {
    const Bench::Cost cost = bench.show(end * static_cast<double>(random() >> 11) * 0x1p-53);
    first.push_back(cost.first);
    there.push_back(cost.end);
  }
  for (const auto& [name, values] : {std::pair("first picture", &first), std::pair("the moment", &there)}) {
    fmt::print("{} random moments, {:>13}: median {:.0f}, 95 % {:.0f}, most {:.0f} ms\n", kMoments, name,
               quantile(*values, 0.5), quantile(*values, 0.95), quantile(*values, 1.0));
  }
  fmt::print("{:.0f} MB resident\n", resident());
}

void past_cost(const Preset& preset, double end) {
  const double before = resident();
  Bench bench(preset);
  const std::vector<double> shares = {0.1, 0.5, 0.9, 0.99};
  std::vector<Worker::EditId> edits;
  const Clock::time_point begin = Clock::now();
  for (const double share : shares) {
    bench.run_to(share * end);
    edits.push_back(bench.edit());
  }
  bench.run_to(end);
  fmt::print("{}, to {} s: {:.1f} s of computing, {} key frames, {:.0f} MB more than before\n", preset.title,
             end, since(begin), bench.key_frames(), resident() - before);
  scrub_cost(bench, end);
  fmt::print("{:>12} {:>18} {:>19} {:>12} {:>14}\n", "edit at / s", "first frame / ms", "end of replay / ms",
             "key frames", "resident / MB");
  for (std::size_t i = shares.size(); i-- > 0;) {
    const Bench::Cost cost = bench.undo(edits[i]);
    fmt::print("{:>12.0f} {:>18.1f} {:>19.0f} {:>12} {:>14.0f}\n", shares[i] * end, 1e3 * cost.first,
               1e3 * cost.end, bench.key_frames(), resident());
  }
}

}  // namespace
}  // namespace carom

// An argument is a share of the runs' lengths: ten minutes, and an hour of Newton's cradle.
int main(int argc, char** argv) {
  using namespace carom;
  const double share = argc > 1 ? std::atof(argv[1]) : 1.0;
  past_cost(read_preset(test::preset_file("piles/pile.json")), share * 600.0);
  past_cost(discs_in_a_room(), share * 600.0);
  past_cost(read_preset(test::preset_file("chains-and-cradles/newtons-cradle.json")), share * 3600.0);
}
