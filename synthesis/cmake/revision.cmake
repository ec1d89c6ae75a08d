# Writes the commit of SOURCE as a string literal to OUT, if it is not there yet.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=10
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT revision)
    set(revision "no commit")
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "\"${revision}\"\n")
