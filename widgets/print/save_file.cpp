#include "widgets/print/save_file.h"

#include "physics/scene/validate.h"

namespace carom {

bool save_file(const QString& path, const std::function<void(OutputFile&)>& write, QString* error) {
  try {
    OutputFile file(path.toStdString());
    write(file);
    file.commit();
    return true;
  } catch (const SceneError& refusal) {
    if (error != nullptr) *error = QString::fromUtf8(refusal.what());
    return false;
  }
}

void write_bytes(OutputFile& file, const QByteArray& bytes) {
  file.write({bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace carom
