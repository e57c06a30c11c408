// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_texts.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::extrema(data, size);
}
