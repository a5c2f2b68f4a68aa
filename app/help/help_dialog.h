#pragma once

class QString;
class QWidget;

namespace carom {

// Opens the help pages (app/help, Markdown), a list of them at the left, in a window of their own. `keys` is
// the page of keys (keys_page.h).
enum class HelpPage { kFirstLesson, kKeys };
void show_help(QWidget* parent, const QString& keys, HelpPage page = HelpPage::kFirstLesson);

}  // namespace carom
