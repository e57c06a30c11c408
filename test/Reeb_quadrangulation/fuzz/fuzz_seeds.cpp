// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the good files that the fuzz targets begin with into a folder:  fuzz_seeds FOLDER
#include "mesh_samples.h"

#include <fstream>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  int number = 0;
  for (const std::string& file : samples::good_files())
    std::ofstream(std::string(argv[1]) + "/seed_" + std::to_string(number++), std::ios::binary) << file;
  return 0;
}
