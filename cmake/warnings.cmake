option(SCREE_WARNINGS "Compile scree with all warnings" ON)

# Warnings are ours to keep, never a user's to inherit: they are PRIVATE.
function(scree_warnings target)
  if(SCREE_WARNINGS)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
    if(PROJECT_IS_TOP_LEVEL)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
endfunction()
