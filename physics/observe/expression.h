#pragma once

#include <compare>
#include <memory>
#include <string>
#include <vector>

namespace carom {

// A closed form as people write it: "2*exp(-t/3)", "t < 1 ? 3*t : 3". A value; copies share what was compiled.
// Names are `t` and, where it is asked for, `x`; pi; sin, cos, tan and their like, exp, ln, log10, sqrt, abs,
// min, max, floor, ceil, mod (never negative) and others; operators are + - * / ^ < <= > >= == != && || ?:.
class Expression {
 public:
  Expression() = default;  // none
  // Throws SceneError, one line: where the slip is, what is wrong, and which names are allowed.
  Expression(const std::string& text, bool with_x);

  [[nodiscard]] bool empty() const { return compiled_ == nullptr; }
  [[nodiscard]] const std::string& text() const { return text_; }
  // Hangs on t. It may be asked from several threads. NaN where there is no value, and of no expression.
  [[nodiscard]] bool uses_t() const { return uses_t_; }
  [[nodiscard]] double operator()(double t, double x = 0.0) const;

  // By the text.
  bool operator==(const Expression& other) const { return text_ == other.text_; }
  auto operator<=>(const Expression& other) const { return text_ <=> other.text_; }

 private:
  struct Compiled;

  std::string text_;
  bool uses_t_ = false;
  std::shared_ptr<Compiled> compiled_;
};

}  // namespace carom
