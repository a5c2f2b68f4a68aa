#pragma once

#include <QString>

#include "app/lab/session.h"

// Runs under two methods into which discs come on the way.
namespace carom {

inline constexpr double kLateDiscsEnd = 2.0;  // s
[[nodiscard]] Preset late_discs_preset();
// Runs it to the end, with discs at 0.7 s and 1.2 s.
void add_late_discs(Session& session);
// Waits until all runs are at the end with so many edits.
void wait_for_late_discs(const Session& session, std::size_t edits = 2);
// Does it in a window, keeps that work in the folder, says so on standard output and plays on until it is
// killed: the child process of a test.
int keep_late_discs(const QString& folder);

}  // namespace carom
