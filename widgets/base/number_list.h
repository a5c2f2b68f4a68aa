#pragma once

#include <QString>
#include <vector>

namespace carom {

// The numbers of a text, in rising order, each once: between them semicolons, spaces, or commas with a space;
// with a decimal point or comma. Throws SceneError if a part is no number from `least` to `largest`, naming
// what is `allowed` ("a time from 0 to 2 s").
[[nodiscard]] std::vector<double> numbers_in(const QString& text, double least, double largest,
                                             const QString& allowed);

}  // namespace carom
