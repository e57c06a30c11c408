// SPDX-License-Identifier: GPL-3.0-or-later
// A plain driver for a fuzz target, where the compiler brings none: changes good files at random for some seconds.
//   fuzz_TARGET [SECONDS [SEED]]     or     fuzz_TARGET --file FILE     to run one file, as one that was left behind
// The input of a failed run is left in fuzz_failure.bin.
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

class Mutator {
public:
  explicit Mutator(std::uint64_t seed)
      : m_state(seed * 2654435761u + 88172645463325252u), m_files(samples::good_files()) {}

  std::string next() {
    std::string file = m_files[below(m_files.size())];
    for (std::size_t steps = 1 + below(6); steps > 0; --steps) change(file);
    return file;
  }

private:
  // xorshift, after G. Marsaglia, "Xorshift RNGs", 2003
  std::size_t below(std::size_t n) {
    m_state ^= m_state << 13;
    m_state ^= m_state >> 7;
    m_state ^= m_state << 17;
    return std::size_t(m_state % n);
  }

  void change(std::string& file) {
    using namespace std::string_view_literals;
    static constexpr std::string_view words[] = {"0"sv,
                                                 "-1"sv,
                                                 "4294967296"sv,
                                                 "2147483647"sv,
                                                 "1e999"sv,
                                                 "nan"sv,
                                                 "-"sv,
                                                 "\\\n"sv,
                                                 "#"sv,
                                                 "\n"sv,
                                                 " 3 0 1 2 "sv,
                                                 "element"sv,
                                                 "list"sv,
                                                 "uint"sv,
                                                 "OFF "sv,
                                                 "f "sv,
                                                 "v 1 1 1\n"sv,
                                                 "\0\0\0\0"sv,
                                                 "\xff\xff\xff\xff"sv,
                                                 "solid "sv,
                                                 "facet "sv,
                                                 "end_header\n"sv};
    const std::size_t at = below(file.size() + 1), length = std::min(below(20), file.size() - at);
    switch (below(7)) {
    case 0: file.resize(at); break;
    case 1: file.erase(at, length); break;
    case 2: file.insert(at, file.substr(below(file.size() + 1), length)); break;
    case 3: file.insert(at, words[below(std::size(words))]); break;
    case 4: {
      const std::string& other = m_files[below(m_files.size())];
      const std::size_t from = below(other.size());
      file.replace(at, length, other.substr(from, below(60)));
      break;
    }
    case 5:
      if (at < file.size()) file[at] = char(file[at] ^ char(1 << below(8)));
      break;
    default:
      if (at < file.size()) file[at] = char(below(256));
      break;
    }
  }

  std::uint64_t m_state;
  std::vector<std::string> m_files;
};

} // namespace

int main(int argc, char** argv) {
  for (int signal : {SIGABRT, SIGSEGV, SIGALRM, SIGFPE, SIGBUS}) std::signal(signal, keep_input);
  if (argc == 3 && std::string(argv[1]) == "--file") {
    std::ifstream in(argv[2], std::ios::binary);
    run(std::string(std::istreambuf_iterator<char>(in), {}));
    return 0;
  }
  const int seconds = argc > 1 ? std::atoi(argv[1]) : 60;
  Mutator mutator(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  long runs = 0;
  for (; std::chrono::steady_clock::now() < end; ++runs) run(current_input = mutator.next());
  std::printf("%s: %ld inputs in %d seconds, no failure\n", argv[0], runs, seconds);
  return 0;
}
