#include "app/cli/command_line.h"
#include "app/cli/standard_output.h"

int main(int argc, char** argv) {
  carom::prepare_process();
  return carom::run_program(argc, argv);
}
