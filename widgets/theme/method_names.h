#pragma once

#include <QString>
#include <string_view>
#include <vector>

#include "physics/scene/method.h"

namespace carom {

// A text of the tables of methods.
[[nodiscard]] inline QString text_of(std::string_view s) {
  return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

// Of each of these methods the integrator and whatever else they differ by, as short as it tells them apart:
// "RK4", or "RK4, step end, 5 ms".
[[nodiscard]] std::vector<QString> names_of(const std::vector<Method>& methods);

// The whole of a method in one line.
[[nodiscard]] QString description_of(const Method& method);

}  // namespace carom
