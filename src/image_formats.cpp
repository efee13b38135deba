#include "image_formats.h"

#include <dlfcn.h>

#include "error.h"

namespace gnomon {

namespace {

/// Never closed: OpenImageIO keeps threads.
const ImageFormats& load() {
    void* library = dlopen(GNOMON_FORMATS, RTLD_NOW | RTLD_LOCAL);
    void* table = library ? dlsym(library, "gnomon_image_formats") : nullptr;
    if (!table)
        throw Error(Blame::run, "cannot load the image formats", GNOMON_FORMATS,
                    std::string(dlerror()) + "; it belongs beside gnomon's library; .png needs none of it");
    return *static_cast<const ImageFormats*>(table);
}

}  // namespace

const ImageFormats& image_formats() {
    static const ImageFormats& formats = load();
    return formats;
}

}  // namespace gnomon
