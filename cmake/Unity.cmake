# SPDX-License-Identifier: GPL-3.0-or-later
# Unity builds (-DCMAKE_UNITY_BUILD=ON) compile the sources of one folder together: a build from nothing takes less than half of
# the time, since what CGAL's headers cost is paid once for a room. Who edits one file after the other is better off without.

# unite_by_folder(target): the sources of one folder of `target` are one unit, or several of at most ten; the names in their
# unnamed namespaces must differ.
function(unite_by_folder target)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    list(APPEND members_of_${folder} ${source})
    list(LENGTH members_of_${folder} number)
    math(EXPR part "(${number} - 1) / 10")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${folder}_${part}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  # To GCC a source that is included is a header, whose classes should not have members of types of unnamed namespaces.
  get_target_property(is_united ${target} UNITY_BUILD)
  if(is_united AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()
