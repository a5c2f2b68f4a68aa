#pragma once

namespace carom {

// Reads the command line, carries out the command and returns the exit code: 0 good, 1 a check fell short, 2
// bad input.
int run_program(int argc, char** argv);

}  // namespace carom
