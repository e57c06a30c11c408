// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Cholmod_solver.h>
#include <CGAL/Reeb_quadrangulation/Eigen_solver.h>
#include <CGAL/Reeb_quadrangulation/Field_solver_options.h>
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>
#include <CGAL/Reeb_quadrangulation/laplacian.h>

#include "linear/kernels.h"
#include "tiny_surfaces.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <numeric>
#include <string>

using namespace CGAL::Reeb_quadrangulation;

namespace {

// A fixed sequence of numbers in [0, 1): xorshift64*.
class Sequence {
public:
  explicit Sequence(std::uint64_t seed) : m_state(seed * 2685821657736338717ull + 1) {}
  double next() {
    m_state ^= m_state >> 12;
    m_state ^= m_state << 25;
    m_state ^= m_state >> 27;
    return double((m_state * 2685821657736338717ull) >> 11) / 9007199254740992.0;
  }
  int below(int n) { return int(next() * n); }

private:
  std::uint64_t m_state;
};

Symmetric_matrix sparse(const Eigen::MatrixXd& a) {
  Symmetric_matrix m;
  m.size = int(a.rows());
  m.column_begin.push_back(0);
  for (int j = 0; j < m.size; ++j) {
    for (int i = j; i < m.size; ++i)
      if (i == j || a(i, j) != 0) {
        m.row.push_back(i);
        m.value.push_back(a(i, j));
      }
    m.column_begin.push_back(int(m.row.size()));
  }
  return m;
}

std::vector<int> all_numbers(int count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

struct Named_matrix {
  std::string name;
  Eigen::MatrixXd matrix;
};

// Diagonally dominant, so positive definite, with off-diagonal entries wherever `has_entry` says.
template <class Has_entry> Eigen::MatrixXd dominant(int n, Sequence& random, Has_entry has_entry) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = j + 1; i < n; ++i)
      if (has_entry(i, j)) a(i, j) = a(j, i) = random.next() - 0.7;
  for (int j = 0; j < n; ++j) a(j, j) = 0.1 + random.next() + a.col(j).cwiseAbs().sum();
  return a;
}

std::vector<Named_matrix> definite_matrices() {
  Sequence random(1);
  std::vector<Named_matrix> all;
  all.push_back({"empty", Eigen::MatrixXd(0, 0)});
  all.push_back({"one number", Eigen::MatrixXd::Constant(1, 1, 4.0)});
  all.push_back({"diagonal", dominant(23, random, [](int, int) { return false; })});
  for (const int n : {2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 33, 64, 101})
    all.push_back({"dense " + std::to_string(n), dominant(n, random, [](int, int) { return true; })});
  all.push_back({"arrow to the first", dominant(60, random, [](int, int j) { return j == 0; })});
  all.push_back({"arrow to the last", dominant(60, random, [](int i, int) { return i == 59; })});
  all.push_back({"tridiagonal", dominant(90, random, [](int i, int j) { return i == j + 1; })});
  all.push_back({"blocks apart", dominant(80, random, [](int i, int j) { return i / 9 == j / 9; })});
  all.push_back({"grid", dominant(144, random,
                                  [](int i, int j) { return i == j + 12 || (i == j + 1 && i % 12 != 0); })});
  for (const double density : {0.01, 0.03, 0.1, 0.4})
    for (int k = 0; k < 5; ++k)
      all.push_back({"random, density " + std::to_string(density),
                     dominant(30 + 25 * k, random, [&](int, int) { return random.next() < density; })});
  return all;
}

Eigen::VectorXd random_vector(int n, Sequence& random) {
  Eigen::VectorXd b(n);
  for (int i = 0; i < n; ++i) b[i] = 2 * random.next() - 1;
  return b;
}

bool same_bits(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.size() == b.size() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

// The Laplacian of a torus with one vertex held: large enough for several fronts and tasks.
Symmetric_matrix torus_matrix(int m, int n) {
  const Triangle_surface s = tiny::torus(m, n);
  std::vector<char> fixed(s.points.size(), 0);
  fixed[5] = 1;
  return assemble(s, clamped_cotangent_weights(s), fixed).matrix;
}

} // namespace

