#pragma once

class QWidget;

namespace carom {

// Opens the help pages (app/help, Markdown), a list of them at the left, in a window of their own.
void show_help(QWidget* parent);

}  // namespace carom
