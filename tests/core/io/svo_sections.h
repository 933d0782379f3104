// A .svo file taken apart and put together again, written from the byte diagram in svo_file.h
// alone, so that tests can read what was written and damage files under valid checksums.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace voxprite::test {

struct SvoSection {
    std::string tag;
    std::uint32_t flags = 0;
    std::vector<std::uint8_t> bytes;
};

template <class T>
T valueAt(const std::vector<std::uint8_t>& bytes, std::size_t offset) {
    T value{};
    if (offset + sizeof(T) > bytes.size()) {
        ADD_FAILURE() << "offset " << offset << " is beyond the end";
        return value;
    }
    std::memcpy(&value, bytes.data() + offset, sizeof(T));
    return value;
}

template <class T>
void setValueAt(std::vector<std::uint8_t>& bytes, std::size_t offset, T value) {
    ASSERT_LE(offset + sizeof(T), bytes.size());
    std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

inline std::uint32_t checksum(const std::uint8_t* bytes, std::size_t count) {
    return static_cast<std::uint32_t>(::crc32(0, bytes, static_cast<unsigned>(count)));
}

// Makes all checksums right, whatever the sections hold. Leaves a table that is no table alone.
inline void reseal(std::vector<std::uint8_t>& bytes) {
    const auto count = valueAt<std::uint32_t>(bytes, 12);
    const std::size_t tableEnd = 64 + std::size_t{32} * count;
    if (count > 100 || tableEnd > bytes.size()) return;
    for (std::size_t entry = 64; entry < tableEnd; entry += 32) {
        const auto offset = valueAt<std::uint64_t>(bytes, entry + 8);
        const auto length = valueAt<std::uint64_t>(bytes, entry + 16);
        if (offset > bytes.size() || length > bytes.size() - offset) continue;
        setValueAt(bytes, entry + 24, checksum(bytes.data() + offset, length));
    }
    setValueAt(bytes, 60, std::uint32_t{0});
    setValueAt(bytes, 60, checksum(bytes.data(), tableEnd));
}

inline std::vector<SvoSection> sectionsOf(const std::vector<std::uint8_t>& bytes) {
    std::vector<SvoSection> sections;
    const auto count = valueAt<std::uint32_t>(bytes, 12);
    for (std::size_t entry = 64; entry < 64 + std::size_t{32} * count; entry += 32) {
        SvoSection section;
        section.tag.assign(bytes.begin() + static_cast<std::ptrdiff_t>(entry),
                           bytes.begin() + static_cast<std::ptrdiff_t>(entry) + 4);
        section.flags = valueAt<std::uint32_t>(bytes, entry + 4);
        const auto first = bytes.begin() + valueAt<std::int64_t>(bytes, entry + 8);
        section.bytes.assign(first, first + valueAt<std::int64_t>(bytes, entry + 16));
        sections.push_back(std::move(section));
    }
    return sections;
}

inline std::vector<std::uint8_t> fileOf(const std::vector<SvoSection>& sections) {
    std::vector<std::uint8_t> bytes(64 + 32 * sections.size(), 0);
    const std::uint8_t magic[8] = {0x89, 0x53, 0x56, 0x4F, 0x0D, 0x0A, 0x1A, 0x0A};
    std::memcpy(bytes.data(), magic, 8);
    setValueAt(bytes, 8, std::uint16_t{1});
    setValueAt(bytes, 12, static_cast<std::uint32_t>(sections.size()));
    for (std::size_t i = 0; i < sections.size(); ++i) {
        while (bytes.size() % 64 != 0) bytes.push_back(0);
        std::memcpy(bytes.data() + 64 + 32 * i, sections[i].tag.data(), 4);
        setValueAt(bytes, 64 + 32 * i + 4, sections[i].flags);
        setValueAt(bytes, 64 + 32 * i + 8, std::uint64_t{bytes.size()});
        setValueAt(bytes, 64 + 32 * i + 16, std::uint64_t{sections[i].bytes.size()});
        bytes.insert(bytes.end(), sections[i].bytes.begin(), sections[i].bytes.end());
    }
    setValueAt(bytes, 16, std::uint64_t{bytes.size()});
    reseal(bytes);
    return bytes;
}

inline SvoSection& sectionNamed(std::vector<SvoSection>& sections, const std::string& tag) {
    for (SvoSection& section : sections) {
        if (section.tag == tag) return section;
    }
    ADD_FAILURE() << "no section " << tag;
    return sections.front();
}

}  // namespace voxprite::test
