#include "apps/program/program.h"

int main(int argc, char** argv) { return shellmatch_main(argc, argv); }
