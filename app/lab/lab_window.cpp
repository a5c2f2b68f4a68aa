#include "app/lab/lab_window.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QScreen>
#include <QSignalBlocker>
#include <QTimer>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "app/lab/document_files.h"
#include "app/lab/drawer.h"
#include "app/lab/lab_exports.h"
#include "app/lab/marked_interval.h"
#include "app/lab/method_bar.h"
#include "app/lab/notice_bar.h"
#include "app/lab/scene_chips.h"
#include "app/lab/work_recovery.h"
#include "app/library/library_items.h"
#include "app/library/preset_library.h"
#include "physics/model/needs.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"
#include "widgets/base/ask.h"
#include "widgets/base/method_names.h"
#include "widgets/base/plain_text.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/study_panel.h"
#include "widgets/edit/bodies_sheet.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/reading_table.h"
#include "widgets/run/before_after_panel.h"
#include "widgets/run/experiment_list.h"
#include "widgets/run/experiment_preview.h"
#include "widgets/run/impacts_panel.h"
#include "widgets/run/ledger_table.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_view.h"

// The layout is in lab_layout.cpp, the menus are in lab_menus.cpp; this file has the window's actions.
namespace carom {
namespace {

// The file that is dropped; empty if it is none, or several.
QString dropped_file(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 ? urls.front().toLocalFile() : QString();
}

// "saved as %1", and what the file has of the theories of the first scene that are seen: an edit took those of
// a built-in experiment from its plots; one's own are still there.
QString saved_text(const std::vector<PlotContent>& contents) {
  bool taken = false;
  bool kept = false;
  for (const PlotContent& content : contents) {
    for (std::size_t i = 0; i < content.lines.size(); ++i) {
      if (content.lines[i].first_theory.empty()) continue;
      (content.plot.y[i].theory.empty() ? taken : kept) = true;
    }
  }
  if (taken) return LabWindow::tr("saved as %1, without the theories of the first scene");
  return kept ? LabWindow::tr("saved as %1; its theories are those of the first scene")
              : LabWindow::tr("saved as %1");
}

}  // namespace

LabWindow::LabWindow(const Theme& theme) : theme_(theme) {
  keep_messages_plain();
  make_body();
  chips_ = new SceneChips(*view_);
  files_ = new DocumentFiles(this, session_);
  exports_ = new LabExports(this, session_, {*view_, *plots_, *ledger_});
  recovery_ = new WorkRecovery(
      session_, *restore_bar_, [this] { return view_->moved_view(); }, this);
  make_file_menu();
  make_edit_menu();
  make_tools_menu();
  make_view_menu();
  make_run_menus();
  make_start_chip_menu();
  make_help_menu();
  make_tool_bar();
  connect_views();
  connect_stops();
  connect_session();
  connect_edits();
  list_->set_items(library_items());
  set_theme(theme);
  setMinimumSize(880, 600);  // the tool bar would be cut in a smaller one
  // Never larger than the screen leaves; the frame of the window needs some of it.
  constexpr QSize kFrame(8, 40);
  resize(QSize(1280, 800).boundedTo(screen()->availableSize() - kFrame).expandedTo(minimumSize()));
  setAcceptDrops(true);
  standard_layout();
  view_->setFocus();  // so that the keys of the scene work at once
}

// Parts that are being destroyed send the window no more signals.
LabWindow::~LabWindow() {
  hide();
  session_.disconnect();
  for (const QObject* child : findChildren<QObject*>()) child->disconnect(this);
}

void LabWindow::connect_session() {
  connect(&session_.runs(), &LabRuns::framesChanged, this, &LabWindow::show_frame);
  connect(&session_.runs(), &LabRuns::noticesChanged, this, &LabWindow::show_notices);
  connect(&session_.history(), &EditHistory::documentChanged, this, &LabWindow::show_document);
  connect(&session_, &Session::modifiedChanged, this, &LabWindow::setWindowModified);
  connect(&session_.history(), &EditHistory::plotsChanged, this, [this] {
    plots_->set_first_theories(first_theories_of(session_.history().document()));
    plots_->change_plots(preset().plots);
    session_.runs().record(plots_->curves());
  });
  connect(&session_.history(), &EditHistory::bodiesChanged, this, [this] {
    plots_->set_first_theories(first_theories_of(session_.history().document()));
    plots_->set_bodies(session_.history().bodies(), preset().plots);
    session_.runs().record(plots_->curves());
  });
  connect(files_, &DocumentFiles::opened, this, &LabWindow::show_scene);
  connect(files_, &DocumentFiles::stayed, this, [this] { list_->set_current(session_.name()); });
  connect(files_, &DocumentFiles::saved, this, &LabWindow::say_saved);
  connect(recovery_, &WorkRecovery::keptChanged, this, &LabWindow::show_notices);
  // The button that had the focus is hidden.
  connect(restore_bar_, &NoticeBar::dismissed, this, [this] {
    if (!restore_bar_->isVisible()) view_->setFocus();
  });
  connect(recovery_, &WorkRecovery::restoreAsked, this,
          [this](const Preset& work, const KeptStarts& starts, const WorkSource& source) {
            files_->when_saved([this, work, starts, source] {
              show_scene(work, source.name, source.file);
              session_.starts().recover(starts);
              session_.edits().resetClean();
              recovery_->restored();
            });
          });
}

// --- the document
// -----------------------------------------------------------------------------------------------------------

bool LabWindow::open(const std::string& file_or_name) { return files_->open(file_or_name); }

bool LabWindow::save() { return files_->save(); }

void LabWindow::keep_work(const QString& folder) { recovery_->begin(folder); }

void LabWindow::keep_now() { recovery_->keep_now(); }

void LabWindow::show_scene(const Preset& preset, const QString& name, const QString& file) {
  preview_->hide();
  plots_->set_first_theories({});
  plots_->set_plots(preset.plots, all_bodies(preset));
  session_.open(preset, plots_->chosen(), plots_->curves(), name, file);
  view_->await_scene();
  constexpr int kSoon = 200;  // ms: a scene that is ready by then shows no notice
  QTimer::singleShot(kSoon, this, &LabWindow::show_preparing);
  view_->set_view(preset.view);
  view_->set_tool(preset.tool, preset.tool != SceneTool::kSelect);
  view_->set_aim(std::nullopt);
  chips_->forget_position();
  said_.clear();
  sheet_->begin();
  list_->set_current(name);
  show_title();
  study_->set_scene(preset, name.isEmpty() ? QFileInfo(file).completeBaseName() : name);
  if (!preset.compare.empty()) {
    drawer_->choose(compare_);
  } else if (drawer_->shows(compare_)) {
    drawer_->choose(sheet_);
  }
}

// The start of the experiment that is marked in the list, until one is chosen. The work is left alone.
void LabWindow::preview(const QString& name) {
  preview_->hide();
  if (name.isEmpty() || name == session_.name()) return;
  try {
    const Preset preset = read_preset(find_preset(name.toStdString()));
    preview_->show_start(start_frame(preset), preset.view, view_->look(), QString::fromStdString(preset.title));
  } catch (const SceneError&) {
    return;  // the list has the reason
  }
  place_preview();
}

// What the experiment is about, and what its scene needs of the model.
void LabWindow::show_about() {
  const auto paragraph = [](const QString& text) {
    return text.isEmpty() ? QString() : "<p>" + text.toHtmlEscaped().replace("\n", "<br>") + "</p>";
  };
  const auto listed = [](const std::vector<std::string>& parts) {
    QStringList list;
    for (const std::string& part : parts) list << QString::fromStdString(part);
    return list.isEmpty() ? tr("nothing") : list.join(", ");
  };
  const Preset& document = preset();
  const NeedsText needs = text_of(needs_of(document.scene), document.scene, document.method.contacts);
  about_->setText("<p><b>" + QString::fromStdString(document.title).toHtmlEscaped() + "</b></p>" +
                  paragraph(QString::fromStdString(document.observe)) +
                  paragraph(QString::fromStdString(document.about)) +
                  paragraph(tr("Modelled: %1.\nNot needed by this scene: %2.")
                                .arg(listed(needs.modelled), listed(needs.not_needed))));
}

// With the name of its file.
void LabWindow::show_title() {
  const QString file = QFileInfo(session_.file()).fileName();
  const QString title = QString::fromStdString(preset().title);
  name_experiment();
  setWindowTitle((file.isEmpty() ? title : tr("%1 – %2").arg(file, title)) + "[*] – Carom");
}

void LabWindow::say_saved(const QString& file) {
  show_title();
  say_for_a_while(saved_text(plots_->contents()).arg(QFileInfo(file).fileName()));
}

void LabWindow::say_for_a_while(const QString& text) {
  constexpr int kSaid = 4000;  // ms
  said_ = text;
  show_notices();
  QTimer::singleShot(kSaid, this, [this, said = said_] {
    if (said_ != said) return;
    said_.clear();
    show_notices();
  });
}

void LabWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!dropped_file(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void LabWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  files_->open(dropped_file(*event->mimeData()).toStdString());
}

// A large scene takes seconds to be ready; the old scene must not be shown meanwhile.
void LabWindow::show_preparing() {
  if (frame() != nullptr) return;
  view_->clear();
  chips_->show_time(session_.runs());
  show_notices();
}

void LabWindow::show_document() {
  methods_->show_document(preset());
  chips_->show_start(session_.history().document().start);
  show_about();
  ledger_->set_scene(preset());
  study_->edit_scene(preset());
  compare_->set_scene(preset(), session_.history().document().reference);
  transport_->set_duration(preset().duration);
  transport_->timeline().set_start(start_time(preset().saved));
  plots_->set_duration(preset().duration);
  show_stops();
  show_selection();
}

void LabWindow::closeEvent(QCloseEvent* event) {
  if (isWindowModified()) {
    event->ignore();
    return files_->when_saved([this] {
      setWindowModified(false);
      close();
    });
  }
  session_.runs().forget_wait();
  recovery_->end();
  event->accept();
}

// --- the run
// -----------------------------------------------------------------------------------------------------------

void LabWindow::set_playing(bool playing) {
  // The lost run stands still: shows the advice again.
  if (playing && frame() != nullptr && frame()->lost) {
    lost_bar_->show();
    return show_notices();
  }
  if (playing) forget_refusal();
  session_.starts().set_playing(playing);
}

void LabWindow::compare_usual() {
  if (!session_.methods().compares_usual()) {
    drawer_->choose(compare_);
    const QSignalBlocker part_of_this_edit(plots_);
    if (first_reference(preset()) != ReferenceId::kNone) plots_->set_shown("error", true);
  }
  session_.methods().compare_usual(plots_->chosen(), plots_->curves());
}

void LabWindow::run_until(double time) {
  session_.runs().run_until(time);
  plots_->show_now();
}

void LabWindow::show_frame() {
  const auto& frames = session_.runs().frames();
  if (frames.empty()) return;
  const Frame& frame = *frames.front();
  const auto& recorders = session_.runs().recorders();
  std::vector<Method> methods;
  for (const auto& each : frames) methods.push_back(each->method);
  const std::vector<QString> names = names_of(methods);
  std::vector<PlottedRun> plotted;
  for (std::size_t i = 0; i < frames.size(); ++i) plotted.push_back({recorders[i], names[i]});
  const Frame& newest = *session_.runs().newest().front();
  const double shown = session_.runs().shown_time();
  plots_->update_from(plotted);
  plots_->set_playhead(session_.runs().in_past() ? std::optional(shown) : std::nullopt);
  show_run_before();
  view_->set_picked(session_.runs().picked());
  view_->set_frame(frames.front(), {frames.begin() + 1, frames.end()});
  if (frame.playing) view_->set_aim(std::nullopt);
  show_selection();
  transport_->update_from(frame, newest, *recorders.front(), shown);
  transport_->timeline().set_marks(plots_->marks().a, plots_->marks().b);
  if (drawer_->shows(before_after_)) show_before_after();
  if (drawer_->shows(impacts_))
    impacts_->update_from(newest, std::max(frame.time, session_.runs().picked().value_or(0.0)),
                          *recorders.front());
  if (drawer_->shows(ledger_)) ledger_->update_from(frame);
  if (drawer_->shows(reading_)) reading_->update_from(plots_->runs(), plots_->contents(), plots_->marks());
  if (drawer_->shows(compare_)) compare_->update_from(frames);
  drawer_->set_title(impacts_, tr("Impacts (%1)").arg(newest.impact_count));
  chips_->show_time(session_.runs());
  show_notices();
}

// A loss is reported once, so that a dismissed bar stays hidden.
void LabWindow::show_notices() {
  const Frame* lost = session_.runs().lost();
  const QString why = lost == nullptr ? QString() : QString::fromStdString(*lost->lost);
  if (std::exchange(lost_, why) != why) {
    const bool several = session_.runs().frames().size() > 1;
    lost_bar_->say(several ? tr("A run is %1").arg(why) : tr("The run is %1").arg(why), tr("Restart"),
                   tr("Dismiss"));
    lost_bar_->setVisible(!why.isEmpty());
  }
  chips_->show_notices(session_.runs(), said_.isEmpty() ? recovery_->not_kept() : said_,
                       lost_bar_->isVisibleTo(this));
}

}  // namespace carom
