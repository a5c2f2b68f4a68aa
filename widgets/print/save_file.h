#pragma once

#include <QByteArray>
#include <QString>
#include <functional>

#include "physics/files/output_file.h"

namespace carom {

// Saves the output of `write`. The file is replaced only when it is complete; otherwise returns false with the
// reason in `error`. `write` may throw SceneError.
[[nodiscard]] bool save_file(const QString& path, const std::function<void(OutputFile&)>& write,
                             QString* error);

void write_bytes(OutputFile& file, const QByteArray& bytes);

}  // namespace carom