TEMPLATE_TEST_CASE("the solution is that of a dense factorization, whatever the matrix's shape", "",
                   Multifrontal_solver, Cholmod_solver, Eigen_solver) {
  Sequence random(2);
  TestType reused;
  for (const Named_matrix& named : definite_matrices()) {
    INFO(named.name);
    const Symmetric_matrix m = sparse(named.matrix);
    TestType fresh;
    for (TestType* solver : {&reused, &fresh}) {
      REQUIRE(bool(solver->factorize(m)));
      CHECK(solver->size() == m.size);
      const Eigen::VectorXd b = random_vector(m.size, random);
      Eigen::VectorXd x = b;
      REQUIRE(bool(solver->solve(x.data())));
      CHECK(relative_residual(m, x.data(), b.data()) < 1e-14);
      if (m.size == 0) continue;
      const Eigen::VectorXd expected = named.matrix.ldlt().solve(b);
      CHECK((x - expected).norm() <= 1e-11 * expected.norm());
    }
  }
}

TEST_CASE("right-hand sides solved together have the bits of those solved alone") {
  Sequence random(3);
  const Symmetric_matrix m = torus_matrix(30, 21);
  Multifrontal_solver solver;
  REQUIRE(bool(solver.factorize(m)));
  for (const int sides : {2, 3, 4, 5, 9}) {
    Eigen::MatrixXd together(m.size, sides);
    for (int q = 0; q < sides; ++q) together.col(q) = random_vector(m.size, random);
    Eigen::MatrixXd alone = together;
    REQUIRE(bool(solver.solve(together.data(), sides)));
    for (int q = 0; q < sides; ++q) REQUIRE(bool(solver.solve(alone.col(q).data())));
    CHECK(same_bits(together, alone));
  }
}

TEST_CASE("this machine's kernels give the bits of the portable ones") {
  using internal::Dense_kernels;
  Sequence random(10);
  const Dense_kernels &fast = internal::dense_kernels(), &portable = internal::portable_dense_kernels();
  for (const int columns : {1, 2, 3, 4, 5, 7, 8, 13, 64, 67, 68, 69, 140})
    for (const int rows : {0, 4, 8, 12, 44, 48, 52, 100}) {
      const int ld = columns + rows;
      Eigen::MatrixXd panel(ld, columns), update(ld * ld + 16, 1), x(ld, 3);
      for (Eigen::MatrixXd* a : {&panel, &update, &x})
        for (Eigen::Index i = 0; i < a->size(); ++i) a->data()[i] = random.next() - 0.5;
      for (int j = 0; j < columns; ++j) panel(j, j) += ld;
      const std::vector<double> threshold(columns, 0.0);
      std::vector<double> scratch(internal::scratch_size(ld));
      for (const bool is_zero : {false, true}) {
        Eigen::MatrixXd p = panel, q = panel, u = update, v = update, y = x, z = x;
        REQUIRE(fast.factorize(p.data(), columns, ld, threshold.data(), scratch.data()) == -1);
        REQUIRE(portable.factorize(q.data(), columns, ld, threshold.data(), scratch.data()) == -1);
        fast.update(p.data(), columns, rows, u.data(), 0, rows / 4, is_zero, scratch.data());
        const int middle = rows / 12; // in two parts, as two threads do
        portable.update(q.data(), columns, rows, v.data(), 0, middle, is_zero, scratch.data());
        portable.update(q.data(), columns, rows, v.data(), middle, rows / 4, is_zero, scratch.data());
        fast.forward(p.data(), columns, ld, y.data(), 3);
        portable.forward(q.data(), columns, ld, z.data(), 3);
        fast.backward(p.data(), columns, ld, y.data(), 3);
        portable.backward(q.data(), columns, ld, z.data(), 3);
        CHECK(same_bits(p, q));
        CHECK(same_bits(u, v));
        CHECK(same_bits(y, z));
      }
    }
}

