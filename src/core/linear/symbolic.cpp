// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear/symbolic.h"

#include "linear/ordering.h"

#include <algorithm>
#include <numeric>

namespace CGAL {
namespace Reeb_quadrangulation {
namespace internal {

namespace {

// Lists of integers, one after the other.
struct Lists {
  std::vector<int> begin, item;
};

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = int(i);
  return place;
}

// Entries as pairs of two different unknowns, `visit` calling an action with each, turned into lists: for
// each unknown, those before it (`earlier`) or those after it.
template <class Visit> Lists lists_of(int size, bool earlier, Visit visit) {
  Lists lists;
  lists.begin.assign(size + 1, 0);
  visit([&](int a, int b) { ++lists.begin[((a > b) == earlier ? a : b) + 1]; });
  std::partial_sum(lists.begin.begin(), lists.begin.end(), lists.begin.begin());
  lists.item.resize(lists.begin.back());
  std::vector<int> end(lists.begin.begin(), lists.begin.end() - 1);
  visit([&](int a, int b) {
    if ((a > b) != earlier) std::swap(a, b);
    lists.item[end[a]++] = b;
  });
  return lists;
}

// The off-diagonal entries with rows and columns renumbered by `place`: for each unknown, those before it.
Lists earlier_entries(const Symmetric_matrix& m, const std::vector<int>& place) {
  return lists_of(m.size, true, [&](auto action) {
    for (int j = 0; j < m.size; ++j)
      for (int k = m.column_begin[j] + 1; k < m.column_begin[j + 1]; ++k) action(place[m.row[k]], place[j]);
  });
}

// The same entries once more renumbered. Where the two orders are much alike, this runs through memory in
// order.
Lists renumbered(const Lists& lists, const std::vector<int>& place, bool earlier) {
  const int size = int(place.size());
  return lists_of(size, earlier, [&](auto action) {
    for (int i = 0; i < size; ++i)
      for (int k = lists.begin[i]; k < lists.begin[i + 1]; ++k) action(place[i], place[lists.item[k]]);
  });
}

// Liu's algorithm: the parent of a column is the first later one that its elimination touches.
std::vector<int> elimination_tree(const Lists& earlier, int size) {
  std::vector<int> parent(size, -1), ancestor(size, -1);
  for (int j = 0; j < size; ++j)
    for (int k = earlier.begin[j]; k < earlier.begin[j + 1]; ++k)
      for (int i = earlier.item[k]; i != -1 && i < j;) {
        const int next = ancestor[i];
        ancestor[i] = j;
        if (next == -1) parent[i] = j;
        i = next;
      }
  return parent;
}

// Children before parents; roots and siblings keep their order. `parent` must be increasing along the tree.
std::vector<int> postorder(const std::vector<int>& parent) {
  const int size = int(parent.size());
  std::vector<int> head(size, -1), next(size, -1), order, stack;
  order.reserve(size);
  for (int j = size - 1; j >= 0; --j)
    if (parent[j] >= 0) {
      next[j] = head[parent[j]];
      head[parent[j]] = j;
    }
  for (int root = 0; root < size; ++root) {
    if (parent[root] >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int j = stack.back();
      if (head[j] >= 0) {
        const int c = head[j];
        head[j] = next[c];
        stack.push_back(c);
      } else {
        order.push_back(j);
        stack.pop_back();
      }
    }
  }
  return order;
}

// The number of entries of each column of the factor, diagonal included, for columns in postorder: each row
// of the factor is a subtree; its leaves add one to their column and their lowest common ancestors take one
// away.
std::vector<int> column_counts(const Lists& later, const std::vector<int>& parent) {
  const int size = int(parent.size());
  std::vector<int> first(size), count(size, 0), latest_first(size, -1), latest_leaf(size, -1), set(size);
  std::iota(first.begin(), first.end(), 0);
  std::iota(set.begin(), set.end(), 0);
  for (int j = 0; j < size; ++j) {
    if (first[j] == j) count[j] = 1; // a leaf of the tree
    if (parent[j] >= 0) first[parent[j]] = std::min(first[parent[j]], first[j]);
  }
  for (int j = 0; j < size; ++j) {
    if (parent[j] >= 0) --count[parent[j]];
    for (int k = later.begin[j]; k < later.begin[j + 1]; ++k) {
      const int i = later.item[k];
      if (first[j] <= latest_first[i]) continue; // j is no leaf of row i
      latest_first[i] = first[j];
      ++count[j];
      const int leaf = latest_leaf[i];
      latest_leaf[i] = j;
      if (leaf < 0) continue;
      int root = leaf;
      while (root != set[root]) root = set[root];
      for (int s = leaf; s != root;) {
        const int above = set[s];
        set[s] = root;
        s = above;
      }
      --count[root];
    }
    if (parent[j] >= 0) set[j] = parent[j];
  }
  for (int j = 0; j < size; ++j)
    if (parent[j] >= 0) count[parent[j]] += count[j];
  return count;
}

double operations(double columns, double rows) {
  const double m = columns + rows;
  return m * (m + 1) * (2 * m + 1) / 6 - rows * (rows + 1) * (2 * rows + 1) / 6;
}

// Estimated nanoseconds that a front costs in one factorization and a solve or two. Halving or doubling a
// constant changed measured times of surfaces by less than their noise; and it changes nothing but times.
double estimated_time(double columns, double rows) {
  constexpr double start = 250, operation = 0.035, panel_entry = 1.0, update_entry = 0.9;
  return start + operation * operations(columns, rows) + panel_entry * columns * (columns + rows) +
         update_entry * rows * (rows + 1) / 2;
}

// Columns in postorder -> the fronts they belong to (with gaps in the numbering), columns and rows of each
// front.
struct Partition {
  std::vector<int> front_of, columns, rows, parent;
};

Partition fundamental_fronts(const std::vector<int>& parent, const std::vector<int>& count) {
  const int size = int(parent.size());
  Partition p;
  p.front_of.resize(size);
  for (int j = 0; j < size; ++j) {
    const bool continues = j > 0 && parent[j - 1] == j && count[j - 1] == count[j] + 1;
    if (!continues) {
      p.columns.push_back(0);
      p.rows.push_back(0);
    }
    p.front_of[j] = int(p.columns.size()) - 1;
    ++p.columns.back();
    p.rows.back() = count[j] - 1;
  }
  p.parent.assign(p.columns.size(), -1);
  for (int j = 0; j < size; ++j)
    if (parent[j] >= 0 && p.front_of[parent[j]] != p.front_of[j])
      p.parent[p.front_of[j]] = p.front_of[parent[j]];
  return p;
}

// Merges fronts into their parents, leaves first, where the estimated time of the two exceeds that of the
// merged one.
void merge_fronts(Partition& p) {
  const int fronts = int(p.columns.size());
  std::vector<int> merged_into(fronts);
  std::iota(merged_into.begin(), merged_into.end(), 0);
  for (int s = 0; s < fronts; ++s) {
    const int q = p.parent[s];
    if (q < 0) continue;
    const double apart = estimated_time(p.columns[s], p.rows[s]) + estimated_time(p.columns[q], p.rows[q]);
    if (estimated_time(p.columns[s] + p.columns[q], p.rows[q]) > apart) continue;
    p.columns[q] += p.columns[s];
    p.columns[s] = 0;
    merged_into[s] = q;
  }
  for (int s = fronts - 1; s >= 0; --s) merged_into[s] = merged_into[merged_into[s]];
  for (int& s : p.front_of) s = merged_into[s];
  for (int s = 0; s < fronts; ++s)
    if (p.parent[s] >= 0) p.parent[s] = merged_into[p.parent[s]];
}

// An order of the fronts that keeps few update matrices waiting at a time (Liu 1986): among siblings, those
// whose subtrees need much more room than the update they leave come first.
std::vector<int> order_fronts(const Partition& p) {
  const int fronts = int(p.columns.size());
  std::vector<std::vector<int>> children(fronts);
  std::vector<double> peak(fronts, 0), left(fronts, 0);
  std::vector<int> roots;
  for (int s = 0; s < fronts; ++s) {
    if (p.columns[s] == 0) continue;
    Front front;
    front.rows = p.rows[s];
    left[s] = double(front.update_size());
    std::vector<int>& c = children[s];
    std::sort(c.begin(), c.end(), [&](int a, int b) {
      const double x = peak[a] - left[a], y = peak[b] - left[b];
      return x != y ? x > y : a < b;
    });
    double waiting = 0;
    for (const int a : c) {
      peak[s] = std::max(peak[s], waiting + peak[a]);
      waiting += left[a];
    }
    peak[s] = std::max(peak[s], waiting + left[s]);
    (p.parent[s] >= 0 ? children[p.parent[s]] : roots).push_back(s);
  }
  std::vector<int> order, stack;
  for (const int root : roots) {
    // Reversed preorder with reversed children is the postorder.
    const std::size_t begin = order.size();
    stack.assign(1, root);
    while (!stack.empty()) {
      const int s = stack.back();
      stack.pop_back();
      order.push_back(s);
      stack.insert(stack.end(), children[s].begin(), children[s].end());
    }
    std::reverse(order.begin() + begin, order.end());
  }
  return order;
}

// Numbers fronts and columns for elimination. `original` has the matrix's rows in the order of the partition.
void number_fronts(const Partition& p, const std::vector<int>& original, Assembly_tree& tree) {
  const std::vector<int> order = order_fronts(p);
  const int fronts = int(order.size()), size = int(original.size());
  std::vector<int> place(p.columns.size(), -1);
  for (int s = 0; s < fronts; ++s) place[order[s]] = s;
  tree.fronts.resize(fronts);
  tree.child_begin.assign(fronts + 1, 0);
  std::size_t rows = 0;
  int column = 0;
  for (int s = 0; s < fronts; ++s) {
    Front& front = tree.fronts[s];
    const int t = order[s];
    front.first = column;
    front.columns = p.columns[t];
    front.rows = p.rows[t];
    front.parent = p.parent[t] < 0 ? -1 : place[p.parent[t]];
    front.rows_begin = rows;
    front.panel_begin = tree.factor_size;
    rows += front.rows;
    column += front.columns;
    tree.factor_size += front.panel_size();
    tree.operations += operations(front.columns, front.rows);
    if (front.parent >= 0) ++tree.child_begin[front.parent + 1];
  }
  tree.row.resize(rows);
  tree.row_in_parent.resize(rows);
  std::partial_sum(tree.child_begin.begin(), tree.child_begin.end(), tree.child_begin.begin());
  tree.child.resize(tree.child_begin.back());
  std::vector<int> end(tree.child_begin.begin(), tree.child_begin.end() - 1), next(fronts);
  for (int s = 0; s < fronts; ++s) {
    next[s] = tree.fronts[s].first;
    if (tree.fronts[s].parent >= 0) tree.child[end[tree.fronts[s].parent]++] = s;
  }
  tree.original.resize(size);
  tree.front_of.resize(size);
  for (int j = 0; j < size; ++j) {
    const int s = place[p.front_of[j]];
    tree.front_of[next[s]] = s;
    tree.original[next[s]++] = original[j];
  }
}

// Row i of the factor is the part of the tree above the entries of row i of the matrix: walking there row by
// row fills every front's list in increasing order.
void find_rows(const Lists& earlier, Assembly_tree& tree) {
  const int size = int(tree.original.size());
  std::vector<int> visitor(tree.fronts.size(), -1);
  std::vector<std::size_t> end(tree.fronts.size());
  for (std::size_t s = 0; s < end.size(); ++s) end[s] = tree.fronts[s].rows_begin;
  for (int i = 0; i < size; ++i) {
    visitor[tree.front_of[i]] = i;
    for (int k = earlier.begin[i]; k < earlier.begin[i + 1]; ++k)
      for (int s = tree.front_of[earlier.item[k]]; visitor[s] != i; s = tree.fronts[s].parent) {
        visitor[s] = i;
        tree.row[end[s]++] = i;
      }
  }
}

void find_rows_in_parents(Assembly_tree& tree) {
  for (const Front& front : tree.fronts) {
    if (front.parent < 0) continue;
    const Front& parent = tree.fronts[front.parent];
    const int* wanted = tree.row.data() + front.rows_begin;
    const int* rows = tree.row.data() + parent.rows_begin;
    int* place = tree.row_in_parent.data() + front.rows_begin;
    int k = 0;
    for (int i = 0; i < front.rows; ++i) {
      if (wanted[i] < parent.first + parent.columns) {
        place[i] = wanted[i] - parent.first;
        continue;
      }
      while (rows[k] != wanted[i]) ++k;
      place[i] = parent.columns + k;
    }
  }
}

// Where each entry of the matrix is added: to the front of its earlier unknown.
void place_entries(const Symmetric_matrix& m, const std::vector<int>& place, Assembly_tree& tree) {
  tree.entry_begin.assign(tree.fronts.size() + 1, 0);
  for (int j = 0; j < m.size; ++j)
    for (int k = m.column_begin[j]; k < m.column_begin[j + 1]; ++k)
      ++tree.entry_begin[tree.front_of[std::min(place[j], place[m.row[k]])] + 1];
  std::partial_sum(tree.entry_begin.begin(), tree.entry_begin.end(), tree.entry_begin.begin());
  std::vector<int> end(tree.entry_begin.begin(), tree.entry_begin.end() - 1);
  tree.entry.resize(m.row.size());
  tree.entry_target.resize(m.row.size());
  for (int j = 0; j < m.size; ++j)
    for (int k = m.column_begin[j]; k < m.column_begin[j + 1]; ++k) {
      const int a = std::min(place[j], place[m.row[k]]), b = std::max(place[j], place[m.row[k]]);
      const int s = tree.front_of[a];
      const Front& front = tree.fronts[s];
      int row = b - front.first;
      if (row >= front.columns) {
        const auto begin = tree.row.begin() + front.rows_begin;
        row = front.columns + int(std::lower_bound(begin, begin + front.rows, b) - begin);
      }
      tree.entry[end[s]] = k;
      tree.entry_target[end[s]++] = (a - front.first) * front.leading_dimension() + row;
    }
}

// By size, dissection is for large sparse graphs such as those of surfaces.
bool uses_dissection(const Symmetric_matrix& m, Multifrontal_solver::Ordering ordering) {
  constexpr int smallest = 30000;
  constexpr std::size_t most_entries = 10; // a row of the lower triangle; a triangulation has four
  switch (ordering) {
  case Multifrontal_solver::Ordering::minimum_degree: return false;
  case Multifrontal_solver::Ordering::nested_dissection: return true;
  case Multifrontal_solver::Ordering::by_size: break;
  }
  return m.size >= smallest && m.row.size() < most_entries * std::size_t(m.size);
}

} // namespace

Assembly_tree analyze_pattern(const Symmetric_matrix& m, const std::vector<int>& order) {
  Assembly_tree tree;
  tree.child_begin = tree.entry_begin = {0};
  if (m.size == 0) return tree;
  const Lists earlier = earlier_entries(m, inverse(order));
  const std::vector<int> raw_parent = elimination_tree(earlier, m.size);
  const std::vector<int> post = postorder(raw_parent), place_in_post = inverse(post);
  std::vector<int> original(m.size), parent(m.size);
  for (int j = 0; j < m.size; ++j) {
    original[j] = order[post[j]];
    parent[j] = raw_parent[post[j]] < 0 ? -1 : place_in_post[raw_parent[post[j]]];
  }
  const std::vector<int> count = column_counts(renumbered(earlier, place_in_post, false), parent);

  Partition partition = fundamental_fronts(parent, count);
  merge_fronts(partition);
  number_fronts(partition, original, tree);
  const std::vector<int> place = inverse(tree.original);
  std::vector<int> moved(m.size); // from the given order to that of the fronts
  for (int j = 0; j < m.size; ++j) moved[j] = place[order[j]];
  find_rows(renumbered(earlier, moved, true), tree);
  find_rows_in_parents(tree);
  place_entries(m, place, tree);
  return tree;
}

Result<Assembly_tree> analyze_pattern(const Symmetric_matrix& m, Multifrontal_solver::Ordering ordering) {
  const Result<std::vector<int>> order =
      uses_dissection(m, ordering) ? dissection_order(m) : minimum_degree_order(m);
  if (!order) return order.error();
  return analyze_pattern(m, *order);
}

} // namespace internal
} // namespace Reeb_quadrangulation
} // namespace CGAL
