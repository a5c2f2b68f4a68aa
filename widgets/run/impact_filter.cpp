#include "widgets/run/impact_filter.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cstddef>

namespace carom {
namespace {

constexpr auto kQuantities = std::to_array<ImpactFilter::Quantity>({
    {"#", "", [](const NumberedImpact& i) { return static_cast<double>(i.number); }},
    {"t", "s", [](const NumberedImpact& i) { return i.record.time; }},
    {"closing", "m/s", [](const NumberedImpact& i) { return i.record.closing_speed; }},
    {"jn", "N·s", [](const NumberedImpact& i) { return i.record.normal_impulse; }},
    {"jt", "N·s", [](const NumberedImpact& i) { return i.record.tangential_impulse; }},
    {"loss", "J", [](const NumberedImpact& i) { return lost_energy(i.record); }},
});
constexpr const char* kWall = "wall";
constexpr const char* kComparisons = "<>=≤≥";

QString tr(const char* text) { return QCoreApplication::translate("ImpactFilter", text); }

QString lower_name(const Body& body) { return QString::fromStdString(body.name).toLower(); }

const ImpactFilter::Quantity* quantity_of(const QString& name) {
  const auto found = std::find_if(kQuantities.begin(), kQuantities.end(), [&](const auto& quantity) {
    return name.compare(QString::fromUtf8(quantity.name), Qt::CaseInsensitive) == 0;
  });
  return found == kQuantities.end() ? nullptr : &*found;
}

// Words, comparisons and numbers. A comma between digits is a decimal one.
QStringList tokens_of(const QString& text) {
  static const QRegularExpression token(
      QStringLiteral("<=|>=|[<>=≤≥]|\"[^\"]*\"|(?:(?<=\\d),(?=\\d)|[^\\s,<>=≤≥\"])+"));
  QStringList tokens;
  for (auto match = token.globalMatch(text); match.hasNext();) tokens << match.next().captured();
  return tokens;
}

class Reader {
 public:
  Reader(const QString& text, const std::vector<Body>& bodies) : tokens_(tokens_of(text)), bodies_(bodies) {}

  TypedFilter read() {
    TypedFilter typed;
    while (at_ < tokens_.size() && typed.fault.isEmpty()) {
      const QString word = tokens_[at_++];
      typed.fault = comparison_next() || is_comparison(word) ? read_bound(word, typed.filter)
                                                             : read_word(word, typed.filter);
    }
    return typed;
  }

 private:
  static bool is_comparison(const QString& token) {
    return QString::fromUtf8(kComparisons).contains(token.front());
  }
  [[nodiscard]] bool comparison_next() const { return at_ < tokens_.size() && is_comparison(tokens_[at_]); }

  // Returns what is wrong, if anything is.
  QString read_word(QString word, ImpactFilter& filter) const {
    word.remove('"');
    const bool known = word.compare(kWall, Qt::CaseInsensitive) == 0 ||
                       std::any_of(bodies_.begin(), bodies_.end(),
                                   [&](const Body& body) { return lower_name(body).contains(word.toLower()); });
    if (!known && quantity_of(word) != nullptr) return tr("after \"%1\" comes < or > and a number").arg(word);
    if (!known) return tr("no body is called \"%1\"").arg(word);
    filter.add_word(word);
    return {};
  }

  QString read_bound(const QString& name, ImpactFilter& filter) {
    const ImpactFilter::Quantity* quantity = quantity_of(name);
    if (is_comparison(name)) return tr("before \"%1\" comes #, t, closing, jn, jt or loss").arg(name);
    if (quantity == nullptr) return tr("\"%1\" is none of #, t, closing, jn, jt, loss").arg(name);
    const QString comparison = tokens_[at_++];
    bool is_number = false;
    const QString text = at_ < tokens_.size() ? tokens_[at_++] : QString();
    const double number = QString(text).replace(',', '.').replace(QChar(0x2212), '-').toDouble(&is_number);
    if (!is_number) return tr("after \"%1 %2\" comes a number").arg(name, comparison);
    const QString unit = QString::fromUtf8(quantity->unit);
    if (at_ < tokens_.size() && !unit.isEmpty() && tokens_[at_] == unit) ++at_;
    add(filter, *quantity, comparison, number);
    return {};
  }

  static void add(ImpactFilter& filter, const ImpactFilter::Quantity& quantity, const QString& comparison,
                  double number) {
    const bool exact = comparison == QStringLiteral("=");
    const bool above = comparison.startsWith('>') || comparison == QStringLiteral("≥");
    const bool equal = exact || comparison.endsWith('=') || comparison == QStringLiteral("≥") ||
                       comparison == QStringLiteral("≤");
    filter.add({&quantity, above, equal, number});
    if (exact) filter.add({&quantity, true, true, number});
  }

  QStringList tokens_;
  const std::vector<Body>& bodies_;
  qsizetype at_ = 0;
};

bool fulfils(const ImpactFilter::Bound& bound, const NumberedImpact& impact) {
  const double value = bound.quantity->value(impact);
  return (bound.above ? value > bound.number : value < bound.number) || (bound.equal && value == bound.number);
}

}  // namespace

bool ImpactFilter::keeps(const NumberedImpact& impact, const std::vector<Body>& bodies) const {
  const std::array both = {&bodies[static_cast<std::size_t>(impact.record.a)],
                           &bodies[static_cast<std::size_t>(impact.record.b)]};
  const auto means = [](const QString& word, const Body& body) {
    return lower_name(body).contains(word) || (word == kWall && has_infinite_mass(body));
  };
  return std::all_of(bounds_.begin(), bounds_.end(),
                     [&](const Bound& bound) { return fulfils(bound, impact); }) &&
         std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return means(word, *both[0]) || means(word, *both[1]); });
}

TypedFilter typed_filter(const QString& text, const std::vector<Body>& bodies) {
  return Reader(text, bodies).read();
}

}  // namespace carom