TEST_CASE("threads, repetition and a new solver leave the bits as they are") {
  Sequence random(4);
  for (const Symmetric_matrix& m : {torus_matrix(9, 7), torus_matrix(120, 70)}) {
    const Eigen::VectorXd b = random_vector(m.size, random);
    Multifrontal_solver first;
    REQUIRE(bool(first.factorize(m)));
    Eigen::VectorXd expected = b;
    REQUIRE(bool(first.solve(expected.data())));
    for (const int threads : {2, 1, 3, 2}) {
      Multifrontal_solver fresh;
      for (Multifrontal_solver* solver : {&first, &fresh}) {
        solver->set_threads(threads);
        Eigen::VectorXd x = b;
        REQUIRE(bool(solver->factorize(m)));
        REQUIRE(bool(solver->solve(x.data())));
        CHECK(same_bits(x, expected));
      }
    }
  }
}

TEST_CASE("an incremental factorization has the bits of one from scratch and redoes less") {
  Sequence random(5);
  Symmetric_matrix m = torus_matrix(90, 60);
  const auto ordering = GENERATE(Multifrontal_solver::Ordering::minimum_degree,
                                 Multifrontal_solver::Ordering::nested_dissection);
  Multifrontal_solver incremental;
  incremental.set_ordering(ordering);
  incremental.set_incremental(true);
  REQUIRE(bool(incremental.factorize(m)));
  CHECK(incremental.eliminated_fronts() == incremental.number_of_fronts());
  REQUIRE(bool(incremental.factorize(m)));
  CHECK(incremental.eliminated_fronts() == 0);
  for (int round = 0; round < 20; ++round) {
    incremental.set_threads(1 + round % 2);
    for (int k = 0; k < 3; ++k) {
      const int j = random.below(m.size);
      m.value[m.column_begin[j]] += random.next();
      if (m.column_begin[j] + 1 < m.column_begin[j + 1]) m.value[m.column_begin[j] + 1] *= random.next();
    }
    REQUIRE(bool(incremental.factorize(m)));
    CHECK(incremental.eliminated_fronts() > 0);
    CHECK(incremental.eliminated_fronts() < incremental.number_of_fronts() / 2);
    Multifrontal_solver scratch;
    scratch.set_ordering(ordering);
    REQUIRE(bool(scratch.factorize(m)));
    Eigen::VectorXd x = random_vector(m.size, random), y = x;
    REQUIRE(bool(incremental.solve(x.data())));
    REQUIRE(bool(scratch.solve(y.data())));
    CHECK(same_bits(x, y));
  }
}

TEST_CASE("after a refusal an incremental solver is as good as a new one") {
  Symmetric_matrix m = torus_matrix(20, 20);
  Multifrontal_solver solver;
  solver.set_incremental(true);
  REQUIRE(bool(solver.factorize(m)));
  const double diagonal = m.value[m.column_begin[77]];
  m.value[m.column_begin[77]] = -1;
  const auto refused = solver.factorize(m);
  REQUIRE(!refused);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(m.size), y = x;
  CHECK(solver.solve(x.data()).error().code == Error_code::solver_failure);
  m.value[m.column_begin[77]] = diagonal;
  Multifrontal_solver fresh;
  REQUIRE(bool(solver.factorize(m)));
  REQUIRE(bool(fresh.factorize(m)));
  REQUIRE(bool(solver.solve(x.data())));
  REQUIRE(bool(fresh.solve(y.data())));
  CHECK(same_bits(x, y));
}

