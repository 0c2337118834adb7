#include "references/command.h"

int main(int argc, char** argv) { return rays::references_command(argc, argv); }
