include(private_flags)

option(SCREE_PRECOMPILED_EIGEN "Compile Eigen's headers once for all libraries" OFF)

# What nearly every source of some libraries reads through scree::base, in a third of its time. A source that forgets one
# of the standard headers which Eigen includes compiles with it all the same, and not without. GCC demands that all have
# the same flags.
if(SCREE_PRECOMPILED_EIGEN)
  find_package(Eigen3 3.4 REQUIRED NO_MODULE)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/eigen.cpp CONTENT "// A library needs a source.\n")
  add_library(scree_eigen OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/eigen.cpp)
  target_link_libraries(scree_eigen PRIVATE Eigen3::Eigen)
  target_compile_features(scree_eigen PRIVATE cxx_std_20)
  target_compile_options(scree_eigen PRIVATE ${SCREE_ARITHMETIC})
  set_target_properties(scree_eigen PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(scree_eigen PRIVATE <Eigen/Core>)
  scree_private_flags(scree_eigen)
endif()

# scree_reads_eigen(<library>)
function(scree_reads_eigen library)
  if(SCREE_PRECOMPILED_EIGEN)
    target_precompile_headers(scree_${library} REUSE_FROM scree_eigen)
  endif()
endfunction()
