// SPDX-License-Identifier: GPL-3.0-or-later
// The main function of every test. A run that passed, but could not find the real meshes of some cases,
// returns 77: skipped.
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>
#include <string>

namespace {

constexpr int skipped = 77;
bool needs_models = false;
std::string running_case;
std::set<std::string> skipped_cases;

struct Case_listener : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    running_case = info.name;
    needs_models = std::count(info.tags.begin(), info.tags.end(), "models") > 0;
  }
};

CATCH_REGISTER_LISTENER(Case_listener)

} // namespace

std::optional<std::string> model_file(const std::string& name) {
  if (!needs_models) FAIL("a test case that reads " << name << " needs the tag [models]");
  const std::filesystem::path file = std::filesystem::path(REEBQUAD_MODELS_DIR) / name;
  if (std::filesystem::exists(file)) return file.string();
  if (skipped_cases.insert(running_case).second)
    std::cout << "SKIP: \"" << running_case << "\" needs " << file.string() << ", which is missing\n";
  return std::nullopt;
}

int main(int argc, char* argv[]) {
  const int status = Catch::Session().run(argc, argv);
  if (status != 0 || skipped_cases.empty()) return status;
  std::cout << skipped_cases.size() << " test cases were skipped for want of real meshes\n";
  return skipped;
}
