// SPDX-License-Identifier: GPL-3.0-or-later
// The three solver models, the two ways to enforce constraints and the ways to change them, in one run: JSON
// lines. Usage: bench_solver [triangles [repetitions]]. Medians of the process's CPU time, except where
// "wall" is said. For the table of the manual: 20000, 100000, 400000 and 1000000 triangles.
#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/Eigen_solver.h>
#include <CGAL/Reeb_quadrangulation/Harmonic_field.h>
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>

using namespace CGAL::Reeb_quadrangulation;
using Json = nlohmann::ordered_json;

namespace {

struct Stopwatch {
  std::clock_t cpu = std::clock();
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
  double cpu_ms() const { return 1e3 * double(std::clock() - cpu) / CLOCKS_PER_SEC; }
  double wall_ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wall).count();
  }
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

template <class Action> double median_ms(int repetitions, Action action) {
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const Stopwatch watch;
    action();
    times.push_back(watch.cpu_ms());
  }
  return median(times);
}

void need(const Result<void>& result) {
  if (result) return;
  std::cerr << result.error().message << '\n';
  std::exit(1);
}

// Numbers in [0, 1): xorshift64*.
double next(std::uint64_t& state) {
  state ^= state >> 12;
  state ^= state << 25;
  state ^= state >> 27;
  return double((state * 2685821657736338717ull) >> 11) / 9007199254740992.0;
}

// A bumpy torus with scattered points, whose triangles split their quads either way and whose vertices are
// numbered at random, as a file's may be: no lattice for the ordering to profit from.
Triangle_surface scattered_torus(int triangles) {
  const int n = std::max(3, int(std::sqrt(triangles / 4.0))), m = std::max(3, triangles / (2 * n));
  std::uint64_t state = 88172645463325252ull;
  std::vector<int> id(std::size_t(m) * n);
  for (std::size_t i = 0; i < id.size(); ++i) id[i] = int(i);
  for (std::size_t i = id.size() - 1; i > 0; --i)
    std::swap(id[i], id[std::size_t(next(state) * double(i + 1))]);
  Triangle_surface s;
  s.points.resize(id.size());
  const double turn = 2 * std::acos(-1.0);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = turn * (i + 0.6 * next(state)) / m, b = turn * (j + 0.6 * next(state)) / n;
      const double r = 0.4 + 0.05 * std::sin(5 * a) * std::cos(3 * b), d = 1 + r * std::cos(b);
      s.points[id[std::size_t(i) * n + j]] = Point(d * std::cos(a), d * std::sin(a), r * std::sin(b));
    }
  const auto at = [&](int i, int j) { return id[std::size_t(i % m) * n + j % n]; };
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (next(state) < 0.5) {
        s.triangles.push_back({a, b, c});
        s.triangles.push_back({a, c, d});
      } else {
        s.triangles.push_back({a, b, d});
        s.triangles.push_back({b, c, d});
      }
    }
  need(s.connect());
  return s;
}

// Of a solver that has analyzed the matrix.
template <class Solver>
Json time_factored(Solver& solver, const char* name, const Symmetric_matrix& m, const std::vector<double>& b,
                   int repetitions) {
  Json line{{"benchmark", "solver"}, {"model", name}, {"unknowns", m.size}};
  need(solver.factorize(m)); // memory is there from now on, as in an editor
  Stopwatch wall;
  line["factorize_ms"] = median_ms(repetitions, [&] { need(solver.factorize(m)); });
  line["factorize_wall_mean_ms"] = wall.wall_ms() / repetitions;
  for (const int sides : {1, 2, 4}) {
    std::vector<double> x;
    for (int q = 0; q < sides; ++q) x.insert(x.end(), b.begin(), b.end());
    const std::vector<double> start = x;
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
      x = start;
      const Stopwatch watch;
      need(solver.solve(x.data(), sides));
      times.push_back(watch.cpu_ms());
    }
    line["solve_" + std::to_string(sides) + "_ms"] = median(times);
    line["residual"] = relative_residual(m, x.data(), b.data());
  }
  return line;
}

template <class Solver>
Json time_solver(Solver& solver, const char* name, const Symmetric_matrix& m, const std::vector<double>& b,
                 int repetitions) {
  const double analysis = median_ms(std::max(1, repetitions / 4), [&] { need(solver.analyze(m)); });
  Json line = time_factored(solver, name, m, b, repetitions);
  line["analyze_ms"] = analysis;
  return line;
}

void set(Harmonic_field& field, int vertex, double value) {
  need(field.set_constraint(vertex, value));
}

// One constraint moved about, as a drag of an extremum does. The first solve, which orders and factorizes, is
// told apart.
Json time_moved_constraint(const Triangle_surface& s, const Field_solver_options& options, bool incremental,
                           int repetitions) {
  Harmonic_field field(s, options);
  field.set_incremental(incremental);
  const int vertices = s.number_of_vertices();
  set(field, 0, 0);
  set(field, vertices / 2, 1);
  const auto solve = [&] {
    if (const auto solved = field.solve(); !solved) need(solved.error());
  };
  const double first = median_ms(1, solve);
  std::uint64_t state = 1234567;
  int moved = vertices / 2;
  const double time = median_ms(repetitions, [&] {
    field.remove_constraint(moved);
    moved = 1 + int(next(state) * (vertices - 1));
    set(field, moved, 1);
    solve();
  });
  return {{"benchmark", "field, one constraint moved"},
          {"solver", options.solver.name()},
          {"method", options.constraints == Constraint_method::penalty ? "penalty" : "elimination"},
          {"incremental", incremental},
          {"first_ms", first},
          {"ms", time}};
}

