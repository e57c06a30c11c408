// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel_for.h"

#include <catch2/catch.hpp>

#include <numeric>
#include <stdexcept>
#include <string>

using namespace CGAL::Reeb_quadrangulation::internal;

TEST_CASE("every number is worked on once, however many threads there are and at once") {
  for (const int n : {0, 1, 2, 7, 100, 1001})
    for (const int threads : {0, 1, 2, 5, 2000})
      for (const int at_once : {1, 3, 100, 5000}) {
        std::vector<int> count(n, 0);
        parallel_for(n, threads, at_once, [&](int i) { ++count[i]; });
        CHECK(std::count(count.begin(), count.end(), 1) == n);
      }
}

TEST_CASE("numbers that are taken together are worked on by one thread, in order") {
  std::vector<std::thread::id> who(1000);
  std::vector<int> when(1000);
  std::atomic<int> clock{0};
  parallel_for(1000, 4, 50, [&](int i) {
    who[i] = std::this_thread::get_id();
    when[i] = clock++;
  });
  for (int i = 0; i < 1000; ++i)
    if (i % 50 != 0) CHECK((who[i] == who[i - 1] && when[i] > when[i - 1]));
}

TEST_CASE("an exception in any thread arrives, once all threads have ended, and stops what was not begun") {
  for (const int threads : {1, 2, 4})
    for (const int at_once : {1, 10})
      for (const int thrown : {0, 57, 99999}) {
        std::atomic<int> begun{0}, ended{0};
        std::string message;
        try {
          parallel_for(100000, threads, at_once, [&](int i) {
            ++begun;
            if (i == thrown) throw std::runtime_error("at " + std::to_string(i));
            ++ended;
          });
        } catch (const std::runtime_error& e) {
          message = e.what();
        }
        CHECK(message == "at " + std::to_string(thrown));
        CHECK(begun == ended + 1);
        if (thrown < 100 && threads == 1) CHECK(begun == thrown + 1);
      }
}

TEST_CASE("of several exceptions one arrives, and loops within loops are no obstacle") {
  CHECK_THROWS_AS(parallel_for(8, 4, [](int i) { throw std::out_of_range(std::to_string(i)); }),
                  std::out_of_range);
  std::vector<int> sums(6, 0);
  parallel_for(6, 3, [&](int i) {
    std::vector<int> parts(50, 0);
    parallel_for(50, 2, [&](int j) { parts[j] = i * j; });
    sums[i] = std::accumulate(parts.begin(), parts.end(), 0);
  });
  for (int i = 0; i < 6; ++i) CHECK(sums[i] == i * 1225);
}
