#include "app/export/run_progress.h"

#include <QCoreApplication>
#include <QProgressBar>
#include <QProgressDialog>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>

#include "widgets/base/ask.h"

namespace carom {
namespace {

constexpr int kParts = 1000;
constexpr int kPeriod = 30;                      // ms between two polls of the work
constexpr std::chrono::milliseconds kSoon{300};  // shorter work shows no dialog

// Work on a thread. The destructor requests a stop and joins the thread.
class Job {
 public:
  explicit Job(const std::function<void(const Progress&)>& work)
      : thread_([this, work](const std::stop_token& stop) { run(work, stop); }) {}

  void stop() { thread_.request_stop(); }
  [[nodiscard]] bool stopped() const { return thread_.get_stop_token().stop_requested(); }
  [[nodiscard]] bool done_in(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, time, [this] { return done_; });
  }
  [[nodiscard]] double share() const { return share_; }
  [[nodiscard]] const QString& error() const { return error_; }  // when done; empty: no error

 private:
  void run(const std::function<void(const Progress&)>& work, const std::stop_token& stop) {
    try {
      work([&](double share) {
        share_ = share;
        return !stop.stop_requested();
      });
    } catch (const std::exception& error) {
      error_ = QString::fromUtf8(error.what());
    }
    const std::lock_guard lock(mutex_);
    done_ = true;
    ended_.notify_all();
  }

  std::atomic<double> share_ = 0.0;
  QString error_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool done_ = false;
  std::jthread thread_;  // last: it uses all of the above
};

void finish(const Job& job, QWidget* window, const QString& failure, const std::function<void()>& then) {
  if (!job.error().isEmpty()) {
    show_message(window, failure, job.error());
  } else if (!job.stopped() && then) {
    then();
  }
}

}  // namespace

void with_progress(QWidget* window, const QString& title, const QString& failure,
                   const std::function<void(const Progress&)>& work, const std::function<void()>& then) {
  const auto job = std::make_shared<Job>(work);
  if (job->done_in(kSoon)) return finish(*job, window, failure, then);
  const auto tr = [](const char* text) { return QCoreApplication::translate("RunProgress", text); };
  auto* dialog = new QProgressDialog(tr("Replaying the run"), tr("Cancel"), 0, kParts, window);
  dialog->setWindowTitle(title);
  // QProgressDialog::setValue() would run the event loop.
  auto* bar = new QProgressBar;
  dialog->setBar(bar);
  bar->setRange(0, kParts);
  auto* timer = new QTimer(dialog);
  QObject::connect(timer, &QTimer::timeout, dialog, [=] {
    bar->setValue(static_cast<int>(kParts * job->share()));
    if (dialog->wasCanceled()) job->stop();
    if (!job->done_in(std::chrono::milliseconds(0))) return;
    timer->stop();
    dialog->hide();
    dialog->deleteLater();
    finish(*job, window, failure, then);
  });
  timer->start(kPeriod);
  dialog->open();
}

}  // namespace carom
