// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Reeb_quadrangulation/Multifrontal_solver.h>

#include "base/parallel_for.h"
#include "linear/kernels.h"
#include "linear/smallest_pivot.h"
#include "linear/symbolic.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace CGAL {
namespace Reeb_quadrangulation {

namespace {

using internal::Assembly_tree;
using internal::Dense_kernels;
using internal::Front;
using internal::smallest_pivot_ratio;

// Numbers without initial values: a vector would write them once for nothing.
class Numbers {
public:
  void resize(std::size_t size) {
    if (size == m_size) return;
    m_data.reset(); // first, so that both are never there at once
    m_data.reset(new double[size]);
    m_size = size;
  }
  double* data() { return m_data.get(); }
  const double* data() const { return m_data.get(); }
  std::size_t size() const { return m_size; }

private:
  std::unique_ptr<double[]> m_data;
  std::size_t m_size = 0;
};

// What one thread needs besides the fronts.
struct Scratch {
  std::vector<double> threshold, packed;
};

// Fronts that one thread eliminates in order, with the update matrices that wait for their parents on a
// stack.
struct Task {
  std::vector<int> fronts;
  std::size_t peak = 0; // of the stack
  double operations = 0;
};

} // namespace

struct Multifrontal_solver::Implementation {
  Symmetric_matrix matrix; // the last one
  Assembly_tree tree;
  Numbers factor;
  std::vector<double*> update; // of each front, until its parent has taken it
  Numbers kept_updates;
  std::vector<Task> tasks; // independent ones, then a last one for what depends on several of them
  std::vector<Numbers> stacks;
  bool is_analyzed = false, is_factorized = false, is_incremental = false;
  int threads = 1;
  Ordering ordering = Ordering::by_size;
  int eliminated_fronts = 0;
  const Dense_kernels* kernels = &internal::dense_kernels();
  mutable std::vector<double> permuted, front_x;

