#include "cli/program.h"

int main(int argc, char** argv) { return verisim::cli::run({argv, argv + argc}); }
