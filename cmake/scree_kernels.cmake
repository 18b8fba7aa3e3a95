include(CheckCXXCompilerFlag)

# Kernels for wide instruction sets are worth their compile time in the optimised build alone.
option(SCREE_WIDE_KERNELS "Compile hot loops for x86-64-v3 and v4 too, chosen when a program starts" ON)
check_cxx_compiler_flag(-march=x86-64-v4 SCREE_KNOWS_X86_64_V4)  # not on other machines
if(SCREE_WIDE_KERNELS AND SCREE_KNOWS_X86_64_V4)
  set(SCREE_INSTRUCTION_SETS baseline x86-64-v3 x86-64-v4)
else()
  set(SCREE_INSTRUCTION_SETS baseline)
endif()

# scree_kernels(<library> <source>..)
#
# Compiles each source into the library once per instruction set, with SCREE_INSTRUCTION_SET the name of a namespace
# (baseline, x86_64_v3, x86_64_v4) that everything in it must be in. Where the wider sets are compiled, the whole
# library sees SCREE_WIDE_KERNELS. Such a source must leave no weak symbol outside its namespace: the linker keeps
# one copy of it, which may be the one that an older machine cannot run. tests/kernel_symbols.cmake looks for them.
function(scree_kernels library)
  foreach(set IN LISTS SCREE_INSTRUCTION_SETS)
    string(REPLACE "-" "_" namespace ${set})
    set(kernels scree_${library}_${namespace})
    add_library(${kernels} OBJECT ${ARGN})
    set_target_properties(${kernels} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_features(${kernels} PRIVATE cxx_std_20)
    target_compile_options(${kernels} PRIVATE $<TARGET_PROPERTY:scree_${library},COMPILE_OPTIONS>)
    # False warnings of a header of GCC 12 for AVX-512.
    target_compile_options(${kernels} PRIVATE -Wno-uninitialized -Wno-maybe-uninitialized)
    target_include_directories(${kernels} PRIVATE include src)
    target_link_libraries(${kernels} PRIVATE scree::base)
    target_compile_definitions(${kernels} PRIVATE SCREE_INSTRUCTION_SET=${namespace})
    if(NOT set STREQUAL baseline)
      # Optimised in any build: what is not inlined into the kernels would be a weak symbol.
      target_compile_options(${kernels} PRIVATE -march=${set} $<$<NOT:$<CONFIG:Release,RelWithDebInfo>>:-O2>)
      target_compile_definitions(scree_${library} PRIVATE SCREE_WIDE_KERNELS)
    endif()
    target_sources(scree_${library} PRIVATE $<TARGET_OBJECTS:${kernels}>)
  endforeach()
endfunction()
