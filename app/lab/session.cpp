#include "app/lab/session.h"

#include <algorithm>
#include <utility>

#include "physics/preset/preset_file.h"
#include "physics/scene/fingerprint.h"

namespace carom {
namespace {

Preset empty_document() {
  Preset empty;
  empty.title = "Empty scene";
  return empty;
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent), document_{empty_document()}, runs_(document_) {
  connect(&edits_, &QUndoStack::indexChanged, this, &Session::check_modified);
  connect(&edits_, &QUndoStack::cleanChanged, this, &Session::check_modified);
  // Before the window's slot: it shows the document too.
  connect(&runs_, &LabRuns::framesChanged, this, &Session::take_times_of_edits);
}

void Session::open(const Preset& preset, const std::vector<Plot>& plots, const std::vector<Curve>& curves,
                   const QString& name, const QString& file) {
  document_ = {preset,
               preset.compare.empty() ? ReferenceId::kNone : usual_reference(setup_of(preset)),
               {},
               !name.isEmpty()};
  document_.preset.plots = plots;
  give_ids(document_.preset);
  document_.start = {.scene = fingerprint(document_.preset.scene, start_time(document_.preset.saved))};
  first_start_ = std::make_shared<const Start>(start_of(document_));
  name_ = name;
  file_ = file;
  bodies_ = all_bodies(preset);
  runs_.load(curves);
  ++revision_;
  edits_.clear();
  edits_.setClean();
  check_modified();
  emit documentChanged();
}

void Session::save(const QString& file) {
  save_preset(document_.preset, file.toStdString());
  file_ = file;
  Start saved = start_of(document_);
  saved.origin = {.saved = true, .scene = fingerprint(saved.scene, start_time(saved.saved))};
  if (!document_.start.from) document_.start = saved.origin;
  first_start_ = std::make_shared<const Start>(std::move(saved));
  edits_.setClean();
}

bool Session::modified() const {
  const int clean = edits_.cleanIndex();
  if (clean < 0) return true;
  const auto [from, to] = std::minmax({clean, edits_.index()});
  for (int i = from; i < to; ++i) {
    if (static_cast<const DocumentEdit*>(edits_.command(i))->what().is_work) return true;
  }
  return false;
}

void Session::check_modified() {
  const bool now = modified();
  if (std::exchange(was_modified_, now) != now) emit modifiedChanged(now);
}

}  // namespace carom
