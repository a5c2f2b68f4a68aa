#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QTabWidget>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/lab/lab_window.h"
#include "app/lab/notice_bar.h"
#include "app/lab/preset_library.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/study_panel.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/plot/reading_table.h"
#include "widgets/run/experiment_list.h"
#include "widgets/run/ledger_table.h"
#include "widgets/run/run_tables.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_thumbnail.h"
#include "widgets/scene/scene_view.h"
#include "widgets/theme/plain_text.h"

// What stands where in the lab's window.
namespace carom {
namespace {

QWidget* with_frame(QWidget* inside, int margin) {
  auto* frame = new QFrame;
  frame->setObjectName("panel");
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(margin, margin, margin, margin);
  column->addWidget(inside);
  return frame;
}

// Scrolls upright only: as wide as what it holds.
class PlotArea : public QScrollArea {
 public:
  [[nodiscard]] QSize minimumSizeHint() const override {
    const int bar = verticalScrollBar()->sizeHint().width();
    return {widget() == nullptr ? 0 : widget()->minimumSizeHint().width() + bar, 0};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};

}  // namespace

void LabWindow::make_body() {
  auto* middle = new QWidget;
  middle->setObjectName("window");
  auto* row = new QHBoxLayout(middle);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);

  list_ = new ExperimentList(theme_);
  list_->setFixedWidth(240);
  row->addWidget(list_);

  view_ = new SceneView(theme_);
  transport_ = new TransportBar(theme_);
  bodies_ = new BodiesTable;
  impacts_ = new ImpactsTable;
  ledger_ = new LedgerTable;
  study_ = new StudyPanel(theme_);
  connect(study_, &StudyPanel::methodChosen, &session_, &Session::compare_with);
  compare_ = new ComparePanel(theme_);
  connect(compare_, &ComparePanel::methodAdded, &session_, &Session::add_method);
  connect(compare_, &ComparePanel::methodRemoved, &session_, &Session::remove_method);
  connect(compare_, &ComparePanel::methodChanged, &session_, &Session::change_method);
  connect(compare_, &ComparePanel::stepChanged, &session_, &Session::change_step);
  connect(compare_, &ComparePanel::referenceChosen, &session_, &Session::choose_reference);
  connect(compare_, &ComparePanel::usualAsked, this, &LabWindow::compare_usual);
  about_ = new QLabel;
  about_->setWordWrap(true);
  about_->setTextFormat(Qt::RichText);
  about_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  about_->setContentsMargins(4, 4, 12, 8);
  about_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* about_area = new QScrollArea;
  about_area->setWidget(about_);
  about_area->setWidgetResizable(true);
  about_area->setFrameShape(QFrame::NoFrame);
  about_area->setStyleSheet("QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; }");
  tabs_ = new QTabWidget;
  tabs_->addTab(bodies_, tr("Before and after"));
  tabs_->addTab(impacts_, tr("Impacts"));
  tabs_->addTab(ledger_, tr("Ledger"));
  reading_ = new ReadingTable;
  tabs_->addTab(reading_, tr("Reading"));
  tabs_->addTab(compare_, tr("Compare"));
  tabs_->addTab(study_, tr("Study"));
  tabs_->addTab(about_area, tr("About"));
  connect(tabs_, &QTabWidget::currentChanged, this, &LabWindow::show_frame);

  auto* drawer = with_frame(tabs_, 0);
  drawer->layout()->setContentsMargins(12, 4, 12, 8);
  auto* centre = new QSplitter(Qt::Vertical);
  centre->setHandleWidth(8);
  auto* scene = new QWidget;
  auto* scene_column = new QVBoxLayout(scene);
  scene_column->setContentsMargins(0, 0, 0, 0);
  scene_column->setSpacing(8);
  scene_column->addWidget(with_frame(view_, 1), 1);
  scene_column->addWidget(transport_);
  centre->addWidget(scene);
  centre->addWidget(drawer);
  centre->setStretchFactor(0, 3);
  centre->setStretchFactor(1, 1);
  centre->setSizes({540, 190});
  centre->setChildrenCollapsible(false);

