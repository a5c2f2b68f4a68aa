#include "app/lab/film_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardItemModel>

#include "app/lab/marks_text.h"
#include "physics/scene/validate.h"
#include "widgets/base/ask.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"

namespace carom {
namespace {

// Without trailing zeros.
class NumberBox : public QDoubleSpinBox {
 public:
  [[nodiscard]] QString textFromValue(double value) const override { return locale().toString(value, 'g', 10); }
};

QDoubleSpinBox* number_box(double least, double most, int decimals, double value, const QString& tip) {
  auto* box = new NumberBox;
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setValue(value);
  box->setToolTip(tip);
  return box;
}

QSpinBox* pixel_box(int value, const QString& tip) {
  auto* box = new QSpinBox;
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setRange(200, 8000);
  box->setSingleStep(2);
  box->setSuffix(" px");
  box->setValue(value);
  box->setToolTip(tip);
  // Video encoders require even numbers.
  QObject::connect(box, &QSpinBox::editingFinished, box, [box] { box->setValue(box->value() / 2 * 2); });
  return box;
}

QWidget* row_of(std::initializer_list<QWidget*> parts) {
  auto* widget = new QWidget;
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  for (QWidget* part : parts) row->addWidget(part, qobject_cast<QLabel*>(part) == nullptr ? 1 : 0);
  return widget;
}

}  // namespace

FilmDialog::FilmDialog(const Film& suggestion, const QString& folder,
                       const std::optional<std::pair<double, double>>& marked, QWidget* parent)
    : QDialog(parent),
      suggestion_(suggestion),
      suggested_folder_(folder),
      marked_(marked),
      part_(new QComboBox),
      from_(number_box(0.0, 1e9, 3, suggestion.from, tr("The run's time at the first frame"))),
      to_(number_box(0.0, 1e9, 3, suggestion.to,
                     tr("No frame is after this time; what the run has not reached yet is computed for it"))),
      rate_(number_box(0.001, 1000.0, 3, suggestion.rate, tr("Frames in each second of the film"))),
      speed_(number_box(1e-6, 1e6, 6, suggestion.speed,
                        tr("Seconds of the run in a second of the film: below 1 it is slow motion"))),
      width_(pixel_box(suggestion.pixels.width(), tr("Width of the frames"))),
      height_(pixel_box(suggestion.pixels.height(), tr("Height of the frames"))),
      shown_(new QComboBox),
      folder_(new QLineEdit(folder)),
      summary_(new PlainLabel) {
  setWindowTitle(tr("Film"));
  setMinimumWidth(480);
  folder_->setObjectName("folder");
  auto* column = new QVBoxLayout(this);
  column->setSpacing(12);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(10);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (QDoubleSpinBox* box : {from_, to_}) box->setSuffix(" s");
  speed_->setPrefix(QStringLiteral("× "));
  shown_->addItem(tr("What the window shows"));
  shown_->addItem(tr("All bodies, all the time"));
  shown_->setToolTip(tr("The camera stands still in either case"));
  auto* choose = new QPushButton(tr("Choose..."));
  choose->setAutoDefault(false);
  part_->setObjectName("part");
  part_->addItem(tr("The run so far"));
  part_->addItem(marked ? tr("From A to B: %1").arg(text_of(marked)) : tr("From A to B"));
  if (!marked) static_cast<QStandardItemModel*>(part_->model())->item(1)->setEnabled(false);
  part_->setItemData(1, marks_tip(), Qt::ToolTipRole);
  part_->setToolTip(marks_tip());
  form->addRow(tr("Part"), part_);
  form->addRow(tr("Of the run"), row_of({from_, new PlainLabel(tr("to")), to_}));
  form->addRow(tr("Speed"), speed_);
  form->addRow(tr("Frames a second"), rate_);
  form->addRow(tr("Size"), row_of({width_, new PlainLabel(QStringLiteral("×")), height_}));
  form->addRow(tr("Picture"), shown_);
  auto* where = row_of({folder_, choose});
  where->layout()->setAlignment(choose, Qt::AlignRight);
  static_cast<QHBoxLayout*>(where->layout())->setStretch(1, 0);
  form->addRow(tr("Folder"), where);
  column->addLayout(form);
  summary_->setObjectName("summary");
  summary_->setWordWrap(true);
  column->addWidget(summary_);
  auto* note =
      new PlainLabel(tr("Numbered PNG files. The run is computed once more for them, so that its past "
                        "is exact however long ago."));
  note->setObjectName("muted");
  note->setWordWrap(true);
  column->addWidget(note);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  make_ = buttons->button(QDialogButtonBox::Save);
  make_->setText(tr("Make the frames"));
  column->addWidget(buttons);

  connect(buttons, &QDialogButtonBox::accepted, this, &FilmDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(part_, &QComboBox::currentIndexChanged, this, &FilmDialog::choose_part);
  connect(choose, &QPushButton::clicked, this, &FilmDialog::choose_folder);
  for (QDoubleSpinBox* box : {from_, to_, rate_, speed_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &FilmDialog::update_summary);
  connect(folder_, &QLineEdit::textChanged, this, &FilmDialog::update_summary);
  update_summary();
}

Film FilmDialog::film() const {
  Film film = suggestion_;
  film.from = from_->value();
  film.to = to_->value();
  film.rate = rate_->value();
  film.speed = speed_->value();
  film.pixels = QSize(width_->value(), height_->value()) / 2 * 2;
  film.whole = shown_->currentIndex() == 1;
  // Sizes in the film are as in the window.
  const QSizeF window = film.look.camera.viewport;
  film.dots = std::min(film.pixels.width() / window.width(), film.pixels.height() / window.height());
  return film;
}

QString FilmDialog::folder() const { return QDir::cleanPath(folder_->text().trimmed()); }

// A folder that the user has chosen stays.
void FilmDialog::choose_part() {
  const bool of_marks = part_->currentIndex() == 1 && marked_.has_value();
  const QString named = suggested_folder_ + ", " + text_of(marked_);
  if (folder_->text() == (of_marks ? suggested_folder_ : named))
    folder_->setText(of_marks ? named : suggested_folder_);
  from_->setValue(of_marks ? marked_->first : suggestion_.from);
  to_->setValue(of_marks ? marked_->second : suggestion_.to);
}

void FilmDialog::choose_folder() {
  auto* dialog = new QFileDialog(this, tr("The frames' folder"), folder_->text());
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  ask(dialog, [this, dialog] { folder_->setText(dialog->selectedFiles().constFirst()); });
}

void FilmDialog::update_summary() {
  const bool named = !folder_->text().trimmed().isEmpty();
  try {
    const Film film = this->film();
    const auto count = static_cast<double>(film_times(film).size());
    summary_->setText(named ? tr("%1 frames, a film of %2 s; %3 frames in a second of the run.")
                                  .arg(count)
                                  .arg(short_figure(count / film.rate), short_figure(film.rate / film.speed))
                            : tr("The frames need a folder."));
    make_->setEnabled(named);
  } catch (const SceneError& error) {
    summary_->setText(QString::fromUtf8(error.what()));
    make_->setEnabled(false);
  }
}

void FilmDialog::accept() {
  const auto there = frames_in(folder()).size();
  if (there == 0) return QDialog::accept();
  auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Replace the frames?"),
                              tr("The folder has %1 frames already. Replace them?").arg(there),
                              QMessageBox::Cancel, this);
  box->addButton(tr("Replace"), QMessageBox::AcceptRole);
  box->setDefaultButton(QMessageBox::Cancel);
  ask(box, [this] {
    may_replace_ = true;
    QDialog::accept();
  });
}

}  // namespace carom
