// Output files that are there whole or not at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

namespace gnomon {

/// A file beside `target` that takes its name once it is whole, and is gone after any failure. Failures are
/// Error(Blame::run) with the target's name.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::filesystem::path& target);
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    std::string path() const { return path_.string(); }
    std::FILE* stream() { return stream_; }

    /// Throws unless all that was written has reached the file.
    void close();
    void move_to_target();

  private:
    std::filesystem::path target_, path_;
    std::FILE* stream_;
};

/// A path that remove_temporary_files() removes too while this lives: a file's or an empty folder's.
class Fleeting {
  public:
    explicit Fleeting(std::string path);
    ~Fleeting();
    Fleeting(const Fleeting&) = delete;
    Fleeting& operator=(const Fleeting&) = delete;

  private:
    std::string path_;
};

/// Removes those that are there now, whose objects are of no use afterwards. May be called by a signal handler.
void remove_temporary_files() noexcept;

/// Throws Error(Blame::input) unless `path` names a file, there or not, in a folder that can be written to.
void check_folder(const std::string& path);

/// All bytes of a file; none of one that is not there or cannot be read.
std::string read_text(const std::filesystem::path& path);

/// Writes a whole text file.
void write_text(const std::string& path, const std::string& text);

}  // namespace gnomon
