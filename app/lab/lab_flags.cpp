#include "app/lab/lab_window.h"
#include "widgets/edit/inspector.h"
#include "widgets/run/stop_editor.h"
#include "widgets/run/transport_bar.h"

// The stops of the document in the window: their flags on the timeline, and their editor.
namespace carom {

void LabWindow::connect_stops() {
  stop_editor_ = new StopEditor(this);
  const Timeline* timeline = &transport_->timeline();
  connect(stop_editor_, &StopEditor::stopsChanged, &session_, &Session::change_stops);
  connect(inspector_, &Inspector::stopsAsked, this, [this] { edit_stops(std::nullopt); });
  connect(transport_, &TransportBar::stopsClicked, this, [this] { edit_stops(std::nullopt); });
  connect(timeline, &Timeline::flagClicked, this, [this](std::size_t stop) { edit_stops(stop); });
  connect(timeline, &Timeline::flagMoved, this, [this](std::size_t stop, double time) {
    std::vector<Stop> stops = preset().stops;
    stops.at(stop).time = time;
    session_.change_stops(stops, tr("Stop %1").arg(QString::fromStdString(sentence_of(stops[stop]))));
  });
  connect(timeline, &Timeline::flagRemoved, this, [this](std::size_t stop) {
    std::vector<Stop> stops = preset().stops;
    const QString sentence = QString::fromStdString(sentence_of(stops.at(stop)));
    stops.erase(stops.begin() + static_cast<std::ptrdiff_t>(stop));
    session_.change_stops(stops, tr("Remove stop %1").arg(sentence));
  });
}

void LabWindow::show_stops() {
  transport_->timeline().set_stops(preset().stops);
  stop_editor_->set_document(preset().stops, session_.history().bodies());
  DurationAndStops shown{.duration = preset().duration};
  for (const Stop& stop : preset().stops) shown.stops << QString::fromStdString(sentence_of(stop));
  inspector_->show_duration_and_stops(shown);
}

void LabWindow::edit_stops(std::optional<std::size_t> stop) {
  stop_editor_->open_over(transport_->flag(), stop);
}

}  // namespace carom
