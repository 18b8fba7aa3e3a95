include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)

# Kernels for wide instruction sets are worth their compile time in the optimised build alone.
option(SCREE_WIDE_KERNELS "Compile hot loops for x86-64-v3 and v4 too, chosen when a program starts" ON)
check_cxx_compiler_flag(-march=x86-64-v4 SCREE_KNOWS_X86_64_V4)  # not on other machines
# GCC copies structures of registers in halves unless told how wide they are; clang does not.
check_cxx_compiler_flag("-mmove-max=256;-mstore-max=256" SCREE_KNOWS_MOVE_MAX)
if(SCREE_WIDE_KERNELS AND SCREE_KNOWS_X86_64_V4)
  set(SCREE_INSTRUCTION_SETS baseline x86-64-v3 x86-64-v4)
else()
  set(SCREE_INSTRUCTION_SETS baseline)
endif()

# Elementary functions of whole registers are in the C library of GNU since 2.35 (libmvec). Every C++ program links it,
# for it is part of libm there; elsewhere packs compute them lane by lane.
if(NOT SCREE_INSTRUCTION_SETS STREQUAL baseline)
  set(CMAKE_REQUIRED_FLAGS -march=x86-64-v4)
  check_cxx_source_compiles("
    using Four [[gnu::vector_size(32)]] = double;
    using Eight [[gnu::vector_size(64)]] = double;
    extern \"C\" {
    Four _ZGVdN4v_exp(Four), _ZGVdN4v_expm1(Four), _ZGVdN4v_log(Four), _ZGVdN4vv_pow(Four, Four);
    Eight _ZGVeN8v_exp(Eight), _ZGVeN8v_expm1(Eight), _ZGVeN8v_log(Eight), _ZGVeN8vv_pow(Eight, Eight);
    }
    int main(int count, char**) {
      const Four four = Four{} + count;
      const Eight eight = Eight{} + count;
      const Four of_four = _ZGVdN4v_exp(four) + _ZGVdN4v_expm1(four) + _ZGVdN4v_log(four) + _ZGVdN4vv_pow(four, four);
      const Eight of_eight =
        _ZGVeN8v_exp(eight) + _ZGVeN8v_expm1(eight) + _ZGVeN8v_log(eight) + _ZGVeN8vv_pow(eight, eight);
      return static_cast<int>(of_four[0] + of_eight[0]);
    }" SCREE_HAS_VECTOR_FUNCTIONS)
  unset(CMAKE_REQUIRED_FLAGS)
endif()
set(SCREE_REGISTER_BITS_OF_x86-64-v3 256)
set(SCREE_REGISTER_BITS_OF_x86-64-v4 512)
set(SCREE_VECTOR_FUNCTIONS_OF_x86-64-v3 _ZGVdN4)
set(SCREE_VECTOR_FUNCTIONS_OF_x86-64-v4 _ZGVeN8)

# scree_kernels(<library> <source>..)
#
# Compiles each source into the library once per instruction set, with SCREE_INSTRUCTION_SET the name of a namespace
# (baseline, x86_64_v3, x86_64_v4) that everything in it must be in, and SCREE_VECTOR_FUNCTIONS how the names of its
# elementary functions begin, where there are any. Where the wider sets are compiled, the whole library sees
# SCREE_WIDE_KERNELS. Such a source must leave no weak symbol outside its namespace: the linker keeps
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
      if(SCREE_KNOWS_MOVE_MAX)
        set(bits ${SCREE_REGISTER_BITS_OF_${set}})
        target_compile_options(${kernels} PRIVATE -mmove-max=${bits} -mstore-max=${bits})
      endif()
      target_compile_definitions(scree_${library} PRIVATE SCREE_WIDE_KERNELS)
      if(SCREE_HAS_VECTOR_FUNCTIONS)
        target_compile_definitions(${kernels} PRIVATE SCREE_VECTOR_FUNCTIONS="${SCREE_VECTOR_FUNCTIONS_OF_${set}}")
      endif()
    endif()
    target_sources(scree_${library} PRIVATE $<TARGET_OBJECTS:${kernels}>)
  endforeach()
endfunction()
