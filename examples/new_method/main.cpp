#include "bench/app/program.h"
#include "methods/gathering/gathering.h"

int main(int argc, char** argv) { return gibench::run_program(argc, argv, {gibench::gathering_entry()}); }
