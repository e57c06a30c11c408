// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_REEB_QUADRANGULATION_RESULT_H
#define CGAL_REEB_QUADRANGULATION_RESULT_H

#include <CGAL/assertions.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace CGAL {
namespace Reeb_quadrangulation {

/// Why a request was not carried out. `description()` gives each code its text.
enum class Error_code {
  unreadable_file,     ///< the file cannot be opened, or is not a regular file
  malformed_file,      ///< the file's bytes contradict its format
  unsupported_format,  ///< the format, or this variant of it, is not one we read or write
  unwritable_file,     ///< the file cannot be written whole
  not_a_surface,       ///< the mesh is not a surface that the method takes
  impossible_request,  ///< the options contradict each other or the surface
  refused_edit,        ///< an edit is not applicable; nothing was changed
  solver_failure,      ///< a linear system could not be solved to the asked residual
  infeasible_sampling, ///< no integer sampling satisfies the constraints
  certificate_failure, ///< the mesh does not pass its certificate
  cancelled,           ///< the observer asked to stop
  internal_error       ///< an invariant of the library does not hold: a defect of ours
};

/// The kind of element that an error is about.
enum class Element_kind { none, vertex, edge, face, component, contour, chart, node, line, byte };

/// What went wrong: a code, a sentence for people, and the element it is about.
struct Error {
  Error_code code = Error_code::internal_error;
  std::string message;
  Element_kind element = Element_kind::none;
  std::int64_t index = -1; ///< of the element; lines count from 1, everything else from 0
};

/// The text of an error code, in the words of the manual.
const char* description(Error_code code);

/// The name of an element kind ("vertex", "line", ...).
const char* name(Element_kind kind);

/// Either a value or the reason why there is none. Compilers warn where it is dropped: a failure that nobody
/// looks at is lost, as there are no exceptions for it.
template <class T> class [[nodiscard]] Result {
public:
  Result(T value) : m_content(std::move(value)) {}
  Result(Error error) : m_content(std::move(error)) {}

  explicit operator bool() const { return m_content.index() == 0; }
  const T& operator*() const { return std::get<0>(m_content); }
  T& operator*() { return std::get<0>(m_content); }
  const T* operator->() const { return &std::get<0>(m_content); }
  T* operator->() { return &std::get<0>(m_content); }
  /// \pre it is a failure
  const Error& error() const {
    CGAL_precondition(!*this);
    return std::get<1>(m_content);
  }

private:
  std::variant<T, Error> m_content;
};

/// Success, or the reason of the failure.
template <> class [[nodiscard]] Result<void> {
public:
  Result() = default;
  Result(Error error) : m_error(std::move(error)) {}

  explicit operator bool() const { return !m_error; }
  /// \pre it is a failure
  const Error& error() const {
    CGAL_precondition(!*this);
    return m_error.value();
  }

private:
  std::optional<Error> m_error;
};

inline Error make_error(Error_code code, std::string message, Element_kind element = Element_kind::none,
                        std::int64_t index = -1) {
  return Error{code, std::move(message), element, index};
}

} // namespace Reeb_quadrangulation
} // namespace CGAL

#endif // CGAL_REEB_QUADRANGULATION_RESULT_H
