# What every target of the project shares, and hatchway_layer(), which declares one layer of the engine.

find_package(glm REQUIRED)
find_package(fmt REQUIRED)

add_library(hatchway_flags INTERFACE)
target_compile_options(hatchway_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wno-missing-field-initializers)
if(HATCHWAY_WARNINGS_AS_ERRORS)
    target_compile_options(hatchway_flags INTERFACE -Werror)
endif()
if(HATCHWAY_SANITIZE)
    target_compile_options(hatchway_flags INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer
                           -fno-sanitize-recover=undefined
                           # GCC 12 takes instrumented code of std::regex for uninitialised.
                           $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(hatchway_flags INTERFACE -fsanitize=address,undefined)
endif()
if(HATCHWAY_SANITIZE_THREADS)
    target_compile_options(hatchway_flags INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
    target_link_options(hatchway_flags INTERFACE -fsanitize=thread)
    # TBB's library is not instrumented: see there.
    foreach(header blocked_range enumerable_thread_specific global_control parallel_for parallel_for_each parallel_invoke
            parallel_reduce parallel_sort task_arena)
        file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/threads/tbb/${header}.h"
             CONTENT "#include \"${CMAKE_SOURCE_DIR}/tests/threads/tbb_on_threads.hpp\"\n")
    endforeach()
    target_include_directories(hatchway_flags BEFORE INTERFACE "${CMAKE_BINARY_DIR}/threads")
endif()
if(HATCHWAY_LIBFUZZER)
    target_compile_options(hatchway_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
target_compile_definitions(hatchway_flags INTERFACE GLM_FORCE_CTOR_INIT GLM_ENABLE_EXPERIMENTAL)
# Headers have one name, "hatchway/LAYER/...", in this tree and in an installation.
set(include_folder "${CMAKE_BINARY_DIR}/include/hatchway")
if(IS_SYMLINK "${include_folder}")
    file(REMOVE "${include_folder}")
endif()
file(MAKE_DIRECTORY "${include_folder}")
file(GLOB layers LIST_DIRECTORIES ON RELATIVE "${CMAKE_SOURCE_DIR}/scenegraph" "${CMAKE_SOURCE_DIR}/scenegraph/*")
list(REMOVE_ITEM layers CMakeLists.txt)
foreach(layer ${layers})
    file(CREATE_LINK "${CMAKE_SOURCE_DIR}/scenegraph/${layer}" "${include_folder}/${layer}" SYMBOLIC)
endforeach()
file(CREATE_LINK "${CMAKE_SOURCE_DIR}/npr_plugins/kit" "${include_folder}/kit" SYMBOLIC)
include(style_headers)
hatchway_write_header_hash("${include_folder}/header_hash.hpp")
target_include_directories(hatchway_flags INTERFACE "${CMAKE_BINARY_DIR}/include")
target_link_libraries(hatchway_flags INTERFACE glm::glm fmt::fmt)

# hatchway_layer(NAME [MADE ...] [LIBRARIES ...] [HEAVY ...])
#   One object library hw_NAME of all sources below the layer's folder, linked into the shared library `hatchway`.
#   MADE: generated sources. LIBRARIES: third parties of this layer, private to it. HEAVY: headers to precompile for it.
function(hatchway_layer name)
    cmake_parse_arguments(LAYER "" "" "MADE;LIBRARIES;HEAVY" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "*.cpp")
    add_library(hw_${name} OBJECT ${sources} ${LAYER_MADE})
    target_link_libraries(hw_${name} PRIVATE hatchway_flags ${LAYER_LIBRARIES})
    target_precompile_headers(hw_${name} PRIVATE <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map>
                              <memory> <optional> <span> <string> <string_view> <unordered_map> <vector>
                              <glm/glm.hpp> ${LAYER_HEAVY})
    target_link_libraries(hatchway PRIVATE hw_${name} ${LAYER_LIBRARIES})
endfunction()

# hatchway_test(NAME [LIBRARIES ...] [LABELS ...] [SOURCES ...]): the test binary of one layer, of all sources below its
# folder unless SOURCES says which. In ctest each of its suites is one test, since a process for each case costs more than
# most cases; tests/results/NAME.SUITE.xml in the build folder has the cases.
function(hatchway_test name)
    cmake_parse_arguments(TEST "" "" "SOURCES;LIBRARIES;LABELS" ${ARGN})
    if(NOT TEST_SOURCES)
        file(GLOB_RECURSE TEST_SOURCES CONFIGURE_DEPENDS "*.cpp")
    endif()
    add_executable(test_${name} ${TEST_SOURCES})
    target_link_libraries(test_${name} PRIVATE hatchway_flags hatchway hatchway_measure GTest::gtest_main GTest::gmock
                          ${TEST_LIBRARIES})
    # Checks of results gain nothing from -O3. GCC 12 sees writes past the ends of strings where there are none.
    target_compile_options(test_${name} PRIVATE $<$<CONFIG:Release>:-O1> -Wno-array-bounds -Wno-stringop-overflow)
    target_compile_definitions(test_${name} PRIVATE
        HATCHWAY_SOURCE_DIR="${CMAKE_SOURCE_DIR}" HATCHWAY_BUILD_DIR="${CMAKE_BINARY_DIR}")
    target_include_directories(test_${name} PRIVATE "${CMAKE_SOURCE_DIR}" "${CMAKE_SOURCE_DIR}/editor_tools")
    target_precompile_headers(test_${name} PRIVATE <gtest/gtest.h> <gmock/gmock.h> <filesystem> <functional> <map> <set>
                              <span> <string> <vector> <glm/glm.hpp>)
    set(suites "${CMAKE_CURRENT_BINARY_DIR}/test_${name}_suites.cmake")
    file(GENERATE OUTPUT "${suites}" CONTENT "include(\"${CMAKE_SOURCE_DIR}/cmake/add_suites.cmake\")
hatchway_add_suites(${name} \"$<TARGET_FILE:test_${name}>\" \"${CMAKE_BINARY_DIR}/tests/results\" \"${name};${TEST_LABELS}\"
                    \"${CMAKE_COMMAND}\" $<IF:$<BOOL:${HATCHWAY_SANITIZE}>,6,1>)
")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${suites}")
endfunction()