TEST_CASE("every ordering serves matrices of every shape") {
  Sequence random(9);
  std::vector<Named_matrix> all = definite_matrices();
  all.push_back({"large and diagonal", dominant(2500, random, [](int, int) { return false; })});
  all.push_back({"large arrow", dominant(2500, random, [](int, int j) { return j == 0; })});
  all.push_back({"many blocks", dominant(2500, random, [](int i, int j) { return i / 3 == j / 3; })});
  all.push_back({"long chain", dominant(2500, random, [](int i, int j) { return i == j + 1; })});
  for (const Named_matrix& named : all) {
    INFO(named.name);
    const Symmetric_matrix m = sparse(named.matrix);
    const Eigen::VectorXd b = random_vector(m.size, random);
    for (const auto ordering :
         {Multifrontal_solver::Ordering::minimum_degree, Multifrontal_solver::Ordering::nested_dissection}) {
      Multifrontal_solver solver;
      solver.set_ordering(ordering);
      REQUIRE(bool(solver.factorize(m)));
      Eigen::VectorXd x = b;
      REQUIRE(bool(solver.solve(x.data())));
      CHECK(relative_residual(m, x.data(), b.data()) < 1e-14);
    }
  }
}

TEST_CASE("nested dissection saves operations on a large surface, and its order is always the same") {
  const Symmetric_matrix m = torus_matrix(260, 160);
  Multifrontal_solver degree, dissection, again, automatic;
  degree.set_ordering(Multifrontal_solver::Ordering::minimum_degree);
  dissection.set_ordering(Multifrontal_solver::Ordering::nested_dissection);
  again.set_ordering(Multifrontal_solver::Ordering::nested_dissection);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(m.size), y = x, z = x;
  REQUIRE((bool(degree.factorize(m)) && bool(degree.solve(x.data()))));
  REQUIRE((bool(dissection.factorize(m)) && bool(dissection.solve(y.data()))));
  REQUIRE((bool(again.factorize(m)) && bool(again.solve(z.data()))));
  REQUIRE(bool(automatic.analyze(m)));
  CHECK(dissection.operations() < 0.8 * degree.operations());
  CHECK(automatic.operations() == dissection.operations());
  CHECK(same_bits(y, z));
  CHECK((x - y).norm() < 1e-9 * x.norm());
}

TEST_CASE("an order that is given is used, and what it leaves of a part of the unknowns serves the part") {
  const Symmetric_matrix m = torus_matrix(120, 90);
  Multifrontal_solver whole, again, backwards;
  whole.set_ordering(Multifrontal_solver::Ordering::nested_dissection);
  CHECK(whole.elimination_order().empty());
  REQUIRE(bool(whole.factorize(m)));
  const std::vector<int> order = whole.elimination_order();
  CHECK(std::is_permutation(order.begin(), order.end(), all_numbers(m.size).begin()));
  REQUIRE((bool(again.analyze(m, order)) && bool(again.factorize(m))));
  CHECK(again.operations() < 1.01 * whole.operations()); // fronts may be merged a little differently
  REQUIRE(bool(backwards.analyze(m, all_numbers(m.size))));
  CHECK(backwards.operations() > 3 * whole.operations());

  // The first half of the rows, with their part of the order.
  Symmetric_matrix part;
  part.size = m.size / 2;
  part.column_begin.push_back(0);
  for (int j = 0; j < part.size; ++j) {
    for (int k = m.column_begin[j]; k < m.column_begin[j + 1]; ++k)
      if (m.row[k] < part.size) {
        part.row.push_back(m.row[k]);
        part.value.push_back(m.value[k]);
      }
    part.column_begin.push_back(int(part.row.size()));
  }
  std::vector<int> part_order;
  std::copy_if(order.begin(), order.end(), std::back_inserter(part_order),
               [&](int v) { return v < part.size; });
  Multifrontal_solver solver;
  REQUIRE((bool(solver.analyze(part, part_order)) && bool(solver.factorize(part))));
  CHECK(solver.operations() < whole.operations());
  const std::vector<double> b(part.size, 1.0);
  std::vector<double> x = b;
  REQUIRE(bool(solver.solve(x.data())));
  CHECK(relative_residual(part, x.data(), b.data()) < 1e-14);
}

