#include "bench/app/program.h"

int main(int argc, char** argv) { return gibench::run_program(argc, argv); }
