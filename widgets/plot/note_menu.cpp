#include "widgets/plot/note_menu.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <optional>
#include <qwt_axis.h>
#include <qwt_plot.h>

#include "physics/preset/preset.h"
#include "physics/scene/limits.h"
#include "widgets/base/ask.h"
#include "widgets/plot/run_plot.h"

namespace carom {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("NoteMenu", text); }

// The text, unless the user cancels.
void ask_for_words(QWidget* parent, const std::string& now, const std::function<void(std::string)>& then) {
  auto* dialog = new QInputDialog(parent);
  dialog->setWindowTitle(tr("Note"));
  dialog->setLabelText(tr("Text of the note at this point"));
  dialog->setTextValue(QString::fromStdString(now));
  if (auto* line = dialog->findChild<QLineEdit*>()) line->setMaxLength(kLongestTitle);
  ask(dialog, [dialog, then] {
    const QString text = dialog->textValue().trimmed();
    if (!text.isEmpty()) then(text.toStdString());
  });
}

}  // namespace

void add_note_entries(QMenu& menu, RunPlot& plot, const QPoint& at, QWidget* parent,
                      const std::function<void()>& changed) {
  const std::vector<PlotNote> notes = plot.content().plot.notes;
  const QPointer<RunPlot> where = &plot;  // which may be deleted while the user writes
  const auto put = [where, changed](const std::vector<PlotNote>& what) {
    if (where == nullptr) return;
    where->set_notes(what);
    changed();
  };
  if (const std::optional<std::size_t> i = plot.note_at(at)) {
    menu.addAction(tr("&Change this note..."), parent, [=] {
      ask_for_words(parent, notes[*i].text, [=](const std::string& words) {
        std::vector<PlotNote> now = notes;
        now[*i].text = words;
        put(now);
      });
    });
    menu.addAction(tr("Remove this &note"), parent, [=] {
      std::vector<PlotNote> now = notes;
      now.erase(now.begin() + static_cast<std::ptrdiff_t>(*i));
      put(now);
    });
    return;
  }
  // In the present axes: a running simulation moves them while the user writes.
  const PlotNote note{plot.plot()->invTransform(QwtAxis::XBottom, at.x()),
                      plot.plot()->invTransform(QwtAxis::YLeft, at.y()),
                      {}};
  QAction* here = menu.addAction(tr("&Note here..."), parent, [=] {
    ask_for_words(parent, {}, [=](const std::string& words) {
      std::vector<PlotNote> now = notes;
      now.push_back({note.x, note.y, words});
      put(now);
    });
  });
  const bool inside = plot.plot()->canvas()->rect().contains(at);
  here->setEnabled(inside && notes.size() < kMostNotes);
  if (!inside) {
    here->setToolTip(tr("Right click within the plot's axes"));
  } else if (!here->isEnabled()) {
    here->setToolTip(tr("A plot has up to %1 notes").arg(kMostNotes));
  }
}

}  // namespace carom
