// What every fuzz target asks of its reader: any bytes end in an error that says why, or in
// something valid; never in a crash, a hang or a hunger for memory (the command line of the fuzzer
// sets the bounds: see `./dev fuzz`).
//
// Built with libFuzzer and sanitizers (VOXPRITE_SANITIZE by clang). Checksums are not compared
// (core/base/hash.h), since no mutation would come past them.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite::fuzz {

// Bugs show as a crash.
inline void require(bool holds) {
    if (!holds) std::abort();
}

inline void requireReason(const Error& error, std::size_t inputBytes) {
    require(!error.message.empty());
    if (error.offset) require(*error.offset <= inputBytes);
    if (error.line) require(*error.line >= 1);
}

inline std::string_view textOf(ByteView bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

inline void requireValid(const Document& document) {
    require(validate(document).has_value());
}

// Is it small enough to be written and read back within a mutation's time?
inline bool isSmall(const Document& document) {
    std::uint64_t voxels = 0;
    for (const Model& model : document.models) voxels += model.voxels.solidCount();
    return voxels <= 20'000 && document.nodes.size() <= 200;
}

// True of one input in `count`, always of the same ones: for what takes much longer than reading.
inline bool isOneIn(std::uint64_t count, ByteView bytes) {
    return std::hash<std::string_view>()(textOf(bytes)) % count == 0;
}

}  // namespace voxprite::fuzz

// VOXPRITE_FUZZ_TARGET(bytes) { ... }: the body of one target.
#define VOXPRITE_FUZZ_TARGET(bytes)                                                \
    static void fuzzOne(voxprite::ByteView bytes);                                 \
    extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, size_t size) { \
        fuzzOne(voxprite::ByteView(data, size));                                   \
        return 0;                                                                  \
    }                                                                              \
    static void fuzzOne(voxprite::ByteView bytes)
