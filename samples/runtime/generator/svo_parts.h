// A .svo file taken apart into its sections and put together again, whatever they hold: how the
// broken files of the conformance set are made.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/hash.h"

namespace voxprite::samples {

template <class T>
T valueAt(const Bytes& bytes, std::size_t offset) {
    T value{};
    if (offset + sizeof(T) > bytes.size()) throw std::out_of_range("beyond the end of a section");
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

template <class T>
void setValueAt(Bytes& bytes, std::size_t offset, T value) {
    if (offset + sizeof(T) > bytes.size()) throw std::out_of_range("beyond the end of a section");
    std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

struct SvoPart {
    std::string tag;
    std::uint32_t flags = 0;
    Bytes bytes;
};

struct SvoParts {
    std::uint16_t major = 1;
    std::uint16_t minor = 0;
    std::vector<SvoPart> parts;

    explicit SvoParts(const Bytes& file)
        : major(valueAt<std::uint16_t>(file, 8)), minor(valueAt<std::uint16_t>(file, 10)) {
        const auto count = valueAt<std::uint32_t>(file, 12);
        for (std::size_t entry = 64; entry < 64 + std::size_t{32} * count; entry += 32) {
            const auto first = file.begin() + valueAt<std::int64_t>(file, entry + 8);
            parts.push_back({std::string(file.begin() + static_cast<std::ptrdiff_t>(entry),
                                         file.begin() + static_cast<std::ptrdiff_t>(entry) + 4),
                             valueAt<std::uint32_t>(file, entry + 4),
                             Bytes(first, first + valueAt<std::int64_t>(file, entry + 16))});
        }
    }
    [[nodiscard]] Bytes& operator[](const std::string& tag) {
        for (SvoPart& part : parts) {
            if (part.tag == tag) return part.bytes;
        }
        throw std::out_of_range("no section " + tag);
    }
    void remove(const std::string& tag) {
        std::erase_if(parts, [&](const SvoPart& part) { return part.tag == tag; });
    }

    // All checksums are right.
    [[nodiscard]] Bytes file() const {
        Bytes bytes(64 + 32 * parts.size(), 0);
        const std::uint8_t magic[8] = {0x89, 'S', 'V', 'O', '\r', '\n', 0x1A, '\n'};
        std::memcpy(bytes.data(), magic, 8);
        setValueAt(bytes, 8, major);
        setValueAt(bytes, 10, minor);
        setValueAt(bytes, 12, static_cast<std::uint32_t>(parts.size()));
        for (std::size_t i = 0; i < parts.size(); ++i) {
            while (bytes.size() % 64 != 0) bytes.push_back(0);
            std::memcpy(bytes.data() + 64 + 32 * i, parts[i].tag.data(), 4);
            setValueAt(bytes, 64 + 32 * i + 4, parts[i].flags);
            setValueAt(bytes, 64 + 32 * i + 8, std::uint64_t{bytes.size()});
            setValueAt(bytes, 64 + 32 * i + 16, std::uint64_t{parts[i].bytes.size()});
            setValueAt(bytes, 64 + 32 * i + 24, crc32(parts[i].bytes));
            bytes.insert(bytes.end(), parts[i].bytes.begin(), parts[i].bytes.end());
        }
        setValueAt(bytes, 16, std::uint64_t{bytes.size()});
        return sealed(std::move(bytes));
    }

    // With the checksum of header and table as they stand.
    [[nodiscard]] static Bytes sealed(Bytes bytes) {
        const std::size_t end = 64 + std::size_t{32} * valueAt<std::uint32_t>(bytes, 12);
        setValueAt(bytes, 60, std::uint32_t{0});
        setValueAt(bytes, 60, crc32(ByteView(bytes).first(std::min(end, bytes.size()))));
        return bytes;
    }
};

}  // namespace voxprite::samples