  plots_ = new PlotPanel(theme_);
  connect(plots_, &PlotPanel::layoutChanged, this, [this] {
    session_.change_plots(plots_->chosen());
    session_.record(plots_->curves());
  });
  connect(plots_, &PlotPanel::marksChanged, this, [this] {
    tabs_->setCurrentWidget(reading_);
    show_frame();
  });
  connect(plots_, &PlotPanel::pictureAsked, this, &LabWindow::save_plot);
  connect(plots_, &PlotPanel::dataAsked, this, &LabWindow::save_data);
  connect(plots_, &PlotPanel::dataCopyAsked, this, &LabWindow::copy_data);
  auto* columns = new QSplitter(Qt::Horizontal);
  columns->setHandleWidth(8);
  columns->addWidget(centre);
  // More plots than the height shows well are scrolled.
  auto* plot_area = new PlotArea;
  plot_area->setWidget(plots_);
  plot_area->setWidgetResizable(true);
  plot_area->setFrameShape(QFrame::NoFrame);
  plot_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  plot_area->setStyleSheet("QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; }");
  columns->addWidget(plot_area);
  // Both keep their share of the window's width.
  columns->setStretchFactor(0, 616);
  columns->setStretchFactor(1, 392);
  columns->setSizes({616, 392});
  columns->setChildrenCollapsible(false);
  restore_bar_ = new NoticeBar;
  connect(restore_bar_, &NoticeBar::accepted, this, &LabWindow::restore_work);
  connect(restore_bar_, &NoticeBar::dismissed, this, &LabWindow::discard_work);
  auto* inner = new QVBoxLayout;
  inner->setContentsMargins(8, 8, 8, 8);
  inner->setSpacing(8);
  inner->addWidget(restore_bar_);
  lost_bar_ = new NoticeBar;
  connect(lost_bar_, &NoticeBar::accepted, &session_, &Session::restart);
  connect(lost_bar_, &NoticeBar::dismissed, this, [this] {
    lost_bar_->hide();
    show_notices();
  });
  lost_bar_->hide();
  inner->addWidget(lost_bar_);
  inner->addWidget(columns, 1);
  row->addLayout(inner, 1);
  setCentralWidget(middle);

  // Chips over the scene: time, speed and what is modelled; below, what the run has to say.
  chips_ = new QWidget(view_);
  auto* chips = new QHBoxLayout(chips_);
  chips->setContentsMargins(0, 0, 0, 0);
  chips->setSpacing(6);
  for (QLabel** chip : {&time_chip_, &speed_chip_, &needs_chip_}) {
    *chip = new PlainLabel(chips_);
    (*chip)->setObjectName("chip");
    chips->addWidget(*chip);
  }
  needs_chip_->setAccessibleName(tr("What is modelled"));
  status_chip_ = new PlainLabel(view_);
  status_chip_->setObjectName("chip");
  time_chip_->setStyleSheet("font-weight: bold;");
  speed_chip_->setToolTip(tr("Simulated seconds per second"));
  status_chip_->hide();
  view_->installEventFilter(this);

  position_ = new PlainLabel(view_);
  position_->setObjectName("caption");
  connect(view_, &SceneView::cursorMoved, this, [this](double x, double y) {
    position_->setText(
        QString("x = %1 m, y = %2 m").arg(x, 0, 'f', 3).arg(y, 0, 'f', 3).replace('-', QChar(0x2212)));
    position_->show();
    place_chips();
  });
  connect(view_, &SceneView::cursorLeft, position_, &QLabel::hide);
  connect(view_, &SceneView::spawnRequested, this, &LabWindow::spawn);
  connect(list_, &ExperimentList::openRequested, this,
          [this](const QString& name) { open(name.toStdString()); });
  connect(transport_, &TransportBar::playClicked, this, &LabWindow::set_playing);
  connect(transport_, &TransportBar::restartClicked, &session_, &Session::restart);
  connect(transport_, &TransportBar::stepClicked, &session_, &Session::step_once);
  connect(transport_, &TransportBar::speedChosen, this, [this](double speed) {
    session_.set_speed(speed);
    show_frame();
  });
}

bool LabWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) place_chips();
  if (watched == tool_bar_ && event->type() == QEvent::Resize) show_method();
  return QMainWindow::eventFilter(watched, event);
}

