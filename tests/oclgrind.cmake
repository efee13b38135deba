# Runs TESTS of PROGRAM (Catch2's) on Oclgrind, which simulates an OpenCL device: with EXPECTED=nothing the tests must
# pass and Oclgrind must have nothing to report; else its report must have the text EXPECTED.
#
# Inlining of functions that return structs leaves an intrinsic behind that Oclgrind 21.10 does not know
# (llvm.experimental.noalias.scope.decl), so that nothing is optimised.
find_program(oclgrind oclgrind)
if(NOT oclgrind)
  message(FATAL_ERROR "Oclgrind is not installed (Debian's package oclgrind)")
endif()
string(RANDOM LENGTH 8 name)
set(log ${CMAKE_CURRENT_BINARY_DIR}/oclgrind-${name}.log)
set(ENV{OCLGRIND_BUILD_OPTIONS} -cl-opt-disable)
execute_process(COMMAND ${oclgrind} --data-races --max-errors 20 --log ${log} ${PROGRAM} ${TESTS}
                RESULT_VARIABLE result)
if(NOT EXISTS ${log})
  message(FATAL_ERROR "Oclgrind wrote no log: it was not what ran the kernels")
endif()
file(READ ${log} report)
file(REMOVE ${log})
message("${report}")
if(EXPECTED STREQUAL "nothing")
  if(NOT result EQUAL 0 OR NOT report STREQUAL "")
    message(FATAL_ERROR "the tests failed (${result}), or Oclgrind has reported the above")
  endif()
elseif(NOT report MATCHES "${EXPECTED}")
  message(FATAL_ERROR "Oclgrind did not report: ${EXPECTED}")
endif()
