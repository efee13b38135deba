#include "mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>

#include "error.h"

namespace gnomon {

namespace {

/// A mapping outlives the descriptor it was made from, which is closed on every way out.
struct Descriptor {
    explicit Descriptor(int opened) : number(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) close(number);
    }
    int number;
};

[[noreturn]] void fail(const std::string& path) {
    throw Error(Blame::input, "cannot read the file: " + std::generic_category().message(errno), path);
}

std::size_t size_of(const Descriptor& file, const std::string& path) {
    struct stat status {};
    if (fstat(file.number, &status) != 0) fail(path);
    if (S_ISDIR(status.st_mode)) throw Error(Blame::input, "found a folder, expected a file", path);
    if (!S_ISREG(status.st_mode)) throw Error(Blame::input, "found a pipe or a device, expected a file", path);
    if (status.st_size == 0) throw Error(Blame::input, "found an empty file", path);
    return static_cast<std::size_t>(status.st_size);
}

}  // namespace

// Without O_NONBLOCK, opening a pipe would wait for somebody to write to it; of regular files it changes nothing.
MappedFile::MappedFile(const std::string& path) : path_(path) {
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number < 0) fail(path);
    size_ = size_of(file, path);
    start_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file.number, 0);
    if (start_ == MAP_FAILED) fail(path);
}

MappedFile::~MappedFile() { munmap(start_, size_); }

void MappedFile::forget(const void* first, std::size_t count) const {
    // Only pages that lie in the range as a whole; others are forgotten with their neighbours, or stay.
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE)),
               from = reinterpret_cast<std::uintptr_t>(first);
    const std::uintptr_t low = (from + page - 1) / page * page, high = (from + count) / page * page;
    if (low < high) madvise(reinterpret_cast<void*>(low), high - low, MADV_DONTNEED);  // else it just stays
}

}  // namespace gnomon
