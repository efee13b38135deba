# Installs the build, and uses what was installed as a stranger would: the program from another folder, the library through
# find_package. usage: cmake -D BUILD=dir -D SOURCE=dir -D GENERATOR=name -P install.cmake
set(root ${BUILD}/install-test)
file(REMOVE_RECURSE ${root})
file(MAKE_DIRECTORY ${root}/consumer)

function(run)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${root} RESULT_VARIABLE result OUTPUT_VARIABLE output
                                  ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}: ${result}\n${output}")
  endif()
endfunction()

function(expect file)
  if(NOT EXISTS ${root}/${file})
    message(FATAL_ERROR "${file} was not made")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${root}/before)
file(RENAME ${root}/before ${root}/moved)  # anywhere
run(${root}/moved/bin/gnomon render ${root}/moved/share/gnomon/examples/directional.json --size 40x30 -o picture.png)
expect(picture.png)

file(WRITE ${root}/consumer/CMakeLists.txt "
cmake_minimum_required(VERSION 3.25)
project(consumer CXX)
find_package(gnomon REQUIRED)
add_executable(one_page ${SOURCE}/examples/one_page.cpp)
target_link_libraries(one_page PRIVATE gnomon::gnomon)
")
run(${CMAKE_COMMAND} -G ${GENERATOR} -S consumer -B consumer/build -D CMAKE_PREFIX_PATH=${root}/moved)
run(${CMAKE_COMMAND} --build consumer/build)
run(${root}/consumer/build/one_page one_page.png)
expect(one_page.png)
