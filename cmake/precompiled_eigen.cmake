include(private_flags)

option(SCREE_PRECOMPILED_EIGEN "Compile Eigen's headers once for all libraries, and once for all programs" OFF)

# What nearly every source of some libraries, and of the programs, reads through scree::base, in a third of its time. A
# source that forgets one of the standard headers which Eigen includes compiles with it all the same, and not without.
# GCC demands that all have the same flags, and libraries have one more: shared ones may be made of them.
if(SCREE_PRECOMPILED_EIGEN)
  find_package(Eigen3 3.4 REQUIRED NO_MODULE)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/eigen.cpp CONTENT "// A library needs a source.\n")
  foreach(eigen scree_eigen scree_eigen_of_programs)
    add_library(${eigen} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/eigen.cpp)
    target_link_libraries(${eigen} PRIVATE Eigen3::Eigen)
    target_compile_features(${eigen} PRIVATE cxx_std_20)
    target_compile_options(${eigen} PRIVATE ${SCREE_ARITHMETIC})
    target_precompile_headers(${eigen} PRIVATE <Eigen/Core>)
    scree_private_flags(${eigen})
  endforeach()
  set_target_properties(scree_eigen PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif()

# scree_reads_eigen(<library>)
function(scree_reads_eigen library)
  if(SCREE_PRECOMPILED_EIGEN)
    target_precompile_headers(scree_${library} REUSE_FROM scree_eigen)
  endif()
endfunction()

# scree_program_reads_eigen(<target>): the same for what is part of a program alone.
function(scree_program_reads_eigen target)
  if(SCREE_PRECOMPILED_EIGEN)
    target_precompile_headers(${target} REUSE_FROM scree_eigen_of_programs)
  endif()
endfunction()