  void set_tree(Assembly_tree&& new_tree, const Symmetric_matrix& pattern);
  void plan_tasks();
  std::size_t peak_of(const std::vector<int>& fronts, const std::vector<int>& task_of, int task) const;
  std::vector<char> dirty_fronts(const std::vector<double>& value) const;
  int eliminate(int s, double* target, Scratch& scratch, bool splits);
  void add_child(int child, const Front& parent, double* panel, double* target) const;
  int run(const Task& task, Numbers& stack, const std::vector<char>& dirty, bool splits);
  int eliminate_all(const std::vector<char>& dirty);
  void solve_sides(double* x, int sides) const;
};

namespace {

[[maybe_unused]] bool is_permutation(const std::vector<int>& order, int size) {
  std::vector<char> seen(size, 0);
  for (const int i : order)
    if (i < 0 || i >= size || seen[i]++) return false;
  return int(order.size()) == size;
}

// The place of a column of an update matrix such that adding a row gives the entry.
inline double* update_column(double* update, int padded_rows, int column) {
  const long block = column / internal::pack, in_block = column % internal::pack;
  const long skipped = internal::pack * block * padded_rows - 8 * block * (block - 1);
  return update + skipped + in_block * (padded_rows - internal::pack * block) - internal::pack * block;
}

} // namespace

// Adds the child's update matrix to the parent's panel and update matrix.
void Multifrontal_solver::Implementation::add_child(int child, const Front& parent, double* panel,
                                                    double* target) const {
  const Front& front = tree.fronts[child];
  const int* place = tree.row_in_parent.data() + front.rows_begin;
  const int rows = front.rows, front_rows = internal::padded(rows),
            parent_rows = internal::padded(parent.rows);
  for (int j = 0; j < rows; ++j) {
    const double* from = update_column(update[child], front_rows, j);
    double* to = place[j] < parent.columns
                     ? panel + std::size_t(place[j]) * parent.leading_dimension()
                     : update_column(target, parent_rows, place[j] - parent.columns) - parent.columns;
    for (int i = j; i < rows; ++i) to[place[i]] += from[i];
  }
}

// Factorizes one front into the factor and its update matrix into `target`. Returns the failing column or -1.
int Multifrontal_solver::Implementation::eliminate(int s, double* target, Scratch& scratch, bool splits) {
  const Front& front = tree.fronts[s];
  double* panel = factor.data() + front.panel_begin;
  const int ld = front.leading_dimension();
  std::fill_n(panel, front.panel_size(), 0.0);
  for (int k = tree.entry_begin[s]; k < tree.entry_begin[s + 1]; ++k)
    panel[tree.entry_target[k]] = matrix.value[tree.entry[k]];
  scratch.threshold.resize(front.columns);
  if (scratch.packed.size() < std::size_t(internal::scratch_size(ld)))
    scratch.packed.resize(internal::scratch_size(ld));
  for (int j = 0; j < front.columns; ++j)
    scratch.threshold[j] = smallest_pivot_ratio * panel[std::size_t(j) * ld + j];

  const bool is_leaf = tree.child_begin[s] == tree.child_begin[s + 1];
  if (!is_leaf) std::fill_n(target, front.update_size(), 0.0);
  for (int c = tree.child_begin[s]; c < tree.child_begin[s + 1]; ++c)
    add_child(tree.child[c], front, panel, target);

  const int failed =
      kernels->factorize(panel, front.columns, ld, scratch.threshold.data(), scratch.packed.data());
  if (failed >= 0) return front.first + failed;
  const int rows = internal::padded(front.rows), blocks = rows / internal::pack;
  const auto update_blocks = [&](int from, int to, double* packed) {
    kernels->update(panel, front.columns, rows, target, from, to, is_leaf, packed);
  };
  if (splits && double(rows) * rows * front.columns > 4e6) {
    // Blocks are independent; the first 29 % of them are half of the triangle.
    const int middle = int(0.29 * blocks);
    std::vector<double> packed(internal::scratch_size(ld));
    internal::parallel_for(2, 2, [&](int part) {
      if (part == 0)
        update_blocks(0, middle, packed.data());
      else
        update_blocks(middle, blocks, scratch.packed.data());
    });
  } else {
    update_blocks(0, blocks, scratch.packed.data());
  }
  return -1;
}

// Eliminates the task's fronts, or those of them that are dirty. Returns the failing column or -1.
int Multifrontal_solver::Implementation::run(const Task& task, Numbers& stack, const std::vector<char>& dirty,
                                             bool splits) {
  Scratch scratch;
  if (is_incremental) {
    for (const int s : task.fronts) {
      if (!dirty[s]) continue;
      const int failed = eliminate(s, update[s], scratch, splits);
      if (failed >= 0) return failed;
    }
    return -1;
  }
  stack.resize(task.peak);
  double* const begin = stack.data();
  double* const end = begin + task.peak;
  double* top = begin;
  for (const int s : task.fronts) {
    const int failed = eliminate(s, top, scratch, splits);
    if (failed >= 0) return failed;
    // The children's updates, at the top of this stack unless other tasks left them, are used up.
    double* place = top;
    for (int c = tree.child_begin[s]; c < tree.child_begin[s + 1]; ++c) {
      double* of_child = update[tree.child[c]];
      if (of_child >= begin && of_child < end) place = std::min(place, of_child);
    }
    const std::size_t size = tree.fronts[s].update_size();
    if (place != top) std::memmove(place, top, size * sizeof(double));
    update[s] = place;
    top = place + size;
  }
  return -1;
}

// The largest number of update entries that wait on the task's stack, the one being made included.
std::size_t Multifrontal_solver::Implementation::peak_of(const std::vector<int>& fronts,
                                                         const std::vector<int>& task_of, int task) const {
  std::size_t top = 0, peak = 0;
  for (const int s : fronts) {
    const std::size_t size = tree.fronts[s].update_size();
    peak = std::max(peak, top + size);
    for (int c = tree.child_begin[s]; c < tree.child_begin[s + 1]; ++c)
      if (task_of[tree.child[c]] == task) top -= tree.fronts[tree.child[c]].update_size();
    top += size;
  }
  return peak;
}

// Cuts the tree into subtrees of about equal work for the threads; what lies above them is left for
// afterwards.
void Multifrontal_solver::Implementation::plan_tasks() {
  const int fronts = int(tree.fronts.size());
  std::vector<double> work(fronts, 0);
  std::vector<int> task_of(fronts, -1);
  for (int s = 0; s < fronts; ++s) {
    const Front& front = tree.fronts[s];
    const double size = front.leading_dimension();
    work[s] += 1000 + size * size * front.columns;
    if (front.parent >= 0) work[front.parent] += work[s];
  }
  double total = 0;
  for (int s = 0; s < fronts; ++s)
    if (tree.fronts[s].parent < 0) total += work[s];
  tasks.assign(threads + 1, Task());
  // Parents come later, so going down the numbers meets every subtree's root before its inside. A subtree
  // goes to the thread with the least work so far.
  const double largest = threads == 1 ? total : total / (6 * threads);
  for (int s = fronts - 1; s >= 0; --s) {
    const int parent = tree.fronts[s].parent;
    if (parent >= 0 && task_of[parent] < threads) {
      task_of[s] = task_of[parent];
    } else if (work[s] > largest) {
      task_of[s] = threads;
    } else {
      task_of[s] = 0;
      for (int t = 1; t < threads; ++t)
        if (tasks[t].operations < tasks[task_of[s]].operations) task_of[s] = t;
      tasks[task_of[s]].operations += work[s];
    }
  }
  for (int s = 0; s < fronts; ++s) tasks[task_of[s]].fronts.push_back(s);
  for (int t = 0; t <= threads; ++t) tasks[t].peak = peak_of(tasks[t].fronts, task_of, t);
  stacks = std::vector<Numbers>(tasks.size());
}

// Fronts with a changed entry, and everything above them.
std::vector<char> Multifrontal_solver::Implementation::dirty_fronts(const std::vector<double>& value) const {
  const int fronts = int(tree.fronts.size());
  if (!is_factorized) return std::vector<char>(fronts, 1);
  std::vector<char> dirty(fronts, 0);
  for (int s = 0; s < fronts; ++s) {
    // The bits are compared: -0 and not-a-number are values like others here.
    for (int k = tree.entry_begin[s]; k < tree.entry_begin[s + 1] && !dirty[s]; ++k)
      dirty[s] = std::memcmp(&value[tree.entry[k]], &matrix.value[tree.entry[k]], sizeof(double)) != 0;
    if (dirty[s] && tree.fronts[s].parent >= 0) dirty[tree.fronts[s].parent] = 1;
  }
  return dirty;
}

// Returns the failing column (the smallest one of those that the threads meet) or -1.
int Multifrontal_solver::Implementation::eliminate_all(const std::vector<char>& dirty) {
  std::vector<int> failed(threads, -1);
  internal::parallel_for(threads, threads,
                         [&](int t) { failed[t] = run(tasks[t], stacks[t], dirty, false); });
  int first = -1;
  for (const int f : failed)
    if (f >= 0 && (first < 0 || f < first)) first = f;
  return first >= 0 ? first : run(tasks[threads], stacks[threads], dirty, threads > 1);
}

Multifrontal_solver::Multifrontal_solver() : m_implementation(std::make_unique<Implementation>()) {}
Multifrontal_solver::~Multifrontal_solver() = default;
Multifrontal_solver::Multifrontal_solver(Multifrontal_solver&&) noexcept = default;
Multifrontal_solver& Multifrontal_solver::operator=(Multifrontal_solver&&) noexcept = default;

int Multifrontal_solver::size() const {
  return m_implementation->matrix.size;
}
int Multifrontal_solver::eliminated_fronts() const {
  return m_implementation->eliminated_fronts;
}
int Multifrontal_solver::number_of_fronts() const {
  return int(m_implementation->tree.fronts.size());
}
double Multifrontal_solver::operations() const {
  return m_implementation->tree.operations;
}
std::size_t Multifrontal_solver::factor_size() const {
  return m_implementation->tree.factor_size;
}

void Multifrontal_solver::set_threads(int threads) {
  CGAL_precondition(threads >= 1);
  if (threads == m_implementation->threads) return;
  m_implementation->threads = threads;
  if (m_implementation->is_analyzed) m_implementation->plan_tasks();
}

void Multifrontal_solver::set_ordering(Ordering ordering) {
  m_implementation->is_analyzed = m_implementation->is_analyzed && ordering == m_implementation->ordering;
  m_implementation->ordering = ordering;
}

void Multifrontal_solver::set_incremental(bool incremental) {
  if (incremental == m_implementation->is_incremental) return;
  m_implementation->is_incremental = incremental;
  m_implementation->is_factorized = false;
  if (!incremental) m_implementation->kept_updates = Numbers();
}

void Multifrontal_solver::Implementation::set_tree(Assembly_tree&& new_tree,
                                                   const Symmetric_matrix& pattern) {
  tree = std::move(new_tree);
  matrix = pattern;
  plan_tasks();
  is_analyzed = true;
}

Result<void> Multifrontal_solver::analyze(const Symmetric_matrix& pattern) {
  Implementation& impl = *m_implementation;
  impl.is_analyzed = impl.is_factorized = false;
  const Result<void> checked = check_pattern(pattern);
  if (!checked) return checked;
  Result<Assembly_tree> tree = internal::analyze_pattern(pattern, impl.ordering);
  if (!tree) return tree.error();
  impl.set_tree(std::move(*tree), pattern);
  return {};
}

Result<void> Multifrontal_solver::analyze(const Symmetric_matrix& pattern, const std::vector<int>& order) {
  Implementation& impl = *m_implementation;
  impl.is_analyzed = impl.is_factorized = false;
  const Result<void> checked = check_pattern(pattern);
  if (!checked) return checked;
  CGAL_precondition(is_permutation(order, pattern.size));
  impl.set_tree(internal::analyze_pattern(pattern, order), pattern);
  return {};
}

const std::vector<int>& Multifrontal_solver::elimination_order() const {
  return m_implementation->tree.original;
}

Result<void> Multifrontal_solver::factorize(const Symmetric_matrix& matrix) {
  Implementation& impl = *m_implementation;
  if (!impl.is_analyzed || !same_pattern(matrix, impl.matrix)) {
    const Result<void> analyzed = analyze(matrix);
    if (!analyzed) return analyzed;
  }
  CGAL_precondition(matrix.value.size() == matrix.row.size());
  std::vector<char> dirty;
  if (impl.is_incremental) {
    dirty = impl.dirty_fronts(matrix.value);
    impl.eliminated_fronts = int(std::count(dirty.begin(), dirty.end(), 1));
  } else {
    impl.eliminated_fronts = number_of_fronts();
  }
  const bool has_updates = impl.is_factorized;
  impl.is_factorized = false; // until all fronts are, whatever is thrown
  impl.matrix.value = matrix.value;
  impl.factor.resize(impl.tree.factor_size);
  impl.update.resize(impl.tree.fronts.size());
  if (impl.is_incremental && !has_updates) {
    std::size_t size = 0;
    for (const Front& front : impl.tree.fronts) size += front.update_size();
    impl.kept_updates.resize(size);
    size = 0;
    for (std::size_t s = 0; s < impl.update.size(); ++s) {
      impl.update[s] = impl.kept_updates.data() + size;
      size += impl.tree.fronts[s].update_size();
    }
  }
  const int failed = impl.eliminate_all(dirty);
  impl.is_factorized = failed < 0;
  if (impl.is_factorized) return {};
  const int row = impl.tree.original[failed];
  return make_error(Error_code::solver_failure,
                    "The matrix is not positive definite: elimination fails at row " + std::to_string(row) +
                        ".",
                    Element_kind::none, row);
}

Result<void> Multifrontal_solver::solve(double* x, int right_hand_sides) const {
  const Implementation& impl = *m_implementation;
  if (!impl.is_factorized)
    return make_error(Error_code::solver_failure, "Solve was called before a successful factorization.");
  CGAL_precondition(right_hand_sides >= 0);
  constexpr int most = 4; // right-hand sides that a kernel takes at a time
  for (int done = 0; done < right_hand_sides; done += most)
    impl.solve_sides(x + std::size_t(done) * size(), std::min(most, right_hand_sides - done));
  return {};
}

// The columns' numbers are zero in all of a sparse right-hand side that the front cannot be reached from:
// skipping it changes nothing.
void Multifrontal_solver::Implementation::solve_sides(double* x, int sides) const {
  const int n = matrix.size;
  permuted.resize(std::size_t(n) * sides);
  int largest = 0;
  for (const Front& front : tree.fronts) largest = std::max(largest, front.leading_dimension());
  front_x.assign(std::size_t(largest) * sides, 0.0);
  for (int s = 0; s < sides; ++s)
    for (int j = 0; j < n; ++j) permuted[std::size_t(s) * n + j] = x[std::size_t(s) * n + tree.original[j]];

  const auto gather = [&](const Front& front) {
    const int* row = tree.row.data() + front.rows_begin;
    for (int s = 0; s < sides; ++s) {
      const double* from = permuted.data() + std::size_t(s) * n;
      double* to = std::copy_n(from + front.first, front.columns,
                               front_x.data() + std::size_t(s) * front.leading_dimension());
      for (int i = 0; i < front.rows; ++i) to[i] = from[row[i]];
      std::fill(to + front.rows, to + internal::padded(front.rows), 0.0);
    }
  };
  const auto scatter = [&](const Front& front, bool rows_too) {
    const int* row = tree.row.data() + front.rows_begin;
    for (int s = 0; s < sides; ++s) {
      double* to = permuted.data() + std::size_t(s) * n;
      const double* from = front_x.data() + std::size_t(s) * front.leading_dimension();
      std::copy_n(from, front.columns, to + front.first);
      from += front.columns;
      if (rows_too)
        for (int i = 0; i < front.rows; ++i) to[row[i]] = from[i];
    }
  };
  const auto is_zero = [&](const Front& front) {
    for (int s = 0; s < sides; ++s)
      for (int j = front.first; j < front.first + front.columns; ++j)
        if (permuted[std::size_t(s) * n + j] != 0) return false;
    return true;
  };

  for (const Front& front : tree.fronts) {
    if (is_zero(front)) continue;
    gather(front);
    kernels->forward(factor.data() + front.panel_begin, front.columns, front.leading_dimension(),
                     front_x.data(), sides);
    scatter(front, true);
  }
  for (auto front = tree.fronts.rbegin(); front != tree.fronts.rend(); ++front) {
    gather(*front);
    kernels->backward(factor.data() + front->panel_begin, front->columns, front->leading_dimension(),
                      front_x.data(), sides);
    scatter(*front, false);
  }
  for (int s = 0; s < sides; ++s)
    for (int j = 0; j < n; ++j) x[std::size_t(s) * n + tree.original[j]] = permuted[std::size_t(s) * n + j];
}

} // namespace Reeb_quadrangulation
} // namespace CGAL