void LabWindow::place_chips() {
  constexpr int kEdge = 10;       // px
  constexpr int kGap = 6;         // px between chips
  constexpr int kPadding = 22;    // px, of a chip's text left and right, with its border
  constexpr int kLeastRoom = 60;  // px
  const auto elide = [&](QLabel* chip, const QString& text, int room) {
    chip->setText(chip->fontMetrics().elidedText(text, Qt::ElideRight, std::max(room, kLeastRoom) - kPadding));
  };
  const int before = time_chip_->sizeHint().width() + speed_chip_->sizeHint().width() + 2 * kGap;
  elide(needs_chip_, needs_, view_->width() - 2 * kEdge - before);
  chips_->adjustSize();
  chips_->move(kEdge, kEdge);
  chips_->raise();
  const int second_row = kEdge + chips_->height() + kGap;
  position_->adjustSize();
  position_->move(view_->width() - position_->width() - kEdge - 2, second_row + 4);
  position_->raise();
  elide(status_chip_, status_, view_->width() - 3 * kEdge - (position_->isVisible() ? position_->width() : 0));
  status_chip_->adjustSize();
  status_chip_->move(kEdge, second_row);
  status_chip_->raise();
}

void LabWindow::set_theme(const Theme& theme) {
  theme_ = theme;
  for (const auto& [action, icon] : icon_actions_) action->setIcon(themed_icon(icon, theme.text));
  theme_action_->setIcon(themed_icon(theme.dark ? "sun" : "moon", theme.text));
  theme_action_->setText(theme.dark ? tr("&Light colours") : tr("&Dark colours"));
  list_->set_theme(theme);
  view_->set_theme(theme);
  transport_->set_theme(theme);
  plots_->set_theme(theme);
  study_->set_theme(theme);
  compare_->set_theme(theme);
  draw_thumbnails();
}

void LabWindow::fill_library() {
  std::vector<ExperimentItem> items;
  for (const LibraryEntry& entry : preset_library()) {
    try {
      const Preset preset = read_preset(entry.file);
      items.push_back({QString::fromStdString(entry.name), QString::fromStdString(entry.topic),
                       QString::fromStdString(preset.title), QString::fromStdString(preset.observe)});
    } catch (const SceneError& error) {
      items.push_back({QString::fromStdString(entry.name), QString::fromStdString(entry.topic),
                       QString::fromStdString(entry.name), QString::fromStdString(error.what())});
    }
  }
  list_->set_items(std::move(items));
  draw_thumbnails();
}

void LabWindow::draw_thumbnails() {
  std::vector<QPixmap> pictures;
  for (const LibraryEntry& entry : preset_library()) {
    QPixmap picture;
    try {
      const Preset preset = read_preset(entry.file);
      const Simulation simulation(setup_of(preset));
      Frame frame;
      take_moment(simulation, frame);
      frame.bodies = std::make_shared<const std::vector<Body>>(simulation.bodies());
      frame.forces = std::make_shared<const Forces>(preset.scene.forces);
      picture = scene_thumbnail(frame, theme_, {52, 36}, devicePixelRatioF());
    } catch (const SceneError&) {
      picture = QPixmap();
    }
    pictures.push_back(picture);
  }
  list_->set_pictures(pictures);
}

}  // namespace carom