TEMPLATE_TEST_CASE("a matrix that is not positive definite is refused by a row", "", Multifrontal_solver,
                   Cholmod_solver, Eigen_solver) {
  Sequence random(6);
  for (const Named_matrix& named : definite_matrices()) {
    INFO(named.name);
    if (named.matrix.rows() == 0) continue;
    const int row = random.below(int(named.matrix.rows()));
    for (const double value : {-1.0, 0.0, std::nan(""), double(INFINITY)}) {
      INFO(value);
      Eigen::MatrixXd a = named.matrix;
      a(row, row) = value;
      TestType solver;
      const auto refused = solver.factorize(sparse(a));
      REQUIRE(!refused);
      CHECK(refused.error().code == Error_code::solver_failure);
      CHECK(refused.error().index >= 0);
      CHECK(refused.error().index < a.rows());
      if (named.name == "diagonal") CHECK(refused.error().index == row);
      CHECK(!solver.solve(a.data()));
      REQUIRE(bool(solver.factorize(sparse(named.matrix))));
    }
  }
}

TEMPLATE_TEST_CASE("a closed surface's Laplacian without a constraint is singular and refused", "",
                   Multifrontal_solver, Cholmod_solver, Eigen_solver) {
  for (const Triangle_surface& s :
       {tiny::tetrahedron(), tiny::octahedron(), tiny::torus(7, 5), tiny::torus(80, 50)}) {
    CHECK(!TestType().factorize(assemble(s, cotangent_weights(s)).matrix));
    CHECK(!TestType().factorize(assemble(s, uniform_weights(s)).matrix));
  }
}

TEMPLATE_TEST_CASE("malformed matrices are refused before anything is computed", "", Multifrontal_solver,
                   Cholmod_solver, Eigen_solver) {
  TestType solver;
  CHECK(!solver.factorize({2, {0, 1}, {0}, {1}}));                // arrays of the wrong length
  CHECK(!solver.factorize({2, {0, 1, 2}, {0, 0}, {1, 1}}));       // a column without its diagonal
  CHECK(!solver.factorize({2, {0, 2, 3}, {0, 2, 1}, {1, 1, 1}})); // a row beyond the size
  CHECK(!solver.factorize({3, {0, 3, 4, 5}, {0, 2, 1, 1, 2}, {1, 1, 1, 1, 1}})); // rows out of order
  CHECK(!solver.solve(nullptr));
}

TEST_CASE("the three models agree on surfaces") {
  Sequence random(7);
  const Symmetric_matrix m = torus_matrix(110, 80);
  const Eigen::VectorXd b = random_vector(m.size, random);
  Eigen::VectorXd multifrontal = b, cholmod = b, dissected = b, eigen = b;
  Multifrontal_solver a;
  Cholmod_solver c, d(Cholmod_solver::Ordering::nested_dissection);
  Eigen_solver e;
  REQUIRE((bool(a.factorize(m)) && bool(a.solve(multifrontal.data()))));
  REQUIRE((bool(c.factorize(m)) && bool(c.solve(cholmod.data()))));
  REQUIRE((bool(d.factorize(m)) && bool(d.solve(dissected.data()))));
  REQUIRE((bool(e.factorize(m)) && bool(e.solve(eigen.data()))));
  for (const Eigen::VectorXd& x : {cholmod, dissected, eigen})
    CHECK((x - multifrontal).lpNorm<Eigen::Infinity>() < 1e-10 * multifrontal.lpNorm<Eigen::Infinity>());
}

