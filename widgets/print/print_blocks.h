#pragma once

#include <QFont>
#include <QString>
#include <vector>

#include "widgets/print/print_pages.h"

class QColor;

namespace carom {

class FigureModel;

// The blocks of printed pages, in the light colours. Sizes in px of 1/96 inch.
[[nodiscard]] QFont print_font(int size, bool bold = false);

// Text, wrapped to the page's width.
[[nodiscard]] PrintBlock print_text(const QString& text, const QFont& font, const QColor& color);
[[nodiscard]] PrintBlock print_heading(const QString& text);
// A name at the left and text beside it.
[[nodiscard]] PrintBlock print_entry(const QString& name, const QString& text);
// At least this many lines to write on.
[[nodiscard]] PrintBlock print_ruled(int lines);
// Labels with lines to write on, side by side; `share` is a label's part of the width, `text` its printed
// value.
struct PrintField {
  QString name;
  QString text;
  double share;
};
[[nodiscard]] PrintBlock print_fields(const std::vector<PrintField>& fields);

// A table of figures as shown: without rows that are wholly pale or empty; at most the first `most` rows, not
// counting sums.
[[nodiscard]] PrintBlock print_table(const FigureModel& table, int most);

// Blocks of one height side by side, `gap` px apart, in a width for `columns`.
[[nodiscard]] PrintBlock print_row(std::vector<PrintBlock> blocks, int columns, double gap);

}  // namespace carom
