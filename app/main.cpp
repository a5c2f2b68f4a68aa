#include "app/command_line.h"

int main(int argc, char** argv) { return carom::run_program(argc, argv); }
