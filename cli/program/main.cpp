// SPDX-License-Identifier: MIT
#include "program.hpp"

int main(int argc, char** argv) {
  return stillpoint::cli::run(argc, argv);
}
