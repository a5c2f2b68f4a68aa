#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "physics/scene/scene.h"
#include "physics/world/frame.h"

namespace carom {

// Runs one simulation on a thread of its own, at a chosen pace, and publishes whole frames. Calls return at
// once: they are carried out between two steps, in their order. The lock guards only the hand-over of commands
// and of the newest frame; nobody holds it while stepping or painting.
class Worker {
 public:
  // The scene must be valid.
  explicit Worker(const Scene& scene);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void load(const Scene& scene);  // stops at t = 0
  void restart();                 // the same scene with the bodies that were added, stopped at t = 0
  // Plays at the chosen pace, until `until` if that lies ahead; or stops.
  void set_playing(bool playing, double until = std::numeric_limits<double>::infinity());
  void step_once();              // one step of the method, stopped
  void set_speed(double speed);  // simulated seconds per second, > 0
  void set_method(const Method& method);
  void add_body(const Body& body);
  void run_until(double time);  // as fast as it goes, then stopped; frames come on the way

  // What happened since the last call; nullptr if nothing did. Never of before the last load or restart.
  [[nodiscard]] std::shared_ptr<const Frame> take_frame();
  // The scene as it would be saved now: with the method in force and the bodies that were added.
  [[nodiscard]] Scene scene() const;

 private:
  struct Lab;  // what belongs to the thread
  void post(std::function<void(Lab&)> command);
  void work(const std::stop_token& stop, const Scene& first);
  void publish(Lab& lab);

  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::vector<std::function<void(Lab&)>> commands_;
  std::shared_ptr<Frame> newest_;
  Scene scene_;
  std::uint64_t run_ = 1;  // of the frames to hand out: loads and restarts so far, and the start
  std::jthread thread_;    // last: it uses all of the above
};

}  // namespace carom