// One entry of the matrix changed at a time.
void time_incremental(const Symmetric_matrix& matrix, int repetitions) {
  Multifrontal_solver incremental;
  incremental.set_incremental(true);
  need(incremental.factorize(matrix));
  Symmetric_matrix changing = matrix;
  std::uint64_t state = 777;
  double fronts = 0;
  const double update = median_ms(repetitions, [&] {
    changing.value[changing.column_begin[int(next(state) * changing.size)]] += 1;
    need(incremental.factorize(changing));
    fronts += double(incremental.eliminated_fronts()) / repetitions;
  });
  std::cout << Json{{"benchmark", "incremental factorization"},
                    {"one_entry_ms", update},
                    {"mean_fronts", fronts}}
                   .dump()
            << std::endl;
}

// A row added to the matrix of a factor at a time.
void time_update(Cholmod_solver& cholmod, const Symmetric_matrix& matrix, int repetitions) {
  need(cholmod.factorize(matrix));
  need(cholmod.add_to_diagonal({1}, {1.0})); // converts the factor
  std::uint64_t state = 777;
  const double updown =
      median_ms(repetitions, [&] { need(cholmod.add_to_diagonal({int(next(state) * matrix.size)}, {1.0})); });
  std::cout << Json{{"benchmark", "cholmod update"}, {"one_row_ms", updown}}.dump() << std::endl;
}

void time_moved_constraints(const Triangle_surface& s, int repetitions) {
  for (const char* name : {"multifrontal", "cholmod", "eigen"})
    for (const Constraint_method method : {Constraint_method::elimination, Constraint_method::penalty})
      for (const bool reuse : {false, true}) {
        if (reuse && std::string(name) == "eigen") continue; // which has nothing to reuse
        const Field_solver_options options{*linear_solver_named(name), method};
        std::cout << time_moved_constraint(s, options, reuse, repetitions).dump() << std::endl;
      }
}

} // namespace

int main(int argc, char** argv) {
  const int triangles = argc > 1 ? std::atoi(argv[1]) : 400000,
            repetitions = argc > 2 ? std::atoi(argv[2]) : 9;
  if (triangles < 100 || repetitions < 1) return 2;
  const Triangle_surface s = scattered_torus(triangles);
  const int vertices = s.number_of_vertices();
  std::vector<char> fixed(vertices, 0);
  std::vector<double> values(vertices, 0.0);
  fixed[0] = fixed[vertices / 2] = 1;
  values[vertices / 2] = 1;

  Json assembly{{"benchmark", "assembly"}, {"triangles", s.number_of_faces()}};
  Edge_weights weights;
  Laplace_system system;
  assembly["weights_ms"] = median_ms(repetitions, [&] { weights = cotangent_weights(s); });
  assembly["assemble_ms"] = median_ms(repetitions, [&] { system = assemble(s, weights, fixed); });
  const std::vector<double> b = right_hand_side(s, weights, system, values);
  std::cout << assembly.dump() << std::endl;

  Multifrontal_solver own, two_threads;
  two_threads.set_threads(2);
  Cholmod_solver cholmod, dissected(Cholmod_solver::Ordering::nested_dissection), ordered;
  Eigen_solver eigen;
  const Json ours = time_solver(own, "multifrontal", system.matrix, b, repetitions);
  std::cout << ours.dump() << std::endl;
  std::cout << time_solver(two_threads, "multifrontal, 2 threads", system.matrix, b, repetitions).dump()
            << std::endl;
  const Json reference = time_solver(cholmod, "cholmod, minimum degree", system.matrix, b, repetitions);
  std::cout << reference.dump() << std::endl;
  std::cout << time_solver(dissected, "cholmod, nested dissection", system.matrix, b, repetitions).dump()
            << std::endl;
  need(ordered.analyze(system.matrix, own.elimination_order()));
  std::cout << time_factored(ordered, "cholmod, the order of multifrontal", system.matrix, b, repetitions)
            << std::endl;
  std::cout << time_solver(eigen, "eigen", system.matrix, b, std::max(1, repetitions / 4)).dump()
            << std::endl;
  const auto total = [](const Json& j) { return double(j["factorize_ms"]) + double(j["solve_1_ms"]); };
  std::cout << Json{{"benchmark", "ratio"},
                    {"cholmod_over_multifrontal_factorize_and_solve", total(reference) / total(ours)},
                    {"factor_numbers", own.factor_size()},
                    {"operations", own.operations()},
                    {"fronts", own.number_of_fronts()}}
                   .dump()
            << std::endl;

  time_incremental(system.matrix, repetitions);
  time_update(cholmod, system.matrix, repetitions);
  time_moved_constraints(s, repetitions);
}
