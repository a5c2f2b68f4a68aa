#include "widgets/base/plain_text.h"

#include <QApplication>
#include <QEvent>
#include <QMessageBox>
#include <QTextDocument>

namespace carom {
namespace {

class PlainMessages : public QObject {
 public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override {
    // Before the layout, which would read pictures in the text.
    if (event->type() == QEvent::Polish && watched->isWidgetType()) {
      auto* label = qobject_cast<QLabel*>(watched);
      if (label != nullptr && qobject_cast<QMessageBox*>(label->parentWidget()) != nullptr &&
          label->textFormat() == Qt::AutoText)
        label->setTextFormat(Qt::PlainText);
    }
    return QObject::eventFilter(watched, event);
  }
};

}  // namespace

QString plain_tip(const QString& text) {
  if (!Qt::mightBeRichText(text)) return text;
  return "<span>" + text.toHtmlEscaped().replace('\n', "<br>") + "</span>";
}

void keep_messages_plain() {
  static const char* const kName = "plain-messages";
  if (qApp->findChild<QObject*>(kName, Qt::FindDirectChildrenOnly) != nullptr) return;
  auto* filter = new PlainMessages(qApp);
  filter->setObjectName(kName);
  qApp->installEventFilter(filter);
}

}  // namespace carom
