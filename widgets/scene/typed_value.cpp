#include "widgets/scene/typed_value.h"

#include <type_traits>
#include <variant>

#include "widgets/edit/field_rows.h"

namespace carom {

std::vector<TypedValue> typed_sizes(const Shape& shape) {
  std::vector<TypedValue> sizes;
  std::visit(
      [&sizes]<class Form>(const Form& form) {
        if constexpr (std::is_same_v<Form, Disc> || std::is_same_v<Form, Box> || std::is_same_v<Form, Wall>) {
          for (const FieldRow& row : field_rows(form)) {
            if (const auto* number = std::get_if<double>(&row.value))
              sizes.push_back({row.label, row.range, *number});
          }
        }
        if constexpr (std::is_same_v<Form, Compound>)
          sizes.push_back({"Width", positive("m"), 2.0 * half_extent(form, 0.0).x()});
      },
      shape);
  return sizes;
}

}  // namespace carom
