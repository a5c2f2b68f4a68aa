#include "widgets/base/number_list.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <fmt/format.h>

#include "physics/scene/validate.h"

namespace carom {

std::vector<double> numbers_in(const QString& text, double least, double largest, const QString& allowed) {
  static const QRegularExpression between("[;\\s]+|,\\s+");
  std::vector<double> numbers;
  for (QString part : text.split(between, Qt::SkipEmptyParts)) {
    part.replace(',', '.');  // a decimal comma
    bool good = false;
    const double number = part.toDouble(&good);
    if (!good || !(number >= least && number <= largest)) {
      throw SceneError(
          fmt::format("{} is not allowed; allowed: {}", shortened(part.toStdString()), allowed.toStdString()));
    }
    numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace carom
