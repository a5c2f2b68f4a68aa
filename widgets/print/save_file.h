#pragma once

#include <QByteArray>
#include <QString>
#include <functional>

#include "physics/files/output_file.h"

namespace carom {

// Saves what `write` writes. The file is replaced only when all of it is there; else the answer is false and
// `error` says why. `write` may throw SceneError.
[[nodiscard]] bool save_file(const QString& path, const std::function<void(OutputFile&)>& write,
                             QString* error);

void write_bytes(OutputFile& file, const QByteArray& bytes);

}  // namespace carom
