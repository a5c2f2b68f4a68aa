// Prints what a change affects, one path a line.
//   carom_affected sources|tests FILE ...
// sources: the source files to check again: those among FILE, and those that include one of FILE, directly or
//   not.
// tests: the files of tests to run again (see IncludeGraph::tests).
//
// Paths are relative to the top of the sources, as git prints them; what is gone is left out.
#include <cstdio>
#include <string_view>

#include "tests/support/include_graph.h"
#include "tests/support/source_folder.h"

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what != "sources" && what != "tests") {
    std::fprintf(stderr, "carom_affected: carom_affected sources|tests FILE ...\n");
    return 2;
  }
  const carom::test::IncludeGraph graph(carom::test::source(""));
  const std::set<std::filesystem::path> changed(argv + 2, argv + argc);
  for (const auto& file : what == "tests" ? graph.tests(changed) : graph.affected(changed)) {
    if (what == "tests" || (file.extension() == ".cpp" && graph.includes().contains(file)))
      std::puts(file.c_str());
  }
  return 0;
}
