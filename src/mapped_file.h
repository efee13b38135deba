// Files as memory: read where they lie, page by page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace gnomon {

/// Which file it is, and what changes when somebody writes to it.
struct FileState {
    uint64_t device = 0, number = 0;
    std::size_t size = 0;                  ///< bytes
    int64_t seconds = 0, nanoseconds = 0;  ///< of the last change
};

/// A file's bytes, to read, for as long as this lives. The file must not change meanwhile: that it did is noticed in
/// most cases, but not if it shrinks below what is being read.
class MappedFile {
  public:
    /// Throws Error(Blame::input) for what cannot be opened, is not a regular file, or is empty.
    explicit MappedFile(const std::string& path);
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile();

    const std::string& path() const { return path_; }
    std::string_view bytes() const { return {static_cast<const char*>(start_), opened_.size}; }
    /// Throws Error(Blame::input) if the file has another size or time of change than when it was opened. One that took
    /// its name meanwhile is another file, and no concern of this one.
    void expect_unchanged() const;
    /// Lets go of the memory behind some of its bytes; they are read from the file again when they are next looked at.
    /// That what was read is still the file's is expected here.
    void forget(const void* first, std::size_t count) const;

  private:
    std::string path_;
    FileState opened_;
    void* start_ = nullptr;
};

/// What a table keeps when its rows lie in the file itself.
using SharedFile = std::shared_ptr<const MappedFile>;

}  // namespace gnomon
