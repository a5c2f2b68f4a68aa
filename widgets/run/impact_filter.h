#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "physics/ledger/impact_record.h"
#include "physics/scene/scene.h"

namespace carom {

// An impact in a list: with its number, counted from 1 over the run.
struct NumberedImpact {
  ImpactRecord record;
  std::int64_t number = 0;
};

// Which impacts a list shows: those that fulfil every term.
class ImpactFilter {
 public:
  [[nodiscard]] bool keeps(const NumberedImpact& impact, const std::vector<Body>& bodies) const;
  [[nodiscard]] bool empty() const { return words_.empty() && bounds_.empty(); }

  // A figure that a term compares with a number.
  struct Quantity {
    const char* name;  // typed in any case
    const char* unit;  // may follow the number
    double (*value)(const NumberedImpact&);
  };
  // A bound of a figure; of both kinds.
  struct Bound {
    const Quantity* quantity;
    bool above;  // the figure is to be more than the number, else less
    bool equal;  // or equal to it
    double number;
  };
  void add_word(const QString& word) { words_.push_back(word.toLower()); }
  void add(const Bound& bound) { bounds_.push_back(bound); }

 private:
  std::vector<QString> words_;  // in lower case
  std::vector<Bound> bounds_;
};

// A text that was read: the filter, or one sentence on what was not understood.
struct TypedFilter {
  ImpactFilter filter;
  QString fault;
};

// Reads terms with spaces or commas between them, such as "light wall loss > 0.1 t < 2": a part of the name of
// a body that took part, "wall" for any body that is fixed or driven, or a bound of a figure: # (the number),
// t, closing, jn, jt or loss, in the units of the table. The bodies are those of the run.
[[nodiscard]] TypedFilter typed_filter(const QString& text, const std::vector<Body>& bodies);

}  // namespace carom
