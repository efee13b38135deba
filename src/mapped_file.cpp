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

FileState state_of(const struct stat& status) {
    return {status.st_dev, status.st_ino, static_cast<std::size_t>(status.st_size), status.st_mtim.tv_sec,
            status.st_mtim.tv_nsec};
}

FileState state_of(const Descriptor& file, const std::string& path) {
    struct stat status {};
    if (fstat(file.number, &status) != 0) fail(path);
    if (S_ISDIR(status.st_mode)) throw Error(Blame::input, "found a folder, expected a file", path);
    if (!S_ISREG(status.st_mode)) throw Error(Blame::input, "found a pipe or a device, expected a file", path);
    if (status.st_size == 0) throw Error(Blame::input, "found an empty file", path);
    return state_of(status);
}

}  // namespace

// Without O_NONBLOCK, opening a pipe would wait for somebody to write to it; of regular files it changes nothing.
MappedFile::MappedFile(const std::string& path) : path_(path) {
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number < 0) fail(path);
    opened_ = state_of(file, path);
    start_ = mmap(nullptr, opened_.size, PROT_READ, MAP_PRIVATE, file.number, 0);
    if (start_ == MAP_FAILED) fail(path);
}

MappedFile::~MappedFile() { munmap(start_, opened_.size); }

// By the name, since a scene may have more files than a process may have descriptors.
void MappedFile::expect_unchanged() const {
    struct stat status {};
    if (stat(path_.c_str(), &status) != 0) return;
    const FileState now = state_of(status);
    if (now.device != opened_.device || now.number != opened_.number) return;
    const bool same =
        now.size == opened_.size && now.seconds == opened_.seconds && now.nanoseconds == opened_.nanoseconds;
    if (!same) throw Error(Blame::input, "changed while it was read", path_);
}

void MappedFile::forget(const void* first, std::size_t count) const {
    expect_unchanged();
    // Only pages that lie in the range as a whole; others are forgotten with their neighbours, or stay.
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE)),
               from = reinterpret_cast<std::uintptr_t>(first);
    const std::uintptr_t low = (from + page - 1) / page * page, high = (from + count) / page * page;
    if (low < high) madvise(reinterpret_cast<void*>(low), high - low, MADV_DONTNEED);  // else it just stays
}

}  // namespace gnomon
