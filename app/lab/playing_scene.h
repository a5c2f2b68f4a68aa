#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "physics/record/frame.h"
#include "physics/worker/worker.h"

namespace carom {

// The scene of a run that plays, as scene_now() gives it of one that stands still: made from what its frames
// have, with edits that are on their way to the run.
class PlayingScene {
 public:
  // This edit of the run was asked for; a frame has it later.
  void expect(Worker::EditId edit, const SceneEdits& edits);
  void forget_expected();

  // At the moment of the frame.
  [[nodiscard]] std::shared_ptr<const Scene> at(const std::shared_ptr<const Frame>& frame);
  // The same, but bodies may be where they were at an earlier moment: the same object until an edit.
  [[nodiscard]] std::shared_ptr<const Scene> parts(const std::shared_ptr<const Frame>& frame);

 private:
  struct Expected {
    Worker::EditId edit = 0;
    std::size_t earlier = 0;  // edits of the scene with this id before it
    SceneEdits edits;
  };

  void build(const Frame& frame);

  std::vector<Expected> expected_;
  std::shared_ptr<const RunSetup> setup_;  // of these parts
  std::shared_ptr<const std::vector<Body>> bodies_;
  std::shared_ptr<const Scene> parts_;
  std::shared_ptr<const Frame> frame_;  // of this moment
  std::shared_ptr<const Scene> moment_;
};

}  // namespace carom
