find_package(GTest REQUIRED)
include(GoogleTest)

# What the fast tests run: all that has to be built under the sanitizers.
add_custom_target(fast_tests)

# Most of what a test runs is in the libraries, which are always those that users get: in the optimised build the tests
# themselves are compiled with little optimisation, in half the time.
set(scree_test_options $<$<CONFIG:Release>:-O1>)

# The headers that nearly every test reads, compiled once: they are half the time of a small test. Only those of
# others: ours are seen as users see them.
add_library(scree_test_headers OBJECT test_headers.cpp)
target_link_libraries(scree_test_headers PRIVATE scree::base GTest::gtest GTest::gmock)
target_compile_features(scree_test_headers PRIVATE cxx_std_20)
target_compile_options(scree_test_headers PRIVATE ${scree_test_options})
scree_private_flags(scree_test_headers)  # the flags of those that share it
target_precompile_headers(scree_test_headers PRIVATE
  <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits> <map> <memory> <numbers> <numeric> <random>
  <set> <span> <sstream> <string> <variant> <vector>
  <Eigen/Core> <Eigen/Eigenvalues> <Eigen/Geometry> <Eigen/LU> <gmock/gmock.h> <gtest/gtest.h>)

# Under the sanitizers a program takes longer to start than most tests take.
option(SCREE_TESTS_IN_SHARDS "Start each test program four times, with a share of its tests, instead of once a test" OFF)
function(scree_test_shards name)
  foreach(shard RANGE 3)
    add_test(NAME ${name}_${shard} COMMAND ${name} --gtest_brief=1)
    set_tests_properties(${name}_${shard} PROPERTIES ${ARGN})
    set_property(TEST ${name}_${shard} APPEND PROPERTY ENVIRONMENT GTEST_TOTAL_SHARDS=4 GTEST_SHARD_INDEX=${shard})
  endforeach()
endfunction()

# scree_tests(<name> SOURCES <files> LINK <targets> [LABEL <label>] [OPTIMISED])
#
# One test program. Its tests are labelled fast: they run every day, and under the sanitizers. LABEL flow is for
# those that compute whole flows, or are too dear there, and run every day in the optimised build only, LABEL verify for those of many
# minutes, which belong to `./dev verify`. OPTIMISED are those that run long in code of headers.
function(scree_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OPTIMISED" "LABEL" "SOURCES;LINK")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  target_compile_definitions(${name} PRIVATE SCREE_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
  scree_private_flags(${name})
  if(NOT arg_LABEL)
    set(arg_LABEL fast)
    add_dependencies(fast_tests ${name})
  endif()
  if(NOT arg_OPTIMISED)
    target_compile_options(${name} PRIVATE ${scree_test_options})
    target_precompile_headers(${name} REUSE_FROM scree_test_headers)
  endif()
  # Its sources are never read as one: each has names of its own.
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  # Threads that wait sleep: tests run beside each other, and some ask for more threads than there are cores.
  set(properties LABELS ${arg_LABEL} TIMEOUT 1500 ENVIRONMENT OMP_WAIT_POLICY=passive)
  if(SCREE_TESTS_IN_SHARDS)
    scree_test_shards(${name} ${properties})
  else()
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
  endif()
endfunction()

# scree_kernel_symbols_test(<library>): the library's kernels for wide instruction sets leave no symbol that the
# linker could mistake for a copy of other code.
function(scree_kernel_symbols_test library)
  foreach(set IN LISTS SCREE_INSTRUCTION_SETS)
    string(REPLACE "-" "_" namespace ${set})
    if(NOT set STREQUAL baseline)
      add_test(NAME KernelSymbols.OfThe_${library}_Library.StayInTheNamespace_${namespace}
               COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DNAMESPACE=${namespace}
                       "-DOBJECTS=$<TARGET_OBJECTS:scree_${library}_${namespace}>"
                       -P ${PROJECT_SOURCE_DIR}/tests/kernel_symbols.cmake)
      set_tests_properties(KernelSymbols.OfThe_${library}_Library.StayInTheNamespace_${namespace} PROPERTIES LABELS fast)
    endif()
  endforeach()
endfunction()
