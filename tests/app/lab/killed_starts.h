#pragma once

#include <QString>

namespace carom {

// Makes one new start after the other in a window and keeps the work in the folder each time, with a line on
// standard output, until it is killed: the child process of a test.
int keep_starts(const QString& folder);

}  // namespace carom
