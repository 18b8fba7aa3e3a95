# Exact sums stay exact, NaN stays visible: no -ffast-math. Contraction and errno-free sqrt are safe.
set(SCREE_ARITHMETIC -ffp-contract=fast -fno-math-errno -fno-trapping-math)

include(precompiled_eigen)
include(private_flags)
include(GNUInstallDirs)

# scree_library(<name> SOURCES <files> [LINK <public targets>] [PRIVATE_LINK <hidden targets>])
#
# Makes scree_<name>, alias scree::<name>, with its headers as a file set and an export set of its own, so
# that each library can be found and linked alone.
function(scree_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK;PRIVATE_LINK")
  set(target scree_${name})
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS include/*.hpp)
  add_library(${target} STATIC)
  add_library(scree::${name} ALIAS ${target})
  target_sources(${target} PRIVATE ${arg_SOURCES}
                 PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${headers})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE ${SCREE_ARITHMETIC})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(${target} PUBLIC ${arg_LINK} PRIVATE ${arg_PRIVATE_LINK})
  scree_private_flags(${target})

  install(TARGETS ${target} EXPORT scree-${name}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${name})
  install(EXPORT scree-${name} NAMESPACE scree:: FILE scree-${name}-targets.cmake COMPONENT ${name}
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scree)
endfunction()
