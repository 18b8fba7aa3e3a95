# Fails if one of OBJECTS defines a weak symbol without NAMESPACE in its name.
execute_process(COMMAND ${NM} --defined-only --demangle ${OBJECTS}
                OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]* [VWuv] [^\n]*" weak "${symbols}")
list(FILTER weak EXCLUDE REGEX "${NAMESPACE}")
if(weak)
  list(JOIN weak "\n" lines)
  message(FATAL_ERROR "weak symbols outside ${NAMESPACE}:\n${lines}")
endif()
