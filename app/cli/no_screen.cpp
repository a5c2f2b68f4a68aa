#include "app/cli/no_screen.h"

#include <QString>
#include <QtGlobal>
#include <fmt/format.h>

namespace carom {
namespace {

// Drops Qt's warnings about a missing screen: they do not concern a user who asked for a picture.
void quiet_messages(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
  if (type == QtCriticalMsg || type == QtFatalMsg) fmt::print(stderr, "carom: {}\n", message.toStdString());
}

}  // namespace

void use_no_screen() {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler(quiet_messages);
}

}  // namespace carom
