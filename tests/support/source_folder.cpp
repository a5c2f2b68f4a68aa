#include "tests/support/source_folder.h"

namespace carom::test {

std::filesystem::path source(const std::filesystem::path& name) {
  return std::filesystem::path(CAROM_SOURCE_DIR) / name;
}

}  // namespace carom::test
