#pragma once

#include <string>
#include <vector>

namespace carom {

// An observable of certain bodies, by their names.
struct QuantityName {
  std::string observable;           // a name of physics/observe/observables.h
  std::vector<std::string> bodies;  // as many as the observable asks for
  // On a plot: its closed form in t (s) and, over another quantity, in x (see physics/observe/expression.h).
  std::string theory{};
  bool residual = false;  // what is shown is the observable less the theory

  bool operator==(const QuantityName&) const = default;
};

}  // namespace carom
