#pragma once

class QWidget;

namespace carom {

// Opens the help pages (app/help, Markdown) in a window of their own.
void show_help(QWidget* parent);

}  // namespace carom
