#include "app/command_line.hpp"

int main(int argc, char** argv) { return eisph::run_program(argc, argv); }
