#include "kernel_source.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "error.h"

namespace gnomon {

namespace {

std::string from_disk(const std::string& folder, const std::string& file) {
    std::ifstream in(folder + "/" + file, std::ios::binary);
    std::ostringstream text;
    if (!in || !(text << in.rdbuf()))
        throw Error(Blame::run, "cannot read the kernel file", folder + "/" + file,
                    "GNOMON_CL_DIR must name the project's cl/ folder; unset it to use the kernels in the program");
    return text.str();
}

std::string read(const std::string& file) {
    const char* folder = std::getenv("GNOMON_CL_DIR");
    if (folder && *folder) return from_disk(folder, file);
    const auto found = embedded_kernel_files().find(file);
    if (found == embedded_kernel_files().end()) throw Error(Blame::run, "this program holds no such kernel", file);
    return found->second;
}

/// The file that an #include "file" line names, else "".
std::string included(const std::string& line) {
    const std::string start = "#include \"";
    if (line.compare(0, start.size(), start) != 0) return "";
    return line.substr(start.size(), line.find('"', start.size()) - start.size());
}

/// Include guards, not this, keep a file from counting twice: an include may stand in a branch that is not compiled.
void expand(const std::string& file, std::ostringstream& out, int depth = 0) {
    if (depth > 16) throw Error(Blame::run, "kernel files include each other in a circle", file);
    std::istringstream in(read(file));
    out << "#line 1 \"cl/" << file << "\"\n";
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        const std::string inner = included(line);
        if (inner.empty()) {
            out << line << '\n';
            continue;
        }
        expand(inner, out, depth + 1);
        out << "#line " << number + 1 << " \"cl/" << file << "\"\n";
    }
}

}  // namespace

std::string kernel_source(const std::string& name) {
    std::ostringstream out;
    expand(name + ".cl", out);
    return out.str();
}

}  // namespace gnomon
