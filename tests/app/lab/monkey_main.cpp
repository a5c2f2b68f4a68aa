// Random actions on the lab window until something breaks:
//   carom_monkey [--seed N] [--actions N] [--folder DIR]
// The seed is printed; the same seed gives the same actions. A crash or a hanging window is reported with the
// last actions. Without --actions there are 300, or 20 000 in the long tests.
#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QThread>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fmt/format.h>
#include <limits>
#include <pthread.h>
#include <sys/prctl.h>
#include <thread>
#include <unistd.h>

#include "app/library/preset_library.h"
#include "monkey.h"
#include "physics/preset/preset.h"
#include "tests/support/effort.h"

namespace carom {
namespace {

constexpr int kActions = 300;
constexpr int kLongActions = 20'000;
constexpr double kLongestTurn = 30.0;    // s of the main thread's own time, for one action
constexpr double kLongestSleep = 240.0;  // s without an action, however little the main thread did

// The last actions, in memory that a signal handler may read.
constexpr std::size_t kKept = 12;
constexpr std::size_t kLength = 120;
std::array<std::array<char, kLength>, kKept> last{};
std::atomic<std::size_t> reported = 0;
unsigned seed_shown = 0;

void remember(const QString& action) {
  const QByteArray text = action.toUtf8().left(kLength - 1);
  auto& place = last[reported % kKept];
  place.fill('\0');
  std::memcpy(place.data(), text.constData(), static_cast<std::size_t>(text.size()));
  ++reported;
}

void write_out(const char* text) { (void)!::write(STDERR_FILENO, text, std::strlen(text)); }

void show_last() {
  const std::size_t count = reported;
  for (std::size_t i = count > kKept ? count - kKept : 0; i < count; ++i) {
    write_out("  ");
    write_out(last[i % kKept].data());
    write_out("\n");
  }
}

void on_crash(int signal) {
  write_out("monkey: crashed; the last actions:\n");
  show_last();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Ends the program if one action takes too long.
void watch(const std::stop_token& stop, pthread_t main_thread) {
  clockid_t clock{};
  pthread_getcpuclockid(main_thread, &clock);
  std::size_t seen = reported;
  double since = seconds(clock);
  double since_wall = seconds(CLOCK_MONOTONIC);
  while (!stop.stop_requested()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if (reported != seen) {
      seen = reported;
      since = seconds(clock);
      since_wall = seconds(CLOCK_MONOTONIC);
    }
    if (seconds(clock) - since < kLongestTurn && seconds(CLOCK_MONOTONIC) - since_wall < kLongestSleep)
      continue;
    fmt::print(
        stderr,
        "monkey: the window has not answered for {:.0f} s of its own time (seed {}); the last actions:\n",
        seconds(clock) - since, seed_shown);
    show_last();
    std::abort();
  }
}

// The lab writes and reads only in this folder, apart from its own experiments.
void make_sandbox(const QString& folder) {
  for (const auto& [name, sub] :
       std::to_array<std::pair<const char*, const char*>>({{"HOME", "home"},
                                                           {"XDG_CONFIG_HOME", "home/config"},
                                                           {"XDG_DATA_HOME", "home/data"},
                                                           {"XDG_CACHE_HOME", "home/cache"},
                                                           {"XDG_PICTURES_DIR", "home/pictures"}})) {
    QDir().mkpath(folder + "/" + sub);
    qputenv(name, (folder + "/" + sub).toUtf8());
  }
  QDir::setCurrent(folder);
  QDir(folder).mkdir("a folder");
  const auto write = [&](const char* name, const QByteArray& text) {
    QFile file(folder + "/" + name);
    if (file.open(QIODevice::WriteOnly)) file.write(text);
  };
  write("empty.json", "");
  write("broken.json", "{\"format\": \"carom-preset\", \"version\": 1, \"bodies\": [");
  write("no-preset.png", "\x89PNG\r\n");
  write("<b>name.json", "[1e400]");
  for (const char* name : {"head-on", "gas", "stacked-boxes"})
    QFile::copy(QString::fromStdString(find_preset(name).string()), folder + "/" + name + "-copy.json");
}

// The monkey cannot write files of root.
void become_nobody(const QString& folder) {
  constexpr uid_t kNobody = 65534;
  if (geteuid() != 0) return;
  for (const QString& entry : {folder, folder + "/a folder", folder + "/home", folder + "/home/config",
                               folder + "/home/data", folder + "/home/cache", folder + "/home/pictures"})
    (void)!chown(entry.toUtf8().constData(), kNobody, kNobody);
  for (const QFileInfo& entry : QDir(folder).entryInfoList(QDir::Files | QDir::System))
    (void)!chown(entry.absoluteFilePath().toUtf8().constData(), kNobody, kNobody);
  if (setgid(kNobody) != 0 || setuid(kNobody) != 0) std::abort();
  prctl(PR_SET_DUMPABLE, 1);
}

int value_of(const QStringList& arguments, const QString& name, int otherwise) {
  const qsizetype at = arguments.indexOf(name);
  return at >= 0 && at + 1 < arguments.size() ? arguments[at + 1].toInt() : otherwise;
}

// Links of the help pages open nothing.
class NoBrowser : public QObject {
  Q_OBJECT
 public slots:
  void open(const QUrl&) {}
};

int run(int argc, char** argv) {
  qunsetenv("CAROM_PRESETS");
  const QTemporaryDir folder;
  make_sandbox(folder.path());
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QApplication::setApplicationName("Carom");
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication::setQuitOnLastWindowClosed(false);
  // Text is not dragged: Qt would ask the screen's own mouse where it is, and wait for its button.
  QApplication::setStartDragDistance(std::numeric_limits<int>::max());
  QApplication::setStartDragTime(std::numeric_limits<int>::max());
  become_nobody(folder.path());
  NoBrowser browser;
  for (const char* scheme : {"http", "https", "file", "mailto"})
    QDesktopServices::setUrlHandler(scheme, &browser, "open");

  const QStringList arguments = QApplication::arguments();
  Monkey::Options options;
  const int ordinary = test::by_effort(kActions, kActions, kLongActions);
  options.actions = value_of(arguments, "--actions", ordinary);
  options.seed = static_cast<unsigned>(value_of(arguments, "--seed", 1));
  options.folder = folder.path();
  const bool aloud = arguments.contains("--aloud");
  options.about = [aloud](const QString& action) {
    remember(action);
    if (aloud) fmt::print(stderr, "{}\n", action.toStdString());
  };
  seed_shown = options.seed;
  fmt::print("monkey: seed {}, {} actions, {}\n", options.seed, options.actions,
             QGuiApplication::platformName().toStdString());
  std::fflush(stdout);
#ifndef CAROM_SANITIZED
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) std::signal(signal, on_crash);
#endif
  std::signal(SIGABRT, on_crash);

  const pthread_t main_thread = pthread_self();
  const std::jthread watchdog([main_thread](const std::stop_token& stop) { watch(stop, main_thread); });
  Monkey monkey(options);
  monkey.run();
  for (const auto& [kind, count] : monkey.counts()) fmt::print("  {:5}  {}\n", count, kind);
  fmt::print("monkey: {} windows, no crash, no hang\n", monkey.windows());
  return 0;
}

}  // namespace
}  // namespace carom

int main(int argc, char** argv) { return carom::run(argc, argv); }

#include "monkey_main.moc"
