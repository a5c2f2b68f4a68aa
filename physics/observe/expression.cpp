#include "physics/observe/expression.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <muParser.h>
#include <mutex>
#include <numbers>

#include "physics/scene/validate.h"

namespace carom {
namespace {

constexpr std::size_t kLongest = 2000;  // characters

double floor_of(double a) { return std::floor(a); }
double ceil_of(double a) { return std::ceil(a); }
// In [0, |b|).
double mod_of(double a, double b) {
  const double rest = std::fmod(a, b);
  return rest < 0.0 ? rest + std::abs(b) : rest;
}

// The error and its position, in our own words: the library's describe its internals.
std::string reason_of(const mu::Parser::exception_type& error) {
  std::string found = error.GetToken();
  while (!found.empty() && found.back() == ' ') found.pop_back();
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN:
      return fmt::format("\"{}\" is not known", shortened(found));
    case mu::ecUNEXPECTED_EOF:
      return "it ends too soon";
    case mu::ecEMPTY_EXPRESSION:
      return "it is empty";
    case mu::ecMISSING_PARENS:
      return "a bracket is not closed";
    case mu::ecMISSING_ELSE_CLAUSE:
      return "a \"?\" without its \":\"";
    case mu::ecTOO_MANY_PARAMS:
      return fmt::format("\"{}\" has too many arguments", found);
    case mu::ecTOO_FEW_PARAMS:
      return fmt::format("\"{}\" has too few arguments", found);
    default:
      return found.empty() ? error.GetMsg() : fmt::format("\"{}\" cannot stand there", shortened(found));
  }
}

}  // namespace

// The parser keeps its stack and reads the variables during evaluation: one caller at a time.
struct Expression::Compiled {
  std::mutex mutex;
  double t = 0.0;
  double x = 0.0;
  mu::Parser parser;

  explicit Compiled(bool with_x) {
    parser.ClearConst();
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineFun("floor", floor_of);
    parser.DefineFun("ceil", ceil_of);
    parser.DefineFun("mod", mod_of);
    parser.DefineVar("t", &t);
    if (with_x) parser.DefineVar("x", &x);
  }
  [[nodiscard]] std::string names() const {
    std::string all = "t";
    for (const auto& [name, variable] : parser.GetVar()) all += name == "t" ? "" : ", " + name;
    for (const auto& [name, value] : parser.GetConst()) all += ", " + name;
    for (const auto& [name, function] : parser.GetFunDef()) all += ", " + name;
    return all;
  }
};

Expression::Expression(const std::string& text, bool with_x)
    : text_(text), compiled_(std::make_shared<Compiled>(with_x)) {
  mu::Parser& parser = compiled_->parser;
  const auto refuse = [&](const std::string& reason, int place) {
    throw SceneError(fmt::format("\"{}\"{}: {}; allowed: an expression of {}", shortened(text),
                                 place < 0 ? "" : fmt::format(" at character {}", place + 1), reason,
                                 compiled_->names()));
  };
  if (text.size() > kLongest) refuse(fmt::format("it is longer than {} characters", kLongest), -1);
  // The library would read a lone = as an assignment.
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const bool compares = (i > 0 && std::string_view("=<>!").find(text[i - 1]) != std::string_view::npos) ||
                          (i + 1 < text.size() && text[i + 1] == '=');
    if (!compares) refuse("\"=\" cannot stand there", static_cast<int>(i));
  }
  try {
    parser.SetExpr(text);
    (void)parser.Eval();
    if (parser.GetNumResults() != 1) refuse("it has several values", -1);
    uses_t_ = parser.GetUsedVar().contains("t");
  } catch (const mu::Parser::exception_type& error) {
    refuse(reason_of(error), static_cast<int>(error.GetPos()));
  }
}

double Expression::operator()(double t, double x) const {
  if (empty()) return std::numeric_limits<double>::quiet_NaN();
  const std::lock_guard lock(compiled_->mutex);
  compiled_->t = t;
  compiled_->x = x;
  try {
    return compiled_->parser.Eval();
  } catch (const mu::Parser::exception_type&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace carom
