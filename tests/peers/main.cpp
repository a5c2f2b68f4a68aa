#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/peers/engine.h"

// The hard cases in Carom and in other engines, side by side in one run. Prints figures, tests nothing.
namespace carom::peers {
namespace {

std::vector<Engine> engines() {
  std::vector<Engine> list = {carom_at_step_end(), carom_located()};
#ifdef CAROM_PEERS_BOX2D
  list.push_back(box2d());
#endif
#ifdef CAROM_PEERS_CHIPMUNK
  list.push_back(chipmunk());
#endif
  return list;
}

struct Request {
  std::string csv;                   // empty: none
  std::set<std::string_view> cases;  // empty: all
};

Request request(const std::vector<Case>& known, int count, char** arguments) {
  Request r;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = arguments[i];
    if (word == "--csv") {
      if (++i == count) throw std::invalid_argument("--csv needs a file");
      r.csv = arguments[i];
      continue;
    }
    if (std::none_of(known.begin(), known.end(), [&](const Case& c) { return c.id == word; })) {
      std::string ids;
      for (const Case& c : known) ids += fmt::format(" {}", c.id);
      throw std::invalid_argument(
          fmt::format("no case {}; usage: carom_peers [--csv FILE] [CASE ...], of{}", word, ids));
    }
    r.cases.insert(word);
  }
  return r;
}

void tell(const Request& wanted, const std::vector<Engine>& engines) {
  std::ofstream csv;
  if (!wanted.csv.empty()) {
    csv.open(wanted.csv);
    if (!csv) throw std::runtime_error(fmt::format("cannot write {}", wanted.csv));
    csv << "case,engine,step,figure,value,unit\n";
  }
  fmt::print("{:<18} {:<11} {:>7}  {:<33} {:>13} {}\n", "case", "engine", "step", "figure", "value", "unit");
  for (std::size_t i = 0; i < engines.front().cases.size(); ++i) {
    if (!wanted.cases.empty() && wanted.cases.count(engines.front().cases[i].id) == 0) continue;
    for (const Engine& engine : engines) {
      const Case& one = engine.cases[i];
      for (const double h : one.steps) {
        for (const Figure& f : one.run(h)) {
          fmt::print("{:<18} {:<11} {:>7}  {:<33} {:>13.5g} {}\n", one.id, engine.name,
                     fmt::format("1/{}", std::lround(1.0 / h)), f.name, f.value, f.unit);
          csv << fmt::format("{},{},{:.9g},{},{:.9g},{}\n", one.id, engine.name, h, f.name, f.value, f.unit);
        }
        std::fflush(stdout);
        csv.flush();
      }
    }
  }
}

}  // namespace
}  // namespace carom::peers

int main(int count, char** arguments) {
  try {
    const std::vector<carom::peers::Engine> engines = carom::peers::engines();
    carom::peers::tell(carom::peers::request(engines.front().cases, count, arguments), engines);
  } catch (const std::exception& error) {
    fmt::print(stderr, "carom_peers: {}\n", error.what());
    return 1;
  }
  return 0;
}
