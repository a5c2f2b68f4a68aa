#include "app/lab/session.h"

#include <algorithm>
#include <utility>

#include "app/lab/new_parts.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/start_fingerprint.h"

namespace carom {
namespace {

Preset empty_document() {
  Preset empty;
  empty.title = "Empty scene";
  return empty;
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent), history_(Document{empty_document()}) {
  connect(&history_.stack(), &QUndoStack::indexChanged, this, &Session::check_modified);
  connect(&history_.stack(), &QUndoStack::cleanChanged, this, &Session::check_modified);
}

void Session::open(const Preset& preset, const std::vector<Plot>& plots, const std::vector<Curve>& curves,
                   const QString& name, const QString& file) {
  Document document{preset,
                    preset.compare.empty() ? ReferenceId::kNone : usual_reference(setup_of(preset)),
                    {},
                    !name.isEmpty()};
  document.preset.plots = plots;
  give_ids(document.preset);
  document.start = {.scene = fingerprint_of_start(document.preset)};
  starts_.begin(start_of(document));
  name_ = name;
  file_ = file;
  history_.load(document, curves);
  check_modified();
  emit history_.documentChanged();
}

void Session::save(const QString& file) {
  save_preset(document(), file.toStdString());
  file_ = file;
  Start saved = start_of(history_.document());
  saved.origin = {.saved = true, .scene = fingerprint_of_start(document())};
  if (!history_.document().start.from) history_.set_origin(saved.origin);
  starts_.set_first(std::move(saved));
  edits().setClean();
}

bool Session::modified() const {
  const int clean = history_.stack().cleanIndex();
  if (clean < 0) return true;
  const auto [from, to] = std::minmax({clean, history_.stack().index()});
  for (int i = from; i < to; ++i) {
    if (history_.edit_at(i).what().is_work) return true;
  }
  return false;
}

void Session::check_modified() {
  const bool now = modified();
  if (std::exchange(was_modified_, now) != now) emit modifiedChanged(now);
}

}  // namespace carom
