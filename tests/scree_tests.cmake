find_package(GTest REQUIRED)
include(GoogleTest)

# What the fast tests run: all that has to be built under the sanitizers.
add_custom_target(fast_tests)

# scree_tests(<name> SOURCES <files> LINK <targets> [LABEL <label>])
#
# One test program. Its tests are labelled fast: they run every day, and under the sanitizers. LABEL flow is for
# those that compute whole flows, or are too dear there, and run every day in the optimised build only, LABEL verify for those of many
# minutes, which belong to `./dev verify`.
function(scree_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL" "SOURCES;LINK")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  target_compile_definitions(${name} PRIVATE SCREE_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
  scree_warnings(${name})
  if(NOT arg_LABEL)
    set(arg_LABEL fast)
    add_dependencies(fast_tests ${name})
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS ${arg_LABEL} TIMEOUT 1500)
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
