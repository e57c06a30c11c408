// SPDX-License-Identifier: GPL-3.0-or-later
// The corpora of the fuzz targets, as they are and changed at random a little: what `fuzz/run_fuzz` does for
// long, in every run of the tests.
#include "fuzz/fuzz_mutator.h"
#include "fuzz/fuzz_reader.h"
#include "fuzz/fuzz_request.h"
#include "fuzz/fuzz_texts.h"
#include "fuzz/fuzz_texture.h"
#include "mesh_samples.h"

#include <catch2/catch.hpp>

#include <functional>

namespace {

using Target = std::function<int(const std::uint8_t*, std::size_t)>;

void replay(const std::string& name, const Target& target, int changed) {
  const std::vector<std::string> files = fuzz::files_of(REEBQUAD_TEST_DIR "/fuzz/corpus/fuzz_read_" + name);
  REQUIRE(!files.empty());
  const auto run = [&](const std::string& file) {
    // Exactly as many bytes as there are, so that a sanitizer sees the first one too many.
    const std::vector<std::uint8_t> bytes(file.begin(), file.end());
    CHECK(target(bytes.data(), bytes.size()) == 0);
  };
  for (const std::string& file : files) run(file);
  fuzz::Mutator mutator(7, files);
  for (int i = 0; i < changed; ++i) run(mutator.next());
}

} // namespace

TEST_CASE("the corpora of the fuzz targets, and 2000 changed files of each") {
  replay("recipe", fuzz::recipe, 2000);
  replay("hints", fuzz::hints, 2000);
  replay("session", fuzz::session, 2000);
  replay("extrema", fuzz::extrema, 2000);
  replay("texture", fuzz::texture, 2000);
  replay("request", fuzz::request, 2000);
  const auto gltf = [](const std::uint8_t* data, std::size_t size) {
    return fuzz::read(data, size, fuzz::Mesh_format::glb);
  };
  replay("gltf", gltf, 2000);
}

TEST_CASE("mesh files of every format, changed at random") {
  using fuzz::Mesh_format;
  fuzz::Mutator mutator(11, samples::good_files());
  for (int i = 0; i < 1000; ++i) {
    const std::string file = mutator.next();
    const std::vector<std::uint8_t> bytes(file.begin(), file.end());
    for (const Mesh_format format :
         {Mesh_format::off, Mesh_format::obj, Mesh_format::ply, Mesh_format::stl, Mesh_format::glb})
      CHECK(fuzz::read(bytes.data(), bytes.size(), format) == 0);
  }
}