TEST_CASE("updates of CHOLMOD's factor are factorizations of the changed matrix") {
  Sequence random(8);
  Symmetric_matrix m = torus_matrix(40, 30);
  Cholmod_solver updated, fresh;
  REQUIRE(bool(updated.factorize(m)));
  const auto check_equal = [&](double tolerance) {
    const Eigen::VectorXd b = random_vector(m.size, random);
    Eigen::VectorXd x = b, y = b;
    REQUIRE(bool(fresh.factorize(m)));
    REQUIRE(bool(updated.solve(x.data())));
    REQUIRE(bool(fresh.solve(y.data())));
    CHECK((x - y).norm() < tolerance * y.norm());
  };
  const std::vector<int> rows = {3, 900, 17};
  for (const int i : rows) m.value[m.column_begin[i]] += 50;
  REQUIRE(bool(updated.add_to_diagonal(rows, {50, 50, 50})));
  check_equal(1e-11);
  for (const int i : rows) m.value[m.column_begin[i]] -= 50;
  REQUIRE(bool(updated.add_to_diagonal(rows, {-50, -50, -50})));
  check_equal(1e-10);

  CHECK(!updated.add_to_diagonal({10}, {-1e6}));
  CHECK(!updated.solve(m.value.data()));
}

TEST_CASE("CHOLMOD goes back to a kept factor, and what is solved then has the bits of before") {
  Sequence random(11);
  const Symmetric_matrix m = torus_matrix(50, 40);
  const Eigen::VectorXd b = random_vector(m.size, random);
  const auto solution = [&](Cholmod_solver& solver, const std::vector<int>& rows) {
    REQUIRE(bool(solver.factorize(m)));
    REQUIRE(bool(solver.add_to_diagonal(rows, std::vector<double>(rows.size(), 1e6))));
    Eigen::VectorXd x = b;
    REQUIRE(bool(solver.solve(x.data())));
    return x;
  };
  Cholmod_solver kept, fresh;
  kept.set_incremental(true);
  const Eigen::VectorXd first = solution(kept, {7});
  CHECK(!same_bits(solution(kept, {1500, 20}), first));
  CHECK(same_bits(solution(kept, {7}), first));
  CHECK(!kept.add_to_diagonal({10}, {-1e9})); // leaves no factor, but the kept one
  CHECK(!kept.solve(Eigen::VectorXd(b).data()));
  CHECK(same_bits(solution(kept, {7}), first));
  CHECK(same_bits(solution(fresh, {7}), first));
  kept.set_incremental(false); // the updates stay
  Eigen::VectorXd x = b;
  REQUIRE(bool(kept.solve(x.data())));
  CHECK(same_bits(x, first));
}

TEMPLATE_TEST_CASE("an order is told, and one that is given is taken", "", Multifrontal_solver,
                   Cholmod_solver) {
  Sequence random(12);
  const Symmetric_matrix m = torus_matrix(60, 40);
  TestType found, given;
  CHECK(found.elimination_order().empty());
  REQUIRE(bool(found.factorize(m)));
  std::vector<int> order = found.elimination_order();
  CHECK(std::is_permutation(order.begin(), order.end(), all_numbers(m.size).begin()));
  REQUIRE(bool(given.analyze(m, order)));
  REQUIRE(bool(given.factorize(m)));
  Eigen::VectorXd x = Eigen::VectorXd::Ones(m.size), y = x;
  REQUIRE((bool(found.solve(x.data())) && bool(given.solve(y.data()))));
  CHECK((x - y).norm() < 1e-10 * x.norm());
  // Along a chain, each unknown waits for the one before: no two can change places.
  order = all_numbers(90);
  const Symmetric_matrix chain = sparse(dominant(90, random, [](int i, int j) { return i == j + 1; }));
  for (int turn = 0; turn < 2; ++turn) {
    REQUIRE(bool(given.analyze(chain, order)));
    CHECK(given.elimination_order() == order);
    std::reverse(order.begin(), order.end());
  }
}

namespace {

// No more than the concept asks for: a dense inverse.
class Dense_solver {
public:
  Dense_solver() = default;
  Dense_solver(Dense_solver&&) = default;
  Dense_solver& operator=(Dense_solver&&) = default;

