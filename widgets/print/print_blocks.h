#pragma once

#include <QFont>
#include <QString>
#include <vector>

#include "widgets/print/print_pages.h"

class QColor;

namespace carom {

class FigureModel;

// What printed pages are made of, in the light colours. Sizes in px of 1/96 inch.
[[nodiscard]] QFont print_font(int size, bool bold = false);

// Text in lines of the page's width.
[[nodiscard]] PrintBlock print_text(const QString& text, const QFont& font, const QColor& color);
[[nodiscard]] PrintBlock print_heading(const QString& text);
// A name at the left, and text beside it.
[[nodiscard]] PrintBlock print_entry(const QString& name, const QString& text);
// Lines to write on, at least so many.
[[nodiscard]] PrintBlock print_ruled(int lines);
// Words with a line to write on, beside each other; `share` is its part of the width, `text` what stands there.
struct PrintField {
  QString name;
  QString text;
  double share;
};
[[nodiscard]] PrintBlock print_fields(const std::vector<PrintField>& fields);

// A table of figures as it stands: without rows that are pale or empty throughout; of more than `most` rows,
// not counting sums, the first ones.
[[nodiscard]] PrintBlock print_table(const FigureModel& table, int most);

// Blocks of one height side by side, `gap` px between them, room left for `columns`.
[[nodiscard]] PrintBlock print_row(std::vector<PrintBlock> blocks, int columns, double gap);

}  // namespace carom
