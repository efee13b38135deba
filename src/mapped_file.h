// Files as memory: read where they lie, page by page.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace gnomon {

/// A file's bytes, to read, for as long as this lives. The file must not shrink meanwhile.
class MappedFile {
  public:
    /// Throws Error(Blame::input) for what cannot be opened, is not a regular file, or is empty.
    explicit MappedFile(const std::string& path);
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile();

    const std::string& path() const { return path_; }
    std::string_view bytes() const { return {static_cast<const char*>(start_), size_}; }
    /// Lets go of the memory behind some of its bytes; they are read from the file again when they are next looked at.
    void forget(const void* first, std::size_t count) const;

  private:
    std::string path_;
    void* start_ = nullptr;
    std::size_t size_ = 0;
};

/// What a table keeps when its rows lie in the file itself.
using SharedFile = std::shared_ptr<const MappedFile>;

}  // namespace gnomon