  Result<void> analyze(const Symmetric_matrix& pattern) { return check_pattern(pattern); }
  Result<void> factorize(const Symmetric_matrix& m) {
    if (const Result<void> checked = analyze(m); !checked) return checked;
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(m.size, m.size);
    for (int j = 0; j < m.size; ++j)
      for (int k = m.column_begin[j]; k < m.column_begin[j + 1]; ++k) a(m.row[k], j) = m.value[k];
    const Eigen::LLT<Eigen::MatrixXd> factor(a.selfadjointView<Eigen::Lower>());
    m_size = m.size;
    if (factor.info() != Eigen::Success)
      return make_error(Error_code::solver_failure, "not positive definite");
    m_inverse = factor.solve(Eigen::MatrixXd::Identity(m.size, m.size));
    return {};
  }
  Result<void> solve(double* x, int right_hand_sides = 1) const {
    Eigen::Map<Eigen::MatrixXd> columns(x, m_size, right_hand_sides);
    columns = (m_inverse * columns).eval();
    return {};
  }
  int size() const { return m_size; }

private:
  Eigen::MatrixXd m_inverse;
  int m_size = 0;
};

} // namespace

TEST_CASE("any model can be held, and what it has beyond the concept is found") {
  const Symmetric_matrix m = torus_matrix(30, 12);
  const auto solved = [&](Any_linear_solver solver) {
    solver.set_threads(2);
    solver.set_incremental(true);
    REQUIRE(bool(solver.analyze(m, all_numbers(m.size))));
    REQUIRE(bool(solver.factorize(m)));
    Eigen::MatrixXd x = Eigen::MatrixXd::Ones(m.size, 2);
    REQUIRE(bool(solver.solve(x.data(), 2)));
    CHECK(solver.size() == m.size);
    return x;
  };
  Multifrontal_solver plain;
  REQUIRE((bool(plain.analyze(m, all_numbers(m.size))) && bool(plain.factorize(m))));
  Eigen::MatrixXd expected = Eigen::MatrixXd::Ones(m.size, 2);
  REQUIRE(bool(plain.solve(expected.data(), 2)));
  CHECK(same_bits(solved(Any_linear_solver()), expected));
  CHECK(same_bits(solved(Linear_solver_factory()()), expected));
  for (const Linear_solver_factory& make :
       {sparse_linear_solver<Cholmod_solver>(), sparse_linear_solver<Eigen_solver>(),
        sparse_linear_solver<Dense_solver>("dense")})
    CHECK((solved(make()) - expected).norm() < 1e-10 * expected.norm());

  Any_linear_solver dense = sparse_linear_solver<Dense_solver>()(),
                    cholmod = sparse_linear_solver<Cholmod_solver>()();
  REQUIRE((bool(dense.factorize(m)) && bool(cholmod.factorize(m))));
  CHECK(dense.elimination_order().empty());
  CHECK(!dense.can_update());
  CHECK(dense.add_to_diagonal({0}, {1}).error().code == Error_code::solver_failure);
  CHECK(cholmod.elimination_order().size() == std::size_t(m.size));
  CHECK(cholmod.can_update());
  CHECK(bool(cholmod.add_to_diagonal({0}, {1})));
}

TEST_CASE("solvers are chosen by name, and a name that is none is refused by the names that there are") {
  for (const char* name : {"multifrontal", "cholmod", "eigen"}) {
    const Result<Linear_solver_factory> found = linear_solver_named(name);
    REQUIRE(bool(found));
    CHECK(found->name() == name);
    CHECK((*found)().can_update() == (found->name() == "cholmod"));
  }
  CHECK(sparse_linear_solver<Eigen_solver>().name() == "eigen");
  CHECK(sparse_linear_solver<Dense_solver>().name() == "custom");
  const Result<Linear_solver_factory> none = linear_solver_named("gauss");
  REQUIRE(!none);
  CHECK(none.error().code == Error_code::impossible_request);
  for (const char* word : {"gauss", "multifrontal", "cholmod", "eigen"})
    CHECK(none.error().message.find(word) != std::string::npos);
}
