#include "widgets/edit/field_rows.h"

#include <array>
#include <string>
#include <string_view>

namespace carom {
namespace {

struct LabelOf {
  std::string_view key;
  const char* label;  // UTF-8
};

// Where people say more, or less, than the key.
constexpr auto kLabels = std::to_array<LabelOf>({
    {"restitution", "Restitution e"},
    {"tangential_restitution", "Tangential restitution"},
    {"kinetic_friction", "Kinetic friction µ"},
    {"static_friction", "Static friction µs"},
    {"rolling_resistance", "Rolling resistance"},
    {"shape/radius", "Radius"},
    {"shape/width", "Width"},
    {"shape/height", "Height"},
    {"shape/length", "Length"},
    {"shape/rounding", "Rounding"},
    {"constant", "Constant G"},
    {"drive/velocity", "Drive velocity"},
    {"drive/amplitude", "Amplitude"},
    {"drive/angular_frequency", "Angular frequency ω"},
    {"drive/phase", "Phase φ"},
});

// Within its object, if that is one of a list: "shapes/0/angle" is an angle.
std::string_view key_in_object(std::string_view key) {
  const std::size_t number = key.find_first_of("0123456789");
  return number == std::string_view::npos ? key : key.substr(key.find('/', number) + 1);
}

QString label_of(const FieldPlace& place) {
  const std::string key(key_in_object(place.key));
  QString label;
  for (const LabelOf& known : kLabels) {
    if (known.key == key) label = QString::fromUtf8(known.label);
  }
  if (label.isEmpty()) {
    label = QString::fromStdString(key).replace('_', ' ').replace('/', ' ');
    label[0] = label[0].toUpper();
  }
  if (place.part >= 0) label += place.part == 0 ? " x" : " y";
  return label;
}

}  // namespace

FieldRow field_row(const FieldPlace& place, const char* meaning, const Range& range, const FieldValue& value) {
  return {place, label_of(place), QString::fromUtf8(meaning), range, value};
}

}  // namespace carom
