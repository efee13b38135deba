# Writes the files of cl/ into a C++ source, so that the program carries its kernels with it.
# usage: cmake -D OUTPUT=file.cpp -D "FILES=a;b" -P embed.cmake
set(text "// Made by cmake/embed.cmake from the files of cl/.\n#include \"kernel_source.h\"\n\nnamespace gnomon {\n\n")
string(APPEND text "const std::map<std::string, std::string>& embedded_kernel_files() {\n")
string(APPEND text "    static const std::map<std::string, std::string> files = {\n")
foreach(path IN LISTS FILES)
  get_filename_component(name "${path}" NAME)
  file(READ "${path}" content)
  string(APPEND text "        {\"${name}\", R\"__cl__(${content})__cl__\"},\n")
endforeach()
string(APPEND text "    };\n    return files;\n}\n\n}  // namespace gnomon\n")
file(WRITE "${OUTPUT}" "${text}")
