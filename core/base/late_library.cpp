#include "core/base/late_library.h"

#include <dlfcn.h>

namespace voxprite {

Result<void*> entryOf(const std::string& library, const char* entry) {
    const auto reason = [&]() -> Failure {
        const char* said = dlerror();
        return fail(library + ", a part of this program, cannot be loaded: " +
                    (said == nullptr ? "no reason was given" : said));
    };
    void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (loaded == nullptr) return reason();
    void* const found = dlsym(loaded, entry);
    if (found == nullptr) return reason();
    return found;
}

}  // namespace voxprite
