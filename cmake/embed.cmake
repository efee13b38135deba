# Writes text files into a C++ source, so that the program carries them with it: the function that the header declares
# returns file name to text.
# usage: cmake -D OUTPUT=file.cpp -D "FILES=a;b" -D HEADER=file.h -D FUNCTION=name -P embed.cmake
set(text "// Made by cmake/embed.cmake.\n#include \"${HEADER}\"\n\nnamespace gnomon {\n\n")
string(APPEND text "const std::map<std::string, std::string>& ${FUNCTION}() {\n")
string(APPEND text "    static const std::map<std::string, std::string> files = {\n")
foreach(path IN LISTS FILES)
  get_filename_component(name "${path}" NAME)
  file(READ "${path}" content)
  string(APPEND text "        {\"${name}\", R\"__text__(${content})__text__\"},\n")
endforeach()
string(APPEND text "    };\n    return files;\n}\n\n}  // namespace gnomon\n")
file(WRITE "${OUTPUT}" "${text}")
