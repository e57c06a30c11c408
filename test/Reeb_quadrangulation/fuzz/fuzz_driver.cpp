// SPDX-License-Identifier: GPL-3.0-or-later
// A plain driver for a fuzz target, where the compiler brings none: changes good files at random for some
// seconds.
//   fuzz_TARGET [SECONDS [SEED [FOLDER]]]
//   fuzz_TARGET --file FILE      to run one file, as one that was left behind
// The good files are those of FOLDER; without one, or where it is empty, meshes of each format. Instead of
// seconds, RUNSx is a number of runs.
// The input of a failed run is left in fuzz_failure.bin.
#include "fuzz_mutator.h"
#include "mesh_samples.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::string current_input;

// Only calls that are allowed in a signal handler.
extern "C" void keep_input(int signal) {
  const int file = ::open("fuzz_failure.bin", O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file >= 0 && ::write(file, current_input.data(), current_input.size()) >= 0) ::close(file);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void run(const std::string& input) {
  // Exactly as many bytes as the input has, so that the sanitizer sees the first one too many.
  const std::vector<std::uint8_t> bytes(input.begin(), input.end());
  ::alarm(20);
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

} // namespace

int main(int argc, char** argv) {
  for (int signal : {SIGABRT, SIGSEGV, SIGALRM, SIGFPE, SIGBUS}) std::signal(signal, keep_input);
  if (argc == 3 && std::string(argv[1]) == "--file") {
    std::ifstream in(argv[2], std::ios::binary);
    run(std::string(std::istreambuf_iterator<char>(in), {}));
    return 0;
  }
  const std::string length = argc > 1 ? argv[1] : "60";
  const bool counts = length.back() == 'x';
  const long limit = std::atol(length.c_str());
  std::vector<std::string> files = argc > 3 ? fuzz::files_of(argv[3]) : std::vector<std::string>();
  if (files.empty()) files = samples::good_files();
  fuzz::Mutator mutator(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1, std::move(files));
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  long runs = 0;
  for (; counts ? runs < limit : seconds() < double(limit); ++runs) run(current_input = mutator.next());
  std::printf("%s: %ld inputs in %.0f seconds, no failure\n", argv[0], runs, seconds());
  return 0;
}
