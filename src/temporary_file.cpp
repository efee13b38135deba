#include "temporary_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "error.h"

namespace gnomon {

namespace fs = std::filesystem;

namespace {

constexpr const char* writing_failed = "cannot write the file";

/// The names of the files that are there, for remove_temporary_files(); null where there is none.
constexpr size_t most_at_once = 16;
std::atomic<const char*> names[most_at_once];
static_assert(std::atomic<const char*>::is_always_lock_free);  // or signal handlers could not touch them

void remember(const char* name) {
    for (std::atomic<const char*>& place : names) {
        const char* none = nullptr;
        if (place.compare_exchange_strong(none, name)) return;
    }
    throw Error(Blame::run, "too many files are written at once", name);
}

void forget(const char* name) {
    for (std::atomic<const char*>& place : names) {
        const char* same = name;
        place.compare_exchange_strong(same, nullptr);
    }
}

std::string reason(int error_number) { return std::generic_category().message(error_number); }

}  // namespace

// A stream of our own, since a failed write must be noticed whoever writes through it.
TemporaryFile::TemporaryFile(const fs::path& target)
    : target_(target),
      path_(target.parent_path() /
            ("." + target.stem().string() + "." + std::to_string(getpid()) + ".tmp" + target.extension().string())),
      stream_(nullptr) {
    remember(path_.c_str());
    stream_ = std::fopen(path_.c_str(), "w+b");
    if (stream_) return;
    const int error = errno;
    forget(path_.c_str());
    throw Error(Blame::run, writing_failed, path_.string(), reason(error));
}

TemporaryFile::~TemporaryFile() {
    if (stream_) std::fclose(stream_);
    std::error_code ignored;  // a destructor has nobody to tell
    if (path_.empty()) return;
    fs::remove(path_, ignored);
    forget(path_.c_str());
}

void TemporaryFile::close() {
    const bool lost = std::ferror(stream_) != 0;
    const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
    if (lost || !closed) throw Error(Blame::run, writing_failed, target_.string(), "is the disk full?");
}

void TemporaryFile::move_to_target() {
    std::error_code error;
    fs::rename(path_, target_, error);
    if (error) throw Error(Blame::run, writing_failed, target_.string(), error.message());
    forget(path_.c_str());
    path_.clear();
}

Fleeting::Fleeting(std::string path) : path_(std::move(path)) { remember(path_.c_str()); }
Fleeting::~Fleeting() { forget(path_.c_str()); }

void remove_temporary_files() noexcept {
    for (const auto remove : {unlink, rmdir})  // files first, then the folders that they were in
        for (const std::atomic<const char*>& place : names)
            if (const char* const name = place) remove(name);
}

void check_folder(const std::string& file) {
    const fs::path path(file), folder = path.has_parent_path() ? path.parent_path() : ".";
    const auto refuse = [&](const std::string& what, const std::string& hint) {
        throw Error(Blame::input, what, file, hint);
    };
    std::error_code ignored;  // what cannot be looked at does not exist for us
    if (fs::is_directory(path, ignored)) refuse("this is a folder", "add a file name");
    if (!fs::exists(folder, ignored)) refuse("there is no folder " + folder.string(), "make it first");
    if (!fs::is_directory(folder, ignored)) refuse(folder.string() + " is not a folder", "choose another path");
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        refuse("cannot write to folder " + folder.string() + ": " + reason(errno), "choose another folder");
}

std::string read_text(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

void write_text(const std::string& path, const std::string& text) {
    TemporaryFile file(path);
    std::fwrite(text.data(), 1, text.size(), file.stream());
    file.close();
    file.move_to_target();
}

}  // namespace gnomon
