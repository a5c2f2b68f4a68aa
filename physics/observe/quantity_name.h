#pragma once

#include <string>
#include <vector>

namespace carom {

// An observable of certain bodies, by their names.
struct QuantityName {
  std::string observable;           // a name of physics/observe/observables.h
  std::vector<std::string> bodies;  // as many as the observable needs
  // On a plot: its formula in t (s) and, over another quantity, in x (see physics/observe/expression.h).
  std::string theory{};
  bool residual = false;  // shows the observable less the theory

  bool operator==(const QuantityName&) const = default;
};

}  // namespace carom
