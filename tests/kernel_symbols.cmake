# Fails if one of OBJECTS defines a weak function without NAMESPACE in its name: the linker would keep one copy of it
# for all. Weak data may be shared, which has no instructions.
execute_process(COMMAND ${NM} --defined-only --demangle ${OBJECTS}
                OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," symbols "${symbols}")
string(REGEX MATCHALL "[^\n]* W [^\n]*" weak "${symbols}")
list(FILTER weak EXCLUDE REGEX "${NAMESPACE}")
# Code that runs when a program starts runs on any machine.
string(REGEX MATCHALL "[^\n]*_GLOBAL__sub_I_[^\n]*" at_start "${symbols}")
list(APPEND weak ${at_start})
if(weak)
  list(JOIN weak "\n" lines)
  message(FATAL_ERROR "weak functions, or some that run at start, outside ${NAMESPACE}:\n${lines}")
endif()
