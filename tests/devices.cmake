# Tests on devices that Debian has packages of beside PoCL, each for a preset of its own (CMakePresets.json): ctest
# leaves tests of another configuration out, so that plain `ctest` neither needs these packages nor waits for them.
# They run the portable tests, in two parts, for two cores.
set(portable_parts "[portable][verify]" "[portable]~[verify]")

# Only rusticl is loaded: it, or nothing, is what is tested.
foreach(part ${portable_parts})
  add_test(NAME "rusticl: ${part}" CONFIGURATIONS rusticl COMMAND gnomon_tests ${part})
  set_tests_properties("rusticl: ${part}" PROPERTIES
    LABELS rusticl ENVIRONMENT "OCL_ICD_VENDORS=rusticl.icd;RUSTICL_ENABLE=llvmpipe" TIMEOUT 900)
endforeach()

function(add_oclgrind_test name expected)
  add_test(NAME "oclgrind: ${name}" CONFIGURATIONS oclgrind
           COMMAND ${CMAKE_COMMAND} -D EXPECTED=${expected} -D PROGRAM=$<TARGET_FILE:gnomon_tests> -D TESTS=${ARGN}
                   -P ${CMAKE_CURRENT_SOURCE_DIR}/oclgrind.cmake)
  set_tests_properties("oclgrind: ${name}" PROPERTIES LABELS oclgrind TIMEOUT 900)
endfunction()
foreach(part ${portable_parts})
  add_oclgrind_test("${part}" nothing "${part}")
endforeach()
# Whether reports come at all.
add_oclgrind_test("a race is reported" "data race" "[.race]")
add_oclgrind_test("an access beyond a buffer is reported" "Invalid write" "[.beyond]")
