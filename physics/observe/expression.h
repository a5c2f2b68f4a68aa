#pragma once

#include <compare>
#include <memory>
#include <string>
#include <vector>

namespace carom {

// A formula as people write it: "2*exp(-t/3)", "t < 1 ? 3*t : 3". A value; copies share the compiled form.
// Names are `t` and, with `with_x`, `x`; pi; sin, cos, tan and similar, exp, ln, log10, sqrt, abs, min, max,
// floor, ceil, mod (never negative) and others; operators are + - * / ^ < <= > >= == != && || ?:.
class Expression {
 public:
  Expression() = default;  // no formula
  // Throws SceneError, one line: the position of the mistake, what is wrong, and which names are allowed.
  Expression(const std::string& text, bool with_x);

  [[nodiscard]] bool empty() const { return compiled_ == nullptr; }
  [[nodiscard]] const std::string& text() const { return text_; }
  // Depends on t. Thread-safe. NaN where there is no value, or without a formula.
  [[nodiscard]] bool uses_t() const { return uses_t_; }
  [[nodiscard]] double operator()(double t, double x = 0.0) const;

  // Compares the text.
  bool operator==(const Expression& other) const { return text_ == other.text_; }
  auto operator<=>(const Expression& other) const { return text_ <=> other.text_; }

 private:
  struct Compiled;

  std::string text_;
  bool uses_t_ = false;
  std::shared_ptr<Compiled> compiled_;
};

}  // namespace carom
